// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace txn {

/// Where the light of a shaded material comes from, as the viewer sees it. A regular value.
struct Light {
    double azimuth = 0.75 * std::numbers::pi;   ///< 0: from the right; counterclockwise, in radians
    double elevation = 0.25 * std::numbers::pi; ///< above the picture, in radians, 0 to pi / 2

    /// Towards it: x to the right, y up, z to the eye.
    glm::dvec3 direction() const {
        return {std::cos(elevation) * std::cos(azimuth),
                std::cos(elevation) * std::sin(azimuth),
                std::sin(elevation)};
    }

    bool operator==(const Light&) const = default;
};

} // namespace txn
