// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/PaintedMap.h"

#include "core/mixing/MixingMap.h"

#include <QtEndian>
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <tbb/parallel_for.h>
#include <unordered_set>
#include <utility>

namespace txn::app {
namespace {

using Texels = std::vector<std::uint16_t>;

constexpr double kLargest = 65535.0;

std::uint16_t stored(float rho) {
    // NaN is not above 0.
    const double value = rho > 0.0F ? std::min(static_cast<double>(rho), 1.0) : 0.0;
    const double nearest = kLargest * value + 0.5; // once truncated
    return static_cast<std::uint16_t>(nearest);
}

float shown(std::uint16_t value) {
    return static_cast<float>(value / kLargest);
}

/// What a texel is most likely to be, by those before it: exact on slopes. Modulo 65536.
std::uint16_t predicted(const std::uint16_t* texel, int x, int y, int width) {
    const int left = x > 0 ? texel[-1] : 0;
    const int above = y > 0 ? texel[-width] : 0;
    if (x == 0 || y == 0)
        return static_cast<std::uint16_t>(left + above);
    return static_cast<std::uint16_t>(left + above - texel[-width - 1]);
}

/// Small differences of either sign as small numbers: 0, -1, 1, -2, ...
std::uint16_t folded(std::uint16_t difference) {
    const unsigned twice = 2U * difference;
    return static_cast<std::uint16_t>(difference < 0x8000U ? twice : ~twice);
}

std::uint16_t unfolded(std::uint16_t number) {
    const unsigned half = number / 2U;
    return static_cast<std::uint16_t>(number % 2U == 0U ? half : ~half);
}

/// High bytes of what is unexpected, then low ones, which compress worse.
QByteArray compressed(const Texels& texels, int width) {
    const auto count = static_cast<qsizetype>(texels.size());
    QByteArray raw(2 * count, Qt::Uninitialized);
    char* out = raw.data();
    for (qsizetype i = 0; i < count; ++i) {
        const std::uint16_t* texel = texels.data() + i;
        const int x = static_cast<int>(i) % width;
        const int y = static_cast<int>(i) / width;
        const std::uint16_t number =
            folded(static_cast<std::uint16_t>(*texel - predicted(texel, x, y, width)));
        out[i] = static_cast<char>(number >> 8U);
        out[count + i] = static_cast<char>(number & 0xffU);
    }
    return qCompress(raw, 1);
}

/// Nothing where the bytes are not those of so many texels.
std::optional<Texels> decompressed(const QByteArray& bytes, Size size) {
    const auto count = static_cast<qsizetype>(size.area());
    // qUncompress trusts the length at the start.
    if (bytes.size() < 4 ||
        qFromBigEndian<quint32>(bytes.constData()) != static_cast<quint32>(2 * count))
        return {};
    const QByteArray raw = qUncompress(bytes);
    if (raw.size() != 2 * count)
        return {};
    Texels texels(size.area());
    const auto* in = reinterpret_cast<const unsigned char*>(raw.constData());
    std::uint16_t* texel = texels.data();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, ++texel, ++in)
            *texel = static_cast<std::uint16_t>(
                predicted(texel, x, y, size.width) +
                unfolded(static_cast<std::uint16_t>(in[0] << 8U | in[count])));
    }
    return texels;
}

} // namespace

/// All texels alike, or compressed ones.
struct PaintedMap::Tile {
    std::uint16_t value = 0;
    QByteArray bytes; ///< empty: all are value

    static std::shared_ptr<const Tile> of(const Texels& texels, int width) {
        const std::uint16_t first = texels.front();
        if (std::ranges::all_of(texels, [first](auto v) { return v == first; }))
            return std::make_shared<const Tile>(Tile{first, {}});
        return std::make_shared<const Tile>(Tile{0, compressed(texels, width)});
    }
    /// size: the tile's. Its bytes were made or checked here.
    Texels texels(Size size) const {
        return bytes.isEmpty() ? Texels(size.area(), value) : *decompressed(bytes, size);
    }
    bool holds(const Texels& other, Size size) const {
        if (bytes.isEmpty())
            return std::ranges::all_of(other, [this](auto v) { return v == value; });
        return texels(size) == other;
    }
};

