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
#include "core/export/MixtureExport.h"
#include "core/material/MapStack.h"
#include "core/noise/MixedProcess.h"
#include "core/sheet/ContactSheet.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

namespace txn::cli {
namespace {

constexpr std::size_t kSheetTextons = 5;
constexpr Size kSheetTexton{300, 256}; ///< two kernels at least twice as large
constexpr Size kSheetNoise{1600, 512};

struct MixArguments {
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
    std::optional<std::filesystem::path> sheet;
    bool json = false;
};

/// The map that the options tell of, spread over the whole picture.
Result<MixingMap> makeMap(const MixArguments& options) {
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

/// That nothing which is read is written over, and all can be written.
Result<void> checkOutputs(const MixArguments& options, const MaterialMaps& maps) {
    std::vector<std::filesystem::path> inputs = inputFiles(options.a);
    std::ranges::copy(inputFiles(options.b), std::back_inserter(inputs));
    if (options.map)
        inputs.push_back(*options.map);
    for (const auto& input : inputs) {
        if (options.sheet) {
            if (const auto ok = checkPictureOutput(input, *options.sheet); !ok)
                return ok.error();
        }
        for (const auto& file : bakeFiles({options.output, options.save, maps})) {
            if (const auto ok = checkPictureOutput(input, file); !ok)
                return ok.error();
        }
        if (!options.textonFolder)
            continue;
        for (const auto& file :
             mixtureFiles(*options.textonFolder, static_cast<std::size_t>(options.strips))) {
            if (const auto ok = checkNotInput(input, file); !ok)
                return ok.error();
        }
    }
    if (options.textonFolder)
        return checkMixtureOutputs(*options.textonFolder, static_cast<std::size_t>(options.strips));
    return {};
}

Result<Size> chooseSupport(const MixArguments& options, const Exemplar& a, const Exemplar& b) {
    if (options.solve.support)
        return *options.solve.support;
    const BusySign sign("Looking for a support");
    int side = 0;
    for (const Exemplar* exemplar : {&a, &b}) {
        const auto suggestion = suggestSupport(*exemplar);
        if (!suggestion)
            return suggestion.error();
        side = std::max(side, suggestion->side);
    }
    return Size{side, side};
}

Result<MixedTextons> computeTextons(const MixArguments& options,
                                    const Exemplar& a,
                                    const Exemplar& b,
                                    const CancelToken& cancel) {
    const auto support = chooseSupport(options, a, b);
    if (!support)
        return support.error();
    const Size domain{std::max(a.image.width(), b.image.width()),
                      std::max(a.image.height(), b.image.height())};
    const auto params = computeParams(options.solve, *support, domain);
    if (!params)
        return params.error();
    ProgressBar bar("Computing the textons");
    const bool periodic = !options.solve.noPeriodic;
    auto solver = makeMixSolver({a, b, periodic, periodic, *params, options.strips}, {}, cancel);
    if (!solver)
        return solver.error();
    while (!solver->done()) {
        if (const auto ok = solver->step(cancel); !ok)
            return ok.error();
        bar.update(solver->share());
    }
    return solver->result();
}

MixtureAsset makeAsset(const MixArguments& options,
                       const Exemplar& a,
                       const Exemplar& b,
                       const MixedTextons& mixed,
                       MixingMap map,
                       const NoiseParams& noise) {
    MixtureAsset asset;
    asset.mixture.map = std::move(map);
    for (const MixedTexton& one : mixed.textons) {
        asset.mixture.textons.push_back(one.texton);
        asset.rhos.push_back(one.rho);
        asset.distances.push_back(one.distance);
    }
    asset.process = noise.process;
    asset.meanImpacts = noise.meanImpacts;
    asset.seed.value = options.solve.seed;
    asset.exemplarA = a.name;
    asset.exemplarB = b.name;
    asset.maps = a.maps;
    return asset;
}

/// As in figure 5 of [TN17]: some of the textons, and the noise below.
Result<void>
saveSheet(const MixtureAsset& asset, const NoiseGrid& grid, const MixArguments& options) {
    const auto last = asset.mixture.textons.size() - 1;
    std::vector<std::vector<Panel>> rows(2);
    for (std::size_t i = 0; i < kSheetTextons; ++i) {
        const std::size_t r = (i * last + (kSheetTextons - 1) / 2) / (kSheetTextons - 1);
        const Image picture = textonPicture(asset.mixture.textons[r], kSheetTexton);
        rows[0].push_back({"rho " + shortNumber(asset.rhos[r]), firstPicture(picture, asset.maps)});
    }
    const Size shown{std::min(options.size.width, kSheetNoise.width),
                     std::min(options.size.height, kSheetNoise.height)};
    const auto noise = grid.render(
        {(options.size.width - shown.width) / 2, (options.size.height - shown.height) / 2, shown});
    if (!noise)
        return noise.error();
    rows[1].push_back({"Mixed noise of " + std::to_string(asset.mixture.textons.size()) +
                           " textons, distance " + shortNumber(asset.distances.back()),
                       firstPicture(*noise, asset.maps)});
    const auto sheet = rowSheet(asset.exemplarA + " to " + asset.exemplarB, rows);
    if (!sheet)
        return sheet.error();
    return saveImage(*sheet, *options.sheet);
}

struct Times {
    double load = 0.0;
    double solve = 0.0;
    double bake = 0.0;
};

void reportJson(const MixArguments& options,
                const MixtureAsset& asset,
                const MixedTextons& mixed,
                const NoiseParams& params,
                const BakeReport& report,
                const Times& times,
                std::span<const std::filesystem::path> written) {
    nlohmann::ordered_json json;
    json["width"] = options.size.width;
    json["height"] = options.size.height;
    json["channels"] = asset.mixture.textons.front().channels();
    const Size support = asset.mixture.textons.front().support.size();
    json["support"] = {support.width, support.height};
    json["method"] = options.solve.method;
    json["kernels"] = asset.mixture.textons.front().kernelCount();
    json["distance"] = asset.distances.back();
    for (const MixedTexton& one : mixed.textons)
        json["textons"].push_back(
            {{"rho", one.rho}, {"distance", one.distance}, {"error", one.error}});
    json["mni"] = params.meanImpacts;
    json["process"] = toString(params.process);
    json["seed"] = options.solve.seed;
    json["noise_seed"] = params.seed.value;
    json["tile"] = options.tile;
    json["clipped"] = report.clippedShare;
    json["seconds"] = {{"load", times.load}, {"solve", times.solve}, {"bake", times.bake}};
    for (const auto& file : written)
        json["outputs"].push_back(file.string());
    printJson(json);
}

Result<void> run(const MixArguments& options, const CancelToken& cancel) {
    if (options.map && (options.angle != 0.0 || options.ease != "linear"))
        return Error{ErrorCode::InvalidArgument,
                     "--angle and --ease are for gradients; leave them out with --map"};
    const bool stacks = !options.a.stack.empty() || !options.b.stack.empty();
    if (!stacks) {
        if (const auto ok = checkOutputs(options, {}); !ok)
            return ok.error();
    }
    Stopwatch watch;
    Times times;
    auto map = makeMap(options);
    if (!map)
        return map.error();
    const auto a = loadExemplar(options.a);
    if (!a)
        return a.error();
    const auto b = loadExemplar(options.b);
    if (!b)
        return b.error();
    if (stacks) { // what files it becomes is known only now
        if (const auto ok = checkOutputs(options, a->maps); !ok)
            return ok.error();
    }
    NoiseParams params = options.noise.params();
    if (options.tile)
        params.period = Period{map->placement.width, map->placement.height};
    if (const auto ok = checkMixing(static_cast<std::size_t>(options.strips),
                                    map->placement,
                                    map->boundary,
                                    params);
        !ok)
        return Error{ok.error().code, "--process: " + ok.error().message};
    times.load = watch.lap();
    const auto mixed = computeTextons(options, *a, *b, cancel);
    if (!mixed)
        return Error{mixed.error().code,
                     quoted(mainFile(options.a)) + " and " + quoted(mainFile(options.b)) + ": " +
                         mixed.error().message};
    times.solve = watch.lap();
    const MixtureAsset asset = makeAsset(options, *a, *b, *mixed, std::move(*map), params);
    const auto grid = NoiseGrid::create(asset.mixture, params);
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
    times.bake = watch.lap();
    auto written = bakeFiles(target);
    if (options.textonFolder) {
        const auto saved = saveMixture(asset, *options.textonFolder);
        if (!saved)
            return saved.error();
        std::ranges::copy(*saved, std::back_inserter(written));
    }
    if (options.sheet) {
        if (const auto ok = saveSheet(asset, *grid, options); !ok)
            return ok.error();
        written.push_back(*options.sheet);
    }
    if (options.json) {
        reportJson(options, asset, *mixed, params, *report, times, written);
        return {};
    }
    std::cout << a->name << " to " << b->name << ": distance "
              << shortNumber(asset.distances.back()) << "; " << options.strips << " textons in "
              << shortNumber(times.solve) << " s, noise in " << shortNumber(times.bake) << " s\n";
    if (report->clippedShare >= 0.001)
        std::cout << shortNumber(100.0 * report->clippedShare)
                  << " % of the samples were clipped to black or white; EXR keeps them\n";
    if (options.textonFolder)
        std::cout << "wrote the textons to " << quoted(*options.textonFolder) << '\n';
    if (options.sheet)
        std::cout << "wrote a sheet to " << quoted(*options.sheet) << '\n';
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
    auto options = std::make_shared<MixArguments>();
    options->a.stackOption = "--stack-a";
    options->b.stackOption = "--stack-b";
    command->add_option("A", options->a.path, "Picture of the first material");
    command->add_option("B", options->b.path, "Picture of the second material");
    addStackOption(*command, options->a);
    addStackOption(*command, options->b);
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
    command
        ->add_option("--save-textons",
                     options->textonFolder,
                     "Folder for the textons, their description and the map")
        ->type_name("DIR");
    command
        ->add_option("--sheet",
                     options->sheet,
                     "Picture to look at: some of the textons, and the noise")
        ->type_name("PICTURE");
    command->add_flag("--tile", options->tile, "Make a picture that repeats without a seam");
    addDepth(*command, options->save);
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
