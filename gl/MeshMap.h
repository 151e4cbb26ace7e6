// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/mesh/TriangleMesh.h"
#include "gl/View.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace txn {

/// From a mesh to OpenGL's clip space, for an orbiting camera (y is up; at yaw 0 it looks along
/// -z). shift: of the points at which pixels are seen, from their centres, in pixels, y down.
[[nodiscard]] glm::mat4
meshToPicture(const OrbitCamera& camera, const BoundingSphere& bounds, Size size, glm::dvec2 shift);

/// Pixels of the picture per unit of length at the middle of the mesh, seen from distance 1.
[[nodiscard]] double
picturePixelsPerUnit(const OrbitCamera& camera, const BoundingSphere& bounds, Size size);

} // namespace txn
