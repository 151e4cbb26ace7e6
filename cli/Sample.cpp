// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "core/samples/Samples.h"

#include <memory>
#include <optional>

namespace txn::cli {
namespace {

struct SampleArguments {
    std::string name;
    std::filesystem::path output;
    SaveOptions save;
    Size size{512, 512};
    std::uint32_t seed = 1;
};

Result<void> run(const SampleArguments& options) {
    if (const auto ok = checkPictureOutput(options.output); !ok)
        return ok.error();
    std::optional<BusySign> busy("Drawing");
    const auto picture = makeSample(options.name, options.size, Seed{options.seed});
    if (!picture)
        return picture.error();
    if (const auto ok = saveImage(*picture, options.output, options.save); !ok)
        return ok.error();
    busy.reset();
    printWritten({&options.output, 1});
    return {};
}

} // namespace

void addSample(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand("sample", "Generate an exemplar to try things on");
    std::string list = "Names:\n";
    std::vector<std::string> names;
    for (const SampleInfo& info : sampleCatalog()) {
        names.emplace_back(info.name);
        list += "  " + std::string(info.name) + std::string(10 - info.name.size(), ' ') +
                std::string(info.description) + "\n";
    }
    command->footer(list + "Example:\n  texton sample wood -o wood.png --size 512x512");
    auto options = std::make_shared<SampleArguments>();
    command->add_option("NAME", options->name, "Which material")
        ->required()
        ->check(CLI::IsMember(names));
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addParsed(*command,
              "--size",
              options->size,
              parseWidthByHeight,
              "WxH",
              "Size in pixels (default: 512x512)");
    command->add_option("--seed", options->seed, "Another number gives another piece of it")
        ->capture_default_str();
    addDepth(*command, options->save);
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
