// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

#include <QByteArray>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace txn::app {

/// A mixing map (rho, 0 to 1) as steps of the undo stack keep it: 16 bits per texel, in compressed
/// tiles that copies share until a stroke changes them. Copying costs a pointer. A value that is
/// never changed in place; any thread.
class PaintedMap {
  public:
    static constexpr int kTileSide = 64;       ///< texels
    static constexpr int kStandardSide = 1024; ///< texels

    /// All A, kStandardSide wide and high.
    PaintedMap();
    /// rho: one channel, sides up to MixingMap::kMaxSide; values are taken to the nearest of 65536
    /// from 0 to 1, NaN to 0.
    [[nodiscard]] static PaintedMap fromImage(const Image& rho);

    Size size() const { return m_size; }
    /// One channel. What comes back from fromImage() is this map again.
    [[nodiscard]] Image image() const;

    /// The map with rho's texels, of which only those in dirty rectangles may differ. Tiles without
    /// a change stay shared. rho: of this map's size.
    [[nodiscard]] PaintedMap with(const Image& rho, const Rect& dirty) const {
        return with(rho, std::span(&dirty, 1));
    }
    [[nodiscard]] PaintedMap with(const Image& rho, std::span<const Rect> dirty) const;

    bool operator==(const PaintedMap& other) const;
    /// Whether (x, y) lies in a tile that both hold together. Of equal sizes.
    bool sharesTile(const PaintedMap& other, int x, int y) const;

    /// What its tiles take in memory.
    std::size_t bytes() const { return bytes(std::span(this, 1)); }
    /// What those of all the maps take, shared ones once.
    [[nodiscard]] static std::size_t bytes(std::span<const PaintedMap> maps);

    /// For project files, tile after tile; without the size.
    [[nodiscard]] QByteArray toBytes() const;
    /// Errors: Unreadable for anything but the toBytes() of a map of that size.
    [[nodiscard]] static Result<PaintedMap> fromBytes(const QByteArray& bytes, Size size);

  private:
    struct Tile;
    using Tiles = std::vector<std::shared_ptr<const Tile>>;
    struct Grid;
    PaintedMap(Size size, Tiles tiles);

    Size m_size;
    std::shared_ptr<const Tiles> m_tiles; ///< row after row
};

} // namespace txn::app
