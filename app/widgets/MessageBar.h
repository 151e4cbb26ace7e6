// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>
#include <functional>

class QLabel;
class QPushButton;

namespace txn::app {

/// One line under the tool bar that says what happened and what to do; it stays until dismissed or
/// replaced (notes go by themselves). Never steals the focus. Hidden while empty.
class MessageBar : public QFrame {
    Q_OBJECT

  public:
    enum class Kind { Note, Warning, Problem };
    explicit MessageBar(QWidget* parent = nullptr);

    void show(Kind kind, const QString& text);
    /// With a button, such as "Open folder".
    void show(Kind kind, const QString& text, const QString& button, std::function<void()> action);
    void dismiss();
    QString text() const;

  private:
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_button;
    std::function<void()> m_action;
    QTimer m_expiry;
};

} // namespace txn::app
