// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/ImpulseProcess.h"
#include "core/texton/Texton.h"

#include <vector>

namespace txn {

/// Texton noise = offset + gain * (sum of signed kernels), per channel:
///     g(x) = m + sqrt(Q / lambda) sum_j e_j h_{q_j}(x - x_j)
///            - [Poisson only] sqrt(lambda / Q) sum_q sum_k alpha_q(k).
/// [TN17] eq. 2 for Q = 1.
struct Normalization {
    double gain = 1.0;
    std::vector<double> offset; ///< C values
};

/// Sum over kernels and positions of the coefficients of each of the C channels.
[[nodiscard]] std::vector<double> kernelSums(const Texton& texton);

[[nodiscard]] Normalization normalization(const Texton& texton, const ImpulseProcess& impulses);

} // namespace txn
