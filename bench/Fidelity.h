// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/NoiseParams.h"
#include "core/texton/Texton.h"

#include <map>
#include <string>
#include <vector>

namespace txn::bench {

/// How a noise differs from the Gaussian texture of its covariance, over 1024 x 1024 pixels of the
/// grey mean of its channels: means of eight seeds.
struct Gaussianity {
    double kurtosis = 0.0; ///< excess kurtosis of all pixels
    double spread = 0.0; ///< of the variances of windows of 64 x 64 pixels, relative to their mean
};
[[nodiscard]] Gaussianity gaussianity(const Texton& texton, const NoiseParams& params);

/// Our noise beside the paper's.
struct Fidelity {
    /// Smallest whole MNI of the stratified process at which neither number is further from the
    /// Gaussian limit than the paper's.
    int meanImpacts = 0;
    Gaussianity limit;
    Gaussianity paper; ///< Poisson process at MNI 30
    Gaussianity ours;  ///< at meanImpacts
};
[[nodiscard]] Fidelity fidelity(const Texton& texton);

/// Fidelities of textons of support 64, solved from the generated materials and from photographs
/// where they are at hand; each computed when it is first asked for.
class FidelityTable {
  public:
    FidelityTable();
    const std::vector<std::string>& names() const { return m_names; }
    const Fidelity& of(const std::string& name);
    /// The largest of all: enough for every one of these textons.
    int meanImpacts();

  private:
    std::vector<std::string> m_names;
    std::map<std::string, Fidelity> m_known;
};

} // namespace txn::bench
