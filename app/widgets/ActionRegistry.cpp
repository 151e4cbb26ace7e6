// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/ActionRegistry.h"

#include "app/settings/Settings.h"

#include <algorithm>

namespace txn::app {

QString ActionRegistry::Entry::text() const {
    QString plain = action->text();
    plain.remove(QLatin1Char('&'));
    plain.remove(QStringLiteral("..."));
    return plain;
}

QString ActionRegistry::Entry::title() const {
    return group.isEmpty() ? text() : tr("%1: %2").arg(group, text());
}

ActionRegistry::ActionRegistry(Settings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {}

QAction* ActionRegistry::add(const QString& id,
                             const QString& text,
                             const QString& toolTip,
                             const QString& shortcut) {
    auto* action = new QAction(text, this);
    action->setToolTip(toolTip);
    action->setStatusTip(toolTip);
    action->setWhatsThis(toolTip);
    adopt(id, action, shortcut);
    return action;
}

void ActionRegistry::adopt(const QString& id, QAction* action, const QString& shortcut) {
    action->setObjectName(id);
    action->setShortcut(
        QKeySequence(m_settings.shortcut(id, shortcut), QKeySequence::PortableText));
    m_entries.push_back({id, action, shortcut, m_group});
}

QAction* ActionRegistry::find(const QString& id) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& entry) {
        return entry.id == id;
    });
    return found == m_entries.end() ? nullptr : found->action;
}

QString ActionRegistry::setShortcut(const QString& id, const QKeySequence& shortcut) {
    QString robbed;
    for (Entry& entry : m_entries) {
        if (entry.id == id) {
            entry.action->setShortcut(shortcut);
        } else if (!shortcut.isEmpty() && entry.action->shortcut() == shortcut) {
            robbed = entry.id;
            entry.action->setShortcut({});
        } else {
            continue;
        }
        m_settings.setShortcut(entry.id,
                               entry.action->shortcut().toString(QKeySequence::PortableText),
                               entry.standard);
    }
    return robbed;
}

void ActionRegistry::resetShortcuts() {
    for (Entry& entry : m_entries) {
        entry.action->setShortcut(QKeySequence(entry.standard, QKeySequence::PortableText));
        m_settings.setShortcut(entry.id, entry.standard, entry.standard);
    }
}

} // namespace txn::app
