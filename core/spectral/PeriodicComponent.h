// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"
#include "core/spectral/Fft.h"

#include <span>

namespace txn {

/// Periodic component p of an image u: the same picture without the jump across its borders when
/// it is repeated. u = p + s, s smooth; Laplacian of p = interior Laplacian of u; mean(p) =
/// mean(u). H x W x C in and out, values on the same scale. Moisan 2011; [Lec19] "Avoiding
/// artifacts".
[[nodiscard]] Image periodicComponent(const Image& image);

/// Replaces the DFT of a plane (H * W values, row-major; any constant may have been added to it) by
/// that of its periodic component, without leaving the Fourier domain.
void removeSmoothComponent(HalfSpectrum& spectrum, std::span<const float> plane);

/// How much more the wrapped image jumps across its borders than between neighbours inside: the
/// ratio of the root mean square differences, averaged over channels. About 1 for images that
/// already tile; well above for a plain photograph. 1 for images without any variation.
[[nodiscard]] double seamRatio(const Image& image);

} // namespace txn
