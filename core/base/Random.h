// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Hash.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace txn {

/// Which random numbers: equal seeds give equal results.
struct Seed {
    std::uint32_t value = 1;
    bool operator==(const Seed&) const = default;
};

/// Uniform in the open interval (0, 1), every one of the 2^32 values equally likely.
[[nodiscard]] constexpr double toUnitOpen(std::uint32_t bits) {
    return (static_cast<double>(bits) + 0.5) * 0x1p-32;
}

/// Two independent standard Gaussian values (Box-Muller) from two hashed words.
[[nodiscard]] inline std::pair<double, double> gaussianPair(std::uint32_t a, std::uint32_t b) {
    const double radius = std::sqrt(-2.0 * std::log(toUnitOpen(a)));
    const double angle = 2.0 * std::numbers::pi * toUnitOpen(b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace txn
