// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/ImageIo.h"
#include "core/noise/NoiseGrid.h"

#include <functional>

namespace txn {

struct BakeReport {
    /// Samples that the format cannot hold and that were clamped (see ImageWriter), of all samples.
    double clippedShare = 0.0;
};

/// Streams a rectangle of the plane into a picture file, band by band: memory holds one row of
/// tiles, however tall the picture. progress, if given, hears the finished share, 0 to 1.
/// Errors: those of NoiseGrid::render and ImageWriter; Cancelled. No file is left behind then.
[[nodiscard]] Result<BakeReport> bake(const NoiseGrid& noise,
                                      const Rect& rect,
                                      const std::filesystem::path& path,
                                      const SaveOptions& options,
                                      const std::function<void(double)>& progress = {},
                                      const CancelToken& cancel = {});

} // namespace txn
