// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/BeforeAfter.h"

#include "app/look/Theme.h"

#include <QKeyEvent>
#include <QPainter>

namespace txn::app {

BeforeAfter::BeforeAfter(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setToolTip(tr("Hold the mouse button or the space bar to see it as it was before."));
}

void BeforeAfter::setImages(const QImage& before, const QImage& after) {
    m_before = before;
    m_after = after;
    update();
}

void BeforeAfter::hold(bool held) {
    m_held = held;
    update();
}

void BeforeAfter::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themeColors().field);
    const QImage& image = m_held ? m_before : m_after;
    if (!image.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        // Fills the width; what does not fit above and below is left out.
        const double scale = std::max(static_cast<double>(width()) / image.width(),
                                      static_cast<double>(height()) / image.height());
        const QSizeF part = QSizeF(size()) / scale;
        painter.drawImage(QRectF(rect()),
                          image,
                          QRectF(QPointF((image.width() - part.width()) / 2.0,
                                         (image.height() - part.height()) / 2.0),
                                 part));
        const QString text = m_held ? tr("Before") : tr("After (hold for before)");
        const QRect label(4, height() - 22, painter.fontMetrics().horizontalAdvance(text) + 12, 18);
        painter.fillRect(label, QColor(0, 0, 0, 150));
        painter.setPen(Qt::white);
        painter.drawText(label, Qt::AlignCenter, text);
    }
    if (hasFocus())
        paintFocusFrame(painter, rect());
}

void BeforeAfter::mousePressEvent(QMouseEvent*) {
    hold(true);
}

void BeforeAfter::mouseReleaseEvent(QMouseEvent*) {
    hold(false);
}

void BeforeAfter::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space)
        hold(true);
    else
        QWidget::keyPressEvent(event);
}

void BeforeAfter::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        hold(false);
    else
        QWidget::keyReleaseEvent(event);
}

} // namespace txn::app
