// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compute/ComputeTexton.h"
#include "core/gaussian/Barycentre.h"

#include <vector>

namespace txn {

/// One of the textons between two exemplars.
struct MixedTexton {
    double rho = 0.0;
    Texton texton; ///< colour corrected where asked for
    /// What the method made small: see ComputedTexton.
    double error = 0.0;
    /// d_OT from exemplar A to the barycentre that the texton stands for.
    double distance = 0.0;
};

/// The textons between two exemplars, so far.
struct MixedTextons {
    std::vector<MixedTexton> textons; ///< in the order of rho
    /// Of fits: those at rho = 0, 1/4 ... 1, not colour corrected, from which the others start.
    std::vector<Texton> anchors;
};

/// Computes R textons at rho = 0, 1 / (R - 1), ..., 1, each that of the barycentre at rho, as a
/// stepper: the caller's loop owns progress, cancelling and previews.
///
///     while (!solver.done()) { if (!solver.step(cancel)) ...; ... solver.result() ... }
///
/// By projections, all start from one white noise ([TN17] section 7). By least squares, the one at
/// rho = 1/2 starts from white noise, those at 1/4 and 3/4 from it, those at 0 and 1 from these,
/// and all others between two of the five: kernels correspond, and change gradually with rho. A
/// texton depends on its rho only, not on R. One thread at a time; a step computes as many textons
/// as the calling task arena has cores, with the same bits for any number of them.
class MixSolver {
  public:
    static constexpr int kMinTextons = 2;
    static constexpr int kMaxTextons = 64;

    /// params.kernels: unset means 1. weights: see LeastSquaresParams::channelWeights. known: what
    /// an earlier solver found for the same path and params; it is not computed again.
    /// Errors: InvalidArgument for a number of textons out of range.
    [[nodiscard]] static Result<MixSolver> create(BarycentrePath path,
                                                  const ComputeParams& params,
                                                  std::vector<double> weights,
                                                  int textons,
                                                  MixedTextons known = {});

    /// Errors: those of TextonSolver::create and fitTexton; Cancelled. The solver may go on after
    /// Cancelled.
    [[nodiscard]] Result<void> step(const CancelToken& cancel = {});
    bool done() const { return m_next == m_tasks.size(); }
    /// Of the work, 0 to 1.
    double share() const;

    const BarycentrePath& path() const { return m_path; }
    /// Whatever is found by now.
    [[nodiscard]] const MixedTextons& result() const { return m_result; }

  private:
    struct Task {
        double rho = 0.0;
        bool wanted = false; ///< rather than an anchor only
        std::size_t wave = 0;
    };
    struct Found {
        Texton raw;
        MixedTexton texton;
    };

    MixSolver(BarycentrePath path, ComputeParams params, std::vector<double> weights)
        : m_path(std::move(path)), m_params(std::move(params)), m_weights(std::move(weights)) {}
    void plan(int textons, MixedTextons known);
    Result<Found> compute(const Task& task, const CancelToken& cancel) const;
    Result<Found> fit(const GaussianModel& model, double rho, const CancelToken& cancel) const;
    Result<Found> project(const GaussianModel& model, const CancelToken& cancel) const;
    std::optional<Texton> startOf(double rho) const;

    BarycentrePath m_path;
    ComputeParams m_params;
    std::vector<double> m_weights;
    std::vector<Task> m_tasks; ///< in the order of the work
    std::size_t m_next = 0;
    MixedTextons m_result;
};

/// What a MixSolver is made of, for two exemplars: their path, the larger of the numbers of kernels
/// that suit each where it is to be chosen, and weights of the channels that suit both.
struct MixRequest {
    const Exemplar& a;
    const Exemplar& b;
    bool periodicA = true;
    bool periodicB = true;
    ComputeParams params;
    int textons = 21;
};

/// Errors: those of BarycentrePath::create, chooseKernels and MixSolver::create; Cancelled.
[[nodiscard]] Result<MixSolver>
makeMixSolver(const MixRequest& request, MixedTextons known = {}, const CancelToken& cancel = {});

} // namespace txn
