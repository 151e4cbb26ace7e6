// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compute/MethodParams.h"

#include <utility>

namespace txn {

LeastSquaresParams leastSquaresParams(const ComputeParams& params,
                                      std::vector<double> channelWeights) {
    LeastSquaresParams result;
    result.support = params.support;
    result.interpolationOrder = params.interpolationOrder;
    result.kernels = params.kernels.value_or(1);
    result.seed = params.seed;
    result.channelWeights = std::move(channelWeights);
    return result;
}

TextonParams projectionParams(const ComputeParams& params) {
    return {params.support,
            params.interpolationOrder,
            params.iterations,
            params.momentum,
            params.seed};
}

} // namespace txn
