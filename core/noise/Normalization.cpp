// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/Normalization.h"

#include <cmath>
#include <numeric>

namespace txn {

std::vector<double> kernelSums(const Texton& texton) {
    std::vector<double> sums(texton.mean.size(), 0.0);
    for (const Image& kernel : texton.kernels) {
        for (std::size_t c = 0; c < sums.size(); ++c) {
            const auto plane = kernel.plane(static_cast<int>(c));
            sums[c] += std::accumulate(plane.begin(), plane.end(), 0.0);
        }
    }
    return sums;
}

Normalization normalization(const Texton& texton, const ImpulseProcess& impulses) {
    const double perKernel = impulses.intensity() / texton.kernelCount();
    Normalization result{1.0 / std::sqrt(perKernel), texton.mean};
    if (impulses.process() == NoiseProcess::Poisson) {
        const auto sums = kernelSums(texton);
        for (std::size_t c = 0; c < sums.size(); ++c)
            result.offset[c] -= std::sqrt(perKernel) * sums[c];
    }
    return result;
}

} // namespace txn
