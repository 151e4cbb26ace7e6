// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/texton/LeastSquaresTexton.h"

namespace txn {

/// The most kernels that are tried for so many channels.
[[nodiscard]] int mostTrialKernels(int channels);

struct KernelChoice {
    int kernels = 1;
    /// Of 1, 2, ... kernels: |C_alpha - C| / |C| on the half that the fit has not seen. Empty where
    /// there was nothing to try on.
    std::vector<double> errors;
};

using KernelTrialObserver = std::function<void(int kernels, const TextonProgress&)>;

/// The number of kernels by a trial: fits 1, 2 and, for more than three channels, up to
/// min(channels, 4) of them on one half of the exemplar (cut across its longer side) and takes the
/// fewest within 5 % of the best error on the other half. 1 where half of the exemplar is smaller
/// than the support. Errors count channels by params.channelWeights. observe hears of every
/// iteration of every trial and of its number of kernels. Uses all cores of the calling task arena.
/// Errors: those of fitTexton; Degenerate for a half without variation; Cancelled.
[[nodiscard]] Result<KernelChoice> chooseKernels(const Exemplar& exemplar,
                                                 bool periodic,
                                                 const LeastSquaresParams& params,
                                                 const KernelTrialObserver& observe = {},
                                                 const CancelToken& cancel = {});

} // namespace txn
