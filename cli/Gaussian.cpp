// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "core/gaussian/GaussianSampler.h"

#include <memory>

namespace txn::cli {
namespace {

struct GaussianArguments {
    ExemplarOptions exemplar;
    std::filesystem::path output;
    SaveOptions save;
    std::string model = "adsn";
    std::optional<Size> size;
    std::uint32_t seed = 1;
    bool noPeriodic = false;
};

Result<void> run(const GaussianArguments& options) {
    if (const auto ok = checkPictureOutput(options.exemplar.path, options.output); !ok)
        return ok.error();
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    const auto method = options.model == "rpn" ? GaussianMethod::RandomPhase : GaussianMethod::Adsn;
    std::optional<BusySign> busy("Making the Gaussian version");
    const auto picture = gaussianVersion(*exemplar,
                                         options.size.value_or(exemplar->image.size()),
                                         method,
                                         Seed{options.seed},
                                         !options.noPeriodic);
    if (!picture)
        return Error{picture.error().code,
                     quoted(options.exemplar.path) + ": " + picture.error().message};
    if (const auto ok = saveImage(*picture, options.output, options.save); !ok)
        return ok.error();
    busy.reset();
    printWritten({&options.output, 1});
    return {};
}

} // namespace

void addGaussian(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand(
        "gaussian",
        "Make the Gaussian version of a material: what texton noise converges to");
    command->footer("Example:\n  texton gaussian wood.jpg -o wood_gaussian.png --size 1024x1024");
    auto options = std::make_shared<GaussianArguments>();
    addExemplarOptions(*command, options->exemplar);
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    command->add_option("--model", options->model, "adsn (exactly Gaussian) or rpn (random phase)")
        ->check(CLI::IsMember({"adsn", "rpn"}))
        ->capture_default_str();
    addParsed(*command,
              "--size",
              options->size,
              parseWidthByHeight,
              "WxH",
              "Default: that of the exemplar");
    command->add_option("--seed", options->seed, "Another number gives another sample")
        ->capture_default_str();
    command->add_flag("--no-periodic",
                      options->noPeriodic,
                      "The exemplar tiles already: leave its borders alone");
    addDepth(*command, options->save);
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
