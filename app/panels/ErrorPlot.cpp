// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/ErrorPlot.h"

#include "app/look/Theme.h"

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

namespace txn::app {

ErrorPlot::ErrorPlot(QWidget* parent)
    : QChartView(parent), m_series(new QLineSeries), m_iterations(new QValueAxis),
      m_error(new QValueAxis) {
    auto* plot = new QChart;
    plot->legend()->hide();
    plot->setLocalizeNumbers(true);
    plot->setMargins({0, 0, 0, 0});
    plot->setBackgroundRoundness(0.0);
    plot->layout()->setContentsMargins(0, 0, 0, 0);
    plot->addSeries(m_series);
    for (QValueAxis* axis : {m_iterations, m_error}) {
        axis->setTickCount(3);
        axis->setMinorTickCount(0);
        QFont small = font();
        small.setPointSizeF(small.pointSizeF() * 0.85);
        axis->setLabelsFont(small);
        axis->setTitleFont(small);
        axis->setLineVisible(false);
    }
    m_iterations->setLabelFormat(QStringLiteral("%.0f"));
    m_iterations->setTitleText(tr("Error against iterations"));
    m_error->setLabelFormat(QStringLiteral("%.2f"));
    m_error->setRange(0.0, 1.0);
    plot->addAxis(m_iterations, Qt::AlignBottom);
    plot->addAxis(m_error, Qt::AlignLeft);
    m_series->attachAxis(m_iterations);
    m_series->attachAxis(m_error);
    setChart(plot);
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setFixedHeight(136);
    setFocusPolicy(Qt::NoFocus);
    applyColors();
}

void ErrorPlot::showCurve(const std::vector<ErrorPoint>& curve, int iterations) {
    QList<QPointF> points;
    points.reserve(static_cast<qsizetype>(curve.size()));
    double lowest = curve.empty() ? 0.0 : curve.front().error;
    double highest = curve.empty() ? 1.0 : lowest;
    for (const ErrorPoint& point : curve) {
        points.append({static_cast<double>(point.iteration), point.error});
        lowest = std::min(lowest, point.error);
        highest = std::max(highest, point.error);
    }
    m_series->replace(points);
    m_iterations->setRange(0.0, std::max(1, iterations));
    // Whole tenths around the curve, so that it does not jump about while it grows.
    const double low = std::max(0.0, std::floor(10.0 * lowest - 0.2) / 10.0);
    m_error->setRange(low, std::max(low + 0.2, std::ceil(10.0 * highest + 0.2) / 10.0));
}

void ErrorPlot::applyColors() {
    const ThemeColors& colors = themeColors();
    chart()->setBackgroundBrush(Qt::NoBrush);
    setBackgroundBrush(Qt::NoBrush);
    m_series->setPen(QPen(colors.accent, 2.0));
    for (QValueAxis* axis : {m_iterations, m_error}) {
        axis->setLabelsColor(colors.secondary);
        axis->setTitleBrush(colors.secondary);
        axis->setGridLineColor(colors.line);
    }
}

void ErrorPlot::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        applyColors();
}

} // namespace txn::app