/// Where the tiles of a map lie.
struct PaintedMap::Grid {
    explicit Grid(Size map)
        : size(map), columns((map.width + kTileSide - 1) / kTileSide),
          rows((map.height + kTileSide - 1) / kTileSide) {}

    int count() const { return columns * rows; }
    int left(int tile) const { return tile % columns * kTileSide; }
    int top(int tile) const { return tile / columns * kTileSide; }
    /// Those at the right and at the bottom may be smaller.
    Size sizeOf(int tile) const {
        return {std::min(kTileSide, size.width - left(tile)),
                std::min(kTileSide, size.height - top(tile))};
    }
    Texels texels(const Image& rho, int tile) const {
        const Size part = sizeOf(tile);
        Texels texels(part.area());
        auto out = texels.begin();
        for (int y = 0; y < part.height; ++y) {
            const auto row = rho.row(0, top(tile) + y)
                                 .subspan(static_cast<std::size_t>(left(tile)),
                                          static_cast<std::size_t>(part.width));
            out = std::ranges::transform(row, out, stored).out;
        }
        return texels;
    }
    bool meets(int tile, const Rect& rect) const {
        const Size part = sizeOf(tile);
        return rect.size.width > 0 && rect.size.height > 0 && rect.x < left(tile) + part.width &&
               rect.x + rect.size.width > left(tile) && rect.y < top(tile) + part.height &&
               rect.y + rect.size.height > top(tile);
    }

    Size size;
    int columns;
    int rows;
};

PaintedMap::PaintedMap(Size size, Tiles tiles)
    : m_size(size), m_tiles(std::make_shared<const Tiles>(std::move(tiles))) {}

PaintedMap::PaintedMap()
    : PaintedMap({kStandardSide, kStandardSide},
                 Tiles(static_cast<std::size_t>(Grid({kStandardSide, kStandardSide}).count()),
                       std::make_shared<const Tile>())) {}

PaintedMap PaintedMap::fromImage(const Image& rho) {
    assert(rho.channels() == 1);
    const Grid grid(rho.size());
    Tiles tiles(static_cast<std::size_t>(grid.count()));
    tbb::parallel_for(0, grid.count(), [&](int tile) {
        tiles[static_cast<std::size_t>(tile)] =
            Tile::of(grid.texels(rho, tile), grid.sizeOf(tile).width);
    });
    return {rho.size(), std::move(tiles)};
}

Image PaintedMap::image() const {
    const Grid grid(m_size);
    Image rho(m_size, 1);
    tbb::parallel_for(0, grid.count(), [&](int tile) {
        const Size part = grid.sizeOf(tile);
        const auto& from = *(*m_tiles)[static_cast<std::size_t>(tile)];
        const Texels texels = from.texels(part);
        const std::uint16_t* in = texels.data();
        for (int y = 0; y < part.height; ++y, in += part.width)
            std::transform(in,
                           in + part.width,
                           rho.row(0, grid.top(tile) + y).data() + grid.left(tile),
                           shown);
    });
    return rho;
}

PaintedMap PaintedMap::with(const Image& rho, std::span<const Rect> dirty) const {
    assert(rho.size() == m_size && rho.channels() == 1);
    const Grid grid(m_size);
    Tiles tiles = *m_tiles;
    tbb::parallel_for(0, grid.count(), [&](int tile) {
        if (std::ranges::none_of(dirty, [&](const Rect& r) { return grid.meets(tile, r); }))
            return;
        auto& kept = tiles[static_cast<std::size_t>(tile)];
        const Texels texels = grid.texels(rho, tile);
        const Size part = grid.sizeOf(tile);
        if (!kept->holds(texels, part))
            kept = Tile::of(texels, part.width);
    });
    return tiles == *m_tiles ? *this : PaintedMap(m_size, std::move(tiles));
}

