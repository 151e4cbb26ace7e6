// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/Exemplar.h"
#include "core/spectral/Fft.h"

#include <Eigen/Core>
#include <vector>

namespace txn {

/// The Gaussian texture of an exemplar u on its H x W domain: a mean colour m and the DFT of the
/// normalised spot t_u = (u - m) / sqrt(H W), one half spectrum per channel, DFT unnormalised, zero
/// at frequency 0. [SOT14] eq. 3. Immutable; const use is thread-safe.
class GaussianModel {
  public:
    /// With periodic (the default) the exemplar's periodic component takes its place; switch it
    /// off for exemplars that already tile.
    explicit GaussianModel(const Exemplar& exemplar, bool periodic = true);
    /// From a spot given directly: H x W x C, its mean need not be zero and does not count.
    GaussianModel(const Image& spot, std::vector<double> mean);
    /// From the spot's spectra, all of one size: C of them, zero at frequency 0, and C means.
    GaussianModel(std::vector<HalfSpectrum> spot, std::vector<double> mean, Transfer transfer);

    /// Whether it is that of an exemplar's periodic component.
    bool isPeriodicComponent() const { return m_periodicComponent; }
    Size domain() const { return m_domain; }
    int channels() const { return static_cast<int>(m_mean.size()); }
    Transfer transfer() const { return m_transfer; }
    const std::vector<double>& mean() const { return m_mean; }
    const HalfSpectrum& spot(int channel) const {
        return m_spot[static_cast<std::size_t>(channel)];
    }

    /// C x C colour covariance of the texture: t_u t_u^T summed over the domain (Parseval).
    const Eigen::MatrixXd& covariance() const { return m_covariance; }

  private:
    void computeCovariance();

    bool m_periodicComponent = false;
    Size m_domain;
    Transfer m_transfer = Transfer::Encoded;
    std::vector<double> m_mean;
    std::vector<HalfSpectrum> m_spot;
    Eigen::MatrixXd m_covariance;
};

} // namespace txn
