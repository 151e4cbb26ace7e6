// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/BSpline.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace txn {
namespace {

double power(double base, int exponent) {
    double result = 1.0;
    for (int i = 0; i < exponent; ++i)
        result *= base;
    return result;
}

/// Sum over i of (-1)^i binomial(order + 1, i) (y + (order + 1) / 2 - i)_+^degree / degree!:
/// the B-spline for degree = order, its integral for degree = order + 1.
double truncatedPowers(int order, int degree, double y) {
    const double left = y + 0.5 * (order + 1);
    double binomial = 1.0;
    double sum = 0.0;
    for (int i = 0; i <= order + 1 && left > i; ++i) {
        sum += binomial * power(left - i, degree);
        binomial *= -static_cast<double>(order + 1 - i) / (i + 1);
    }
    double factorial = 1.0;
    for (int i = 2; i <= degree; ++i)
        factorial *= i;
    return sum / factorial;
}

} // namespace

double bspline(int order, double y) {
    assert(isInterpolationOrder(order));
    if (order == 0)
        return y >= -0.5 && y < 0.5 ? 1.0 : 0.0;
    const double distance = std::abs(y);
    if (distance >= 0.5 * (order + 1))
        return 0.0;
    return truncatedPowers(order, order, -distance); // the side with the fewest terms
}

double bsplineIntegral(int order, double y) {
    const double half = 0.5 * (order + 1);
    if (y <= -half)
        return 0.0;
    if (y >= half)
        return 1.0;
    return y <= 0.0 ? truncatedPowers(order, order + 1, y)
                    : 1.0 - truncatedPowers(order, order + 1, -y);
}

BsplineWeights bsplineWeights(int order, double y) {
    BsplineWeights result;
    if (order == 0) {
        // The one integer n with -1/2 <= n - y < 1/2.
        result.first = static_cast<long long>(std::ceil(y - 0.5));
        result.weight[0] = 1.0F;
        return result;
    }
    const double floor = std::floor(y);
    const double fraction = y - floor;
    const int left = (order - 1) / 2; // how many of them lie left of floor
    result.first = static_cast<long long>(floor) - left;
    if (order == 1) {
        result.weight[0] = static_cast<float>(1.0 - fraction);
        result.weight[1] = static_cast<float>(fraction);
        return result;
    }
    for (int i = 0; i <= order; ++i)
        result.weight[i] = static_cast<float>(bspline(order, i - left - fraction));
    return result;
}

std::span<const double> bsplineAutocorrelation(int order) {
    // Values of the B-splines of order 1, 3, 7 and 11 at the integers.
    static constexpr std::array<double, 1> kOrder0{1.0};
    static constexpr std::array<double, 2> kOrder1{2.0 / 3.0, 1.0 / 6.0};
    static constexpr std::array<double, 4> kOrder3{2416.0 / 5040.0,
                                                   1191.0 / 5040.0,
                                                   120.0 / 5040.0,
                                                   1.0 / 5040.0};
    static constexpr double kElevenFactorial = 39916800.0;
    static constexpr std::array<double, 6> kOrder5{15724248.0 / kElevenFactorial,
                                                   9738114.0 / kElevenFactorial,
                                                   2203488.0 / kElevenFactorial,
                                                   152637.0 / kElevenFactorial,
                                                   2036.0 / kElevenFactorial,
                                                   1.0 / kElevenFactorial};
    switch (order) {
    case 0:
        return kOrder0;
    case 1:
        return kOrder1;
    case 3:
        return kOrder3;
    default:
        assert(order == 5);
        return kOrder5;
    }
}

std::vector<double> bsplineSpectrum(int order, int length) {
    const auto b = bsplineAutocorrelation(order);
    std::vector<double> spectrum(static_cast<std::size_t>(length));
    for (int k = 0; k < length; ++k) {
        double value = b[0];
        for (std::size_t n = 1; n < b.size(); ++n)
            value +=
                2.0 * b[n] * std::cos(2.0 * std::numbers::pi * k * static_cast<double>(n) / length);
        spectrum[static_cast<std::size_t>(k)] = value;
    }
    return spectrum;
}

} // namespace txn
