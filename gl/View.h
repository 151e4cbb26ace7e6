// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <numbers>
#include <variant>

namespace txn {

/// The plane seen straight from above. A regular value.
struct PlaneView {
    static constexpr double kMinZoom = 1.0 / 64.0;
    static constexpr double kMaxZoom = 64.0;

    double centerX = 0.0; ///< what the middle of the picture shows, in exemplar pixels
    double centerY = 0.0;
    double zoom = 1.0;     ///< pixels of the picture per exemplar pixel
    double rotation = 0.0; ///< by how much the plane is turned, clockwise, in radians

    bool operator==(const PlaneView&) const = default;
};

/// A camera that circles what it looks at. A regular value.
struct OrbitCamera {
    static constexpr double kMinFieldOfView = 1.0 * std::numbers::pi / 180.0;
    static constexpr double kMaxFieldOfView = 150.0 * std::numbers::pi / 180.0;

    double yaw = 0.0;         ///< in radians, counterclockwise seen from above
    double pitch = 0.5;       ///< elevation above the ground, in radians, up to pi / 2
    double distance = 1.0;    ///< 1: as far as shows the object whole, or the ground at its zoom
    double fieldOfView = 0.8; ///< from the top of the picture to its bottom, in radians

    bool operator==(const OrbitCamera&) const = default;
};

/// The plane as a ground that goes on to the horizon. A regular value.
struct GroundView {
    double centerX = 0.0; ///< what the middle of the picture shows, in exemplar pixels
    double centerY = 0.0;
    double zoom = 1.0; ///< pixels of the picture per exemplar pixel there, at distance 1
    OrbitCamera camera{0.0, 0.3};
    glm::vec3 background{0.5F}; ///< above the horizon, encoded (sRGB)

    bool operator==(const GroundView&) const = default;
};

/// A mesh covered with noise, which is counted from the middle of the mesh. A regular value.
struct MeshView {
    /// TextureCoordinates: noise of the plane, laid over the mesh by its texture coordinates.
    /// Surface: surface noise, which needs none ([TN17] section 6).
    enum class Mapping { TextureCoordinates, Surface };

    Mapping mapping = Mapping::Surface;
    double pixelsPerUnit = 256.0; ///< exemplar pixels per unit of length of the mesh
    OrbitCamera camera;
    bool lighting = true;
    glm::vec3 background{0.18F}; ///< encoded (sRGB)

    bool operator==(const MeshView&) const = default;
};

using View = std::variant<PlaneView, GroundView, MeshView>;

/// For noise that is data and not colour: no light, and zero (flat, for slopes) around it.
inline void showAsData(View& view) {
    if (auto* ground = std::get_if<GroundView>(&view))
        ground->background = glm::vec3(0.0F);
    if (auto* mesh = std::get_if<MeshView>(&view)) {
        mesh->background = glm::vec3(0.0F);
        mesh->lighting = false;
    }
}

} // namespace txn
