// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/SliderTrack.h"

#include "app/look/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

constexpr double kHalfHandle = 5.0;
constexpr double kSnapPx = 5.0;
constexpr double kFine = 0.1;
constexpr double kKeyStep = 0.01;
constexpr double kPageStep = 0.1;
constexpr double kWheelStep = 0.02;

} // namespace

SliderTrack::SliderTrack(ValueSlider& slider) : QWidget(&slider), m_slider(slider) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double SliderTrack::share(double value) const {
    const auto& range = m_slider.range();
    const double v = std::clamp(value, range.low, range.high);
    if (range.scale == ValueSlider::Scale::Logarithmic)
        return std::log(v / range.low) / std::log(range.high / range.low);
    return (v - range.low) / (range.high - range.low);
}

double SliderTrack::valueOfShare(double share) const {
    const auto& range = m_slider.range();
    const double s = std::clamp(share, 0.0, 1.0);
    if (range.scale == ValueSlider::Scale::Logarithmic)
        return range.low * std::pow(range.high / range.low, s);
    return range.low + s * (range.high - range.low);
}

double SliderTrack::position(double value) const {
    const double s = isRightToLeft() ? 1.0 - share(value) : share(value);
    return kHalfHandle + s * (width() - 2.0 * kHalfHandle);
}

double SliderTrack::valueAt(double x) const {
    const double s = (x - kHalfHandle) / std::max(1.0, width() - 2.0 * kHalfHandle);
    return valueOfShare(isRightToLeft() ? 1.0 - s : s);
}

double SliderTrack::snapped(double value) const {
    for (const double stop : m_slider.range().stops) {
        if (std::abs(position(stop) - position(value)) <= kSnapPx)
            return stop;
    }
    return value;
}

void SliderTrack::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = themeColors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const double at = position(m_slider.value());
    // Where both signs are possible, the bar starts at 0.
    const double start = position(std::max(m_slider.range().low, 0.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(isEnabled() ? colors.groove : colors.line);
    painter.drawRoundedRect(QRectF(kHalfHandle, middle - 2.0, width() - 2.0 * kHalfHandle, 4.0),
                            2.0,
                            2.0);
    const QColor accent = isEnabled() ? colors.accent : colors.line;
    painter.setBrush(accent);
    painter.drawRoundedRect(QRectF(std::min(start, at), middle - 2.0, std::abs(at - start), 4.0),
                            2.0,
                            2.0);
    painter.setBrush(colors.secondary);
    for (const double stop : m_slider.range().stops)
        painter.drawRect(QRectF(position(stop) - 0.5, middle + 5.0, 1.0, 3.0));
    painter.setBrush(isEnabled() ? colors.text : colors.secondary);
    painter.drawEllipse(QPointF(at, middle), 5.0, 5.0);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colors.accent, 2.0));
        painter.drawEllipse(QPointF(at, middle), 7.0, 7.0);
    }
}

void SliderTrack::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    m_dragging = true;
    m_gesture = Gesture::next();
    m_lastX = event->position().x();
    // A press on the handle picks it up; elsewhere the handle comes to the mouse.
    if (std::abs(m_lastX - position(m_slider.value())) > kHalfHandle + 1.0)
        m_slider.edit(snapped(valueAt(m_lastX)), m_gesture);
    m_dragShare = share(m_slider.value());
}

void SliderTrack::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragging)
        return;
    const double x = event->position().x();
    const bool fine = event->modifiers().testFlag(Qt::ShiftModifier);
    double step = (x - m_lastX) / std::max(1.0, width() - 2.0 * kHalfHandle);
    if (isRightToLeft())
        step = -step;
    m_dragShare += fine ? kFine * step : step;
    m_lastX = x;
    const double value = valueOfShare(m_dragShare);
    m_slider.edit(fine ? value : snapped(value), m_gesture);
}

void SliderTrack::mouseReleaseEvent(QMouseEvent*) {
    m_dragging = false;
}

void SliderTrack::mouseDoubleClickEvent(QMouseEvent*) {
    m_slider.edit(m_slider.range().standard, Gesture::next());
}

void SliderTrack::step(double shares) {
    const auto& range = m_slider.range();
    double value = valueOfShare(share(m_slider.value()) + shares);
    // By one step of what is shown at least.
    const double smallest = std::pow(10.0, -range.decimals);
    if (std::abs(value - m_slider.value()) < smallest)
        value = m_slider.value() + (shares > 0.0 ? smallest : -smallest);
    m_slider.edit(value, m_run.next());
}

void SliderTrack::wheelEvent(QWheelEvent* event) {
    // Without the focus the wheel scrolls the panel.
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    const bool fine = event->modifiers().testFlag(Qt::ShiftModifier);
    step((fine ? kFine : 1.0) * kWheelStep * event->angleDelta().y() / 120.0);
    event->accept();
}

void SliderTrack::keyPressEvent(QKeyEvent* event) {
    const double forward = isRightToLeft() ? -1.0 : 1.0;
    const double size =
        event->modifiers().testFlag(Qt::ShiftModifier) ? kFine * kKeyStep : kKeyStep;
    switch (event->key()) {
    case Qt::Key_Right:
        step(forward * size);
        return;
    case Qt::Key_Left:
        step(-forward * size);
        return;
    case Qt::Key_Up:
        step(size);
        return;
    case Qt::Key_Down:
        step(-size);
        return;
    case Qt::Key_PageUp:
        step(kPageStep);
        return;
    case Qt::Key_PageDown:
        step(-kPageStep);
        return;
    case Qt::Key_Home:
        m_slider.edit(m_slider.range().low, m_run.next());
        return;
    case Qt::Key_End:
        m_slider.edit(m_slider.range().high, m_run.next());
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace txn::app
