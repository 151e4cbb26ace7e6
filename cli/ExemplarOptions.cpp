// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ExemplarOptions.h"

#include "cli/Parse.h"
#include "cli/Report.h"
#include "core/base/OutputFiles.h"
#include "core/gaussian/ExemplarEdits.h"
#include "core/image/ColorTransfer.h"
#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"

namespace txn::cli {
namespace {

void addPreparation(CLI::App& app, ExemplarOptions& options) {
    addParsed(app, "--crop", options.crop, parseRect, "X,Y,W,H", "Use only this part, in pixels");
    app.add_option("--rotate",
                   options.rotate,
                   "Turn by DEG degrees, counter-clockwise, to straighten grain")
        ->type_name("DEG");
    app.add_option("--flatten", options.flatten, "Even out lighting smoother than RADIUS pixels")
        ->type_name("RADIUS")
        ->check(between(0.5, 1e5));
    app.add_flag("--linear", options.linear, "Convert to linear light first");
    app.add_option("--max-samples",
                   options.load.maxSamples,
                   "Refuse larger pictures: width x height x channels")
        ->type_name("N")
        ->check(between(1.0, static_cast<double>(LoadOptions::insisted().maxSamples)))
        ->capture_default_str();
}

/// "height=stone_disp.png"; the name tells what the map is, and what its files will be called.
std::optional<StackEntry> parseStackEntry(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
        return std::nullopt;
    StackEntry entry;
    entry.name = text.substr(0, equals);
    if (!isMapName(entry.name))
        return std::nullopt;
    entry.kind = mapKindOfWord(entry.name).value_or(MapKind::Data);
    entry.path = text.substr(equals + 1);
    return entry;
}

Result<LoadedImage> load(const std::filesystem::path& path, const LoadOptions& options) {
    auto loaded = loadImage(path, options);
    if (!loaded && loaded.error().code == ErrorCode::OverBudget)
        return Error{ErrorCode::OverBudget,
                     loaded.error().message + ", or allow more with --max-samples"};
    return loaded;
}

/// The picture of the options, or the stack, before any preparation and checks.
Result<Exemplar> loadWhole(const ExemplarOptions& options) {
    if (options.stack.empty()) {
        auto loaded = load(options.path, options.load);
        if (!loaded)
            return loaded.error();
        return Exemplar{std::move(loaded->image), options.path.filename().string()};
    }
    std::vector<MapPicture> pictures;
    for (const StackEntry& entry : options.stack) {
        auto loaded = load(entry.path, options.load);
        if (!loaded)
            return loaded.error();
        pictures.push_back(
            {entry.name, entry.kind, std::move(loaded->image), entry.path.filename().string()});
    }
    auto stack = stackMaps(std::move(pictures));
    if (!stack)
        return stack.error();
    return Exemplar{std::move(stack->image),
                    mainFile(options).filename().string(),
                    std::move(stack->maps)};
}

} // namespace

void addExemplarOptions(CLI::App& app, ExemplarOptions& options) {
    app.add_option("EXEMPLAR", options.path, "Picture of the material")->required();
    addPreparation(app, options);
}

void addMaterialOptions(CLI::App& app, ExemplarOptions& options) {
    app.add_option("EXEMPLAR", options.path, "Picture of the material, unless --stack is given");
    addStackOption(app, options);
    addPreparation(app, options);
}

void addStackOption(CLI::App& app, ExemplarOptions& options) {
    app.add_option_function<std::vector<std::string>>(
           options.stackOption,
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   const auto entry = parseStackEntry(text);
                   if (!entry)
                       throw CLI::ValidationError(
                           options.stackOption,
                           "'" + text +
                               "' is not of the form NAME=FILE, such as height=stone_h.png");
                   options.stack.push_back(*entry);
               }
           },
           "One map of a material, given once for each: color, normal (or normal-dx with green "
           "down), height, roughness, occlusion, metalness, packed (occlusion, roughness and "
           "metalness in one picture); other names are data as they are")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<std::filesystem::path> inputFiles(const ExemplarOptions& options) {
    std::vector<std::filesystem::path> files;
    if (!options.path.empty())
        files.push_back(options.path);
    for (const StackEntry& entry : options.stack)
        files.push_back(entry.path);
    return files;
}

std::filesystem::path mainFile(const ExemplarOptions& options) {
    return options.stack.empty() ? options.path : options.stack.front().path;
}

Result<Exemplar> loadExemplar(const ExemplarOptions& options) {
    const bool stack = !options.stack.empty();
    if (stack != options.path.empty())
        return Error{ErrorCode::InvalidArgument,
                     stack ? "give a picture or " + options.stackOption + ", not both"
                           : "give a picture of the material, or its maps with " +
                                 options.stackOption};
    if (stack && options.linear)
        return Error{ErrorCode::InvalidArgument,
                     "--linear is for pictures; the colors of a stack stay encoded"};
    const BusySign busy("Preparing the exemplar");
    auto exemplar = loadWhole(options);
    if (!exemplar)
        return exemplar.error();
    const auto named = [&](const Error& error) {
        return Error{error.code, quoted(mainFile(options)) + ": " + error.message};
    };
    if (options.crop) {
        auto part = crop(exemplar->image, *options.crop);
        if (!part)
            return named(part.error());
        exemplar->image = std::move(*part);
    }
    // After the crop, which may take bad samples away, and before they can spread by filtering.
    exemplar = makeExemplar(std::move(exemplar->image), exemplar->name, exemplar->maps);
    if (!exemplar)
        return exemplar.error();
    if (options.rotate != 0.0) {
        auto upright = turned(std::move(*exemplar), options.rotate);
        if (!upright)
            return named(upright.error());
        exemplar = std::move(*upright);
    }
    if (options.flatten) {
        auto even = lightingEvened(std::move(*exemplar), *options.flatten);
        if (!even)
            return named(even.error());
        exemplar = std::move(*even);
    }
    if (options.linear)
        exemplar->image = toLinear(std::move(exemplar->image));
    return makeExemplar(std::move(exemplar->image), exemplar->name, exemplar->maps);
}

} // namespace txn::cli
