// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <QPoint>
#include <QString>
#include <vector>

namespace txn::app {

/// The values of one pixel of a picture.
struct ProbeInfo {
    int x = 0; ///< in pixels of the picture
    int y = 0;
    std::vector<double> encoded; ///< one per channel; empty outside the picture
    std::vector<double> linear;
    QString hex; ///< such as "#B6A890"; empty for other than one or three channels
};

/// Of the sample at pixel, which may be outside; place is what is told about it.
[[nodiscard]] ProbeInfo probePixel(const Image& image, QPoint pixel, QPoint place);

} // namespace txn::app
