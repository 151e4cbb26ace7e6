// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compute/ComputeTexton.h"
#include "core/texton/LeastSquaresTexton.h"
#include "core/texton/TextonParams.h"

#include <vector>

namespace txn {

// The part of ComputeParams that each method takes.

/// Of as many kernels as asked for, 1 where they are to be chosen.
[[nodiscard]] LeastSquaresParams leastSquaresParams(const ComputeParams& params,
                                                    std::vector<double> channelWeights);
[[nodiscard]] TextonParams projectionParams(const ComputeParams& params);

} // namespace txn
