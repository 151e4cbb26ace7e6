// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "gl/View.h"

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace txn {

/// The pixel from whose centre others are counted, so that steps are small and whole.
[[nodiscard]] glm::ivec2 middlePixel(Size size);

/// Where pixels of a picture of the given size, y down, lie on the plane, for a plane view.
struct PlaneMap {
    glm::dvec2 middle; ///< what the centre of middlePixel() shows, in exemplar pixels
    glm::dvec2 right;  ///< from a pixel to its right neighbour
    glm::dvec2 down;   ///< from a pixel to the one below
};
[[nodiscard]] PlaneMap planeMap(const PlaneView& view, Size size);

/// For a ground view: a pixel n steps from middlePixel() sees the point base + q.xy / q.z,
/// q = middle + n.x right + n.y down; the sky where q.z <= 0.
struct GroundMap {
    glm::dvec2 base; ///< in exemplar pixels
    glm::dvec3 middle;
    glm::dvec3 right;
    glm::dvec3 down;
    glm::dvec3 eye;      ///< in exemplar pixels from the base: x, y and height
    glm::dmat3 fromView; ///< from what is to the right, up and towards the eye to x, y and height
};
[[nodiscard]] GroundMap groundMap(const GroundView& view, Size size);

} // namespace txn
