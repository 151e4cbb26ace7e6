// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ProjectThumbnail.h"
#include "core/export/Exporter.h"
#include "core/image/ImageResize.h"
#include "core/material/MapStack.h"
#include "core/noise/NoiseGrid.h"

#include <memory>
#include <variant>

namespace txn::cli {
namespace {

struct ThumbnailArguments {
    std::filesystem::path input;
    std::filesystem::path output;
    int size = 256;
};

/// A texton is shown by what it is for: its noise.
Result<Image> pictureOf(const TextonAsset& asset, Size size) {
    NoiseParams params;
    params.process = asset.process;
    params.meanImpacts = asset.meanImpacts;
    const auto grid = NoiseGrid::create(asset.texton, params);
    if (!grid)
        return grid.error();
    const auto noise = grid->render({0, 0, size});
    if (!noise)
        return noise.error();
    return firstPicture(*noise, asset.maps);
}

Result<Image> pictureOf(const LoadedImage& loaded, Size) {
    return loaded.image;
}

Result<Image> pictureOf(const std::filesystem::path& path, Size size) {
    if (isProject(path))
        return projectThumbnail(path);
    const auto loaded = loadTextonOrImage(path);
    if (!loaded)
        return loaded.error();
    return std::visit([size](const auto& value) { return pictureOf(value, size); }, *loaded);
}

/// What a PNG can hold.
Image shown(const Image& image) {
    const int channels = image.channels() < 3 ? 1 : 3;
    Image result(image.size(), channels, 0.0F, image.transfer());
    for (int c = 0; c < channels; ++c)
        std::ranges::copy(image.plane(c), result.plane(c).begin());
    return result;
}

Result<void> run(const ThumbnailArguments& options) {
    const Size size{options.size, options.size};
    const auto picture = pictureOf(options.input, size);
    if (!picture)
        return picture.error();
    const auto small = shrunkTo(*picture, size);
    if (!small)
        return Error{small.error().code, quoted(options.input) + ": " + small.error().message};
    SaveOptions png;
    png.fileFormat = ImageFormat::Png; // desktops ask for names without an ending
    return saveImage(shown(*small), options.output, png);
}

} // namespace

void addThumbnail(CLI::App& app, Session& session) {
    auto* command =
        app.add_subcommand("thumbnail",
                           "Draw a small PNG of a texton, project or picture, for file managers");
    command->footer("Example:\n  texton thumbnail wood.texton -o wood_small.png --size 128");
    auto options = std::make_shared<ThumbnailArguments>();
    command->add_option("FILE", options->input, "Texton, project or picture")->required();
    command->add_option("-o,--output", options->output, "PNG to write, whatever its name")
        ->required();
    command->add_option("--size", options->size, "Its longer side in pixels")
        ->type_name("N")
        ->check(CLI::Range(16, 1024))
        ->capture_default_str();
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
