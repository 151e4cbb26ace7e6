// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/texton/LeastSquaresTexton.h"

namespace txn {

/// The number of kernels by a trial: fits 1, 2 and, for more than three channels, up to
/// min(channels, 4) of them on one half of the exemplar (cut across its longer side) and takes the
/// fewest within 5 % of the best error on the other half. 1 where half of the exemplar is smaller
/// than the support. observe is asked now and then whether to go on. Uses all cores of the calling
/// task arena.
/// Errors: those of fitTexton; Degenerate for a half without variation; Cancelled.
[[nodiscard]] Result<int> chooseKernels(const Exemplar& exemplar,
                                        bool periodic,
                                        const LeastSquaresParams& params,
                                        const std::function<bool()>& observe = {});

} // namespace txn
