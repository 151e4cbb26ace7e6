// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compute/ComputeTexton.h"

#include "core/compute/MethodParams.h"
#include "core/gaussian/ChannelWeights.h"
#include "core/qa/KernelChoice.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/LeastSquaresTexton.h"
#include "core/texton/TextonSolver.h"

namespace txn {
namespace {

/// A fit of q kernels takes about as long as 1 + q.
double workOf(int kernels) {
    return 1.0 + kernels;
}

double workOfAll(int kernels) {
    double sum = 0.0;
    for (int q = 1; q <= kernels; ++q)
        sum += workOf(q);
    return sum;
}

class Computation {
  public:
    Computation(const Exemplar& exemplar,
                const GaussianModel& model,
                const ComputeParams& params,
                const ComputeObserver& observe,
                const CancelToken& cancel)
        : m_exemplar(exemplar), m_model(model), m_params(params), m_observe(observe),
          m_cancel(cancel) {}

    Result<ComputedTexton> fit() const {
        auto params = leastSquaresParams(m_params, channelWeights(m_exemplar));
        const int most = mostTrialKernels(m_model.channels());
        const double trials = m_params.kernels ? 0.0 : workOfAll(most);
        std::vector<double> trialErrors;
        // The trials end with the number of kernels; until then it may be any.
        const double all = trials + workOf(m_params.kernels.value_or(most));
        if (!m_params.kernels) {
            auto chosen = chooseKernels(
                m_exemplar,
                m_model.isPeriodicComponent(),
                params,
                [&](int kernels, const TextonProgress& now) {
                    const double share = static_cast<double>(now.iteration) / now.iterations;
                    tell(now, (workOfAll(kernels - 1) + share * workOf(kernels)) / all, kernels);
                },
                m_cancel);
            if (!chosen)
                return chosen.error();
            params.kernels = chosen->kernels;
            trialErrors = std::move(chosen->errors);
        }
        double error = 0.0;
        auto fitted = fitTexton(
            m_model,
            params,
            [&](const TextonProgress& now) {
                error = now.error();
                const double share = static_cast<double>(now.iteration) / now.iterations;
                tell(now, (trials + share * (all - trials)) / all, params.kernels, false);
            },
            m_cancel);
        if (!fitted)
            return fitted.error();
        return ComputedTexton{corrected(std::move(*fitted)),
                              error,
                              std::move(trialErrors),
                              std::nullopt};
    }

    Result<ComputedTexton> project() const {
        const TextonParams params = projectionParams(m_params);
        auto solver = TextonSolver::create(m_model, params);
        if (!solver)
            return solver.error();
        while (!solver->done()) {
            if (m_cancel.cancelled())
                return Error{ErrorCode::Cancelled, "cancelled"};
            solver->step();
            tell({solver->iteration(),
                  params.iterations,
                  [&] { return solver->relativeModelError(); },
                  [&] { return solver->texton(); }},
                 static_cast<double>(solver->iteration()) / params.iterations,
                 1,
                 false);
        }
        ComputedTexton result{corrected(solver->texton()), solver->relativeModelError(), {}, {}};
        result.relativeModelError =
            m_params.colorCorrection ? solver->relativeModelError(result.texton) : result.error;
        return result;
    }

  private:
    Texton corrected(Texton texton) const {
        return m_params.colorCorrection ? colorCorrected(texton, m_model.covariance())
                                        : std::move(texton);
    }
    void tell(const TextonProgress& now, double share, int kernels, bool choosing = true) const {
        if (m_observe)
            m_observe({share, choosing, kernels, now.iteration, now.iterations, now.error, [&] {
                           return corrected(now.texton());
                       }});
    }

    const Exemplar& m_exemplar;
    const GaussianModel& m_model;
    const ComputeParams& m_params;
    const ComputeObserver& m_observe;
    const CancelToken& m_cancel;
};

} // namespace

std::string_view toString(TextonMethod method) {
    return method == TextonMethod::Fit ? "fit" : "projections";
}

Result<ComputedTexton> computeTexton(const Exemplar& exemplar,
                                     const GaussianModel& model,
                                     const ComputeParams& params,
                                     const ComputeObserver& observe,
                                     const CancelToken& cancel) {
    const Computation computation(exemplar, model, params, observe, cancel);
    return params.method == TextonMethod::Fit ? computation.fit() : computation.project();
}

} // namespace txn
