// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/Image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace txn::test {

/// ||a - b|| / ||b||; NaN where the lengths differ or anything is not finite.
template <class A, class B>
double relativeError(const A& a, const B& b) {
    if (std::size(a) != std::size(b))
        return std::numeric_limits<double>::quiet_NaN();
    double difference = 0.0;
    double norm = 0.0;
    for (std::size_t i = 0; i < std::size(a); ++i) {
        const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        difference += d * d;
        norm += static_cast<double>(b[i]) * static_cast<double>(b[i]);
    }
    return norm > 0.0 ? std::sqrt(difference / norm) : std::sqrt(difference);
}

/// Largest |a - b|; NaN where the lengths differ or anything is not a number.
template <class A, class B>
double largestDifference(const A& a, const B& b) {
    double largest = 0.0;
    if (std::size(a) != std::size(b))
        return std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < std::size(a); ++i) {
        const double d = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
        if (!(d <= largest))
            largest = d;
        if (std::isnan(largest))
            break;
    }
    return largest;
}

template <class Values>
bool allFinite(const Values& values) {
    return std::all_of(std::begin(values), std::end(values), [](auto v) {
        return std::isfinite(v);
    });
}

template <class Values>
double meanOf(const Values& values) {
    double sum = 0.0;
    for (const auto v : values)
        sum += static_cast<double>(v);
    return sum / static_cast<double>(std::size(values));
}

/// Mean of squared deviations from the mean.
template <class Values>
double varianceOf(const Values& values) {
    const double mean = meanOf(values);
    double sum = 0.0;
    for (const auto v : values)
        sum += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
    return sum / static_cast<double>(std::size(values));
}

/// Mean of repeated measurements and its standard error.
struct Estimate {
    double mean = 0.0;
    double error = 0.0;
};

inline Estimate estimate(const std::vector<double>& samples) {
    const auto count = static_cast<double>(samples.size());
    return {meanOf(samples), std::sqrt(varianceOf(samples) / (count - 1.0))};
}

/// Small generator for test data (splitmix64): unlike the product's own hash, on purpose.
class TestRandom {
  public:
    explicit TestRandom(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t bits() {
        m_state += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }
    /// Uniform in [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    int below(int count) { return static_cast<int>(uniform() * count); }
    /// Standard Gaussian, near enough: the sum of twelve uniform values.
    double gaussian() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i)
            sum += uniform();
        return sum;
    }

  private:
    std::uint64_t m_state;
};

} // namespace txn::test
