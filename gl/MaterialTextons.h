// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/MaterialMap.h"
#include "core/texton/Texton.h"

#include <memory>
#include <span>
#include <vector>

namespace txn {

/// A texton of a stack as NoiseRenderer shades it: the maps that light knows, in two textons of
/// four channels with the same impulses. Maps that are missing are constant: grey, flat, half
/// rough, not metal, in no shade.
struct MaterialTextons {
    std::shared_ptr<const Texton> base;   ///< encoded colour, occlusion
    std::shared_ptr<const Texton> relief; ///< two slopes, roughness, metalness
};

/// maps: of the texton's channels, not empty.
[[nodiscard]] MaterialTextons materialTextons(const Texton& texton, const MaterialMaps& maps);

/// The same of all textons of a mixture.
struct MixedMaterial {
    std::shared_ptr<const std::vector<Texton>> bases;
    std::shared_ptr<const std::vector<Texton>> reliefs;
};
[[nodiscard]] MixedMaterial mixedMaterial(std::span<const Texton> textons,
                                          const MaterialMaps& maps);

/// The channels of one map, as far as they can be drawn at a time (4).
[[nodiscard]] Texton mapTexton(const Texton& texton, const MaterialMaps& maps, std::size_t map);

} // namespace txn
