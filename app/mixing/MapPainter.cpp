// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mixing/MapPainter.h"

#include "app/document/ProjectDocument.h"
#include "app/pipeline/Pipeline.h"

namespace txn::app {
namespace {

/// Sooner than a screen shows it, the noise need not hear of it.
constexpr int kPublishMs = 16;

bool isGradient(PaintTool tool) {
    return tool == PaintTool::Line || tool == PaintTool::Circle;
}

Brush brushOf(const PaintTools::State& state, double mapScale) {
    Brush brush;
    brush.radius = state.radiusPx / mapScale;
    brush.hardness = state.hardness;
    brush.strength = state.strength;
    brush.target = static_cast<float>(state.target);
    brush.mode = state.tool == PaintTool::Smooth  ? BrushMode::Smooth
                 : state.tool == PaintTool::Erase ? BrushMode::Erase
                                                  : BrushMode::Paint;
    return brush;
}

} // namespace

MapPainter::MapPainter(ProjectDocument& document,
                       Pipeline& pipeline,
                       PaintTools& tools,
                       QObject* parent)
    : QObject(parent), m_document(document), m_pipeline(pipeline), m_tools(tools) {
    m_publishSoon.setSingleShot(true);
    m_publishSoon.setInterval(kPublishMs);
    connect(&m_publishSoon, &QTimer::timeout, this, &MapPainter::publish);
    // Undo, or another material: the stroke was for what is no longer there.
    connect(&m_document, &ProjectDocument::projectChanged, this, [this] {
        if (m_painting)
            cancel();
        if (!m_document.project().mix.source)
            m_lastEnd.reset();
    });
}

bool MapPainter::isReady() const {
    return m_tools.state().tool != PaintTool::Look && m_document.project().mix.source &&
           m_pipeline.mixTextons() && m_pipeline.mixingMap();
}

QPointF MapPainter::texelAt(QPointF place) const {
    const MapPlacement& p = m_map.placement;
    return {(place.x() - p.left) / p.width * m_map.rho.width(),
            (place.y() - p.top) / p.height * m_map.rho.height()};
}

void MapPainter::press(QPointF place, double pressure, bool straight) {
    if (m_painting || !isReady())
        return;
    m_painting = true;
    // The project's own: what the noise shows may be older by a moment.
    const MixSettings& mix = m_document.project().mix;
    m_map.rho = mix.map.image();
    m_map.placement = mapPlacement(mix);
    m_map.boundary = mix.repeats ? MapBoundary::Repeat : MapBoundary::Clamp;
    m_pressed = texelAt(place);
    m_dirty.clear();
    const PaintTools::State& state = m_tools.state();
    if (isGradient(state.tool))
        return;
    m_stroke.emplace(m_map.rho,
                     brushOf(state, mix.mapScale),
                     state.symmetry,
                     m_map.boundary == MapBoundary::Repeat);
    if (straight && m_lastEnd)
        mark(m_stroke->moveTo(m_lastEnd->x(), m_lastEnd->y(), pressure, m_map.rho));
    mark(m_stroke->moveTo(m_pressed.x(), m_pressed.y(), pressure, m_map.rho));
    m_lastEnd = m_pressed;
}

void MapPainter::move(QPointF place, double pressure) {
    if (!m_painting)
        return;
    const QPointF texel = texelAt(place);
    if (!m_stroke) {
        drawGradient(texel);
        return;
    }
    mark(m_stroke->moveTo(texel.x(), texel.y(), pressure, m_map.rho));
    m_lastEnd = texel;
}

/// From what the brush paints to the other end.
void MapPainter::drawGradient(QPointF to) {
    const PaintTools::State& state = m_tools.state();
    const auto from = static_cast<float>(state.target);
    const MapPoint start{m_pressed.x(), m_pressed.y()};
    const MapPoint end{to.x(), to.y()};
    if (state.tool == PaintTool::Circle)
        radialGradient(m_map.rho, start, end, from, 1.0F - from, Ease::Smooth);
    else
        linearGradient(m_map.rho, start, end, from, 1.0F - from, Ease::Smooth);
    m_dirty.clear();
    mark({Rect{0, 0, m_map.rho.size()}});
}

void MapPainter::mark(const std::vector<Rect>& dirty) {
    if (dirty.empty())
        return;
    m_dirty.insert(m_dirty.end(), dirty.begin(), dirty.end());
    if (!m_publishSoon.isActive())
        m_publishSoon.start();
}

void MapPainter::publish() {
    m_pipeline.previewMap(std::make_shared<const MixingMap>(m_map));
}

QString MapPainter::stepName() const {
    switch (m_tools.state().tool) {
    case PaintTool::Smooth:
        return tr("Smooth the map");
    case PaintTool::Erase:
        return tr("Erase in the map");
    case PaintTool::Line:
    case PaintTool::Circle:
        return tr("Gradient in the map");
    case PaintTool::Paint:
    case PaintTool::Look:
        break;
    }
    return tr("Paint in the map");
}

void MapPainter::release() {
    if (!m_painting)
        return;
    const PaintedMap after =
        m_document.project().mix.map.with(m_map.rho, std::span<const Rect>(m_dirty));
    const QString name = stepName();
    end();
    m_document.change(name, [&](Project& project) { project.mix.map = after; });
}

void MapPainter::cancel() {
    m_lastEnd.reset();
    end();
}

void MapPainter::end() {
    m_painting = false;
    m_stroke.reset();
    m_map = {};
    m_publishSoon.stop();
    // The project's own takes its place as soon as it is there.
    m_pipeline.previewMap(nullptr);
}

} // namespace txn::app
