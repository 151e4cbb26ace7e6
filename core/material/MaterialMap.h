// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace txn {

/// Of an exemplar, and so of all maps of a stack together.
inline constexpr int kMaxExemplarChannels = 16;

/// What a map of a material says. Color: as light, encoded. The normal maps hold unit normals in
/// tangent space; inside a stack they are two slopes each, d height / dx and d height / dy with y
/// down. Packed: occlusion, roughness and metalness in R, G and B. The rest: one channel of data,
/// save Data, which may have any number.
enum class MapKind {
    Color,
    Normal,      ///< green points up (OpenGL)
    NormalYDown, ///< green points down (DirectX)
    Height,
    Roughness,
    Occlusion,
    Metalness,
    Packed,
    Data
};

/// One map among the channels of a stack.
struct MaterialMap {
    std::string name; ///< a short word, part of file names: "color", "normal", "height" ...
    MapKind kind = MapKind::Data;
    int channels = 1; ///< inside the stack

    bool operator==(const MaterialMap&) const = default;
};

/// The maps of a stack, one after another in its channels. Empty: a plain picture.
using MaterialMaps = std::vector<MaterialMap>;

[[nodiscard]] bool isNormal(MapKind kind);
/// Whether a map may be called that: letters, digits, '-' and '_', up to 32, and not "a" or
/// "alpha", which stand for transparency in files.
[[nodiscard]] bool isMapName(std::string_view name);
/// Whether these can be the maps of a stack of so many channels: names that may be and differ, two
/// channels for normals, none left over.
[[nodiscard]] bool areMapsOf(const MaterialMaps& maps, int channels);
/// The file of one map of a set: "stone_height.png" of "stone.png" and "height".
[[nodiscard]] std::filesystem::path mapFile(const std::filesystem::path& path,
                                            const std::string& map);
/// Channels of the map as a picture: 3 for normals, which take two in a stack.
[[nodiscard]] int pictureChannels(const MaterialMap& map);
/// Where the map's channels begin.
[[nodiscard]] int firstChannel(const MaterialMaps& maps, std::size_t map);
[[nodiscard]] int channelCount(const MaterialMaps& maps);
/// The first map of the kind, or the one of the name.
[[nodiscard]] std::optional<std::size_t> findMap(const MaterialMaps& maps, MapKind kind);
[[nodiscard]] std::optional<std::size_t> findMap(const MaterialMaps& maps, std::string_view name);
/// A name for each channel of the stack, such as "color.R", "normal.X" or "height".
[[nodiscard]] std::vector<std::string> channelNames(const MaterialMaps& maps);
/// The same of its pictures: "normal.R", "normal.G", "normal.B".
[[nodiscard]] std::vector<std::string> pictureChannelNames(const MaterialMaps& maps);

/// The usual name of the kind: "color", "normal", "normal-y-down", "height", "roughness",
/// "occlusion", "metalness", "packed", "data".
[[nodiscard]] std::string_view toString(MapKind kind);
[[nodiscard]] std::optional<MapKind> mapKindFromString(std::string_view text);

/// What a word means to artists: "albedo", "basecolor" and "diffuse" are colors, "rough" is
/// roughness, "ao" is occlusion, "disp" is height, "nor_dx" is a normal map with green down ...
/// Unset for words that say nothing.
[[nodiscard]] std::optional<MapKind> mapKindOfWord(std::string_view word);

/// The same from a file's name, by the words in it: "Grass_AmbientOcclusion_1K.png" is an
/// occlusion. The last word that says something decides; three of them make a packed map.
[[nodiscard]] std::optional<MapKind> mapKindOfFileName(std::string_view fileName);

} // namespace txn
