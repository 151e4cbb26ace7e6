// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/MeshMap.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace txn {
namespace {

constexpr double kRoom = 1.05; ///< around the object

/// From the camera to the middle of the object, at distance 1.
double fittingDistance(const OrbitCamera& camera, const BoundingSphere& bounds, Size size) {
    const double radius = std::max(1e-12, static_cast<double>(bounds.radius));
    // The object has to fit the shorter side of the picture.
    const double shorter = std::min(1.0, static_cast<double>(size.width) / size.height);
    return kRoom * radius / std::sin(std::atan(shorter * std::tan(0.5 * camera.fieldOfView)));
}

} // namespace

glm::mat4 meshToPicture(const OrbitCamera& camera,
                        const BoundingSphere& bounds,
                        Size size,
                        glm::dvec2 shift) {
    const double distance = camera.distance * fittingDistance(camera, bounds, size);
    const double radius = std::max(1e-12, static_cast<double>(bounds.radius));
    const glm::dvec3 toEye{std::cos(camera.pitch) * std::sin(camera.yaw),
                           std::sin(camera.pitch),
                           std::cos(camera.pitch) * std::cos(camera.yaw)};
    // Which way is up is clear even from straight above.
    const glm::dvec3 up{-std::sin(camera.pitch) * std::sin(camera.yaw),
                        std::cos(camera.pitch),
                        -std::sin(camera.pitch) * std::cos(camera.yaw)};
    const glm::dvec3 center(bounds.center);
    const glm::dmat4 look = glm::lookAt(center + distance * toEye, center, up);
    const glm::dmat4 lens = glm::perspective(camera.fieldOfView,
                                             static_cast<double>(size.width) / size.height,
                                             std::max(distance - 1.01 * radius, 0.01 * radius),
                                             distance + 1.01 * radius);
    // What is seen shift to the right and down has to come to the pixel's centre.
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1.0),
                       glm::dvec3(-2.0 * shift.x / size.width, 2.0 * shift.y / size.height, 0.0));
    return {moved * lens * look};
}

double picturePixelsPerUnit(const OrbitCamera& camera, const BoundingSphere& bounds, Size size) {
    return 0.5 * size.height / std::tan(0.5 * camera.fieldOfView) /
           fittingDistance(camera, bounds, size);
}

} // namespace txn
