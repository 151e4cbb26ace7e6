// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/HistogramPanel.h"

#include "app/look/Theme.h"
#include "app/pipeline/Pipeline.h"

#include <QAreaSeries>
#include <QChart>
#include <QChartView>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <array>

namespace txn::app {
namespace {

constexpr int kMostCharts = 4;

QString channelName(qsizetype channel, qsizetype count) {
    const QStringList names{HistogramPanel::tr("Red"),
                            HistogramPanel::tr("Green"),
                            HistogramPanel::tr("Blue")};
    if (count == 1)
        return HistogramPanel::tr("Gray");
    if (count == names.size() && channel < names.size())
        return names[channel];
    return HistogramPanel::tr("Channel %1").arg(channel + 1);
}

QLineSeries* outline(const TextureAnalysis& analysis, std::size_t channel) {
    auto* series = new QLineSeries;
    const auto& bins = analysis.histograms[channel];
    const double step =
        (analysis.histogramTo - analysis.histogramFrom) / static_cast<double>(bins.size());
    QList<QPointF> points;
    points.reserve(static_cast<qsizetype>(bins.size()));
    for (std::size_t i = 0; i < bins.size(); ++i)
        points.append({analysis.histogramFrom + (static_cast<double>(i) + 0.5) * step, bins[i]});
    series->replace(points);
    return series;
}

} // namespace

HistogramPanel::HistogramPanel(Pipeline& pipeline, QWidget* parent)
    : QWidget(parent), m_pipeline(pipeline), m_legend(new QLabel) {
    setObjectName(QStringLiteral("histogramPanel"));
    m_legend->setObjectName(QStringLiteral("histogramLegend"));
    m_legend->setAlignment(Qt::AlignCenter);
    m_legend->setProperty("role", QStringLiteral("secondary"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addLayout(row, 1);
    column->addWidget(m_legend);
    for (int i = 0; i < kMostCharts; ++i) {
        auto* view = new QChartView;
        view->setObjectName(QStringLiteral("histogram%1").arg(i));
        view->setFrameShape(QFrame::NoFrame);
        view->setRenderHint(QPainter::Antialiasing);
        view->setMinimumSize(120, 96);
        view->setAccessibleName(tr("Histogram"));
        view->setToolTip(
            tr("How often each value occurs. Where the noise reaches beyond 0 or 1, its "
               "colors are clipped."));
        view->hide();
        row->addWidget(view, 1);
        m_charts.push_back(view);
    }
    connect(&m_pipeline, &Pipeline::analysisChanged, this, &HistogramPanel::showAnalysis);
    showAnalysis();
}

void HistogramPanel::showAnalysis() {
    const auto analysis = m_pipeline.analysis();
    const std::size_t channels = analysis ? analysis->exemplar.histograms.size() : 0;
    showLegend();
    m_legend->setVisible(channels > 0);
    const ThemeColors& colors = themeColors();
    for (std::size_t channel = 0; channel < m_charts.size(); ++channel) {
        QChartView& view = *m_charts[channel];
        view.setVisible(channel < channels);
        if (channel >= channels)
            continue;
        auto* chart = new QChart;
        chart->setMargins({0, 0, 0, 0});
        chart->setBackgroundBrush(Qt::NoBrush);
        chart->setTitle(
            channelName(static_cast<qsizetype>(channel), static_cast<qsizetype>(channels)));
        chart->setTitleBrush(colors.text);
        chart->legend()->hide();
        chart->setLocalizeNumbers(true);
        // The exemplar as an area; over it the noise, and the Gaussian version in dashes, since the
        // two should be the same.
        struct Line {
            const TextureAnalysis* analysis;
            QPen pen;
            bool filled;
        };
        const std::array lines{
            Line{&analysis->exemplar, Qt::NoPen, true},
            Line{&analysis->noise, QPen(colors.accent, 2.0), false},
            Line{&analysis->gaussian, QPen(colors.text, 1.25, Qt::DashLine), false}};
        double highest = 0.0;
        for (const Line& line : lines) {
            if (channel >= line.analysis->histograms.size())
                continue;
            auto* series = outline(*line.analysis, channel);
            series->setPen(line.pen);
            if (line.filled) {
                auto* area = new QAreaSeries(series);
                series->setParent(area);
                area->setPen(Qt::NoPen);
                area->setBrush(colors.groove);
                chart->addSeries(area);
            } else {
                chart->addSeries(series);
            }
            const auto& bins = line.analysis->histograms[channel];
            highest = std::max(highest, *std::max_element(bins.begin(), bins.end()));
        }
        auto* values = new QValueAxis;
        values->setRange(analysis->exemplar.histogramFrom, analysis->exemplar.histogramTo);
        values->setTickType(QValueAxis::TicksDynamic);
        values->setTickAnchor(0.0);
        values->setTickInterval(0.5);
        values->setLabelFormat(QStringLiteral("%.1f"));
        values->setLabelsColor(colors.secondary);
        values->setGridLineColor(colors.line);
        values->setLineVisible(false);
        auto* shares = new QValueAxis;
        shares->setRange(0.0, std::max(highest * 1.05, 1e-6));
        shares->setVisible(false);
        chart->addAxis(values, Qt::AlignBottom);
        chart->addAxis(shares, Qt::AlignLeft);
        for (QAbstractSeries* series : chart->series()) {
            series->attachAxis(values);
            series->attachAxis(shares);
        }
        const std::unique_ptr<QChart> old(view.chart());
        view.setChart(chart);
        view.setBackgroundBrush(Qt::NoBrush);
    }
}

void HistogramPanel::showLegend() {
    const ThemeColors& colors = themeColors();
    const auto entry = [](const QColor& color, const QString& sign, const QString& name) {
        return QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3")
            .arg(color.name(), sign, name.toHtmlEscaped());
    };
    const QString gap = QStringLiteral("&nbsp;&nbsp;&nbsp; ");
    m_legend->setText(
        entry(colors.groove, QStringLiteral("\u25a0"), tr("Exemplar")) + gap +
        entry(colors.text, QStringLiteral("\u2013&nbsp;\u2013"), tr("Gaussian version")) + gap +
        entry(colors.accent, QStringLiteral("\u2014"), tr("Noise")));
}

void HistogramPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showAnalysis();
}

} // namespace txn::app
