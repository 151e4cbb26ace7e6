// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <new>

namespace txn::app {

/// A picture to draw into. Qt gives one without pixels where there is no memory, which whoever
/// writes into it would not survive. Throws std::bad_alloc.
[[nodiscard]] inline QImage newImage(QSize size, QImage::Format format) {
    QImage image(size, format);
    if (image.isNull() && !size.isEmpty())
        throw std::bad_alloc();
    return image;
}

} // namespace txn::app
