// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/MaterialSlot.h"

#include "app/look/Theme.h"

#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>

namespace txn::app {

MaterialSlot::MaterialSlot(QString letter, QString hint, QWidget* parent)
    : QWidget(parent), m_letter(std::move(letter)), m_hint(std::move(hint)) {
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setPicture({}, {});
}

void MaterialSlot::setPicture(const QImage& picture, const QString& name) {
    m_picture = picture;
    setAccessibleName(name.isEmpty() ? m_letter : QStringLiteral("%1: %2").arg(m_letter, name));
    update();
}

void MaterialSlot::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = themeColors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), colors.field);
    if (m_picture.isNull()) {
        painter.setPen(QPen(colors.secondary, 1.0, Qt::DashLine));
        painter.drawRect(QRectF(rect()).adjusted(3.5, 3.5, -3.5, -3.5));
        painter.setPen(colors.secondary);
        painter.drawText(rect().adjusted(8, 22, -8, -6),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         m_hint);
    } else {
        // Fills the square; what does not fit is left out.
        const double side = std::min(m_picture.width(), m_picture.height());
        painter.drawImage(QRectF(rect()),
                          m_picture,
                          QRectF((m_picture.width() - side) / 2.0,
                                 (m_picture.height() - side) / 2.0,
                                 side,
                                 side));
    }
    const QRect badge(4, 4, 20, 18);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 160));
    painter.drawRoundedRect(badge, 3, 3);
    painter.setPen(Qt::white);
    painter.drawText(badge, Qt::AlignCenter, m_letter);
    if (m_draggedOver) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colors.accent, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    if (hasFocus())
        paintFocusFrame(painter, rect());
}

void MaterialSlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->pos()))
        emit clicked();
}

void MaterialSlot::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return ||
        event->key() == Qt::Key_Enter)
        emit clicked();
    else
        QWidget::keyPressEvent(event);
}

void MaterialSlot::dragEnterEvent(QDragEnterEvent* event) {
    if (!m_accepts(*event->mimeData()))
        return;
    event->acceptProposedAction();
    m_draggedOver = true;
    update();
}

void MaterialSlot::dragLeaveEvent(QDragLeaveEvent*) {
    m_draggedOver = false;
    update();
}

void MaterialSlot::dropEvent(QDropEvent* event) {
    m_draggedOver = false;
    update();
    event->acceptProposedAction();
    emit dropped(*event->mimeData());
}

} // namespace txn::app
