// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mixing/PaintTools.h"
#include "core/mixing/MapBrush.h"
#include "core/mixing/MixingMap.h"

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace txn::app {

class Pipeline;
class ProjectDocument;

/// Turns the movements of the mouse or pen over the plane into changes of the mixing map. The noise
/// follows while a stroke is drawn; a finished one is one step of the undo stack. Places are in
/// exemplar pixels. Interface thread.
class MapPainter : public QObject {
    Q_OBJECT

  public:
    MapPainter(ProjectDocument& document,
               Pipeline& pipeline,
               PaintTools& tools,
               QObject* parent = nullptr);

    /// Whether there is a mixture to paint and a tool to do it with.
    bool isReady() const;
    bool isPainting() const { return m_painting; }
    const PaintTools& tools() const { return m_tools; }

    /// pressure: 0 to 1. straight: on from where the last stroke ended.
    void press(QPointF place, double pressure, bool straight);
    void move(QPointF place, double pressure);
    void release();
    /// The map is as it was before the stroke.
    void cancel();

  private:
    QPointF texelAt(QPointF place) const;
    void drawGradient(QPointF to);
    void mark(const std::vector<Rect>& dirty);
    void publish();
    void end();
    QString stepName() const;

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    PaintTools& m_tools;
    QTimer m_publishSoon;

    bool m_painting = false;
    MixingMap m_map;   ///< as it will be; of a stroke only
    QPointF m_pressed; ///< texel
    std::optional<BrushStroke> m_stroke;
    std::optional<QPointF> m_lastEnd; ///< texel
    std::vector<Rect> m_dirty;
};

} // namespace txn::app
