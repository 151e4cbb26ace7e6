// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/FilterFade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

constexpr int kLargestSide = 32;

/// Sums of step x step blocks.
std::vector<double> blockSums(std::span<const float> plane, Size size, int step, Size blocks) {
    std::vector<double> sums(blocks.area(), 0.0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            sums[static_cast<std::size_t>(y / step * blocks.width + x / step)] +=
                plane[static_cast<std::size_t>(y * size.width + x)];
    }
    return sums;
}

/// Adds the autocorrelation of values to sums, which holds lags -(w - 1)..w - 1 by 0..h - 1; the
/// others follow by symmetry.
void addAutocorrelation(std::vector<double>& sums, const std::vector<double>& values, Size size) {
    const int columns = 2 * size.width - 1;
    for (int ky = 0; ky < size.height; ++ky) {
        for (int kx = 1 - size.width; kx < size.width; ++kx) {
            double sum = 0.0;
            for (int y = 0; y + ky < size.height; ++y) {
                for (int x = std::max(0, -kx); x < size.width - std::max(0, kx); ++x)
                    sum += values[static_cast<std::size_t>(y * size.width + x)] *
                           values[static_cast<std::size_t>((y + ky) * size.width + x + kx)];
            }
            sums[static_cast<std::size_t>(ky * columns + kx + size.width - 1)] += sum;
        }
    }
}

/// Autocorrelation at lag x of the average over a length.
double overlap(double x, double length) {
    return std::max(0.0, 1.0 - std::abs(x) / length) / length;
}

} // namespace

FilterFade filterFade(const Texton& texton) {
    const Size size = texton.support.size();
    const int step = (std::max(size.width, size.height) + kLargestSide - 1) / kLargestSide;
    const Size blocks{(size.width + step - 1) / step, (size.height + step - 1) / step};
    const int columns = 2 * blocks.width - 1;
    const auto channels = static_cast<std::size_t>(texton.channels());
    std::vector<std::vector<double>> covariance(
        channels,
        std::vector<double>(static_cast<std::size_t>(columns * blocks.height), 0.0));
    for (const Image& kernel : texton.kernels) {
        for (std::size_t c = 0; c < channels; ++c)
            addAutocorrelation(covariance[c],
                               blockSums(kernel.plane(static_cast<int>(c)), size, step, blocks),
                               blocks);
    }

    /// Variances of all channels after averaging.
    const auto variances = [&](double angle, double a, double b) {
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        // Below the grid's own step a box is a point.
        a = std::max<double>(a, step);
        b = std::max<double>(b, step);
        std::vector<double> result(channels, 0.0);
        for (int ky = 0; ky < blocks.height; ++ky) {
            for (int kx = 1 - blocks.width; kx < blocks.width; ++kx) {
                const double x = kx * step;
                const double y = ky * step;
                const double weight = (ky == 0 ? 1.0 : 2.0) * overlap(x * cosine + y * sine, a) *
                                      overlap(y * cosine - x * sine, b);
                const auto n = static_cast<std::size_t>(ky * columns + kx + blocks.width - 1);
                for (std::size_t c = 0; weight > 0.0 && c < channels; ++c)
                    result[c] += weight * covariance[c][n];
            }
        }
        return result;
    };

    const Size footprint = texton.footprint();
    const double reach = std::max(footprint.width, footprint.height);
    FilterFade fade{texton.channels(), {}};
    fade.ratios.reserve(channels * FilterFade::kMajor * FilterFade::kMinor * FilterFade::kAngles);
    for (int k = 0; k < FilterFade::kAngles; ++k) {
        const double angle = std::numbers::pi * k / FilterFade::kAngles;
        for (int j = 0; j < FilterFade::kMinor; ++j) {
            const double b = std::ldexp(reach, j - FilterFade::kMinorOctaves);
            const auto clamped = variances(angle, reach, std::min(b, reach));
            for (int i = 0; i < FilterFade::kMajor; ++i) {
                const auto full = variances(angle, std::ldexp(reach, i), b);
                for (std::size_t c = 0; c < channels; ++c) {
                    const double ratio =
                        clamped[c] > 0.0 ? std::sqrt(std::max(0.0, full[c]) / clamped[c]) : 0.0;
                    fade.ratios.push_back(static_cast<float>(std::min(ratio, 1.0)));
                }
            }
        }
    }
    return fade;
}

} // namespace txn
