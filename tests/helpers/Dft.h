// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spectral/Fft.h"

#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace txn::test {

using DoubleComplex = std::complex<double>;

/// Whole H x W spectrum or plane in double precision, row-major.
using DoublePlane = std::vector<DoubleComplex>;

/// DFT by its definition along rows, then columns; sign -1 forward, +1 inverse, no factor.
inline DoublePlane naiveDft(const DoublePlane& plane, Size size, int sign = -1) {
    const auto pass = [&](const DoublePlane& in, int count, int lines, int step, int jump) {
        std::vector<DoubleComplex> roots(static_cast<std::size_t>(count));
        for (int k = 0; k < count; ++k)
            roots[static_cast<std::size_t>(k)] =
                std::polar(1.0, sign * 2.0 * std::numbers::pi * k / count);
        DoublePlane out(in.size());
        for (int line = 0; line < lines; ++line) {
            for (int k = 0; k < count; ++k) {
                DoubleComplex sum;
                for (int n = 0; n < count; ++n) {
                    const auto root = static_cast<std::size_t>(1LL * k * n % count);
                    sum += in[static_cast<std::size_t>(line * jump + n * step)] * roots[root];
                }
                out[static_cast<std::size_t>(line * jump + k * step)] = sum;
            }
        }
        return out;
    };
    const auto rows = pass(plane, size.width, size.height, 1, size.width);
    return pass(rows, size.height, size.width, size.width, 1);
}

inline DoublePlane naiveDft(std::span<const float> plane, Size size) {
    return naiveDft(DoublePlane(plane.begin(), plane.end()), size);
}

/// The whole spectrum that a half one stands for.
inline DoublePlane wholeSpectrum(const HalfSpectrum& half) {
    const Size size = half.imageSize();
    DoublePlane whole;
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            if (column < half.columns()) {
                whole.emplace_back(half.at(row, column));
            } else {
                const auto& mirrored =
                    half.at((size.height - row) % size.height, size.width - column);
                whole.push_back(std::conj(DoubleComplex(mirrored)));
            }
        }
    }
    return whole;
}

/// ||a - b|| / ||b||.
inline double relativeError(const DoublePlane& a, const DoublePlane& b) {
    if (a.size() != b.size())
        return std::numeric_limits<double>::quiet_NaN();
    double difference = 0.0;
    double norm = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += std::norm(a[i] - b[i]);
        norm += std::norm(b[i]);
    }
    return norm > 0.0 ? std::sqrt(difference / norm) : std::sqrt(difference);
}

} // namespace txn::test
