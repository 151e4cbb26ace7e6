// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/PlotPicture.h"

#include "app/look/Theme.h"

#include <QPainter>

namespace txn::app {

PlotPicture::PlotPicture(const QString& caption, QWidget* parent)
    : QWidget(parent), m_caption(caption) {
    setAccessibleName(caption);
}

void PlotPicture::setImage(const QImage& image) {
    m_image = image;
    update();
}

void PlotPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const int caption = fontMetrics().height() + 4;
    const int side = std::max(0, std::min(width(), height() - caption));
    const QRect place((width() - side) / 2, (height() - caption - side) / 2, side, side);
    if (m_image.isNull()) {
        painter.fillRect(place, themeColors().field);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, m_image);
    }
    painter.setPen(themeColors().secondary);
    painter.drawText(QRect(0, place.bottom() + 1, width(), caption), Qt::AlignCenter, m_caption);
}

} // namespace txn::app
