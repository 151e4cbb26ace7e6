// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

namespace txn::app {

/// Pictures in a row, each with a second one and a word below it, one of which can be chosen.
class FilmStrip : public QWidget {
    Q_OBJECT

  public:
    struct Frame {
        QImage picture;
        QImage below;
        QString caption;
    };

    explicit FilmStrip(QWidget* parent = nullptr);

    void setFrames(std::vector<Frame> frames);
    void setChosen(std::optional<int> frame);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  signals:
    /// By the user; the chosen one again: none.
    void chosen(std::optional<int> frame);
    /// Brought into view by the keyboard.
    void reached(const QRect& place);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QRect frameRect(int frame) const;
    void choose(std::optional<int> frame);

    std::vector<Frame> m_frames;
    std::optional<int> m_chosen;
};

} // namespace txn::app
