// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"
#include "core/texton/Support.h"

#include <optional>
#include <span>
#include <vector>

namespace txn {

/// A texton: Q >= 1 kernels h_q(y) = sum_k alpha_q(k) psi(y - k) on one support, psi the B-spline
/// of the interpolation order, and the mean colour. Every impulse of a texton noise picks one of
/// the kernels, uniformly; coefficients are stored unscaled, so that the covariance of the noise is
/// the plain sum of the kernels' own. The papers: Q = 1. A regular value type.
struct Texton {
    /// Q images of the support's size, C channels each, zero outside the support.
    std::vector<Image> kernels;
    Support support = Support::rectangle({1, 1});
    int interpolationOrder = 1;
    std::vector<double> mean; ///< C values
    Transfer transfer = Transfer::Encoded;

    int channels() const { return static_cast<int>(mean.size()); }
    int kernelCount() const { return static_cast<int>(kernels.size()); }

    /// Width of the border of zeros that makes interpolation fall to zero: max(1, (order + 1) / 2).
    int frame() const { return frameFor(interpolationOrder); }
    static int frameFor(int order) { return order <= 1 ? 1 : (order + 1) / 2; }

    /// Support plus frame: the one source of the intensity lambda = MNI / (Fx Fy), for CPU, GPU and
    /// exports. A disc's or mask's is that of its bounding rectangle.
    Size footprint() const {
        const Size s = support.size();
        return {s.width + 2 * frame(), s.height + 2 * frame()};
    }

    bool operator==(const Texton&) const = default;
};

/// Where a channel comes from: one of a texton's own, or a constant.
struct ChannelSource {
    std::optional<int> channel;
    double constant = 0.0; ///< where channel is unset
};
/// A texton of the same kernels with these channels. Noise of it has the same impulses.
[[nodiscard]] Texton withChannels(const Texton& texton, std::span<const ChannelSource> channels);
/// The first count of a texton's channels.
[[nodiscard]] Texton firstChannels(const Texton& texton, int count);

/// C x C covariance at lag 0 of the noise of a texton, row-major: sum over kernels and lags of
/// b(lag) (alpha * alpha~)(lag). In double precision.
[[nodiscard]] std::vector<double> noiseCovariance(const Texton& texton);

} // namespace txn
