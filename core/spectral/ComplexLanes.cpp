// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/ComplexLanes.h"

#include "core/base/Simd.h"

#include <cmath>
#include <limits>

// std::complex products test for NaN and do not vectorise: real arithmetic on the interleaved
// values instead, which the standard allows for arrays of std::complex.
namespace txn {
namespace {

const float* reals(const Complex* values) {
    return reinterpret_cast<const float*>(values);
}

float* reals(Complex* values) {
    return reinterpret_cast<float*>(values);
}

} // namespace

TXN_MULTIVERSION
void multiplyRows(const Complex* in, const Complex* factor, Complex* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const float* x = reals(in + row * FftPlan::kLanes);
        float* y = reals(out + row * FftPlan::kLanes);
        const float re = factor[row].real();
        const float im = factor[row].imag();
#pragma omp simd
        for (int i = 0; i < FftPlan::kLanes; ++i) {
            const float a = x[2 * i];
            const float b = x[2 * i + 1];
            y[2 * i] = a * re - b * im;
            y[2 * i + 1] = a * im + b * re;
        }
    }
}

TXN_MULTIVERSION
void addRowsTimesConjugate(const Complex* in,
                           const Complex* factor,
                           Complex* sum,
                           std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const float* x = reals(in + row * FftPlan::kLanes);
        float* y = reals(sum + row * FftPlan::kLanes);
        const float re = factor[row].real();
        const float im = factor[row].imag();
#pragma omp simd
        for (int i = 0; i < FftPlan::kLanes; ++i) {
            const float a = x[2 * i];
            const float b = x[2 * i + 1];
            y[2 * i] += a * re + b * im;
            y[2 * i + 1] += b * re - a * im;
        }
    }
}

TXN_MULTIVERSION
void addProducts(const Complex* a, const Complex* b, Complex* sum, std::size_t count) {
    const float* x = reals(a);
    const float* y = reals(b);
    float* z = reals(sum);
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        z[2 * i] += x[2 * i] * y[2 * i] - x[2 * i + 1] * y[2 * i + 1];
        z[2 * i + 1] += x[2 * i] * y[2 * i + 1] + x[2 * i + 1] * y[2 * i];
    }
}

TXN_MULTIVERSION
void multiply(const Complex* a, const Complex* b, Complex* out, std::size_t count) {
    const float* x = reals(a);
    const float* y = reals(b);
    float* z = reals(out);
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const float re = x[2 * i] * y[2 * i] - x[2 * i + 1] * y[2 * i + 1];
        z[2 * i + 1] = x[2 * i] * y[2 * i + 1] + x[2 * i + 1] * y[2 * i];
        z[2 * i] = re;
    }
}

TXN_MULTIVERSION
void scalarProducts(const Complex* target,
                    const Complex* values,
                    int channels,
                    std::size_t stride,
                    Complex* dot,
                    std::size_t count) {
    float* d = reals(dot);
    for (std::size_t i = 0; i < 2 * count; ++i)
        d[i] = 0.0F;
    for (int c = 0; c < channels; ++c) {
        const float* p = reals(target + static_cast<std::size_t>(c) * stride);
        const float* v = reals(values + static_cast<std::size_t>(c) * stride);
#pragma omp simd
        for (std::size_t i = 0; i < count; ++i) {
            d[2 * i] += p[2 * i] * v[2 * i] + p[2 * i + 1] * v[2 * i + 1];
            d[2 * i + 1] += p[2 * i] * v[2 * i + 1] - p[2 * i + 1] * v[2 * i];
        }
    }
}

TXN_MULTIVERSION
void rotateTarget(const Complex* target,
                  const Complex* dot,
                  Complex* values,
                  int channels,
                  std::size_t stride,
                  std::size_t count) {
    constexpr std::size_t kChunk = 64;
    // Below this the square underflows and the phase means nothing.
    constexpr float kSmallest = std::numeric_limits<float>::min();
    for (std::size_t start = 0; start < count; start += kChunk) {
        const std::size_t length = count - start < kChunk ? count - start : kChunk;
        const float* d = reals(dot + start);
        float re[kChunk];
        float im[kChunk];
#pragma omp simd
        for (std::size_t i = 0; i < length; ++i) {
            const float square = d[2 * i] * d[2 * i] + d[2 * i + 1] * d[2 * i + 1];
            const bool usable = square >= kSmallest;
            const float inverse = 1.0F / std::sqrt(usable ? square : 1.0F);
            re[i] = usable ? d[2 * i] * inverse : 1.0F;
            im[i] = usable ? d[2 * i + 1] * inverse : 0.0F;
        }
        for (int c = 0; c < channels; ++c) {
            const std::size_t at = static_cast<std::size_t>(c) * stride + start;
            const float* p = reals(target + at);
            float* v = reals(values + at);
#pragma omp simd
            for (std::size_t i = 0; i < length; ++i) {
                v[2 * i] = p[2 * i] * re[i] - p[2 * i + 1] * im[i];
                v[2 * i + 1] = p[2 * i] * im[i] + p[2 * i + 1] * re[i];
            }
        }
    }
}

} // namespace txn
