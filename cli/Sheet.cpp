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
#include "core/noise/NoiseGrid.h"
#include "core/sheet/ContactSheet.h"

#include <algorithm>
#include <memory>

namespace txn::cli {
namespace {

/// Larger exemplars show their middle, at 100 %.
constexpr int kLargestPanel = 768;

struct Options {
    ExemplarOptions exemplar;
    SolveOptions solve;
    NoiseOptions noise;
    std::filesystem::path output;
};

Result<void> run(const Options& options, const CancelToken& cancel) {
    if (const auto ok = checkPictureOutput(options.exemplar.path, options.output); !ok)
        return ok.error();
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    const GaussianModel model(*exemplar, !options.solve.noPeriodic);
    const auto solved = solve(*exemplar, model, options.solve, cancel);
    if (!solved)
        return Error{solved.error().code,
                     quoted(options.exemplar.path) + ": " + solved.error().message};
    const NoiseParams params = options.noise.params();
    const auto grid = NoiseGrid::create(solved->texton, params);
    if (!grid)
        return grid.error();

    const Size whole = exemplar->image.size();
    const Size shown{std::min(whole.width, kLargestPanel), std::min(whole.height, kLargestPanel)};
    const Rect middle{(whole.width - shown.width) / 2, (whole.height - shown.height) / 2, shown};
    const auto noise = grid->render({0, 0, shown}, cancel);
    if (!noise)
        return noise.error();
    auto picture = crop(exemplar->image, middle);
    auto gaussian =
        crop(sampleGaussian(model, GaussianMethod::Adsn, Seed{options.solve.seed}), middle);
    if (!picture || !gaussian)
        return picture ? gaussian.error() : picture.error();
    const Size support = solved->texton.support.size();
    const Panel panels[] = {
        {"Exemplar, " + sizeText(whole), std::move(*picture)},
        {"Gaussian version (ADSN)", std::move(*gaussian)},
        {"Texton, " + sizeText(support) + ", order " + std::to_string(options.solve.order),
         textonPicture(solved->texton, shown)},
        {"Texton noise, " + std::string(toString(params.process)) + ", MNI " +
             shortNumber(params.meanImpacts),
         *noise}};
    const auto sheet = contactSheet(exemplar->name, panels);
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
    auto options = std::make_shared<Options>();
    addExemplarOptions(*command, options->exemplar);
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addSolveOptions(*command, options->solve);
    addNoiseOptions(*command, options->noise, "--noise-seed");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
