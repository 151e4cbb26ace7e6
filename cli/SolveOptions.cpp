// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/SolveOptions.h"

#include "cli/Parse.h"
#include "cli/Report.h"
#include "core/qa/KernelChoice.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/LeastSquaresTexton.h"
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
        ->check(CLI::IsMember({"projections", "fit"}))
        ->capture_default_str();
    app.add_option("--kernels",
                   options.kernels,
                   "Of --method fit: how many kernels impulses choose from, 1 to 16; more follow "
                   "colors that vary independently")
        ->type_name("auto|N")
        ->check(CLI::IsMember({"auto"}) | CLI::Range(1, 16))
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

namespace {

constexpr int kFitIterations = 80;

/// By least squares; the iterations and momentum are those of the other method.
Result<Solved> fit(const Exemplar& exemplar,
                   const GaussianModel& model,
                   const SolveOptions& options,
                   const Support& support,
                   const CancelToken& cancel) {
    LeastSquaresParams params;
    params.support = support;
    params.interpolationOrder = options.order;
    params.iterations = kFitIterations;
    params.seed.value = options.seed;
    const auto goOn = [&] { return !cancel.cancelled(); };
    if (options.kernels == "auto") {
        const BusySign sign("Choosing the number of kernels");
        const auto chosen = chooseKernels(exemplar, !options.noPeriodic, params, goOn);
        if (!chosen)
            return chosen.error();
        params.kernels = *chosen;
    } else {
        params.kernels = std::stoi(options.kernels);
    }
    ProgressBar bar("Fitting the texton");
    auto fitted = fitTexton(model, params, [&](const LeastSquaresProgress& now) {
        bar.update(static_cast<double>(now.iteration) / now.iterations);
        return goOn();
    });
    if (!fitted)
        return fitted.error();
    Solved result{std::move(*fitted), {}, {}};
    if (!options.noColorCorrection)
        result.texton = colorCorrected(result.texton, model.covariance());
    return result;
}

} // namespace

Result<Solved> solve(const Exemplar& exemplar,
                     const GaussianModel& model,
                     const SolveOptions& options,
                     const CancelToken& cancel) {
    const bool disc = options.shape == "disc";
    if (disc && options.support.width != options.support.height)
        return Error{ErrorCode::InvalidArgument, "a disc needs one number for --support"};
    TextonParams params;
    params.support = Support::rectangle(options.support);
    const Size domain = model.domain();
    // A disc that does not fit is refused below for its size, before its mask takes any memory.
    if (disc && options.support.width <= std::min(domain.width, domain.height))
        params.support = Support::disc(options.support.width);
    if (options.method == "fit")
        return fit(exemplar, model, options, params.support, cancel);
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
    Solved result{solver->texton(), solver->relativeModelError(), {}};
    result.correctedError = result.error;
    if (!options.noColorCorrection) {
        result.texton = colorCorrected(result.texton, model.covariance());
        result.correctedError = solver->relativeModelError(result.texton);
    }
    return result;
}

} // namespace txn::cli
