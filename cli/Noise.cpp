// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/NoiseOptions.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "core/bake/Bake.h"
#include "core/base/OutputFiles.h"
#include "core/export/Exporter.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

namespace txn::cli {
namespace {

struct NoiseArguments {
    std::filesystem::path texton;
    std::filesystem::path output;
    SaveOptions save;
    Size size;
    std::pair<std::int64_t, std::int64_t> origin{0, 0};
    NoiseOptions noise;
    bool tile = false;
    double scale = 1.0;
    int threads = 0;
    bool json = false;
};

Result<void> run(const NoiseArguments& options, const CancelToken& cancel) {
    if (const auto ok = checkNotInput(options.texton, options.output); !ok)
        return ok.error();
    if (const auto format = imageFormatForPath(options.output); !format)
        return format.error();
    std::unique_ptr<tbb::global_control> limit;
    if (options.threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(options.threads));
    Stopwatch watch;
    const auto asset = loadTexton(options.texton);
    if (!asset)
        return asset.error();
    const BakeTarget target{options.output, options.save, asset->maps};
    for (const auto& file : bakeFiles(target)) {
        for (const auto& input : textonFiles(options.texton, asset->maps)) {
            if (const auto ok = checkPictureOutput(input, file); !ok)
                return ok.error();
        }
    }
    NoiseParams params =
        options.noise.params({asset->process, asset->meanImpacts, asset->seed, std::nullopt});
    if (options.tile)
        params.period =
            Period{options.size.width / options.scale, options.size.height / options.scale};
    const auto grid = NoiseGrid::create(asset->texton, params, options.scale);
    if (!grid)
        return Error{grid.error().code, quoted(options.texton) + ": " + grid.error().message};
    const auto report = [&] {
        ProgressBar bar("Making noise");
        return bake(
            *grid,
            {options.origin.first, options.origin.second, options.size},
            target,
            [&](double share) { bar.update(share); },
            cancel);
    }();
    if (!report)
        return report.error();
    const double seconds = watch.lap();
    if (options.json) {
        nlohmann::ordered_json json;
        json["width"] = options.size.width;
        json["height"] = options.size.height;
        json["channels"] = grid->channels();
        json["origin"] = {options.origin.first, options.origin.second};
        json["mni"] = params.meanImpacts;
        json["process"] = toString(params.process);
        json["seed"] = params.seed.value;
        json["scale"] = options.scale;
        json["tile"] = options.tile;
        json["clipped"] = report->clippedShare;
        json["seconds"] = seconds;
        for (const auto& file : bakeFiles(target))
            json["outputs"].push_back(file.string());
        printJson(json);
        return {};
    }
    if (report->clippedShare >= 0.001)
        std::cout << shortNumber(100.0 * report->clippedShare)
                  << " % of the samples were clipped to black or white; EXR keeps them\n";
    printWritten(bakeFiles(target));
    return {};
}

} // namespace

void addNoise(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand("noise", "Make texton noise of any size from a texton");
    command->footer("Examples:\n  texton noise wood.exr -o wood_4k.png --size 4096x4096 --tile\n"
                    "  texton noise wood.exr -o wood_huge.exr --size 30000x30000\n"
                    "Of a stack, all maps are made of the same impulses: one file each\n"
                    "(rock_color.png, rock_normal.png ...), or one EXR with a layer for each.");
    auto options = std::make_shared<NoiseArguments>();
    command->add_option("TEXTON", options->texton, "Texton: .exr, .png or .texton")->required();
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addParsed(*command, "--size", options->size, parseWidthByHeight, "WxH", "Size in pixels")
        ->required();
    addParsed(*command,
              "--origin",
              options->origin,
              parsePoint,
              "X,Y",
              "Which part of the endless plane: its top left pixel (default: 0,0)");
    addNoiseOptions(*command, options->noise, "--seed");
    command->add_flag("--tile", options->tile, "Make a picture that repeats without a seam");
    command->add_option("--scale", options->scale, "Output pixels per exemplar pixel")
        ->type_name("S")
        ->check(between(NoiseGrid::kMinScale, NoiseGrid::kMaxScale))
        ->capture_default_str();
    command
        ->add_option("--threads",
                     options->threads,
                     "How many processor cores to use (default: all)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    addDepth(*command, options->save);
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
