// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;

namespace txn::app {

/// A label and a list to choose from, in one row of a panel.
class ChoiceRow : public QWidget {
    Q_OBJECT

  public:
    ChoiceRow(const QString& label, const QStringList& choices, QWidget* parent = nullptr);

    int current() const;
    /// Without telling anybody.
    void setCurrent(int index);
    QComboBox& box() { return *m_box; }

  signals:
    /// By the user.
    void chosen(int index);

  private:
    QComboBox* m_box;
};

} // namespace txn::app
