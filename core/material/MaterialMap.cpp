// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/MaterialMap.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <utility>

namespace txn {
namespace {

constexpr std::array<std::pair<std::string_view, MapKind>, 9> kKinds{{
    {"color", MapKind::Color},
    {"normal", MapKind::Normal},
    {"normal-y-down", MapKind::NormalYDown},
    {"height", MapKind::Height},
    {"roughness", MapKind::Roughness},
    {"occlusion", MapKind::Occlusion},
    {"metalness", MapKind::Metalness},
    {"packed", MapKind::Packed},
    {"data", MapKind::Data},
}};

/// In small letters, without anything between them.
constexpr std::array<std::pair<std::string_view, MapKind>, 41> kWords{{
    {"color", MapKind::Color},
    {"colour", MapKind::Color},
    {"col", MapKind::Color},
    {"albedo", MapKind::Color},
    {"basecolor", MapKind::Color},
    {"basecolour", MapKind::Color},
    {"base", MapKind::Color},
    {"diffuse", MapKind::Color},
    {"diff", MapKind::Color},
    {"normal", MapKind::Normal},
    {"normals", MapKind::Normal},
    {"normalgl", MapKind::Normal},
    {"nor", MapKind::Normal},
    {"norgl", MapKind::Normal},
    {"nrm", MapKind::Normal},
    {"norm", MapKind::Normal},
    {"normalydown", MapKind::NormalYDown},
    {"normaldx", MapKind::NormalYDown},
    {"nordx", MapKind::NormalYDown},
    {"normaldirectx", MapKind::NormalYDown},
    {"height", MapKind::Height},
    {"heightmap", MapKind::Height},
    {"displacement", MapKind::Height},
    {"disp", MapKind::Height},
    {"depth", MapKind::Height},
    {"roughness", MapKind::Roughness},
    {"rough", MapKind::Roughness},
    {"rgh", MapKind::Roughness},
    {"occlusion", MapKind::Occlusion},
    {"ambientocclusion", MapKind::Occlusion},
    {"ambient", MapKind::Occlusion},
    {"ao", MapKind::Occlusion},
    {"occ", MapKind::Occlusion},
    {"metalness", MapKind::Metalness},
    {"metallic", MapKind::Metalness},
    {"metal", MapKind::Metalness},
    {"mtl", MapKind::Metalness},
    {"packed", MapKind::Packed},
    {"orm", MapKind::Packed},
    {"arm", MapKind::Packed},
    {"aorm", MapKind::Packed},
}};

std::string letters(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

/// "GrassAmbientOcclusion_1K-GL" as "grass", "ambient", "occlusion", "k", "gl".
std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words(1);
    bool wasLower = false;
    for (const char c : text) {
        const auto letter = static_cast<unsigned char>(c);
        const bool upper = std::isupper(letter) != 0;
        if (std::isalpha(letter) == 0 || (upper && wasLower))
            words.emplace_back();
        if (std::isalpha(letter) != 0)
            words.back() += static_cast<char>(std::tolower(letter));
        wasLower = std::islower(letter) != 0;
    }
    std::erase(words, "");
    return words;
}

} // namespace

bool isNormal(MapKind kind) {
    return kind == MapKind::Normal || kind == MapKind::NormalYDown;
}

bool isMapName(std::string_view name) {
    constexpr std::size_t kLongest = 32;
    return !name.empty() && name.size() <= kLongest && letters(name) != "a" &&
           letters(name) != "alpha" && std::ranges::all_of(name, [](unsigned char c) {
               return std::isalnum(c) != 0 || c == '-' || c == '_';
           });
}

bool areMapsOf(const MaterialMaps& maps, int channels) {
    for (auto it = maps.begin(); it != maps.end(); ++it) {
        const bool repeated = std::any_of(maps.begin(), it, [&](const MaterialMap& other) {
            return other.name == it->name;
        });
        if (repeated || !isMapName(it->name) || it->channels < 1 ||
            (isNormal(it->kind) && it->channels != 2))
            return false;
    }
    return channelCount(maps) == channels;
}

std::filesystem::path mapFile(const std::filesystem::path& path, const std::string& map) {
    std::filesystem::path result = path;
    result.replace_filename(path.stem().string() + "_" + map + path.extension().string());
    return result;
}

int pictureChannels(const MaterialMap& map) {
    return isNormal(map.kind) ? 3 : map.channels;
}

int firstChannel(const MaterialMaps& maps, std::size_t map) {
    return std::accumulate(maps.begin(),
                           maps.begin() + static_cast<std::ptrdiff_t>(map),
                           0,
                           [](int sum, const MaterialMap& m) { return sum + m.channels; });
}

int channelCount(const MaterialMaps& maps) {
    return firstChannel(maps, maps.size());
}

namespace {

template <class Test>
std::optional<std::size_t> indexOf(const MaterialMaps& maps, Test test) {
    const auto it = std::find_if(maps.begin(), maps.end(), test);
    return it == maps.end() ? std::nullopt
                            : std::optional(static_cast<std::size_t>(it - maps.begin()));
}

} // namespace

std::optional<std::size_t> findMap(const MaterialMaps& maps, MapKind kind) {
    return indexOf(maps, [kind](const MaterialMap& map) { return map.kind == kind; });
}

std::optional<std::size_t> findMap(const MaterialMaps& maps, std::string_view name) {
    return indexOf(maps, [name](const MaterialMap& map) { return map.name == name; });
}

namespace {

void addNames(const std::string& map,
              int channels,
              const char* letters3,
              std::vector<std::string>& to) {
    for (int c = 0; c < channels; ++c) {
        if (channels == 1)
            to.push_back(map);
        else if (channels <= 3)
            to.push_back(map + "." + letters3[c]);
        else
            to.push_back(map + ".ch" + std::to_string(c));
    }
}

} // namespace

std::vector<std::string> channelNames(const MaterialMaps& maps) {
    std::vector<std::string> names;
    for (const MaterialMap& map : maps)
        addNames(map.name, map.channels, isNormal(map.kind) ? "XY" : "RGB", names);
    return names;
}

std::vector<std::string> pictureChannelNames(const MaterialMaps& maps) {
    std::vector<std::string> names;
    for (const MaterialMap& map : maps)
        addNames(map.name, pictureChannels(map), "RGB", names);
    return names;
}

std::string_view toString(MapKind kind) {
    return kKinds[static_cast<std::size_t>(kind)].first;
}

std::optional<MapKind> mapKindFromString(std::string_view text) {
    const auto* it = std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& known) {
        return known.first == text;
    });
    return it == kKinds.end() ? std::nullopt : std::optional(it->second);
}

std::optional<MapKind> mapKindOfWord(std::string_view word) {
    const std::string plain = letters(word);
    const auto* it = std::find_if(kWords.begin(), kWords.end(), [&](const auto& known) {
        return known.first == plain;
    });
    return it == kWords.end() ? std::nullopt : std::optional(it->second);
}

std::optional<MapKind> mapKindOfFileName(std::string_view fileName) {
    const auto dot = fileName.rfind('.');
    const auto words = wordsOf(fileName.substr(0, dot));
    std::vector<MapKind> found;
    bool directX = false;
    for (const std::string& word : words) {
        directX = directX || word == "dx" || word == "directx";
        if (const auto kind = mapKindOfWord(word); kind && (found.empty() || found.back() != *kind))
            found.push_back(*kind);
    }
    if (found.empty())
        return std::nullopt;
    const auto has = [&](MapKind kind) { return std::ranges::find(found, kind) != found.end(); };
    if (has(MapKind::Occlusion) && has(MapKind::Roughness) && has(MapKind::Metalness))
        return MapKind::Packed;
    if (found.back() == MapKind::Normal && directX)
        return MapKind::NormalYDown;
    return found.back();
}

} // namespace txn
