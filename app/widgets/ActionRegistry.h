// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <vector>

namespace txn::app {

class Settings;

/// Every action of the program by its id, with a shortcut that the user can change. Menus, the
/// command palette, the shortcut editor and the key map all read this one list.
class ActionRegistry : public QObject {
    Q_OBJECT

  public:
    struct Entry {
        QString id; ///< such as "file.open"; what is before the dot names the menu
        QAction* action;
        QString standard; ///< default shortcut, QKeySequence::PortableText; may be empty
        QString group;    ///< such as "File"

        /// What it is called, such as "Open", and with its group, "File: Open".
        QString text() const;
        QString title() const;
    };

    explicit ActionRegistry(Settings& settings, QObject* parent = nullptr);

    /// Of what is added from now on.
    void beginGroup(const QString& title) { m_group = title; }
    /// text as in menus, with &. toolTip: one plain sentence.
    QAction* add(const QString& id,
                 const QString& text,
                 const QString& toolTip,
                 const QString& shortcut = {});
    /// An action that exists already, such as a dock's.
    void adopt(const QString& id, QAction* action, const QString& shortcut = {});
    const std::vector<Entry>& entries() const { return m_entries; }
    QAction* find(const QString& id) const;
    /// Kept in the settings. Takes the shortcut away from whoever had it; the other action's id, or
    /// empty.
    QString setShortcut(const QString& id, const QKeySequence& shortcut);
    void resetShortcuts();

  private:
    Settings& m_settings;
    std::vector<Entry> m_entries;
    QString m_group;
};

} // namespace txn::app
