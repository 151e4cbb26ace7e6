// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/Normalization.h"

#include <cmath>

namespace txn {

Normalization normalization(const Texton& texton, const ImpulseProcess& impulses) {
    const double perKernel = impulses.intensity() / texton.kernelCount();
    Normalization result{1.0 / std::sqrt(perKernel), texton.mean};
    if (impulses.process() == NoiseProcess::Poisson) {
        for (const Image& kernel : texton.kernels) {
            for (int c = 0; c < texton.channels(); ++c) {
                double sum = 0.0;
                for (const float v : kernel.plane(c))
                    sum += v;
                result.offset[static_cast<std::size_t>(c)] -= std::sqrt(perKernel) * sum;
            }
        }
    }
    return result;
}

} // namespace txn
