// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/PlaneMap.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace txn {
namespace {

/// From the middle of the picture to the centre of its middle pixel.
glm::dvec2 middleOffset(Size size) {
    const glm::ivec2 middle = middlePixel(size);
    return {middle.x + 0.5 - 0.5 * size.width, middle.y + 0.5 - 0.5 * size.height};
}

} // namespace

glm::ivec2 middlePixel(Size size) {
    return {size.width / 2, size.height / 2};
}

PlaneMap planeMap(const PlaneView& view, Size size) {
    const double cosine = std::cos(view.rotation) / view.zoom;
    const double sine = std::sin(view.rotation) / view.zoom;
    PlaneMap map;
    map.right = {cosine, -sine};
    map.down = {sine, cosine};
    const glm::dvec2 offset = middleOffset(size);
    map.middle =
        glm::dvec2(view.centerX, view.centerY) + offset.x * map.right + offset.y * map.down;
    return map;
}

GroundMap groundMap(const GroundView& view, Size size) {
    const OrbitCamera& camera = view.camera;
    const double focal = 0.5 * size.height / std::tan(0.5 * camera.fieldOfView);
    const double distance = camera.distance * focal / view.zoom;
    const double cosine = std::cos(camera.pitch);
    const double sine = std::sin(camera.pitch);
    // x and y on the ground, z up; y points down in a picture from above, so that yaw turns x
    // towards -y.
    const glm::dvec2 ahead{-std::sin(camera.yaw), -std::cos(camera.yaw)};
    const glm::dvec3 right{std::cos(camera.yaw), -std::sin(camera.yaw), 0.0};
    const glm::dvec3 forward{ahead * cosine, -sine};
    const glm::dvec3 down{-ahead * sine, -cosine};
    const glm::dvec2 eye = -ahead * (distance * cosine);
    const double height = distance * sine;

    const auto seen = [&](const glm::dvec3& direction) {
        const double fall = -direction.z;
        return glm::dvec3(eye * fall + height * glm::dvec2(direction), fall);
    };
    const glm::dvec2 offset = middleOffset(size);
    GroundMap map;
    map.base = {view.centerX, view.centerY};
    map.middle = seen(focal * forward + offset.x * right + offset.y * down);
    map.right = seen(right);
    map.down = seen(down);
    map.eye = {eye, height};
    map.fromView = {right, -down, -forward};
    return map;
}

} // namespace txn
