// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Commands.h"
#include "core/compute/ComputeTexton.h"
#include "core/qa/CovarianceError.h"
#include "core/qa/SupportSuggestion.h"

#include <optional>
#include <string>

namespace txn::cli {

/// How a texton is computed, for `compute` and `sheet`.
struct SolveOptions {
    std::optional<Size> support{{64, 64}}; ///< unset: as suggested
    std::string shape = "square";
    int order = 1;
    std::string method = "fit";   ///< or "projections"
    std::string kernels = "auto"; ///< of a fit: or a number
    int iterations = 50;          ///< of projections, as is momentum
    double momentum = 0.9;
    std::uint32_t seed = 1;
    bool noPeriodic = false;
    bool noColorCorrection = false;
};

void addSolveOptions(CLI::App& app, SolveOptions& options);

/// What they ask for, with a support of that size for exemplars on that domain. Errors:
/// InvalidArgument for a disc that is not round.
[[nodiscard]] Result<ComputeParams>
computeParams(const SolveOptions& options, Size support, Size domain);

/// What `compute` reports of a texton.
struct Solved {
    ComputedTexton computed;
    std::optional<SupportSuggestion> suggestion; ///< where the support was suggested
    /// Unset for exemplars that are too small to be compared with themselves.
    std::optional<CovarianceError> dial;
};

/// Computes the texton of the exemplar, whose model is given, with a progress bar. Errors: those of
/// computeTexton, suggestSupport and computeParams; Cancelled.
[[nodiscard]] Result<Solved> solve(const Exemplar& exemplar,
                                   const GaussianModel& model,
                                   const SolveOptions& options,
                                   const CancelToken& cancel);

/// "covariance error 1.1 x the floor".
[[nodiscard]] std::string inWords(const CovarianceError& dial);

} // namespace txn::cli
