// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/texton/Texton.h"

#include <optional>
#include <variant>
#include <vector>

namespace txn {

/// How far a texture B is from a texture A. Errors are relative to A: 0 is equal, 1 is as far as a
/// flat colour.
struct Comparison {
    std::vector<double> meanA;
    std::vector<double> meanB;
    double meanDifference = 0.0;  ///< largest over the channels, in sample values
    int lag = 0;                  ///< up to which the next two look
    double covarianceError = 0.0; ///< of the C x C covariances at all lags up to lag
    /// What chance leaves of it: see CovarianceError. Of A if that is a picture, else of B; unset
    /// for two textons, and for a picture too small for its halves to be compared.
    std::optional<double> covarianceErrorFloor;
    double colorCovarianceError = 0.0; ///< of the C x C covariance at lag 0 alone, Frobenius norm
    double spectrumDifference = 0.0;   ///< of the radial power spectra, decibels (root mean square)
    std::optional<double> relativeModelError; ///< where one is a picture and the other a texton
};

using Texture = std::variant<Exemplar, Texton>;

/// lag: unset means 32, or less where a picture is smaller than four times that. A picture in
/// another transfer than the texton (or than A) is converted to it. Pictures may differ in size.
/// Errors: SizeMismatch for different channel counts or a lag that does not fit; Degenerate if A
/// has no variation. Thread-safe.
[[nodiscard]] Result<Comparison>
compare(const Texture& a, const Texture& b, std::optional<int> lag = {});

} // namespace txn
