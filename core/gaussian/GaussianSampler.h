// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"

namespace txn {

/// Which Gaussian version. Adsn: the asymptotic discrete spot noise m + t_u * W, exactly Gaussian.
/// RandomPhase: the exemplar's own Fourier modulus with a random phase. Both draw from one white
/// noise W shared by all channels. [Lec19]; [TN17] section 3.1.
enum class GaussianMethod { Adsn, RandomPhase };

/// A Gaussian version of the exemplar on its own domain: H x W x C, mean added, periodic.
/// Thread-safe; the result does not depend on the number of threads.
[[nodiscard]] Image sampleGaussian(const GaussianModel& model, GaussianMethod method, Seed seed);

/// The model on a larger domain: the spot in the centre of zeros, its border faded by a smooth
/// ramp, rescaled to keep the variance ("equivalent spot", [Lec19]). size may not be smaller than
/// the exemplar in either direction. Errors: InvalidArgument for a smaller size; TooLarge above
/// 2^28 pixels.
[[nodiscard]] Result<GaussianModel>
enlarged(const Exemplar& exemplar, Size size, bool periodic = true);

/// A Gaussian version of any size: larger ones through enlarged(), smaller ones are cut out.
/// Errors: InvalidArgument for sizes below 1; TooLarge above 2^28 samples.
[[nodiscard]] Result<Image> gaussianVersion(
    const Exemplar& exemplar, Size size, GaussianMethod method, Seed seed, bool periodic = true);

} // namespace txn
