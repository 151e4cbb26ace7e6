// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compute/MixSolver.h"

#include "core/compute/MethodParams.h"
#include "core/gaussian/ChannelWeights.h"
#include "core/qa/KernelChoice.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/LeastSquaresTexton.h"
#include "core/texton/TextonSolver.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace txn {
namespace {

constexpr int kAnchors = 5; ///< rho = 0, 1/4 ... 1

bool isSame(double rho, double other) {
    return std::abs(rho - other) < 1e-12;
}

/// Which anchor an anchor starts from; none for the one in the middle.
std::optional<int> anchorBefore(int anchor) {
    constexpr int kMiddle = kAnchors / 2;
    if (anchor == kMiddle)
        return std::nullopt;
    return anchor < kMiddle ? anchor + 1 : anchor - 1;
}

/// Each holds a model of the whole domain: not more than fit into a gigabyte.
std::size_t mostAtOnce(const BarycentrePath& path) {
    constexpr std::size_t kBytes = std::size_t{1} << 30U;
    const std::size_t model =
        path.domain().area() * static_cast<std::size_t>(path.channels()) * sizeof(float);
    return std::max<std::size_t>(1, kBytes / model);
}

/// (1 - share) a + share b, coefficient by coefficient.
Texton between(const Texton& a, const Texton& b, double share) {
    Texton result = a;
    for (std::size_t q = 0; q < a.kernels.size(); ++q) {
        const auto from = b.kernels[q].samples();
        const auto to = result.kernels[q].samples();
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += static_cast<float>(share) * (from[i] - to[i]);
    }
    return result;
}

} // namespace

Result<MixSolver> MixSolver::create(BarycentrePath path,
                                    const ComputeParams& params,
                                    std::vector<double> weights,
                                    int textons,
                                    MixedTextons known) {
    if (textons < kMinTextons || textons > kMaxTextons)
        return Error{ErrorCode::InvalidArgument,
                     "the number of textons must be between " + std::to_string(kMinTextons) +
                         " and " + std::to_string(kMaxTextons)};
    MixSolver solver(std::move(path), params, std::move(weights));
    solver.plan(textons, std::move(known));
    return solver;
}

/// Anchors of fits first, from the middle outwards, then what is left.
void MixSolver::plan(int textons, MixedTextons known) {
    const auto isKnown = [&](double rho) {
        return std::ranges::any_of(known.textons,
                                   [&](const MixedTexton& one) { return isSame(one.rho, rho); });
    };
    std::vector<double> wanted;
    for (int r = 0; r < textons; ++r) {
        const double rho = static_cast<double>(r) / (textons - 1);
        if (!isKnown(rho))
            wanted.push_back(rho);
    }
    for (MixedTexton& one : known.textons) {
        const double position = one.rho * (textons - 1);
        if (isSame(position, std::round(position)))
            m_result.textons.push_back(std::move(one));
    }
    const bool fits = m_params.method == TextonMethod::Fit;
    m_result.anchors = fits ? std::move(known.anchors) : std::vector<Texton>();
    if (fits && m_result.anchors.empty() && !wanted.empty()) {
        m_result.anchors.resize(kAnchors);
        for (const int anchor : {2, 1, 3, 0, 4}) {
            const double rho = static_cast<double>(anchor) / (kAnchors - 1);
            const auto at = std::ranges::find_if(wanted, [&](double w) { return isSame(w, rho); });
            m_tasks.push_back({rho,
                               at != wanted.end(),
                               (static_cast<std::size_t>(std::abs(anchor - kAnchors / 2)))});
            if (at != wanted.end())
                wanted.erase(at);
        }
    }
    for (const double rho : wanted)
        m_tasks.push_back({rho, true, kAnchors});
}

double MixSolver::share() const {
    return m_tasks.empty() ? 1.0
                           : static_cast<double>(m_next) / static_cast<double>(m_tasks.size());
}

