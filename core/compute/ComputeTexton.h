// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/gaussian/GaussianModel.h"
#include "core/texton/Texton.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace txn {

/// Fit: least squares on the exemplar's covariance, with one or several kernels (ours).
/// Projections: the papers' alternating projections on its spectrum, with one.
enum class TextonMethod { Fit, Projections };

/// "fit" or "projections".
[[nodiscard]] std::string_view toString(TextonMethod method);

/// All that decides on a texton, beside the exemplar.
struct ComputeParams {
    TextonMethod method = TextonMethod::Fit;
    Support support = Support::rectangle({64, 64});
    int interpolationOrder = 1;  ///< 0, 1, 3 or 5
    std::optional<int> kernels;  ///< of a fit, 1 to 16; unset: chosen by a trial
    int iterations = 50;         ///< of projections, 1 to 100000
    double momentum = 0.9;       ///< of projections, 0 to below 1
    bool colorCorrection = true; ///< colour covariance at lag 0 made exact afterwards
    Seed seed;
};

/// What is known after an iteration. Valid during the call only.
struct ComputeProgress {
    double share = 0.0; ///< of all the work, 0 to 1, as far as it can be told
    /// Trials show textons, too, of half the exemplar.
    bool choosingKernels = false;
    int kernels = 1;
    int iteration = 0; ///< of this trial, or of the texton itself
    int iterations = 0;
    /// What the method makes small: see TextonProgress.
    std::function<double()> error;
    /// The texton as it is now, colour corrected where asked for.
    std::function<Texton()> texton;
};
using ComputeObserver = std::function<void(const ComputeProgress&)>;

struct ComputedTexton {
    Texton texton;
    /// What the method made small, before colour correction: see TextonProgress.
    double error = 0.0;
    /// Where the number of kernels was chosen: see KernelChoice.
    std::vector<double> trialErrors{};
    /// Of projections, after colour correction (equal without).
    std::optional<double> relativeModelError;
};

/// The texton of the exemplar, whose model is given. The channels of stacks are weighed by
/// channelWeights. Asks cancel at every evaluation; uses all cores of the calling task arena, with
/// the same bits for any number of them. Thread-safe.
/// Errors: those of TextonSolver::create, fitTexton and chooseKernels; Cancelled.
[[nodiscard]] Result<ComputedTexton> computeTexton(const Exemplar& exemplar,
                                                   const GaussianModel& model,
                                                   const ComputeParams& params,
                                                   const ComputeObserver& observe = {},
                                                   const CancelToken& cancel = {});

} // namespace txn
