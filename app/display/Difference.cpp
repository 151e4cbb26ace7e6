// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display/Difference.h"

#include "app/memory/NewImage.h"

#include <algorithm>

namespace txn::app {
namespace {

constexpr int kDifferenceGain = 8;

} // namespace

QImage difference(const QImage& a, const QImage& b) {
    QImage result = newImage(a.size(), QImage::Format_ARGB32_Premultiplied);
    const auto byte = [](int x, int y) {
        return std::clamp(128 + kDifferenceGain * (x - y), 0, 255);
    };
    for (int y = 0; y < a.height(); ++y) {
        const auto* p = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* q = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        auto* out = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (int x = 0; x < a.width(); ++x)
            out[x] = qAlpha(p[x]) == 0 || qAlpha(q[x]) == 0 ? qRgb(128, 128, 128)
                                                            : qRgb(byte(qRed(p[x]), qRed(q[x])),
                                                                   byte(qGreen(p[x]), qGreen(q[x])),
                                                                   byte(qBlue(p[x]), qBlue(q[x])));
    }
    return result;
}

} // namespace txn::app
