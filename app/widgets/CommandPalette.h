// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <optional>

class QLineEdit;
class QTreeWidget;

namespace txn::app {

class ActionRegistry;

/// A list of all commands to search by typing; Enter does the chosen one.
class CommandPalette : public QFrame {
    Q_OBJECT

  public:
    /// At the top of the window, with the focus. Deletes itself when it closes.
    static CommandPalette* open(const ActionRegistry& actions, QWidget& window);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    CommandPalette(const ActionRegistry& actions, QWidget& window);
    void fill(const QString& search);
    void trigger();

    const ActionRegistry& m_actions;
    QLineEdit* m_search;
    QTreeWidget* m_list;
};

/// How well search, as letters in this order, fits the text: lower is better, nothing if not at
/// all.
[[nodiscard]] std::optional<int> matchRank(const QString& search, const QString& text);

} // namespace txn::app
