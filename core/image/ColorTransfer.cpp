// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ColorTransfer.h"

#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

constexpr float kLinearEnd = 0.0031308F; // where the straight part of the curve ends
constexpr float kSlope = 12.92F;
constexpr float kOffset = 0.055F;
constexpr float kGamma = 2.4F;

template <class Curve>
void apply(std::span<float> samples, Curve curve) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.size(), 1U << 14U),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                              samples[i] = curve(samples[i]);
                      });
}

} // namespace

float linearFromEncoded(float encoded) {
    const float x = std::abs(encoded);
    const float y =
        x <= kLinearEnd * kSlope ? x / kSlope : std::pow((x + kOffset) / (1.0F + kOffset), kGamma);
    return std::copysign(y, encoded);
}

float encodedFromLinear(float linear) {
    const float x = std::abs(linear);
    const float y =
        x <= kLinearEnd ? x * kSlope : (1.0F + kOffset) * std::pow(x, 1.0F / kGamma) - kOffset;
    return std::copysign(y, linear);
}

Image toLinear(Image image) {
    if (image.transfer() == Transfer::Encoded) {
        apply(image.samples(), linearFromEncoded);
        image.setTransfer(Transfer::Linear);
    }
    return image;
}

Image toEncoded(Image image) {
    if (image.transfer() == Transfer::Linear) {
        apply(image.samples(), encodedFromLinear);
        image.setTransfer(Transfer::Encoded);
    }
    return image;
}

} // namespace txn
