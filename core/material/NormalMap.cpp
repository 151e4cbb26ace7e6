// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/NormalMap.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace txn {

Image slopesOfNormals(const Image& normals, bool yDown) {
    assert(normals.channels() == 3);
    Image slopes(normals.size(), 2);
    // The normal of z = h(x, y) with y up is (-dh/dx, -dh/dy, 1), and d/dy changes sign with y.
    const float sign = yDown ? -1.0F : 1.0F;
    const auto slope = [](float along, float z) {
        return std::clamp(along / std::max(z, 1e-6F), -kSteepestSlope, kSteepestSlope);
    };
    for (std::size_t i = 0; i < slopes.size().area(); ++i) {
        const float z = 2.0F * normals.plane(2)[i] - 1.0F;
        slopes.plane(0)[i] = slope(1.0F - 2.0F * normals.plane(0)[i], z);
        slopes.plane(1)[i] = sign * slope(2.0F * normals.plane(1)[i] - 1.0F, z);
    }
    return slopes;
}

Image normalsOfSlopes(const Image& slopes, bool yDown) {
    assert(slopes.channels() == 2);
    Image normals(slopes.size(), 3);
    const float sign = yDown ? -1.0F : 1.0F;
    for (std::size_t i = 0; i < slopes.size().area(); ++i) {
        const float dx = slopes.plane(0)[i];
        const float dy = slopes.plane(1)[i];
        const float half = 0.5F / std::sqrt(1.0F + dx * dx + dy * dy);
        normals.plane(0)[i] = 0.5F - half * dx;
        normals.plane(1)[i] = 0.5F + sign * half * dy;
        normals.plane(2)[i] = 0.5F + half;
    }
    return normals;
}

} // namespace txn
