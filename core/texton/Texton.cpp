// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/Texton.h"

#include "core/spectral/BSpline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace txn {
namespace {

/// plane filtered by the sampled autocorrelation of the B-spline in both directions, zero outside.
std::vector<double> filtered(std::span<const float> plane, Size size, int order) {
    const auto b = bsplineAutocorrelation(order);
    const int reach = static_cast<int>(b.size()) - 1;
    const auto pass = [&](const std::vector<double>& in, int count, int lines, int step, int jump) {
        std::vector<double> out(in.size());
        for (int line = 0; line < lines; ++line) {
            const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(line) * jump;
            const auto at = [&](int i) {
                return static_cast<std::size_t>(start + static_cast<std::ptrdiff_t>(i) * step);
            };
            for (int i = 0; i < count; ++i) {
                double sum = 0.0;
                for (int n = std::max(-reach, -i); n <= std::min(reach, count - 1 - i); ++n)
                    sum += b[static_cast<std::size_t>(std::abs(n))] * in[at(i + n)];
                out[at(i)] = sum;
            }
        }
        return out;
    };
    const std::vector<double> values(plane.begin(), plane.end());
    const auto rows = pass(values, size.width, size.height, 1, size.width);
    return pass(rows, size.height, size.width, size.width, 1);
}

} // namespace

Texton withChannels(const Texton& texton, std::span<const ChannelSource> channels) {
    Texton result = texton;
    result.mean.clear();
    for (const ChannelSource& source : channels)
        result.mean.push_back(source.channel
                                  ? texton.mean[static_cast<std::size_t>(*source.channel)]
                                  : source.constant);
    for (Image& kernel : result.kernels) {
        Image chosen(kernel.size(), static_cast<int>(channels.size()), 0.0F, kernel.transfer());
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (channels[c].channel)
                std::ranges::copy(kernel.plane(*channels[c].channel),
                                  chosen.plane(static_cast<int>(c)).begin());
        }
        kernel = std::move(chosen);
    }
    return result;
}

Texton firstChannels(const Texton& texton, int count) {
    assert(count >= 1 && count <= texton.channels());
    std::vector<ChannelSource> channels;
    channels.reserve(static_cast<std::size_t>(count));
    for (int c = 0; c < count; ++c)
        channels.push_back({c, 0.0});
    return withChannels(texton, channels);
}

std::vector<double> noiseCovariance(const Texton& texton) {
    const auto channels = static_cast<std::size_t>(texton.channels());
    std::vector<double> covariance(channels * channels, 0.0);
    for (const Image& kernel : texton.kernels) {
        for (std::size_t i = 0; i < channels; ++i) {
            const auto smooth = filtered(kernel.plane(static_cast<int>(i)),
                                         kernel.size(),
                                         texton.interpolationOrder);
            for (std::size_t j = 0; j <= i; ++j) {
                const auto other = kernel.plane(static_cast<int>(j));
                double sum = 0.0;
                for (std::size_t k = 0; k < smooth.size(); ++k)
                    sum += smooth[k] * other[k];
                covariance[i * channels + j] += sum;
                if (j != i)
                    covariance[j * channels + i] += sum;
            }
        }
    }
    return covariance;
}

} // namespace txn
