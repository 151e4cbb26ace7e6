// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Commands.h"
#include "core/gaussian/GaussianModel.h"
#include "core/texton/Texton.h"
#include "core/texton/TextonParams.h"

#include <optional>

namespace txn::cli {

/// How a texton is computed, for `compute` and `sheet`.
struct SolveOptions {
    Size support{64, 64};
    std::string shape = "square";
    int order = 1;
    std::string method = "projections"; ///< or "fit"
    std::string kernels = "auto";       ///< of a fit: or a number
    int iterations = 50;
    double momentum = 0.9;
    std::uint32_t seed = 1;
    bool noPeriodic = false;
    bool noColorCorrection = false;
};

void addSolveOptions(CLI::App& app, SolveOptions& options);

/// A texton with its relative model errors, before and after colour correction (equal without); a
/// fit has none.
struct Solved {
    Texton texton;
    std::optional<double> error;
    std::optional<double> correctedError;
};

/// Computes the texton of the exemplar, whose model is given, with a progress bar. Errors: those of
/// TextonSolver and fitTexton; InvalidArgument for a disc that is not round; Cancelled.
[[nodiscard]] Result<Solved> solve(const Exemplar& exemplar,
                                   const GaussianModel& model,
                                   const SolveOptions& options,
                                   const CancelToken& cancel);

} // namespace txn::cli
