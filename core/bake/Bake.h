// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/ImageIo.h"
#include "core/material/MaterialMap.h"
#include "core/noise/NoiseGrid.h"

#include <functional>

namespace txn {

/// Where noise goes.
struct BakeTarget {
    std::filesystem::path path;
    SaveOptions options;
    /// Of noise of a stack: then an EXR has a layer for each map, and of other types there is a
    /// file for each, named like path plus "_" and the map's name.
    MaterialMaps maps;
};

/// The files that the target consists of.
[[nodiscard]] std::vector<std::filesystem::path> bakeFiles(const BakeTarget& target);

struct BakeReport {
    /// Samples that the format cannot hold and that were clamped (see ImageWriter), of all samples.
    double clippedShare = 0.0;
};

/// Streams a rectangle of the plane into one or several picture files that appear together, band by
/// band: memory holds one row of tiles, however tall the picture. progress, if given, hears the
/// finished share, 0 to 1.
/// Errors: those of NoiseGrid::render and ImageWriter; Cancelled. No file is left behind then.
[[nodiscard]] Result<BakeReport> bake(const NoiseGrid& noise,
                                      const Rect& rect,
                                      const BakeTarget& target,
                                      const std::function<void(double)>& progress = {},
                                      const CancelToken& cancel = {});

} // namespace txn
