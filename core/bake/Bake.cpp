// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bake/Bake.h"

#include "core/base/OutputFiles.h"
#include "core/material/MapStack.h"

#include <algorithm>

namespace txn {
namespace {

/// Very wide pictures are made in bands thinner than a tile, at the price of making tiles again.
constexpr std::size_t kMaxBandSamples = std::size_t{1} << 27U;

/// One of the files, and which part of the noise it shows.
struct Output {
    ImageWriter writer;
    std::optional<std::size_t> map; ///< unset: all channels, or all maps as layers

    Result<void> write(const Image& band, const MaterialMaps& maps) {
        if (maps.empty())
            return writer.writeRows(band);
        return writer.writeRows(map ? mapPicture(band, maps, *map) : allMaps(band, maps));
    }

  private:
    static Image allMaps(const Image& band, const MaterialMaps& maps) {
        const auto channels = static_cast<int>(pictureChannelNames(maps).size());
        Image all(band.size(), channels, 0.0F, band.transfer());
        int next = 0;
        for (std::size_t m = 0; m < maps.size(); ++m) {
            const Image one = mapPicture(band, maps, m);
            for (int c = 0; c < one.channels(); ++c)
                std::ranges::copy(one.plane(c), all.plane(next++).begin());
        }
        return all;
    }
};

bool inLayers(const BakeTarget& target) {
    const auto format = imageFormatForPath(target.path);
    return target.maps.empty() || (format && *format == ImageFormat::OpenExr);
}

Result<std::vector<Output>>
openOutputs(const NoiseGrid& noise, Size size, const BakeTarget& target, OutputFiles& together) {
    std::vector<Output> outputs;
    const auto paths = bakeFiles(target);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        SaveOptions options = target.options;
        ImageWriter::Layout layout{size, noise.channels(), noise.transfer()};
        std::optional<std::size_t> map;
        if (!inLayers(target)) {
            map = i;
            layout.channels = pictureChannels(target.maps[i]);
        } else if (!target.maps.empty()) {
            options.channelNames = pictureChannelNames(target.maps);
            layout.channels = static_cast<int>(options.channelNames.size());
        }
        auto writer = ImageWriter::open(paths[i], layout, options, &together);
        if (!writer)
            return writer.error();
        outputs.push_back({std::move(*writer), map});
    }
    return outputs;
}

} // namespace

std::vector<std::filesystem::path> bakeFiles(const BakeTarget& target) {
    if (inLayers(target))
        return {target.path};
    std::vector<std::filesystem::path> files;
    for (const MaterialMap& map : target.maps)
        files.push_back(mapFile(target.path, map.name));
    return files;
}

Result<BakeReport> bake(const NoiseGrid& noise,
                        const Rect& rect,
                        const BakeTarget& target,
                        const std::function<void(double)>& progress,
                        const CancelToken& cancel) {
    OutputFiles together;
    auto outputs = openOutputs(noise, rect.size, target, together);
    if (!outputs)
        return outputs.error();
    const int tileHeight = noise.tileSize().height;
    const std::size_t rowSamples =
        static_cast<std::size_t>(rect.size.width) * static_cast<std::size_t>(noise.channels());
    const auto maxRows =
        static_cast<int>(std::clamp<std::size_t>(kMaxBandSamples / rowSamples,
                                                 1,
                                                 static_cast<std::size_t>(tileHeight)));
    for (int y = 0; y < rect.size.height;) {
        // Bands end where tiles do, so that no tile is computed twice.
        const std::int64_t row = rect.y + y;
        const auto intoTile = static_cast<int>(((row % tileHeight) + tileHeight) % tileHeight);
        const int rows = std::min({rect.size.height - y, tileHeight - intoTile, maxRows});
        const auto band = noise.render({rect.x, row, {rect.size.width, rows}}, cancel);
        if (!band)
            return band.error();
        for (Output& output : *outputs) {
            if (const auto ok = output.write(*band, target.maps); !ok)
                return ok.error();
        }
        y += rows;
        if (progress)
            progress(static_cast<double>(y) / rect.size.height);
    }
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    BakeReport report;
    for (Output& output : *outputs) {
        if (const auto ok = output.writer.finish(); !ok)
            return ok.error();
        if (output.writer.clips())
            report.clippedShare += static_cast<double>(output.writer.clippedSamples());
    }
    if (const auto ok = together.commit(); !ok)
        return ok.error();
    const std::size_t channels = target.maps.empty() ? static_cast<std::size_t>(noise.channels())
                                                     : pictureChannelNames(target.maps).size();
    report.clippedShare /= static_cast<double>(rect.size.area()) * static_cast<double>(channels);
    return report;
}

} // namespace txn
