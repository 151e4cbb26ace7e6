// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/GaussianModel.h"
#include "core/texton/Texton.h"

#include <array>

namespace txn {

/// Power of a texture per frequency, averaged over rings and summed over channels: ring i holds the
/// frequencies [i, i + 1) / (2 kRings) cycles per pixel. Units: squared sample values.
struct RadialSpectrum {
    static constexpr int kRings = 32;
    std::array<double, kRings> power{};
};

[[nodiscard]] RadialSpectrum radialSpectrum(const GaussianModel& model);
/// Of the texton's noise. Thread-safe, as above.
[[nodiscard]] RadialSpectrum radialSpectrum(const Texton& texton);

/// Root mean square over the rings of 10 log10 (a / b), in decibels; rings without power in either
/// are left out. 0 when no ring is left.
[[nodiscard]] double differenceInDecibels(const RadialSpectrum& a, const RadialSpectrum& b);

} // namespace txn
