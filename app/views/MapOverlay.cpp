// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/MapOverlay.h"

#include "app/memory/NewImage.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

/// Blue and amber: told apart by everybody, and over any material.
constexpr QRgb kFirst = 0xff2f7fd0U;
constexpr QRgb kSecond = 0xffe8a020U;
constexpr double kVeil = 0.45;
constexpr double kSmallestCopy = 8.0; ///< of a repeating map, on the screen
/// No finer than a screen shows it.
constexpr int kMostTexels = 1024;

QImage veilOf(const MixingMap& map) {
    const int step =
        std::max(1, (std::max(map.rho.width(), map.rho.height()) + kMostTexels - 1) / kMostTexels);
    QImage veil =
        newImage({(map.rho.width() + step - 1) / step, (map.rho.height() + step - 1) / step},
                 QImage::Format_RGB32);
    std::array<QRgb, 256> colors{};
    for (int i = 0; i < 256; ++i) {
        const auto mix = [i](int a, int b) { return a + (b - a) * i / 255; };
        colors[static_cast<std::size_t>(i)] = qRgb(mix(qRed(kFirst), qRed(kSecond)),
                                                   mix(qGreen(kFirst), qGreen(kSecond)),
                                                   mix(qBlue(kFirst), qBlue(kSecond)));
    }
    for (int y = 0; y < veil.height(); ++y) {
        const auto row = map.rho.row(0, y * step);
        auto* line = reinterpret_cast<QRgb*>(veil.scanLine(y));
        for (int x = 0; x < veil.width(); ++x)
            line[x] =
                colors[static_cast<std::size_t>(255.0F * row[static_cast<std::size_t>(x * step)])];
    }
    return veil;
}

} // namespace

QPointF onScreen(const PlaneView& view, QSize screen, QPointF place) {
    return {(place.x() - view.centerX) * view.zoom + screen.width() / 2.0,
            (place.y() - view.centerY) * view.zoom + screen.height() / 2.0};
}

QPointF onPlane(const PlaneView& view, QSize screen, QPointF point) {
    return {(point.x() - screen.width() / 2.0) / view.zoom + view.centerX,
            (point.y() - screen.height() / 2.0) / view.zoom + view.centerY};
}

void MapOverlay::draw(QPainter& painter,
                      const std::shared_ptr<const MixingMap>& map,
                      const PlaneView& view,
                      QSize screen) {
    if (m_of != map) {
        m_of = map;
        m_veil = veilOf(*map);
    }
    const MapPlacement& p = map->placement;
    const QPointF corner = onScreen(view, screen, {p.left, p.top});
    const QRectF place(corner, QSizeF(p.width * view.zoom, p.height * view.zoom));
    painter.save();
    painter.setOpacity(kVeil);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const bool distinct = std::min(place.width(), place.height()) >= kSmallestCopy;
    if (map->boundary == MapBoundary::Repeat && distinct) {
        // Those copies that meet the screen.
        const auto first = [](double start, double length) {
            return -static_cast<int>(std::ceil(start / length));
        };
        const auto last = [](double start, double length, int end) {
            return static_cast<int>(std::floor((end - start) / length));
        };
        for (int j = first(place.top(), place.height());
             j <= last(place.top(), place.height(), screen.height());
             ++j) {
            for (int i = first(place.left(), place.width());
                 i <= last(place.left(), place.width(), screen.width());
                 ++i)
                painter.drawImage(place.translated(i * place.width(), j * place.height()), m_veil);
        }
    } else {
        painter.drawImage(place, m_veil);
    }
    painter.setOpacity(1.0);
    painter.setPen(QPen(QColor(255, 255, 255, 160), 1.0, Qt::DashLine));
    painter.drawRect(place);
    painter.restore();
}

void MapOverlay::drawBrush(QPainter& painter,
                           QPointF place,
                           double radius,
                           double hardness,
                           const PlaneView& view,
                           QSize screen) {
    const QPointF middle = onScreen(view, screen, place);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // Light on dark, so that it is seen on any material.
    for (const auto& [color, width] :
         {std::pair{QColor(0, 0, 0, 140), 3.0}, {QColor(255, 255, 255), 1.25}}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(middle, radius * view.zoom, radius * view.zoom);
    }
    painter.setPen(QPen(QColor(255, 255, 255, 150), 1.0, Qt::DotLine));
    const double full = hardness * radius * view.zoom;
    if (full > 2.0 && hardness < 1.0)
        painter.drawEllipse(middle, full, full);
    painter.restore();
}

} // namespace txn::app
