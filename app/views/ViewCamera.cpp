// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/ViewCamera.h"

#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

constexpr double kFarthest = NoiseParams::kFarthest / 4.0;
/// Noise pixels from one side of a mesh to the other, at scale 1.
constexpr double kPixelsAcrossMesh = 512.0;

} // namespace

PictureWindow pictureWindow(const ViewState& view, QSize screen, Size picture) {
    PictureWindow window;
    window.size = screen;
    window.zoom = view.zoom;
    window.left = picture.width / 2.0 + view.centerX - screen.width() / (2.0 * view.zoom);
    window.top = picture.height / 2.0 + view.centerY - screen.height() / (2.0 * view.zoom);
    // Whole pixels, so that 100 % is exact and pixels are as wide as their neighbours.
    window.left = std::round(window.left * view.zoom) / view.zoom;
    window.top = std::round(window.top * view.zoom) / view.zoom;
    return window;
}

QPointF pictureAt(const ViewState& view, QSize screen, Size picture, QPointF point) {
    const PictureWindow window = pictureWindow(view, screen, picture);
    return QPointF(window.left, window.top) + point / view.zoom;
}

void zoomAt(ViewState& view, QSize screen, QPointF point, double factor) {
    const double zoom = std::clamp(view.zoom * factor, ViewState::kMinZoom, ViewState::kMaxZoom);
    const QPointF fromMiddle = point - QPointF(screen.width() / 2.0, screen.height() / 2.0);
    const QPointF shift = fromMiddle / view.zoom - fromMiddle / zoom;
    view.centerX += shift.x();
    view.centerY += shift.y();
    view.zoom = zoom;
}

void pan(ViewState& view, QPointF distance) {
    view.centerX = std::clamp(view.centerX - distance.x() / view.zoom, -kFarthest, kFarthest);
    view.centerY = std::clamp(view.centerY - distance.y() / view.zoom, -kFarthest, kFarthest);
}

void fit(ViewState& view, QSize screen, Size picture) {
    view.centerX = 0.0;
    view.centerY = 0.0;
    const double zoom = std::min(static_cast<double>(screen.width()) / picture.width,
                                 static_cast<double>(screen.height()) / picture.height);
    view.zoom = std::clamp(zoom, ViewState::kMinZoom, ViewState::kMaxZoom);
}

View noiseView(const ViewState& view, const NoiseSettings& noise, double meshRadius) {
    const double zoom =
        std::clamp(view.zoom * noise.scale, PlaneView::kMinZoom, PlaneView::kMaxZoom);
    switch (noise.scene) {
    case NoiseScene::Plane:
        return PlaneView{view.centerX / noise.scale, view.centerY / noise.scale, zoom, 0.0};
    case NoiseScene::Perspective: {
        GroundView ground;
        ground.centerX = view.centerX / noise.scale;
        ground.centerY = view.centerY / noise.scale;
        ground.zoom = zoom;
        ground.camera.yaw = view.yaw;
        ground.camera.pitch = std::clamp(view.pitch, 0.02, 1.57);
        return ground;
    }
    case NoiseScene::Mesh:
    case NoiseScene::Surface:
        break;
    }
    MeshView mesh;
    mesh.mapping = noise.scene == NoiseScene::Mesh ? MeshView::Mapping::TextureCoordinates
                                                   : MeshView::Mapping::Surface;
    mesh.pixelsPerUnit = kPixelsAcrossMesh / (2.0 * std::max(meshRadius, 1e-6) * noise.scale);
    mesh.camera.yaw = view.yaw;
    mesh.camera.pitch = view.pitch;
    mesh.camera.distance = view.distance;
    mesh.lighting = noise.lighting;
    mesh.background = {0.463F, 0.463F, 0.463F};
    return mesh;
}

} // namespace txn::app
