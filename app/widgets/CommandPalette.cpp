// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/CommandPalette.h"

#include "app/widgets/ActionRegistry.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace txn::app {
namespace {

constexpr QSize kSize{520, 360};
constexpr int kFromTop = 48;

QString plainText(const QAction& action) {
    QString text = action.text();
    text.remove(QLatin1Char('&'));
    text.remove(QStringLiteral("..."));
    return text;
}

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
      m_list(new QListWidget) {
    setObjectName(QStringLiteral("commandPalette"));
    setFrameShape(QFrame::StyledPanel);
    m_search->setObjectName(QStringLiteral("paletteSearch"));
    m_search->setPlaceholderText(tr("Type what you want to do"));
    m_search->setAccessibleName(tr("Search commands"));
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("paletteList"));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setFocusPolicy(Qt::NoFocus);
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
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::trigger);
    fill({});
}

void CommandPalette::fill(const QString& search) {
    struct Match {
        int rank;
        const ActionRegistry::Entry* entry;
    };
    std::vector<Match> matches;
    for (const auto& entry : m_actions.entries()) {
        if (const auto rank = matchRank(search, plainText(*entry.action)))
            matches.push_back({*rank, &entry});
    }
    std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
        return a.rank < b.rank;
    });
    m_list->clear();
    for (const Match& match : matches) {
        const QAction& action = *match.entry->action;
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(
            keys.isEmpty() ? plainText(action) : tr("%1   (%2)").arg(plainText(action), keys),
            m_list);
        item->setToolTip(action.toolTip());
        item->setData(Qt::UserRole, match.entry->id);
        if (!action.isEnabled())
            item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    m_list->setCurrentRow(0);
}

void CommandPalette::trigger() {
    const QListWidgetItem* item = m_list->currentItem();
    QAction* action =
        item != nullptr ? m_actions.find(item->data(Qt::UserRole).toString()) : nullptr;
    close();
    if (action != nullptr && action->isEnabled())
        action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int rows = m_list->count();
        if (rows > 0 && (key == Qt::Key_Down || key == Qt::Key_Up)) {
            const int step = key == Qt::Key_Down ? 1 : rows - 1;
            m_list->setCurrentRow((m_list->currentRow() + step) % rows);
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace txn::app
