// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <vector>

namespace txn {

/// What a texture's spectrum, correlations and values look like, for the eye.
struct TextureAnalysis {
    static constexpr int kBins = 128;
    static constexpr double kDecibels = 60.0; ///< from the brightest to the darkest of logPower

    /// 1 channel, side x side, frequency 0 in the middle: the mean power of the channels, from 0
    /// (kDecibels below the peak, or less) to 1 (the peak).
    Image logPower;
    /// The peak itself: the power of the strongest wave in the mean over squares and channels, in
    /// samples squared; by the ratio of two, two pictures can be shown on one scale.
    double peakPower = 0.0;
    /// 1 channel, side / 2 x side / 2, lag 0 in the middle: mean correlation of the channels, 1 at
    /// lag 0.
    Image autocorrelation;
    /// Per channel kBins shares of all samples, over [histogramFrom, histogramTo].
    std::vector<std::vector<double>> histograms;
    double histogramFrom = 0.0;
    double histogramTo = 1.0;
};

/// sidePx: of the squares that the spectrum is estimated from (Welch: the mean over windowed
/// squares); even, 16 to 512. A smaller image is repeated. histogramFrom/To: where noise of
/// pictures in [0, 1] lies. Any thread, on the cores of the calling arena.
[[nodiscard]] TextureAnalysis analyseTexture(const Image& image, int sidePx = 256);

} // namespace txn
