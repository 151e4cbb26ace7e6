// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/KeyMapOverlay.h"

#include "app/look/Theme.h"
#include "app/widgets/ActionRegistry.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <algorithm>

namespace txn::app {
namespace {

constexpr int kMargin = 16;
constexpr int kMostColumns = 3;
constexpr int kColumnWidth = 440;
constexpr int kKeysWidth = 176;
constexpr int kGapWidth = 16;
constexpr int kTextWidth = kColumnWidth - kKeysWidth - 2 * kGapWidth;

} // namespace

void KeyMapOverlay::toggle(const ActionRegistry& actions, QWidget& window) {
    if (auto* shown = window.findChild<KeyMapOverlay*>()) {
        shown->close();
        return;
    }
    auto* overlay = new KeyMapOverlay(actions, window);
    overlay->setAttribute(Qt::WA_DeleteOnClose);
    overlay->show();
    overlay->raise();
    overlay->setFocus();
}

KeyMapOverlay::KeyMapOverlay(const ActionRegistry& actions, QWidget& window) : QWidget(&window) {
    setObjectName(QStringLiteral("keyMap"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("All keys"));
    setGeometry(window.rect());
    window.installEventFilter(this);
    m_lines = {{{}, tr("In a view")},
               {tr("Wheel"), tr("Zoom at the mouse")},
               {tr("Middle drag, Space drag"), tr("Move the picture")},
               {tr("Left drag"), tr("Look around the ground or mesh")},
               {tr("Hold `"), tr("See the exemplar instead")},
               {tr("Hold X"), tr("See the difference, eightfold")},
               {tr("Double-click the title"), tr("This view only")},
               {{}, tr("On a slider")},
               {tr("Shift drag"), tr("Fine steps")},
               {tr("Double-click"), tr("Default")}};
    QString group;
    for (const auto& entry : actions.entries()) {
        if (entry.action->shortcut().isEmpty())
            continue;
        if (entry.group != group)
            m_lines.append({{}, entry.group});
        group = entry.group;
        m_lines.append({entry.action->shortcut().toString(QKeySequence::NativeText), entry.text()});
    }
}

void KeyMapOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(20, 20, 20, 245));
    const auto placed = [this](QRect place) {
        return QStyle::visualRect(layoutDirection(), rect(), place);
    };
    const auto lines = static_cast<int>(m_lines.size());
    const int columns = std::clamp((width() - 2 * kMargin) / kColumnWidth, 1, kMostColumns);
    const int perColumn = (lines + columns - 1) / columns;
    const int lineHeight =
        std::min(fontMetrics().height() + 8, std::max(1, (height() - 4 * kMargin) / perColumn));
    const int top = (height() - perColumn * lineHeight) / 2;
    painter.setPen(darkColors().secondary);
    painter.drawText(rect().adjusted(0, 0, 0, -kMargin),
                     Qt::AlignHCenter | Qt::AlignBottom,
                     tr("Any key closes this."));
    const int left = std::max(kMargin, (width() - columns * kColumnWidth) / 2);
    for (int i = 0; i < m_lines.size(); ++i) {
        const int x = left + (i / perColumn) * kColumnWidth;
        const int y = top + (i % perColumn) * lineHeight;
        const QRect keys(x, y, kKeysWidth, lineHeight);
        if (m_lines[i].keys.isEmpty()) {
            painter.setPen(darkColors().secondary);
            painter.drawText(placed(QRect(x + kKeysWidth + kGapWidth, y, kTextWidth, lineHeight)),
                             QStyle::visualAlignment(layoutDirection(), Qt::AlignLeft) |
                                 Qt::AlignVCenter,
                             m_lines[i].text.toUpper());
            continue;
        }
        painter.setPen(darkColors().accent);
        painter.drawText(placed(keys),
                         QStyle::visualAlignment(layoutDirection(), Qt::AlignRight) |
                             Qt::AlignVCenter,
                         fontMetrics().elidedText(m_lines[i].keys, Qt::ElideRight, kKeysWidth));
        painter.setPen(darkColors().text);
        painter.drawText(placed(QRect(x + kKeysWidth + kGapWidth, y, kTextWidth, lineHeight)),
                         QStyle::visualAlignment(layoutDirection(), Qt::AlignLeft) |
                             Qt::AlignVCenter,
                         fontMetrics().elidedText(m_lines[i].text, Qt::ElideRight, kTextWidth));
    }
}

void KeyMapOverlay::keyPressEvent(QKeyEvent*) {
    close();
}

void KeyMapOverlay::mousePressEvent(QMouseEvent*) {
    close();
}

bool KeyMapOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize)
        setGeometry(static_cast<QWidget*>(watched)->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace txn::app
