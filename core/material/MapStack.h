// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"
#include "core/material/MaterialMap.h"

namespace txn {

/// A picture of a map as it was read, and what it is.
struct MapPicture {
    std::string name; ///< of the map
    MapKind kind = MapKind::Data;
    Image image;
    std::string file; ///< for messages
};

/// Registered maps of one material as one picture of many channels.
struct MapStack {
    Image image; ///< Encoded: colors are sRGB, data as it is
    MaterialMaps maps;
};

/// Stacks the maps in the order given. Colors in linear light are encoded; normals become slopes;
/// of kinds with one channel the first one is taken where all are equal (grey stored as RGB).
/// Errors (naming the file): SizeMismatch for maps that differ in size from the first one;
/// Unsupported for a number of channels that the kind cannot have or over 16 in all;
/// InvalidArgument for two maps of one name or no map.
[[nodiscard]] Result<MapStack> stackMaps(std::vector<MapPicture> pictures);

/// One map of a stack (or of noise of its texton) as the picture that such a map is: normals are
/// unit normals again, in their own convention.
[[nodiscard]] Image mapPicture(const Image& stack, const MaterialMaps& maps, std::size_t map);

/// What stands for the whole: the picture itself where there are no maps, else the first one's.
[[nodiscard]] Image firstPicture(const Image& image, const MaterialMaps& maps);

/// The slopes in the stack turned with it, counter-clockwise as `rotated` does.
void turnSlopes(Image& stack, const MaterialMaps& maps, double degreesCounterClockwise);

/// Turns the slopes along y round, as for normals whose green points the other way, and tells so in
/// the maps.
void flipGreen(Image& stack, MaterialMaps& maps);

} // namespace txn
