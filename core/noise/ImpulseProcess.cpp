// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/ImpulseProcess.h"

#include <algorithm>
#include <cassert>

namespace txn {

ImpulseProcess::ImpulseProcess(const NoiseParams& params, Size footprint, int kernelCount)
    : m_process(params.process), m_seed(params.seed.value),
      m_kernelCount(static_cast<std::uint32_t>(kernelCount)) {
    assert(checkNoiseParams(params) && kernelCount >= 1 && kernelCount <= 65536);
    const double perSide = std::sqrt(params.meanImpacts);
    m_cellWidth = footprint.width / perSide;
    m_cellHeight = footprint.height / perSide;
    if (params.period) {
        const auto fit = [](double length, double cell) {
            return static_cast<std::int32_t>(std::max(1.0, std::round(length / cell)));
        };
        m_periodX = fit(params.period->width, m_cellWidth);
        m_periodY = fit(params.period->height, m_cellHeight);
        m_cellWidth = params.period->width / m_periodX;
        m_cellHeight = params.period->height / m_periodY;
    }
}

} // namespace txn
