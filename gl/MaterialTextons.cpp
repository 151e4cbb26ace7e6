// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/MaterialTextons.h"

#include <algorithm>
#include <array>

namespace txn {
namespace {

/// Of the map's channels the given one, or a constant.
ChannelSource source(const MaterialMaps& maps, MapKind kind, int channel, double otherwise) {
    const auto map = findMap(maps, kind);
    if (!map)
        return {std::nullopt, otherwise};
    return {firstChannel(maps, *map) + std::min(channel, maps[*map].channels - 1), otherwise};
}

/// Of a map of its own, or of a packed one.
ChannelSource
sourceOrPacked(const MaterialMaps& maps, MapKind kind, int packedChannel, double otherwise) {
    return findMap(maps, kind) ? source(maps, kind, 0, otherwise)
                               : source(maps, MapKind::Packed, packedChannel, otherwise);
}

} // namespace

MaterialTextons materialTextons(const Texton& texton, const MaterialMaps& maps) {
    constexpr double kGrey = 0.5;
    constexpr double kHalfRough = 0.6;
    const MapKind normal = findMap(maps, MapKind::Normal) ? MapKind::Normal : MapKind::NormalYDown;
    const std::array base{source(maps, MapKind::Color, 0, kGrey),
                          source(maps, MapKind::Color, 1, kGrey),
                          source(maps, MapKind::Color, 2, kGrey),
                          sourceOrPacked(maps, MapKind::Occlusion, 0, 1.0)};
    const std::array relief{source(maps, normal, 0, 0.0),
                            source(maps, normal, 1, 0.0),
                            sourceOrPacked(maps, MapKind::Roughness, 1, kHalfRough),
                            sourceOrPacked(maps, MapKind::Metalness, 2, 0.0)};
    return {std::make_shared<const Texton>(withChannels(texton, base)),
            std::make_shared<const Texton>(withChannels(texton, relief))};
}

MixedMaterial mixedMaterial(std::span<const Texton> textons, const MaterialMaps& maps) {
    std::vector<Texton> bases;
    std::vector<Texton> reliefs;
    for (const Texton& texton : textons) {
        const MaterialTextons material = materialTextons(texton, maps);
        bases.push_back(*material.base);
        reliefs.push_back(*material.relief);
    }
    return {std::make_shared<const std::vector<Texton>>(std::move(bases)),
            std::make_shared<const std::vector<Texton>>(std::move(reliefs))};
}

Texton mapTexton(const Texton& texton, const MaterialMaps& maps, std::size_t map) {
    constexpr int kMostDrawn = 4;
    std::vector<ChannelSource> channels;
    const int count = std::min(maps[map].channels, kMostDrawn);
    channels.reserve(static_cast<std::size_t>(count));
    for (int c = 0; c < count; ++c)
        channels.push_back({firstChannel(maps, map) + c, 0.0});
    return withChannels(texton, channels);
}

} // namespace txn
