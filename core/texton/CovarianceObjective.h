// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"
#include "core/spectral/Fft.h"
#include "core/texton/Texton.h"

#include <span>
#include <vector>

namespace txn {

/// How far the covariance of Q kernels is from that of an exemplar, with its gradient: what
/// LeastSquaresTexton minimises.
///
///     J = sum_k w(k) |C_alpha(k) - C_u(k)|^2 / sum_k w(k) |C_u(k)|^2
///         + sum_q sum_k v(k) |gamma_q(k)|^2
///
/// over the lags |k_i| < r_i = 0.7 of the sides of the support, |.| the Frobenius norm of C x C
/// matrices. C_u(k) = sqrt((1 - |k_x| / W) (1 - |k_y| / H)) times the circular autocovariance of
/// the model on its W x H domain: the longer the lag, the less is known of it. C_alpha is that of
/// the noise, sum_q (alpha_q * alpha_q~^T * b), and w(k) = sqrt(w_x w_y), w_i = (1 + cos(pi k_i /
/// r_i)) / 2. Reach and trust are ours, found on pictures cut in two (docs/FIDELITY.md). The
/// variables are gamma, alpha_q = e gamma_q with e a Tukey taper of 25 % of the side at each end
/// (of the radius for a disc). It and the last term, v = 0.002 (1 - e) / total variance, leave no
/// energy on the border to be seen. All of it happens on a grid just large enough for lags not to
/// wrap: the cost does not depend on the exemplar. Single precision, sums in double. Const use is
/// thread-safe; evaluate() uses all cores of the calling task arena and gives the same bits for any
/// number of them.
class CovarianceObjective {
  public:
    struct Shape {
        Support support = Support::rectangle({64, 64});
        int interpolationOrder = 1;
        int kernels = 1;
    };

    /// weights: factors on the channels inside the fit, one each, so that maps of different units
    /// count alike; empty: 1. Errors: SizeMismatch if the support exceeds the model's domain or the
    /// number of weights is wrong; InvalidArgument for parameters out of range; Degenerate for an
    /// exemplar without variation.
    [[nodiscard]] static Result<CovarianceObjective>
    create(const GaussianModel& model, const Shape& shape, const std::vector<double>& weights);

    /// Q * C * w * h: kernel after kernel, channel after channel, row after row.
    std::size_t variables() const;

    /// J at gamma; writes dJ/dgamma.
    [[nodiscard]] double evaluate(std::span<const double> gamma, std::span<double> gradient) const;

    /// White noise whose kernels have the exemplar's total variance.
    [[nodiscard]] std::vector<double> start(Seed seed) const;

    /// The other way round from texton(); what lies where e is 0 is lost. fits(texton) is required.
    [[nodiscard]] std::vector<double> variablesOf(const Texton& texton) const;
    /// Whether it has this support, order and number of kernels and channels.
    [[nodiscard]] bool fits(const Texton& texton) const;

    /// The kernels of gamma in the exemplar's own units, without colour correction.
    [[nodiscard]] Texton texton(std::span<const double> gamma) const;

  private:
    CovarianceObjective(const GaussianModel& model,
                        const Shape& shape,
                        std::vector<double> weights);
    void computeTarget(const GaussianModel& model);
    void computeTaper();
    std::vector<HalfSpectrum> spectra(std::span<const double> gamma) const;
    std::size_t pairs() const;

    Shape m_shape;
    std::vector<double> m_weights;
    std::vector<double> m_mean;
    Transfer m_transfer;
    RealFft2d m_fft;                          ///< of the K_x x K_y grid
    std::vector<float> m_taper;               ///< e, w x h, zero outside the support
    std::vector<float> m_lagWeights;          ///< w(k) on the grid, lag 0 first, negative ones last
    std::vector<std::vector<float>> m_target; ///< C_u on the grid, for channels (i, j), j <= i
    std::vector<float> m_splineX;             ///< b^ of the grid's columns, padded to whole blocks
    std::vector<float> m_splineY;             ///< and of its rows
    double m_targetNorm = 0.0;                ///< sum_k w(k) |C_u(k)|^2
    double m_targetTrace = 0.0;               ///< total variance
};

} // namespace txn
