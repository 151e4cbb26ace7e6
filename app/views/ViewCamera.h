// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"
#include "app/views/NoiseFrame.h"

#include <QPointF>
#include <QSize>

namespace txn::app {

// How the one camera of ViewState looks at each picture. Positions on the screen are in device
// pixels from the view's top left corner, positions in a picture in its pixels, continuous.

/// The part of a picture of the given size that a view shows; its middle is that of all pictures.
[[nodiscard]] PictureWindow pictureWindow(const ViewState& view, QSize screen, Size picture);

/// The place in the picture below a point of the screen.
[[nodiscard]] QPointF pictureAt(const ViewState& view, QSize screen, Size picture, QPointF point);

/// Zooms by factor so that what is below the point stays there.
void zoomAt(ViewState& view, QSize screen, QPointF point, double factor);

/// Moves with the mouse, by so many device pixels.
void pan(ViewState& view, QPointF distance);

/// Shows a picture of the given size whole.
void fit(ViewState& view, QSize screen, Size picture);

/// What the noise's renderer has to draw.
[[nodiscard]] View noiseView(const ViewState& view, const NoiseSettings& noise, double meshRadius);

} // namespace txn::app
