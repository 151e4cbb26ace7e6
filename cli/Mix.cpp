// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/NoiseOptions.h"
#include "cli/Parse.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "cli/SolveOptions.h"
#include "core/bake/Bake.h"
#include "core/base/OutputFiles.h"
#include "core/compute/MixSolver.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

struct Options {
    ExemplarOptions a;
    ExemplarOptions b;
    SolveOptions solve;
    NoiseOptions noise;
    std::filesystem::path output;
    SaveOptions save;
    Size size;
    int strips = 21;
    double angle = 0.0;
    std::string ease = "linear";
    std::optional<std::filesystem::path> map;
    bool tile = false;
    std::optional<std::filesystem::path> textonFolder;
    bool json = false;
};

/// The map that the options tell of, spread over the whole picture.
Result<MixingMap> makeMap(const Options& options) {
    MixingMap map;
    map.placement = {0.0,
                     0.0,
                     static_cast<double>(options.size.width),
                     static_cast<double>(options.size.height)};
    map.boundary = options.tile ? MapBoundary::Repeat : MapBoundary::Clamp;
    if (!options.map) {
        // More texels would say nothing more, since the mean is smoothed and impulses are large.
        const Size texels{std::min(options.size.width, 2048), std::min(options.size.height, 2048)};
        map.rho = gradientMap(texels,
                              options.angle,
                              options.ease == "smooth" ? Ease::Smooth : Ease::Linear);
        return map;
    }
    const auto picture = loadImage(*options.map);
    if (!picture)
        return picture.error();
    auto rho = mapFromPicture(picture->image, options.map->filename().string());
    if (!rho)
        return rho.error();
    map.rho = std::move(*rho);
    return map;
}

Result<MixedTextons> computeTextons(const Options& options,
                                    const Exemplar& a,
                                    const Exemplar& b,
                                    double& distance,
                                    const CancelToken& cancel) {
    Size support = options.solve.support.value_or(Size{});
    if (!options.solve.support) {
        const BusySign sign("Looking for a support");
        for (const Exemplar* exemplar : {&a, &b}) {
            const auto suggestion = suggestSupport(*exemplar);
            if (!suggestion)
                return suggestion.error();
            support.width = support.height = std::max(support.width, suggestion->side);
        }
    }
    const Size domain{std::max(a.image.width(), b.image.width()),
                      std::max(a.image.height(), b.image.height())};
    const auto params = computeParams(options.solve, support, domain);
    if (!params)
        return params.error();
    auto solver = makeMixSolver(
        {a, b, !options.solve.noPeriodic, !options.solve.noPeriodic, *params, options.strips},
        {},
        cancel);
    if (!solver)
        return solver.error();
    ProgressBar bar("Computing the textons");
    while (!solver->done()) {
        if (const auto ok = solver->step(cancel); !ok)
            return ok.error();
        bar.update(solver->share());
    }
    distance = solver->path().distance();
    return solver->result();
}

