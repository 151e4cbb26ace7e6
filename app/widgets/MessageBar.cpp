// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/MessageBar.h"

#include "app/look/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace txn::app {
namespace {

constexpr int kNoteMs = 6000;
constexpr int kIconPx = 16;

QString iconName(MessageBar::Kind kind) {
    switch (kind) {
    case MessageBar::Kind::Problem:
        return QStringLiteral("error");
    case MessageBar::Kind::Warning:
        return QStringLiteral("warning");
    case MessageBar::Kind::Note:
        break;
    }
    return QStringLiteral("info");
}

QColor edgeColor(MessageBar::Kind kind) {
    const ThemeColors& colors = themeColors();
    switch (kind) {
    case MessageBar::Kind::Problem:
        return colors.error;
    case MessageBar::Kind::Warning:
        return colors.stale;
    case MessageBar::Kind::Note:
        break;
    }
    return colors.accent;
}

} // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), m_icon(new QLabel), m_text(new QLabel) {
    setObjectName(QStringLiteral("messageBar"));
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton;
    close->setObjectName(QStringLiteral("messageClose"));
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAccessibleName(tr("Dismiss the message"));
    close->setToolTip(tr("Dismiss the message."));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    row->addWidget(close);
    m_expiry.setSingleShot(true);
    m_expiry.setInterval(kNoteMs);
    connect(&m_expiry, &QTimer::timeout, this, &MessageBar::dismiss);
    connect(close, &QToolButton::clicked, this, &MessageBar::dismiss);
    hide();
}

void MessageBar::show(Kind kind, const QString& text) {
    m_icon->setPixmap(themeIcon(iconName(kind)).pixmap(kIconPx, kIconPx));
    m_text->setText(text);
    setStyleSheet(QStringLiteral("#messageBar { background: %1; border-left: 4px solid %2; }")
                      .arg(themeColors().panel.name(), edgeColor(kind).name()));
    setAccessibleName(text);
    setVisible(true);
    if (kind == Kind::Note)
        m_expiry.start();
    else
        m_expiry.stop();
}

void MessageBar::dismiss() {
    m_expiry.stop();
    hide();
    m_text->clear();
}

QString MessageBar::text() const {
    return m_text->text();
}

} // namespace txn::app
