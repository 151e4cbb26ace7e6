// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/GestureRun.h"
#include "app/widgets/ValueSlider.h"

namespace txn::app {

/// The part of a ValueSlider that is dragged.
class SliderTrack : public QWidget {
    Q_OBJECT

  public:
    explicit SliderTrack(ValueSlider& slider);

    QSize sizeHint() const override { return {96, 20}; }
    QSize minimumSizeHint() const override { return {48, 20}; }
    /// Where a value is, in pixels from the left, and back. Right to left where the language is.
    double position(double value) const;
    double valueAt(double x) const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    double share(double value) const;
    double valueOfShare(double share) const;
    double snapped(double value) const;
    void step(double shares);

    ValueSlider& m_slider;
    bool m_dragging = false;
    Gesture m_gesture;
    double m_dragShare = 0.0;
    double m_lastX = 0.0;
    GestureRun m_run; ///< of keys or the wheel
};

} // namespace txn::app
