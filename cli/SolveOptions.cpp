// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/SolveOptions.h"

#include "cli/Parse.h"
#include "cli/Report.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"

#include <algorithm>

namespace txn::cli {

void addSolveOptions(CLI::App& app, SolveOptions& options) {
    addParsed(app,
              "--support",
              options.support,
              parseSize,
              "N|WxH",
              "Size of the texton, in pixels (default: 64)");
    app.add_option("--shape", options.shape, "square (all of the support) or disc")
        ->check(CLI::IsMember({"square", "disc"}))
        ->capture_default_str();
    app.add_option("--order",
                   options.order,
                   "Interpolation order: 0 nearest, 1 linear, 3 cubic, 5 quintic")
        ->check(CLI::IsMember({0, 1, 3, 5}))
        ->capture_default_str();
    app.add_option("--method", options.method, "How the texton is found")
        ->check(CLI::IsMember({"projections"}))
        ->capture_default_str();
    app.add_option("--iterations", options.iterations, "More are slower and a little better")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--momentum", options.momentum, "0 for the papers' plain iteration, below 1")
        ->check(between(0.0, 0.999))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Another number gives another, equally good result")
        ->capture_default_str();
    app.add_flag("--no-periodic",
                 options.noPeriodic,
                 "The exemplar tiles already: leave its borders alone");
    app.add_flag("--no-color-correction",
                 options.noColorCorrection,
                 "Leave the colours as the iteration found them");
}

Result<Solved>
solve(const GaussianModel& model, const SolveOptions& options, const CancelToken& cancel) {
    const bool disc = options.shape == "disc";
    if (disc && options.support.width != options.support.height)
        return Error{ErrorCode::InvalidArgument, "a disc needs one number for --support"};
    TextonParams params;
    params.support = Support::rectangle(options.support);
    const Size domain = model.domain();
    // A disc that does not fit is refused below for its size, before its mask takes any memory.
    if (disc && options.support.width <= std::min(domain.width, domain.height))
        params.support = Support::disc(options.support.width);
    params.interpolationOrder = options.order;
    params.iterations = options.iterations;
    params.momentum = options.momentum;
    params.seed.value = options.seed;
    auto solver = TextonSolver::create(model, params);
    if (!solver)
        return solver.error();
    ProgressBar bar("Computing the texton");
    while (!solver->done()) {
        if (cancel.cancelled())
            return Error{ErrorCode::Cancelled, "cancelled"};
        solver->step();
        bar.update(static_cast<double>(solver->iteration()) / options.iterations);
    }
    Solved result{solver->texton(), solver->relativeModelError(), 0.0};
    result.correctedError = result.error;
    if (!options.noColorCorrection) {
        result.texton = colorCorrected(result.texton, model.covariance());
        result.correctedError = solver->relativeModelError(result.texton);
    }
    return result;
}

} // namespace txn::cli
