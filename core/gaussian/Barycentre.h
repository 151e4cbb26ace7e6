// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"

#include <vector>

namespace txn {

/// d_OT of two Gaussian textures on one domain, channels alike: the optimal transport distance,
/// as a root mean square over pixels,
///     d^2 = |m_u - m_v|^2 + sum_xi (|t_u^|^2 + |t_v^|^2 - 2 |t_u^* t_v|) / (H W).
/// [XFPA14], with the mean colours. Thread-safe.
[[nodiscard]] double transportDistance(const GaussianModel& u, const GaussianModel& v);

/// The shortest way from one Gaussian texture to another: the barycentres tau_rho of optimal
/// transport, 0 <= rho <= 1 ([TN17] section 7),
///     tau_rho = (1 - rho) tau_0 + rho tau_1, tau_0 = t_u (t_u^* t_v) / |t_u^* t_v|, tau_1 = t_v,
/// phase 1 where the scalar product is 0; means are interpolated alike. d_OT from A grows in
/// proportion to rho. Immutable; const use is thread-safe.
class BarycentrePath {
  public:
    /// Exemplars of different sizes are brought to one domain, the larger width by the larger
    /// height, as equivalent spots (enlarged()). periodicA and periodicB: see GaussianModel.
    /// Errors: SizeMismatch where channels, maps or transfer differ; Degenerate where one has no
    /// variation; TooLarge.
    [[nodiscard]] static Result<BarycentrePath>
    create(const Exemplar& a, const Exemplar& b, bool periodicA = true, bool periodicB = true);

    /// Of models on one domain. Errors: as above.
    [[nodiscard]] static Result<BarycentrePath> create(const GaussianModel& a, GaussianModel b);

    /// The barycentre at rho in [0, 1]; at 0 the texture of A, at 1 that of B.
    [[nodiscard]] GaussianModel at(double rho) const;

    Size domain() const { return m_b.domain(); }
    int channels() const { return m_b.channels(); }
    /// d_OT from A to B.
    double distance() const { return m_distance; }
    /// d_OT from A to another texture on this domain.
    double distanceTo(const GaussianModel& model) const { return transportDistance(m_a, model); }

  private:
    BarycentrePath(GaussianModel a, GaussianModel b);

    GaussianModel m_a; ///< tau_0
    GaussianModel m_b; ///< tau_1
    double m_distance;
};

} // namespace txn
