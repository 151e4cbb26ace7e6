// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/texton/Texton.h"

namespace txn {

/// How far the covariance of a texton's noise is from its exemplar's, and how far two halves of the
/// exemplar are from each other: below about 1 x the floor nobody can tell the texton from another
/// photograph of the same material by its covariance.
///
/// Of stacks, the channels count by channelWeights.
struct CovarianceError {
    /// |C_alpha - C| / |C| over the lags |k_x|, |k_y| <= lag, C the unbiased covariance of the
    /// whole exemplar, not wrapped.
    double error = 0.0;
    /// Root mean square, over the left-right and the top-bottom cut, of |C_1 - C_2| / (2 |C|).
    double floor = 0.0;
    int lag =
        0; ///< half the shorter side of the support, or less for small exemplars and many channels
};

/// The floor alone, for lags that leave room in the exemplar's halves; relative to the whole.
[[nodiscard]] double covarianceErrorFloor(const Exemplar& exemplar, int lag);

/// The exemplar in the texton's transfer, at least 4 x 4. Errors: SizeMismatch for other channel
/// counts or a smaller exemplar; Degenerate for one without variation. Thread-safe.
[[nodiscard]] Result<CovarianceError> covarianceError(const Exemplar& exemplar,
                                                      const Texton& texton);

} // namespace txn
