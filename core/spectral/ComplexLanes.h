// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spectral/Fft.h"

#include <cstddef>

namespace txn {

/// The inner loops of the spectral methods, on columns side by side (FftPlan::kLanes complex values
/// per row). Plain arithmetic without branches, compiled for several instruction sets.

/// out[row] = in[row] * factor[row].
void multiplyRows(const Complex* in, const Complex* factor, Complex* out, std::size_t rows);

/// sum[row] += in[row] * conj(factor[row]).
void addRowsTimesConjugate(const Complex* in,
                           const Complex* factor,
                           Complex* sum,
                           std::size_t rows);

/// sum += a * b, element by element.
void addProducts(const Complex* a, const Complex* b, Complex* sum, std::size_t count);
/// out = a * b, element by element.
void multiply(const Complex* a, const Complex* b, Complex* out, std::size_t count);

/// Writes conj(target) . values, summed over channels, to dot. Channel c of both starts c * stride
/// elements further on.
void scalarProducts(const Complex* target,
                    const Complex* values,
                    int channels,
                    std::size_t stride,
                    Complex* dot,
                    std::size_t count);

/// values[c] = target[c] * dot / |dot|, with phase 1 where dot is 0.
void rotateTarget(const Complex* target,
                  const Complex* dot,
                  Complex* values,
                  int channels,
                  std::size_t stride,
                  std::size_t count);

} // namespace txn