Result<void> MixSolver::step(const CancelToken& cancel) {
    if (done())
        return {};
    // Those of one wave do not wait for each other.
    const auto cores = std::min(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                                mostAtOnce(m_path));
    std::size_t end = m_next;
    while (end < m_tasks.size() && end < m_next + cores &&
           m_tasks[end].wave == m_tasks[m_next].wave)
        ++end;
    std::vector<std::optional<Result<Found>>> found(end - m_next);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
        found[i] = compute(m_tasks[m_next + i], cancel);
    });
    for (const auto& one : found) {
        if (!*one)
            return one->error();
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Task& task = m_tasks[m_next + i];
        Found& one = **found[i];
        if (task.wave < kAnchors && m_params.method == TextonMethod::Fit)
            m_result.anchors[static_cast<std::size_t>(std::lround(task.rho * (kAnchors - 1)))] =
                std::move(one.raw);
        if (task.wanted)
            m_result.textons.insert(
                std::ranges::upper_bound(m_result.textons, task.rho, {}, &MixedTexton::rho),
                std::move(one.texton));
    }
    m_next = end;
    return {};
}

Result<MixSolver::Found> MixSolver::compute(const Task& task, const CancelToken& cancel) const {
    const GaussianModel model = m_path.at(task.rho);
    auto found = m_params.method == TextonMethod::Fit ? fit(model, task.rho, cancel)
                                                      : project(model, cancel);
    if (!found)
        return found;
    found->texton.rho = task.rho;
    found->texton.distance = m_path.distanceTo(model);
    found->texton.texton =
        m_params.colorCorrection ? colorCorrected(found->raw, model.covariance()) : found->raw;
    return found;
}

std::optional<Texton> MixSolver::startOf(double rho) const {
    const auto& anchors = m_result.anchors;
    const double position = rho * (kAnchors - 1);
    const auto nearest = static_cast<int>(std::lround(position));
    if (isSame(position, nearest)) {
        const auto before = anchorBefore(nearest);
        return before ? std::optional(anchors[static_cast<std::size_t>(*before)]) : std::nullopt;
    }
    const auto left = static_cast<std::size_t>(position);
    return between(anchors[left], anchors[left + 1], position - static_cast<double>(left));
}

Result<MixSolver::Found>
MixSolver::fit(const GaussianModel& model, double rho, const CancelToken& cancel) const {
    LeastSquaresParams params = leastSquaresParams(m_params, m_weights);
    params.start = startOf(rho);
    Found result;
    auto fitted = fitTexton(
        model,
        params,
        [&](const TextonProgress& now) { result.texton.error = now.error(); },
        cancel);
    if (!fitted)
        return fitted.error();
    result.raw = std::move(*fitted);
    return result;
}

Result<MixSolver::Found> MixSolver::project(const GaussianModel& model,
                                            const CancelToken& cancel) const {
    auto solver = TextonSolver::create(model, projectionParams(m_params));
    if (!solver)
        return solver.error();
    while (!solver->done()) {
        if (cancel.cancelled())
            return Error{ErrorCode::Cancelled, "cancelled"};
        solver->step();
    }
    Found result;
    result.raw = solver->texton();
    result.texton.error = solver->relativeModelError();
    return result;
}

Result<MixSolver>
makeMixSolver(const MixRequest& request, MixedTextons known, const CancelToken& cancel) {
    auto path = BarycentrePath::create(request.a, request.b, request.periodicA, request.periodicB);
    if (!path)
        return path.error();
    const auto weightsA = channelWeights(request.a);
    const auto weightsB = channelWeights(request.b);
    std::vector<double> weights;
    for (std::size_t c = 0; c < weightsA.size(); ++c)
        weights.push_back(2.0 / (1.0 / weightsA[c] + 1.0 / weightsB[c]));
    ComputeParams params = request.params;
    if (params.method == TextonMethod::Fit && !params.kernels && !known.textons.empty())
        params.kernels = known.textons.front().texton.kernelCount(); // chosen already
    if (params.method == TextonMethod::Fit && !params.kernels) {
        for (const Exemplar* exemplar : {&request.a, &request.b}) {
            const auto trial = leastSquaresParams(params, channelWeights(*exemplar));
            const bool periodic = exemplar == &request.a ? request.periodicA : request.periodicB;
            const auto chosen = chooseKernels(*exemplar, periodic, trial, {}, cancel);
            if (!chosen)
                return chosen.error();
            params.kernels = std::max(params.kernels.value_or(1), chosen->kernels);
        }
    }
    return MixSolver::create(std::move(*path),
                             params,
                             std::move(weights),
                             request.textons,
                             std::move(known));
}

} // namespace txn
