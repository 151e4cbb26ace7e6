// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/Lighting.h"

#include "core/spectral/Fft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace txn {
namespace {

/// Transfer function of the blur at the cosine transform's frequencies pi k / length.
std::vector<double> blurResponse(int length, double radius) {
    std::vector<double> response(static_cast<std::size_t>(length));
    for (int k = 0; k < length; ++k) {
        const double omega = std::numbers::pi * k / length;
        response[static_cast<std::size_t>(k)] = std::exp(-0.5 * radius * radius * omega * omega);
    }
    return response;
}

} // namespace

Result<Image> flattenLighting(const Image& image, double radiusPx, const CancelToken& cancel) {
    if (!(radiusPx > 0.0 && std::isfinite(radiusPx)))
        return Error{ErrorCode::InvalidArgument, "the radius for even lighting must be above 0"};
    const auto horizontal = blurResponse(image.width(), radiusPx);
    const auto vertical = blurResponse(image.height(), radiusPx);
    CosineTransform2d transform(image.size());
    Image result = image;
    for (int c = 0; c < image.channels(); ++c) {
        if (cancel.cancelled())
            return Error{ErrorCode::Cancelled, "cancelled"};
        const auto plane = result.plane(c);
        const auto values = transform.values();
        std::copy(plane.begin(), plane.end(), values.begin());
        transform.forward();
        std::size_t i = 0;
        for (const double v : vertical) {
            for (const double h : horizontal) {
                if (i > 0) // the mean stays
                    values[i] *= static_cast<float>(1.0 - v * h);
                ++i;
            }
        }
        transform.inverse();
        std::copy(values.begin(), values.end(), plane.begin());
    }
    return result;
}

} // namespace txn
