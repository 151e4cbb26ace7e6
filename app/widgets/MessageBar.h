// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>

class QLabel;

namespace txn::app {

/// One line under the tool bar that says what happened and what to do; it stays until dismissed or
/// replaced (notes go by themselves). Never steals the focus. Hidden while empty.
class MessageBar : public QFrame {
    Q_OBJECT

  public:
    enum class Kind { Note, Warning, Problem };
    explicit MessageBar(QWidget* parent = nullptr);

    void show(Kind kind, const QString& text);
    void dismiss();
    QString text() const;

  private:
    QLabel* m_icon;
    QLabel* m_text;
    QTimer m_expiry;
};

} // namespace txn::app
