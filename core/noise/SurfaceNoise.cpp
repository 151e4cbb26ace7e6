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

SurfaceNoise::SurfaceNoise(Mixture mixture, const NoiseParams& params)
    : m_textons(std::move(mixture.textons)),
      m_field(mixture.map, static_cast<int>(m_textons.size()), m_textons.front().footprint()),
      m_impulses(params, m_textons.front().footprint(), m_textons.front().kernelCount()),
      m_gain(surfaceNormalization(m_textons.front(), m_impulses).gain) {
    for (const Texton& texton : m_textons)
        m_offsets.push_back(surfaceNormalization(texton, m_impulses).offset);
}

void SurfaceNoise::evaluate(const glm::dvec3& point,
                            const SurfaceFrame& frame,
                            std::span<double> out) const {
    const Texton& first = m_textons.front(); // what they all share can be read from it
    assert(out.size() == first.mean.size());
    const Size footprint = first.footprint();
    const double half = 0.5 * m_impulses.side();
    const double corner = first.frame() + 0.5;
    const glm::dvec3 reach =
        half * (glm::abs(frame.right) + glm::abs(frame.down) + glm::abs(frame.normal));
    std::fill(out.begin(), out.end(), 0.0);
    m_impulses.visit(point - reach, point + reach, [&](const SurfaceImpulse& impulse) {
        const glm::dvec3 from = point - impulse.place;
        const double weight = 1.0 - std::abs(glm::dot(from, frame.normal)) / half;
        if (weight <= 0.0)
            return;
        const auto texton = static_cast<std::size_t>(
            m_field.textonAt(impulse.place.x, -impulse.place.y, impulse.choice));
        const double x = glm::dot(from, frame.right) + 0.5 * footprint.width - corner;
        const double y = glm::dot(from, frame.down) + 0.5 * footprint.height - corner;
        for (std::size_t c = 0; c < out.size(); ++c)
            out[c] += impulse.sign * weight *
                      kernelValue(m_textons[texton], impulse.kernel, static_cast<int>(c), x, y);
    });
    const auto mean = mixedMean(m_field, m_offsets, point.x, -point.y);
    for (std::size_t c = 0; c < out.size(); ++c)
        out[c] = mean[c] + m_gain * out[c];
}

} // namespace txn
