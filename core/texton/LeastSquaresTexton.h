// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"
#include "core/texton/TextonProgress.h"

#include <optional>
#include <vector>

namespace txn {

/// How a texton is fitted to an exemplar's covariance.
struct LeastSquaresParams {
    Support support = Support::rectangle({64, 64});
    int interpolationOrder = 1; ///< 0, 1, 3 or 5
    int kernels = 1;            ///< Q, 1 to 16
    int iterations = 80;        ///< 1 to 10000; fewer where nothing gets better any more
    Seed seed;
    /// Factors on the channels inside the fit; empty: 1. For maps of different units, such as
    /// 1 / max(standard deviation, 1/255).
    std::vector<double> channelWeights;
    /// Kernels to begin with, of the same shape and channels; unset: white noise.
    std::optional<Texton> start;

    bool operator==(const LeastSquaresParams&) const = default;
};

/// Kernels whose noise has the exemplar's covariance up to lags of the support, by least squares:
/// L-BFGS (memory 8) on CovarianceObjective, from tapered white noise unless told otherwise.
/// Several kernels follow a covariance whose channels move independently, which one cannot. Asks
/// cancel at every evaluation. Uses all cores of the calling task arena; the same bits for any
/// number of them. Thread-safe. Errors: those of CovarianceObjective::create; InvalidArgument for
/// iterations out of range; SizeMismatch for a start that does not fit; Cancelled.
[[nodiscard]] Result<Texton> fitTexton(const GaussianModel& model,
                                       const LeastSquaresParams& params,
                                       const TextonObserver& observe = {},
                                       const CancelToken& cancel = {});

} // namespace txn
