// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace txn::app {

/// A picture after a change; before it, while the mouse or the space bar is held down.
class BeforeAfter : public QWidget {
    Q_OBJECT

  public:
    explicit BeforeAfter(QWidget* parent = nullptr);

    void setImages(const QImage& before, const QImage& after);
    bool isShowingBefore() const { return m_held; }
    QSize sizeHint() const override { return {160, 96}; }
    QSize minimumSizeHint() const override { return {96, 96}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

  private:
    void hold(bool held);

    QImage m_before;
    QImage m_after;
    bool m_held = false;
};

} // namespace txn::app
