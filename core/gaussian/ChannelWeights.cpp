// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/ChannelWeights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace txn {
namespace {

/// Less than a step of eight bits is rounding, not texture.
constexpr double kLeastDeviation = 1.0 / 255.0;

double deviation(std::span<const float> plane) {
    const auto count = static_cast<double>(plane.size());
    const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / count;
    const double sum =
        std::transform_reduce(plane.begin(), plane.end(), 0.0, std::plus<>(), [&](double v) {
            return (v - mean) * (v - mean);
        });
    return std::sqrt(sum / count);
}

} // namespace

std::vector<double> channelWeights(const Exemplar& exemplar) {
    const Image& image = exemplar.image;
    std::vector<double> weights(static_cast<std::size_t>(image.channels()), 1.0);
    if (exemplar.maps.empty())
        return weights;
    for (int c = 0; c < image.channels(); ++c)
        weights[static_cast<std::size_t>(c)] =
            1.0 / std::max(deviation(image.plane(c)), kLeastDeviation);
    return weights;
}

} // namespace txn
