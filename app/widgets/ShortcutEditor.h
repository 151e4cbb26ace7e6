// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QTreeWidget;

namespace txn::app {

class ActionRegistry;

/// Lets the user choose keys for every action.
class ShortcutEditor : public QDialog {
    Q_OBJECT

  public:
    explicit ShortcutEditor(ActionRegistry& actions, QWidget* parent = nullptr);

  private:
    void fill(const QString& search);
    void showCurrent();
    void assign(const QKeySequence& keys);
    QString currentId() const;

    ActionRegistry& m_actions;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_keys;
    QLabel* m_note;
};

} // namespace txn::app
