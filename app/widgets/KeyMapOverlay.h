// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace txn::app {

class ActionRegistry;

/// All keys at a glance, over the whole window; any key or click closes it.
class KeyMapOverlay : public QWidget {
    Q_OBJECT

  public:
    /// Shows it, or closes the one that is there.
    static void toggle(const ActionRegistry& actions, QWidget& window);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    KeyMapOverlay(const ActionRegistry& actions, QWidget& window);

    struct Line {
        QString keys;
        QString text;
    };
    QList<Line> m_lines;
};

} // namespace txn::app