Result<void> run(const Options& options, const CancelToken& cancel) {
    for (const auto& input : {options.a.path, options.b.path, options.map.value_or("")}) {
        if (const auto ok = checkPictureOutput(input, options.output); !ok)
            return ok.error();
    }
    Stopwatch watch;
    auto map = makeMap(options);
    if (!map)
        return map.error();
    const auto a = loadExemplar(options.a);
    if (!a)
        return a.error();
    const auto b = loadExemplar(options.b);
    if (!b)
        return b.error();
    const double load = watch.lap();
    double distance = 0.0;
    const auto mixed = computeTextons(options, *a, *b, distance, cancel);
    if (!mixed)
        return Error{mixed.error().code,
                     quoted(options.a.path) + " and " + quoted(options.b.path) + ": " +
                         mixed.error().message};
    const double solving = watch.lap();
    Mixture mixture;
    mixture.map = std::move(*map);
    for (const MixedTexton& one : mixed->textons)
        mixture.textons.push_back(one.texton);
    NoiseParams params = options.noise.params();
    if (options.tile)
        params.period = Period{static_cast<double>(options.size.width),
                               static_cast<double>(options.size.height)};
    const auto grid = NoiseGrid::create(std::move(mixture), params);
    if (!grid)
        return grid.error();
    const BakeTarget target{options.output, options.save, a->maps};
    const auto report = [&] {
        ProgressBar bar("Making noise");
        return bake(
            *grid,
            {0, 0, options.size},
            target,
            [&](double share) { bar.update(share); },
            cancel);
    }();
    if (!report)
        return report.error();
    const double baking = watch.lap();
    if (options.json) {
        nlohmann::ordered_json json;
        json["width"] = options.size.width;
        json["height"] = options.size.height;
        json["channels"] = grid->channels();
        json["distance"] = distance;
        for (const MixedTexton& one : mixed->textons)
            json["textons"].push_back(
                {{"rho", one.rho}, {"distance", one.distance}, {"error", one.error}});
        json["kernels"] = mixed->textons.front().texton.kernelCount();
        json["mni"] = params.meanImpacts;
        json["process"] = toString(params.process);
        json["seed"] = params.seed.value;
        json["tile"] = options.tile;
        json["clipped"] = report->clippedShare;
        json["seconds"] = {{"load", load}, {"solve", solving}, {"bake", baking}};
        for (const auto& file : bakeFiles(target))
            json["outputs"].push_back(file.string());
        printJson(json);
        return {};
    }
    std::cout << a->name << " to " << b->name << ": distance " << shortNumber(distance) << "; "
              << options.strips << " textons in " << shortNumber(solving) << " s, noise in "
              << shortNumber(baking) << " s\n";
    if (report->clippedShare >= 0.001)
        std::cout << shortNumber(100.0 * report->clippedShare)
                  << " % of the samples were clipped to black or white; EXR keeps them\n";
    printWritten(bakeFiles(target));
    return {};
}

} // namespace

void addMix(CLI::App& app, Session& session) {
    auto* command =
        app.add_subcommand("mix", "Make noise that passes from one material to another");
    command->footer(
        "Examples:\n"
        "  texton mix oak.jpg pine.jpg -o mixed.png --size 4096x1024\n"
        "  texton mix stone.jpg moss.jpg -o mixed.png --size 4096x4096 --map where.png\n"
        "Without a map, A on the left becomes B on the right; --angle 90 goes from top to bottom.\n"
        "In a map, black is A, white is B, and grey is in between.\n"
        "The distance tells how far the materials are apart, in standard deviations of a pixel.");
    auto options = std::make_shared<Options>();
    command->add_option("A", options->a.path, "Photograph of the first material")->required();
    command->add_option("B", options->b.path, "Photograph of the second material")->required();
    command->add_option("-o,--output", options->output, "Picture to write")->required();
    addParsed(*command, "--size", options->size, parseWidthByHeight, "WxH", "Size in pixels")
        ->required();
    command->add_option("--strips", options->strips, "How many textons lie on the way from A to B")
        ->type_name("N")
        ->check(CLI::Range(MixSolver::kMinTextons, MixSolver::kMaxTextons))
        ->capture_default_str();
    command
        ->add_option("--angle",
                     options->angle,
                     "Direction from A to B, in degrees: 0 to the right, 90 down")
        ->type_name("DEG")
        ->check(between(-360.0, 360.0))
        ->capture_default_str();
    command
        ->add_option("--ease",
                     options->ease,
                     "linear: at one pace from A to B; smooth: slowly at both ends")
        ->check(CLI::IsMember({"linear", "smooth"}))
        ->capture_default_str();
    command->add_option("--map", options->map, "Grey picture of where A (black) and B (white) are")
        ->type_name("MAP");
    command->add_flag(
        "--linear",
        [options](auto) { options->a.linear = options->b.linear = true; },
        "Work in linear light");
    addSolveOptions(*command, options->solve);
    addNoiseOptions(*command, options->noise, "--noise-seed");
    command->add_flag("--tile", options->tile, "Make a picture that repeats without a seam");
    addDepth(*command, options->save);
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
