// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"

#include <Eigen/Core>

namespace txn {

/// The texton with its coefficients multiplied by B^1/2 A^-1/2, so that the colour covariance A of
/// its noise becomes B = target (C x C). Directions in which the noise has no variance (grey stored
/// as RGB, a constant channel) stay at zero: pseudo-inverse square root, never NaN.
/// [TN17] section 4.3, [SOT14] figure 3.
[[nodiscard]] Texton colorCorrected(const Texton& texton, const Eigen::MatrixXd& target);

} // namespace txn
