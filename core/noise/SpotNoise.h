// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/MixedProcess.h"

#include <span>

namespace txn {

/// h_q(y) of channel c: sum over k of alpha_q(k) psi(x - kx) psi(y - ky). Zero far outside.
[[nodiscard]] double kernelValue(const Texton& texton, int kernel, int channel, double x, double y);

/// Noise of a texton or a mixture at any point of the plane, in double precision: the reference
/// that the other evaluators are tested against. Const members are thread-safe.
///
/// Plane coordinates are exemplar pixels, pixel n covers [n, n + 1) and is seen at its centre. An
/// impulse at x_j drops the footprint on [x_j, x_j + F): coefficient k is centred on
/// x_j + frame + 1/2 + k.
class SpotNoise {
  public:
    /// mixture and params: checked by checkMixedNoise.
    SpotNoise(Mixture mixture, const NoiseParams& params) : m_process(std::move(mixture), params) {}

    /// Writes the C channels at (x, y), |x|, |y| <= NoiseParams::kFarthest.
    void evaluate(double x, double y, std::span<double> out) const;

  private:
    MixedProcess m_process;
};

} // namespace txn
