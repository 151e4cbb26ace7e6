// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bake/Bake.h"

#include <algorithm>

namespace txn {
namespace {

/// Very wide pictures are made in bands thinner than a tile, at the price of making tiles again.
constexpr std::size_t kMaxBandSamples = std::size_t{1} << 27U;

} // namespace

Result<BakeReport> bake(const NoiseGrid& noise,
                        const Rect& rect,
                        const std::filesystem::path& path,
                        const SaveOptions& options,
                        const std::function<void(double)>& progress,
                        const CancelToken& cancel) {
    auto writer = ImageWriter::open(path, {rect.size, noise.channels(), noise.transfer()}, options);
    if (!writer)
        return writer.error();
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
        if (const auto ok = writer->writeRows(*band); !ok)
            return ok.error();
        y += rows;
        if (progress)
            progress(static_cast<double>(y) / rect.size.height);
    }
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    if (const auto ok = writer->finish(); !ok)
        return ok.error();
    const double samples =
        static_cast<double>(rect.size.area()) * static_cast<double>(noise.channels());
    return BakeReport{writer->clips() ? static_cast<double>(writer->clippedSamples()) / samples
                                      : 0.0};
}

} // namespace txn
