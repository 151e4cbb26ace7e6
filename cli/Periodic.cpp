// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "core/spectral/PeriodicComponent.h"

#include <memory>

namespace txn::cli {
namespace {

struct PeriodicArguments {
    ExemplarOptions exemplar;
    std::filesystem::path output;
    SaveOptions save;
};

Result<void> run(const PeriodicArguments& options) {
    if (const auto ok = checkPictureOutput(options.exemplar.path, options.output); !ok)
        return ok.error();
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    std::optional<BusySign> busy("Removing the seam");
    if (const auto ok = saveImage(periodicComponent(exemplar->image), options.output, options.save);
        !ok)
        return ok.error();
    busy.reset();
    printWritten({&options.output, 1});
    return {};
}

} // namespace

void addPeriodic(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand(
        "periodic",
        "Make the periodic component of a picture: the same without a seam when it repeats");
    command->footer("Example:\n  texton periodic wood.jpg -o wood_periodic.png");
    auto options = std::make_shared<PeriodicArguments>();
    addExemplarOptions(*command, options->exemplar);
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addDepth(*command, options->save);
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
