// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/CropCanvas.h"

#include "app/look/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace txn::app {
namespace {

constexpr double kGrabPx = 6.0;
constexpr int kSmallestCropPx = 16;
constexpr double kShortestLinePx = 8.0;

} // namespace

double straighteningAngle(QPointF a, QPointF b) {
    const double degrees = std::atan2(b.y() - a.y(), b.x() - a.x()) * 180.0 / std::numbers::pi;
    // y points down: a line that falls to the right is turned back counterclockwise.
    return std::remainder(degrees, 90.0);
}

CropCanvas::CropCanvas(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

int CropCanvas::heightForWidth(int width) const {
    constexpr double kFlattest = 0.4;
    const double ratio =
        m_size.width > 0 ? static_cast<double>(m_size.height) / m_size.width : 0.75;
    return static_cast<int>(std::lround(width * std::clamp(ratio, kFlattest, 1.0)));
}

void CropCanvas::setPicture(const QImage& overview, Size size) {
    m_overview = overview;
    if (m_size != size) {
        m_size = size;
        updateGeometry();
    }
    update();
}

void CropCanvas::setCrop(const std::optional<Rect>& crop) {
    m_crop = crop;
    update();
}

void CropCanvas::setTool(Tool tool) {
    m_tool = tool;
    setCursor(tool == Tool::Straighten ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

double CropCanvas::scale() const {
    if (m_size.width <= 0 || m_size.height <= 0)
        return 1.0;
    return std::min((width() - 2.0) / m_size.width, (height() - 2.0) / m_size.height);
}

QRectF CropCanvas::pictureRect() const {
    const QSizeF size(m_size.width * scale(), m_size.height * scale());
    return {QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size};
}

QPointF CropCanvas::toPicture(QPointF position) const {
    const QPointF p = (position - pictureRect().topLeft()) / scale();
    return {std::clamp(p.x(), 0.0, static_cast<double>(m_size.width)),
            std::clamp(p.y(), 0.0, static_cast<double>(m_size.height))};
}

Rect CropCanvas::shownCrop() const {
    return m_crop.value_or(Rect{0, 0, m_size});
}

QRectF CropCanvas::onScreen(const Rect& crop) const {
    return {pictureRect().topLeft() +
                QPointF(static_cast<double>(crop.x), static_cast<double>(crop.y)) * scale(),
            QSizeF(crop.size.width, crop.size.height) * scale()};
}

CropCanvas::Grip CropCanvas::gripAt(QPointF position) const {
    Grip grip;
    const QRectF box = onScreen(shownCrop());
    if (!box.adjusted(-kGrabPx, -kGrabPx, kGrabPx, kGrabPx).contains(position))
        return grip;
    grip.left = std::abs(position.x() - box.left()) <= kGrabPx;
    grip.right = !grip.left && std::abs(position.x() - box.right()) <= kGrabPx;
    grip.top = std::abs(position.y() - box.top()) <= kGrabPx;
    grip.bottom = !grip.top && std::abs(position.y() - box.bottom()) <= kGrabPx;
    return grip;
}

void CropCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_overview.isNull()) {
        painter.fillRect(rect(), themeColors().field);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(pictureRect(), m_overview);
    if (m_crop) {
        QPainterPath outside;
        outside.addRect(pictureRect());
        outside.addRect(onScreen(*m_crop));
        painter.fillPath(outside, QColor(0, 0, 0, 140));
        const QRectF box = onScreen(*m_crop);
        painter.setPen(QPen(Qt::white, 1.0));
        painter.drawRect(box);
        painter.setBrush(Qt::white);
        for (const double x : {box.left(), box.center().x(), box.right()}) {
            for (const double y : {box.top(), box.center().y(), box.bottom()}) {
                if (QPointF(x, y) != box.center())
                    painter.drawRect(QRectF(x - 2.0, y - 2.0, 4.0, 4.0));
            }
        }
    }
    if (m_tool == Tool::Straighten && m_dragging) {
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF origin = pictureRect().topLeft();
        painter.setPen(QPen(Qt::black, 3.0));
        painter.drawLine(origin + m_from * scale(), origin + m_to * scale());
        painter.setPen(QPen(Qt::white, 1.5));
        painter.drawLine(origin + m_from * scale(), origin + m_to * scale());
    }
    if (hasFocus())
        paintFocusFrame(painter, rect());
}

void CropCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_overview.isNull())
        return;
    m_dragging = true;
    m_gesture = Gesture::next();
    m_from = m_to = toPicture(event->position());
    if (m_tool == Tool::Straighten)
        return;
    m_start = shownCrop();
    m_grip = gripAt(event->position());
    m_moving = !m_grip.any() && m_crop && onScreen(*m_crop).contains(event->position());
}

void CropCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragging) {
        if (m_tool != Tool::Crop)
            return;
        const Grip grip = gripAt(event->position());
        const bool across = grip.left || grip.right;
        const bool down = grip.top || grip.bottom;
        setCursor(across && down
                      ? (grip.left == grip.top ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor)
                  : across                                                  ? Qt::SizeHorCursor
                  : down                                                    ? Qt::SizeVerCursor
                  : m_crop && onScreen(*m_crop).contains(event->position()) ? Qt::SizeAllCursor
                                                                            : Qt::CrossCursor);
        return;
    }
    m_to = toPicture(event->position());
    if (m_tool == Tool::Straighten) {
        update();
        return;
    }
    auto left = static_cast<double>(m_start.x);
    auto top = static_cast<double>(m_start.y);
    double right = left + m_start.size.width;
    double bottom = top + m_start.size.height;
    const QPointF by = m_to - m_from;
    if (m_moving) {
        const double x = std::clamp(by.x(), -left, m_size.width - right);
        const double y = std::clamp(by.y(), -top, m_size.height - bottom);
        edit(left + x, top + y, right + x, bottom + y, m_gesture);
    } else if (m_grip.any()) {
        edit(m_grip.left ? left + by.x() : left,
             m_grip.top ? top + by.y() : top,
             m_grip.right ? right + by.x() : right,
             m_grip.bottom ? bottom + by.y() : bottom,
             m_gesture);
    } else {
        edit(std::min(m_from.x(), m_to.x()),
             std::min(m_from.y(), m_to.y()),
             std::max(m_from.x(), m_to.x()),
             std::max(m_from.y(), m_to.y()),
             m_gesture);
    }
}

void CropCanvas::edit(double left, double top, double right, double bottom, Gesture gesture) {
    const auto whole = [](double a, double b, int limit) {
        auto low = std::clamp(static_cast<int>(std::lround(std::min(a, b))), 0, limit);
        auto high = std::clamp(static_cast<int>(std::lround(std::max(a, b))), 0, limit);
        if (high - low < kSmallestCropPx) {
            high = std::min(limit, low + kSmallestCropPx);
            low = std::max(0, high - kSmallestCropPx);
        }
        return std::pair(low, high);
    };
    const auto [x0, x1] = whole(left, right, m_size.width);
    const auto [y0, y1] = whole(top, bottom, m_size.height);
    emit cropEdited({x0, y0, {x1 - x0, y1 - y0}}, gesture);
}

void CropCanvas::mouseReleaseEvent(QMouseEvent*) {
    if (!m_dragging)
        return;
    m_dragging = false;
    const QPointF line = (m_to - m_from) * scale();
    if (m_tool == Tool::Straighten && std::hypot(line.x(), line.y()) >= kShortestLinePx)
        emit lineDrawn(straighteningAngle(m_from, m_to));
    update();
}

void CropCanvas::keyPressEvent(QKeyEvent* event) {
    int x = 0;
    int y = 0;
    switch (event->key()) {
    case Qt::Key_Left:
        x = -1;
        break;
    case Qt::Key_Right:
        x = 1;
        break;
    case Qt::Key_Up:
        y = -1;
        break;
    case Qt::Key_Down:
        y = 1;
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    if (m_overview.isNull())
        return;
    // Arrows move the rectangle, with Shift its lower right corner.
    constexpr int kStep = 8;
    const Rect crop = shownCrop();
    const bool resize = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto left = static_cast<double>(crop.x);
    const auto top = static_cast<double>(crop.y);
    const double dx =
        resize ? x * kStep
               : std::clamp<double>(x * kStep, -left, m_size.width - left - crop.size.width);
    const double dy =
        resize ? y * kStep
               : std::clamp<double>(y * kStep, -top, m_size.height - top - crop.size.height);
    edit(resize ? left : left + dx,
         resize ? top : top + dy,
         left + crop.size.width + dx,
         top + crop.size.height + dy,
         m_keys.next());
}

} // namespace txn::app
