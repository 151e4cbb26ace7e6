// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/LeastSquaresTexton.h"

#include "core/texton/CovarianceObjective.h"

#include <algorithm>
#include <cmath>
#include <lbfgs.h>
#include <limits>

namespace txn {
namespace {

constexpr int kMemory = 8;
constexpr int kStop = 1; ///< any value but 0 ends lbfgs()

struct Run {
    const CovarianceObjective& objective;
    const LeastSquaresParams& params;
    const TextonObserver& observe;
    const CancelToken& cancel;
};

std::span<const double> values(const lbfgsfloatval_t* x, int n) {
    return {x, static_cast<std::size_t>(n)};
}

lbfgsfloatval_t
evaluate(void* instance, const lbfgsfloatval_t* x, lbfgsfloatval_t* g, int n, lbfgsfloatval_t) {
    const auto& run = *static_cast<const Run*>(instance);
    if (run.cancel.cancelled()) { // the line search has no way out but giving up
        std::fill_n(g, n, 0.0);
        return std::numeric_limits<double>::infinity();
    }
    return run.objective.evaluate(values(x, n), {g, static_cast<std::size_t>(n)});
}

int progress(void* instance,
             const lbfgsfloatval_t* x,
             const lbfgsfloatval_t*,
             lbfgsfloatval_t fx,
             lbfgsfloatval_t,
             lbfgsfloatval_t,
             lbfgsfloatval_t,
             int n,
             int k,
             int) {
    const auto& run = *static_cast<const Run*>(instance);
    if (run.observe && !run.cancel.cancelled())
        run.observe({k,
                     run.params.iterations,
                     [&] { return std::sqrt(fx); },
                     [&] { return run.objective.texton(values(x, n)); }});
    return run.cancel.cancelled() ? kStop : 0;
}

} // namespace

Result<Texton> fitTexton(const GaussianModel& model,
                         const LeastSquaresParams& params,
                         const TextonObserver& observe,
                         const CancelToken& cancel) {
    if (params.iterations < 1 || params.iterations > 10000)
        return Error{ErrorCode::InvalidArgument, "iterations must be between 1 and 10000"};
    const auto objective =
        CovarianceObjective::create(model,
                                    {params.support, params.interpolationOrder, params.kernels},
                                    params.channelWeights);
    if (!objective)
        return objective.error();

    if (params.start && !objective->fits(*params.start))
        return Error{ErrorCode::SizeMismatch,
                     "the kernels to begin with do not have the shape of those to be found"};
    std::vector<double> gamma =
        params.start ? objective->variablesOf(*params.start) : objective->start(params.seed);
    lbfgs_parameter_t settings;
    lbfgs_parameter_init(&settings);
    settings.m = kMemory;
    settings.max_iterations = params.iterations;
    // Single precision has no more to give.
    settings.epsilon = 1e-7;
    settings.past = 3;
    settings.delta = 1e-5;
    Run run{*objective, params, observe, cancel};
    // Whatever else ends it (no step gets any lower: rounding errors), gamma holds the best values.
    lbfgs(static_cast<int>(gamma.size()),
          gamma.data(),
          nullptr,
          evaluate,
          progress,
          &run,
          &settings);
    if (cancel.cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    return objective->texton(gamma);
}

} // namespace txn
