// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"

#include <vector>

namespace txn {

/// How much fainter noise gets when it is averaged over a box, once a side of the box is longer
/// than the footprint: sigma(a, b) / sigma(min(a, F), min(b, F)), F the longer side of the
/// footprint. Evaluators on the GPU widen their filters to F at most and multiply by this.
///
/// One table for boxes with the longer side a = F 2^i at the angle pi k / kAngles to the x axis and
/// the shorter side b = F 2^(j - kMinorOctaves): value (i, j, k) of channel c is
/// ratios[((k * kMinor + j) * kMajor + i) * channels + c].
struct FilterFade {
    static constexpr int kMajor = 8;
    static constexpr int kMinorOctaves = 4;
    static constexpr int kMinor = kMinorOctaves + kMajor;
    static constexpr int kAngles = 8;

    int channels = 0;
    std::vector<float> ratios;
};

/// From the covariance of the texton's noise. A kernel is taken at most 32 samples wide: details
/// finer than that are long averaged away.
[[nodiscard]] FilterFade filterFade(const Texton& texton);

} // namespace txn
