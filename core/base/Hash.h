// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace txn {

/// Four 32-bit words to four well mixed ones: pcg4d (Jarzynski and Olano, "Hash Functions for GPU
/// Rendering", JCGT 2020). Only 32-bit additions, products and shifts, so that GLSL gives the same
/// bits. A bijection of 128 bits: no two inputs collide and there is no visible period.
[[nodiscard]] constexpr std::array<std::uint32_t, 4>
hash4(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w) {
    x = x * 1664525U + 1013904223U;
    y = y * 1664525U + 1013904223U;
    z = z * 1664525U + 1013904223U;
    w = w * 1664525U + 1013904223U;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x ^= x >> 16U;
    y ^= y >> 16U;
    z ^= z >> 16U;
    w ^= w >> 16U;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return {x, y, z, w};
}

} // namespace txn
