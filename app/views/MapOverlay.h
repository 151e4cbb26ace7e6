// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mixing/MixingMap.h"
#include "gl/View.h"

#include <QImage>
#include <QPointF>
#include <memory>

class QPainter;

namespace txn::app {

/// The mixing map as a veil over the noise seen from above: one colour for A, another for B, the
/// border of the map as a line. In device pixels.
class MapOverlay {
  public:
    void draw(QPainter& painter,
              const std::shared_ptr<const MixingMap>& map,
              const PlaneView& view,
              QSize screen);

    /// Circles where a brush of that radius, in exemplar pixels, would paint: all of it, and its
    /// full part.
    static void drawBrush(QPainter& painter,
                          QPointF place,
                          double radius,
                          double hardness,
                          const PlaneView& view,
                          QSize screen);

  private:
    std::shared_ptr<const MixingMap> m_of;
    QImage m_veil;
};

/// Where the plane shows up on the screen.
[[nodiscard]] QPointF onScreen(const PlaneView& view, QSize screen, QPointF place);
[[nodiscard]] QPointF onPlane(const PlaneView& view, QSize screen, QPointF point);

} // namespace txn::app
