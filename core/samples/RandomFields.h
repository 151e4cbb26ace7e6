// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/base/Random.h"
#include "core/spectral/Fft.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace txn {

/// In cycles per pixel, each within [-1/2, 1/2].
struct Frequency {
    double x = 0.0;
    double y = 0.0;

    [[nodiscard]] double squared() const { return x * x + y * y; }
};

/// Power of a random field at a frequency: >= 0 and the same at f and -f. Only its shape counts,
/// but the peak should be near 1 or above; the value at frequency 0 does not count.
using SpectralDensity = std::function<double(const Frequency&)>;

/// One value per pixel, row-major.
using Field = std::vector<float>;

/// Draws independent stationary Gaussian fields of mean 0 and variance 1: hashed white noise,
/// filtered in the Fourier domain. The fields are periodic. Equal seeds and equal order of calls
/// give equal bytes for any number of threads.
class RandomFields {
  public:
    RandomFields(Size size, Seed seed);

    /// All zero if the density has next to no power at the frequencies of this size, other than 0.
    [[nodiscard]] Field draw(const SpectralDensity& density);

  private:
    RealFft2d m_fft;
    Seed m_seed;
    std::uint32_t m_drawn = 0;
};

/// Round blobs: Gaussian correlation of standard deviation radiusPx.
[[nodiscard]] SpectralDensity blobs(double radiusPx);

/// Blobs stretched in x and y.
[[nodiscard]] SpectralDensity streaks(double radiusXPx, double radiusYPx);

/// Isotropic fractional field of Hurst index hurst, |f|^(-2 hurst - 2), flat beyond outerPx and
/// without detail below innerPx.
[[nodiscard]] SpectralDensity fractal(double hurst, double outerPx, double innerPx = 0.0);

/// Grains of one size: power around the period only, falling off within so many octaves.
[[nodiscard]] SpectralDensity grains(double periodPx, double octaves);

/// A surface lit from above, somewhat from the left: the light is the slope of the height, so its
/// power is that of the height times the squared frequency towards the lamp.
[[nodiscard]] SpectralDensity lit(SpectralDensity height);

/// Parameters of grainLines().
struct GrainLines {
    double hurst = 0.5;      ///< smoothness: 0 rough, 1 smooth
    double spread = 0.05;    ///< standard deviation of the direction, radians
    double outerPx = 100.0;  ///< widest lines
    double innerPx = 0.0;    ///< no detail across below this
    double lengthPx = 250.0; ///< of the longest lines: standard deviation of the correlation
};

/// Lines along y: elementary anisotropic fractional field, c(arg f) |f|^(-2 hurst - 2), where c
/// keeps to the directions around the x axis. [Pol15] eq. 4 and 5, with a smooth c.
[[nodiscard]] SpectralDensity grainLines(const GrainLines& lines);

/// The field with every pixel fetched from distancePx further right, wrapped around.
[[nodiscard]] Field shiftedAcross(const Field& field, Size size, const Field& distancePx);

} // namespace txn
