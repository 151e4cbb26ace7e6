// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/ShortcutEditor.h"

#include "app/widgets/ActionRegistry.h"
#include "app/widgets/CommandPalette.h"
#include "app/widgets/WhatsThis.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace txn::app {

ShortcutEditor::ShortcutEditor(ActionRegistry& actions, QWidget* parent)
    : QDialog(parent), m_actions(actions), m_list(new QTreeWidget), m_keys(new QKeySequenceEdit),
      m_note(new QLabel) {
    setObjectName(QStringLiteral("shortcutEditor"));
    setWindowTitle(tr("Shortcuts"));
    auto* search = new QLineEdit;
    search->setObjectName(QStringLiteral("shortcutSearch"));
    search->setPlaceholderText(tr("Search"));
    search->setAccessibleName(tr("Search commands"));
    search->setToolTip(tr("Type a part of a command's name."));
    m_list->setObjectName(QStringLiteral("shortcutList"));
    m_list->setHeaderLabels({tr("Command"), tr("Keys")});
    m_list->setRootIsDecorated(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->setAccessibleName(tr("Commands"));
    m_list->setToolTip(tr("Choose a command to give it other keys."));
    m_keys->setObjectName(QStringLiteral("shortcutKeys"));
    m_keys->setAccessibleName(tr("Keys"));
    m_keys->setToolTip(tr("Press the keys that you want for the chosen command."));
    m_note->setProperty("role", QStringLiteral("secondary"));
    m_note->setObjectName(QStringLiteral("shortcutNote"));
    m_note->setWordWrap(true);
    auto* none = new QPushButton(tr("No keys"));
    none->setObjectName(QStringLiteral("shortcutNone"));
    none->setToolTip(tr("Takes the chosen command's keys away."));
    auto* reset = new QPushButton(tr("Reset all"));
    reset->setObjectName(QStringLiteral("shortcutReset"));
    reset->setToolTip(tr("Back to the keys that the program came with."));
    auto* close = new QPushButton(tr("Close"));
    close->setDefault(true);
    close->setToolTip(tr("Closes this window. Changes are kept already."));
    auto* row = new QHBoxLayout;
    row->addWidget(m_keys, 1);
    row->addWidget(none);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(reset);
    buttons->addStretch();
    buttons->addWidget(close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(search);
    column->addWidget(m_list, 1);
    column->addLayout(row);
    column->addWidget(m_note);
    column->addLayout(buttons);
    resize(520, 560);
    connect(search, &QLineEdit::textChanged, this, &ShortcutEditor::fill);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutEditor::showCurrent);
    connect(m_keys, &QKeySequenceEdit::editingFinished, this, [this] {
        assign(m_keys->keySequence());
    });
    connect(none, &QPushButton::clicked, this, [this] { assign({}); });
    connect(reset, &QPushButton::clicked, this, [this, search] {
        m_actions.resetShortcuts();
        fill(search->text());
    });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    fill({});
    explainByToolTips(*this);
}

void ShortcutEditor::fill(const QString& search) {
    const QString current = currentId();
    m_list->clear();
    for (const auto& entry : m_actions.entries()) {
        if (!matchRank(search, entry.title()))
            continue;
        auto* item = new QTreeWidgetItem(
            m_list,
            {entry.title(), entry.action->shortcut().toString(QKeySequence::NativeText)});
        item->setData(0, Qt::UserRole, entry.id);
        if (entry.id == current || m_list->currentItem() == nullptr)
            m_list->setCurrentItem(item);
    }
}

QString ShortcutEditor::currentId() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item != nullptr ? item->data(0, Qt::UserRole).toString() : QString();
}

void ShortcutEditor::showCurrent() {
    const QAction* action = m_actions.find(currentId());
    m_keys->setEnabled(action != nullptr);
    m_keys->setKeySequence(action != nullptr ? action->shortcut() : QKeySequence());
    m_note->setText(action != nullptr ? action->toolTip() : QString());
}

void ShortcutEditor::assign(const QKeySequence& keys) {
    const QAction* action = m_actions.find(currentId());
    if (action == nullptr || action->shortcut() == keys)
        return;
    const QString robbed = m_actions.setShortcut(currentId(), keys);
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_list->topLevelItem(i);
        const QAction* each = m_actions.find(item->data(0, Qt::UserRole).toString());
        item->setText(1, each->shortcut().toString(QKeySequence::NativeText));
    }
    m_keys->setKeySequence(keys);
    if (const QAction* other = m_actions.find(robbed))
        m_note->setText(tr("These keys were those of \"%1\", which has none now.")
                            .arg(other->text().remove(QLatin1Char('&'))));
}

} // namespace txn::app
