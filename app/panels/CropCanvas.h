// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/GestureRun.h"
#include "core/base/Geometry.h"

#include <QImage>
#include <QWidget>
#include <optional>

namespace txn::app {

/// The whole picture, small, with the crop as a rectangle to draw, move and resize, or with a line
/// to draw along the grain.
class CropCanvas : public QWidget {
    Q_OBJECT

  public:
    enum class Tool { Crop, Straighten };
    explicit CropCanvas(QWidget* parent = nullptr);

    /// overview: of a picture of the given size, in its pixels.
    void setPicture(const QImage& overview, Size size);
    void setCrop(const std::optional<Rect>& crop);
    void setTool(Tool tool);

    QSize sizeHint() const override { return {kWidth, heightForWidth(kWidth)}; }
    /// As high as the picture is, no higher than wide.
    int heightForWidth(int width) const override;
    QSize minimumSizeHint() const override { return {160, 120}; }

  signals:
    void cropEdited(const Rect& crop, Gesture gesture);
    /// How far the line is from the horizontal or vertical, whichever is nearer: by so much the
    /// picture has to be turned, counterclockwise.
    void lineDrawn(double degrees);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    static constexpr int kWidth = 272;

    /// Which sides of the rectangle move with the mouse.
    struct Grip {
        bool left = false, top = false, right = false, bottom = false;
        bool any() const { return left || top || right || bottom; }
    };

    QRectF pictureRect() const;
    double scale() const;
    QPointF toPicture(QPointF position) const;
    QRectF onScreen(const Rect& crop) const;
    Rect shownCrop() const;
    Grip gripAt(QPointF position) const;
    void edit(double left, double top, double right, double bottom, Gesture gesture);

    QImage m_overview;
    Size m_size;
    std::optional<Rect> m_crop;
    Tool m_tool = Tool::Crop;
    bool m_dragging = false;
    bool m_moving = false;
    Grip m_grip;
    Gesture m_gesture;
    GestureRun m_keys;
    Rect m_start;
    QPointF m_from; ///< in pixels of the picture
    QPointF m_to;
};

/// By how much a line from a to b, y down, has to be turned to lie along an axis, in degrees
/// counterclockwise, -45 to 45.
[[nodiscard]] double straighteningAngle(QPointF a, QPointF b);

} // namespace txn::app
