// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/SurfaceNoise.h"

#include "core/noise/SpotNoise.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace txn {

Normalization surfaceNormalization(const Texton& texton, const SurfaceImpulses& impulses) {
    const double perKernel = impulses.intensity() / texton.kernelCount();
    Normalization result{1.0 / std::sqrt(perKernel * impulses.side() / 3.0), texton.mean};
    if (impulses.process() == NoiseProcess::Poisson) {
        const auto sums = kernelSums(texton);
        for (std::size_t c = 0; c < sums.size(); ++c)
            result.offset[c] -= result.gain * perKernel * impulses.side() / 2.0 * sums[c];
    }
    return result;
}

SurfaceNoise::SurfaceNoise(Texton texton, const NoiseParams& params)
    : m_texton(std::move(texton)), m_impulses(params, m_texton.footprint(), m_texton.kernelCount()),
      m_normalization(surfaceNormalization(m_texton, m_impulses)) {}

void SurfaceNoise::evaluate(const glm::dvec3& point,
                            const SurfaceFrame& frame,
                            std::span<double> out) const {
    assert(out.size() == m_texton.mean.size());
    const Size footprint = m_texton.footprint();
    const double half = 0.5 * m_impulses.side();
    const double corner = m_texton.frame() + 0.5;
    const glm::dvec3 reach =
        half * (glm::abs(frame.right) + glm::abs(frame.down) + glm::abs(frame.normal));
    std::fill(out.begin(), out.end(), 0.0);
    m_impulses.visit(point - reach, point + reach, [&](const SurfaceImpulse& impulse) {
        const glm::dvec3 from = point - impulse.place;
        const double weight = 1.0 - std::abs(glm::dot(from, frame.normal)) / half;
        if (weight <= 0.0)
            return;
        const double x = glm::dot(from, frame.right) + 0.5 * footprint.width - corner;
        const double y = glm::dot(from, frame.down) + 0.5 * footprint.height - corner;
        for (std::size_t c = 0; c < out.size(); ++c)
            out[c] += impulse.sign * weight *
                      kernelValue(m_texton, impulse.kernel, static_cast<int>(c), x, y);
    });
    for (std::size_t c = 0; c < out.size(); ++c)
        out[c] = m_normalization.offset[c] + m_normalization.gain * out[c];
}

} // namespace txn
