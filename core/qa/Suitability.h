// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/gaussian/GaussianModel.h"

#include <vector>

namespace txn {

/// What texton noise can make of a material, told from how far the exemplar is from a Gaussian
/// texture with its own mean and spectrum.
enum class Verdict {
    Suits,         ///< a Gaussian texture looks like it
    ColoursClip,   ///< its grain suits, but a share of the Gaussian samples leaves [0, 1]
    ColoursDiffer, ///< its grain suits, but its values are spread in a way that will be lost
    HasShapes,     ///< edges, spots or patches that a Gaussian texture cannot keep
};

struct Suitability {
    Verdict verdict = Verdict::Suits;
    double skewness = 0.0;       ///< of the samples, largest in size over the channels
    double excessKurtosis = 0.0; ///< likewise
    double clippedShare = 0.0;   ///< of a Gaussian texture's samples outside [0, 1], 0 to 1
    /// How far the sub-bands' statistics lie outside those of the exemplar's own Gaussian versions:
    /// largest deviation over the bands, in standard deviations of theirs.
    double subbandDeviation = 0.0;
};

/// exemplar and its model; any thread, on the cores of the calling arena. Errors: Cancelled;
/// Degenerate for an exemplar without variation.
[[nodiscard]] Result<Suitability> assessSuitability(const Exemplar& exemplar,
                                                    const GaussianModel& model,
                                                    const CancelToken& cancel = {});

} // namespace txn