bool PaintedMap::operator==(const PaintedMap& other) const {
    if (m_size != other.m_size)
        return false;
    if (m_tiles == other.m_tiles)
        return true;
    const Grid grid(m_size);
    for (int tile = 0; tile < grid.count(); ++tile) {
        const auto& a = (*m_tiles)[static_cast<std::size_t>(tile)];
        const auto& b = (*other.m_tiles)[static_cast<std::size_t>(tile)];
        const bool same = a == b || (a->value == b->value && a->bytes == b->bytes);
        // Other versions of zlib may have made other bytes.
        if (!same && !a->holds(b->texels(grid.sizeOf(tile)), grid.sizeOf(tile)))
            return false;
    }
    return true;
}

bool PaintedMap::sharesTile(const PaintedMap& other, int x, int y) const {
    assert(m_size == other.m_size && x >= 0 && x < m_size.width && y >= 0 && y < m_size.height);
    const auto tile =
        static_cast<std::size_t>(y / kTileSide * Grid(m_size).columns + x / kTileSide);
    return (*m_tiles)[tile] == (*other.m_tiles)[tile];
}

std::size_t PaintedMap::bytes(std::span<const PaintedMap> maps) {
    std::unordered_set<const void*> seen;
    std::size_t sum = 0;
    for (const PaintedMap& map : maps) {
        if (!seen.insert(map.m_tiles.get()).second)
            continue;
        sum += map.m_tiles->size() * sizeof(map.m_tiles->front());
        for (const auto& tile : *map.m_tiles) {
            if (seen.insert(tile.get()).second)
                sum += sizeof(Tile) + static_cast<std::size_t>(tile->bytes.size());
        }
    }
    return sum;
}

// For each tile the number of its bytes and these, or 0 and the value of all its texels: numbers of
// 16 bits, little endian.

QByteArray PaintedMap::toBytes() const {
    QByteArray out;
    const auto append = [&out](quint16 number) {
        out.append(static_cast<char>(number & 0xffU));
        out.append(static_cast<char>(number >> 8U));
    };
    for (const auto& tile : *m_tiles) {
        append(static_cast<quint16>(tile->bytes.size()));
        if (tile->bytes.isEmpty())
            append(tile->value);
        out.append(tile->bytes);
    }
    return out;
}

Result<PaintedMap> PaintedMap::fromBytes(const QByteArray& bytes, Size size) {
    const Error damaged{ErrorCode::Unreadable, "damaged: the mixing map is not whole"};
    if (size.width < 1 || size.height < 1 || size.width > MixingMap::kMaxSide ||
        size.height > MixingMap::kMaxSide)
        return damaged;
    const Grid grid(size);
    // Whatever a tile holds, zlib adds a few bytes at most; more may be a bomb.
    constexpr qsizetype kOverhead = 32;
    qsizetype at = 0;
    const auto number = [&]() -> std::optional<quint16> {
        if (bytes.size() - at < 2)
            return {};
        at += 2;
        return qFromLittleEndian<quint16>(bytes.constData() + at - 2);
    };
    Tiles tiles;
    for (int tile = 0; tile < grid.count(); ++tile) {
        const auto length = number();
        const auto value = length == 0 ? number() : 0;
        if (!length || !value || *length > bytes.size() - at ||
            *length > static_cast<qsizetype>(2 * grid.sizeOf(tile).area()) + kOverhead)
            return damaged;
        tiles.push_back(std::make_shared<const Tile>(Tile{*value, bytes.mid(at, *length)}));
        at += *length;
        if (*length > 0 && !decompressed(tiles.back()->bytes, grid.sizeOf(tile)))
            return damaged;
    }
    if (at != bytes.size())
        return damaged;
    return PaintedMap(size, std::move(tiles));
}

} // namespace txn::app
