// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace txn {

/// Centred B-spline of order 0, 1, 3 or 5 at y: a box, a triangle, and smoother bells; integral 1,
/// zero for |y| >= (order + 1) / 2. Order 0 is 1 on [-1/2, 1/2).
[[nodiscard]] double bspline(int order, double y);

/// Integral of bspline(order, .) from minus infinity to y.
[[nodiscard]] double bsplineIntegral(int order, double y);

/// Weights of the order + 1 integer positions first, first + 1, ... at which bspline(order, n - y)
/// is not zero. They sum to 1.
struct BsplineWeights {
    long long first = 0;
    float weight[6] = {};
};
[[nodiscard]] BsplineWeights bsplineWeights(int order, double y);

/// Samples b(0), b(1), ..., b(order) of the B-spline of order 2 order + 1: the autocorrelation of
/// bspline(order, .) at integer lags, symmetric. [TN17] section 4.1, b.
[[nodiscard]] std::span<const double> bsplineAutocorrelation(int order);

/// DFT of those samples on a circle of length points, at frequencies 0..length - 1. Always > 0.
[[nodiscard]] std::vector<double> bsplineSpectrum(int order, int length);

/// Interpolation orders in use.
[[nodiscard]] constexpr bool isInterpolationOrder(int order) {
    return order == 0 || order == 1 || order == 3 || order == 5;
}

} // namespace txn
