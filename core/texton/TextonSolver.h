// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"
#include "core/texton/SpectralProjection.h"
#include "core/texton/Texton.h"
#include "core/texton/TextonParams.h"

namespace txn {

/// Computes a texton by alternating projections between "has the exemplar's spectrum" and "is zero
/// outside the support" ([SOT14] algorithm 2 for order 0, [TN17] algorithm 1 for order 1), as a
/// stepper: the caller's loop owns progress, cancelling and previews.
///
///     while (!solver.done()) { solver.step(); ... solver.texton() ... }
///
/// Plain iterations never increase the distance in which they project; for orders above 0 that is
/// the relative model error without its weights b^, which may therefore rise a little on the way.
///
/// With momentum m > 0 the projection is taken of z + m (z - z_prev) from the fourth iteration on:
/// same fixed points in far fewer iterations. One thread at a time; a step uses all cores of the
/// calling task arena and gives the same bits for any number of them.
class TextonSolver {
  public:
    /// Starts from Gaussian white noise on the support.
    /// Errors: SizeMismatch if the support exceeds the model's domain; InvalidArgument for
    /// parameters out of range; Degenerate for an exemplar without variation.
    [[nodiscard]] static Result<TextonSolver> create(const GaussianModel& model,
                                                     const TextonParams& params);

    /// Starts from the given noise, H x W x C on the whole domain (as in the papers) or on the
    /// support. Errors: the same, and SizeMismatch for other noise.
    [[nodiscard]] static Result<TextonSolver>
    create(const GaussianModel& model, const TextonParams& params, Image initialNoise);

    /// One iteration. Does nothing when done.
    void step();
    bool done() const { return m_iteration >= m_params.iterations; }
    int iteration() const { return m_iteration; }
    const TextonParams& params() const { return m_params; }

    /// The current texton, without colour correction; all zero before the first step.
    [[nodiscard]] Texton texton() const;

    /// Of the current coefficients. Costs about half a step.
    [[nodiscard]] double relativeModelError() const;
    /// Of another texton of the same support, order and channels, such as the colour corrected one.
    [[nodiscard]] double relativeModelError(const Texton& texton) const;

  private:
    TextonSolver(const GaussianModel& model, const TextonParams& params, Image initialNoise);
    void cutToSupport(Image& coefficients) const;

    TextonParams m_params;
    SpectralProjection m_projection;
    std::vector<double> m_mean;
    Transfer m_transfer;
    int m_iteration = 0;
    Image m_next;     ///< what the next step projects
    Image m_current;  ///< z
    Image m_previous; ///< z_prev
};

} // namespace txn
