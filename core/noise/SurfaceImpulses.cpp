// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/SurfaceImpulses.h"

#include <algorithm>
#include <cassert>

namespace txn {

SurfaceImpulses::SurfaceImpulses(const NoiseParams& params, Size footprint, int kernelCount)
    : m_process(params.process), m_seed(params.seed.value),
      m_kernelCount(static_cast<std::uint32_t>(kernelCount)),
      m_side(std::max(footprint.width, footprint.height)),
      m_cell(m_side / std::cbrt(params.meanImpacts)) {
    assert(checkNoiseParams(params) && kernelCount >= 1 && kernelCount <= 65536);
}

} // namespace txn
