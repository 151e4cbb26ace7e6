// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/NoiseOptions.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "cli/SolveOptions.h"
#include "core/base/OutputFiles.h"
#include "core/gaussian/GaussianSampler.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageIo.h"
#include "core/material/MapStack.h"
#include "core/noise/NoiseGrid.h"
#include "core/sheet/ContactSheet.h"

#include <algorithm>
#include <memory>

namespace txn::cli {
namespace {

/// Larger exemplars show their middle, at 100 %.
constexpr int kLargestPanel = 768;

struct SheetArguments {
    ExemplarOptions exemplar;
    SolveOptions solve;
    NoiseOptions noise;
    std::filesystem::path output;
};

/// Of a picture: exemplar, Gaussian version, texton, noise. Of a stack: each map and its noise.
std::vector<Panel> panels(const Exemplar& exemplar,
                          const Image& gaussian,
                          const Texton& texton,
                          const Image& noise,
                          Size shown,
                          const std::string& noiseName) {
    const Size whole = exemplar.image.size();
    const Image picture = middlePart(exemplar.image, shown);
    if (exemplar.maps.empty())
        return {{"Exemplar, " + sizeText(whole), picture},
                {"Gaussian version (ADSN)", middlePart(gaussian, shown)},
                {"Texton, " + sizeText(texton.support.size()) + ", order " +
                     std::to_string(texton.interpolationOrder),
                 textonPicture(texton, shown)},
                {noiseName, noise}};
    std::vector<Panel> result;
    for (std::size_t m = 0; m < exemplar.maps.size(); ++m) {
        const std::string map = exemplar.maps[m].name + ", ";
        result.push_back(
            {std::string(map).append(sizeText(whole)), mapPicture(picture, exemplar.maps, m)});
        result.push_back({std::string(map).append(noiseName), mapPicture(noise, exemplar.maps, m)});
    }
    return result;
}

Result<void> run(const SheetArguments& options, const CancelToken& cancel) {
    for (const auto& input : inputFiles(options.exemplar)) {
        if (const auto ok = checkPictureOutput(input, options.output); !ok)
            return ok.error();
    }
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    const GaussianModel model(*exemplar, !options.solve.noPeriodic);
    const auto solved = solve(*exemplar, model, options.solve, cancel);
    if (!solved)
        return Error{solved.error().code,
                     quoted(mainFile(options.exemplar)) + ": " + solved.error().message};
    const Texton& texton = solved->computed.texton;
    const NoiseParams params = options.noise.params();
    const auto grid = NoiseGrid::create(texton, params);
    if (!grid)
        return grid.error();

    const Size whole = exemplar->image.size();
    const Size shown{std::min(whole.width, kLargestPanel), std::min(whole.height, kLargestPanel)};
    const auto noise = grid->render({0, 0, shown}, cancel);
    if (!noise)
        return noise.error();
    const auto gaussian = sampleGaussian(model, GaussianMethod::Adsn, Seed{options.solve.seed});
    const std::string noiseName = "Texton noise, " + std::string(toString(params.process)) +
                                  ", MNI " + shortNumber(params.meanImpacts);
    const std::string title = exemplar->name + (solved->dial ? ": " + inWords(*solved->dial) : "");
    const auto sheet =
        contactSheet(title, panels(*exemplar, gaussian, texton, *noise, shown, noiseName));
    if (!sheet)
        return sheet.error();
    if (const auto ok = saveImage(*sheet, options.output); !ok)
        return ok.error();
    printWritten({&options.output, 1});
    return {};
}

} // namespace

void addSheet(CLI::App& app, Session& session) {
    auto* command =
        app.add_subcommand("sheet",
                           "Make a contact sheet: exemplar, Gaussian version, texton and noise");
    command->footer("Example:\n  texton sheet wood.jpg -o wood_sheet.png");
    auto options = std::make_shared<SheetArguments>();
    addMaterialOptions(*command, options->exemplar);
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addSolveOptions(*command, options->solve);
    addNoiseOptions(*command, options->noise, "--noise-seed");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
