// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/CommandPalette.h"

#include "app/widgets/ActionRegistry.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace txn::app {
namespace {

constexpr QSize kSize{520, 360};
constexpr int kFromTop = 48;

} // namespace

std::optional<int> matchRank(const QString& search, const QString& text) {
    const QString wanted = search.simplified().toCaseFolded();
    const QString where = text.toCaseFolded();
    if (const auto whole = where.indexOf(wanted); whole >= 0)
        return static_cast<int>(whole);
    qsizetype at = 0;
    int gaps = 0;
    for (const QChar c : wanted) {
        if (c.isSpace())
            continue;
        const auto found = where.indexOf(c, at);
        if (found < 0)
            return std::nullopt;
        gaps += static_cast<int>(found - at);
        at = found + 1;
    }
    constexpr int kScattered = 1000; // behind everything that has the words as they are
    return kScattered + gaps;
}

CommandPalette* CommandPalette::open(const ActionRegistry& actions, QWidget& window) {
    auto* palette = new CommandPalette(actions, window);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    palette->show();
    palette->m_search->setFocus();
    return palette;
}

CommandPalette::CommandPalette(const ActionRegistry& actions, QWidget& window)
    : QFrame(&window, Qt::Popup), m_actions(actions), m_search(new QLineEdit),
      m_list(new QTreeWidget) {
    setObjectName(QStringLiteral("commandPalette"));
    setFrameShape(QFrame::StyledPanel);
    m_search->setObjectName(QStringLiteral("paletteSearch"));
    m_search->setPlaceholderText(tr("Type what you want to do"));
    m_search->setAccessibleName(tr("Search commands"));
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("paletteList"));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setColumnCount(2);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    column->addWidget(m_search);
    column->addWidget(m_list);
    const QSize size = kSize.boundedTo(window.size());
    resize(size);
    move(window.mapToGlobal(QPoint((window.width() - size.width()) / 2, kFromTop)));
    connect(m_search, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(m_search, &QLineEdit::returnPressed, this, &CommandPalette::trigger);
    connect(m_list, &QTreeWidget::itemClicked, this, &CommandPalette::trigger);
    fill({});
}

void CommandPalette::fill(const QString& search) {
    struct Match {
        int rank;
        const ActionRegistry::Entry* entry;
    };
    std::vector<Match> matches;
    for (const auto& entry : m_actions.entries()) {
        if (const auto rank = matchRank(search, entry.title()))
            matches.push_back({*rank, &entry});
    }
    std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
        return a.rank < b.rank;
    });
    m_list->clear();
    for (const Match& match : matches) {
        const QAction& action = *match.entry->action;
        auto* item = new QTreeWidgetItem(
            m_list,
            {match.entry->title(), action.shortcut().toString(QKeySequence::NativeText)});
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(0, action.toolTip());
        item->setData(0, Qt::UserRole, match.entry->id);
        if (!action.isEnabled())
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
}

void CommandPalette::trigger() {
    const QTreeWidgetItem* item = m_list->currentItem();
    QAction* action =
        item != nullptr ? m_actions.find(item->data(0, Qt::UserRole).toString()) : nullptr;
    close();
    if (action != nullptr && action->isEnabled())
        action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int rows = m_list->topLevelItemCount();
        if (rows > 0 && (key == Qt::Key_Down || key == Qt::Key_Up)) {
            const int step = key == Qt::Key_Down ? 1 : rows - 1;
            const int now = m_list->indexOfTopLevelItem(m_list->currentItem());
            m_list->setCurrentItem(m_list->topLevelItem((now + step) % rows));
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace txn::app
