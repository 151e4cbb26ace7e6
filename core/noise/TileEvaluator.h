// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/image/Image.h"
#include "core/mixing/Mixture.h"
#include "core/noise/NoiseParams.h"

#include <cstdint>
#include <memory>

namespace txn {

/// Texton noise on one tile of a grid of tiles that is fixed to the plane. Whoever asks for a pixel
/// gets it from the same tile, computed in the same way, hence with the same bits.
class TileEvaluator {
  public:
    virtual ~TileEvaluator() = default;

    /// Tile (i, j) covers output pixels [i w, (i + 1) w) x [j h, (j + 1) h).
    virtual Size tileSize() const = 0;

    /// Computes one tile, tileSize() x C. Single-threaded; may run on many threads at once. May
    /// return early, with nothing of use, once cancel says so.
    virtual void evaluate(std::int64_t tileX,
                          std::int64_t tileY,
                          Image& tile,
                          const CancelToken& cancel) const = 0;
};

/// For one output pixel per exemplar pixel: the impulses of each kernel are splatted once with the
/// B-spline and convolved with its coefficients by FFT, tile by tile (overlap-save); textons that a
/// tile does not use cost nothing. The cost depends neither on the MNI nor, much, on the support.
[[nodiscard]] std::unique_ptr<TileEvaluator> makeConvolutionEvaluator(Mixture mixture,
                                                                      const NoiseParams& params);

/// What that takes in memory, nearly.
[[nodiscard]] std::size_t convolutionBytes(const Mixture& mixture);

/// For any scale (output pixels per exemplar pixel): every impulse adds its interpolated kernel.
/// Above 1 the noise is sampled at the pixel centres; below 1 each pixel is the exact mean of the
/// noise over its area, by integrated B-splines. The cost is proportional to the MNI.
[[nodiscard]] std::unique_ptr<TileEvaluator>
makeScaledEvaluator(Mixture mixture, const NoiseParams& params, double scale);

} // namespace txn
