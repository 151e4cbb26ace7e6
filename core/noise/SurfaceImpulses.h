// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/ImpulseProcess.h"

#include <glm/vec3.hpp>

namespace txn {

/// One impulse of surface noise: a kernel waiting in space for a surface to pass by.
struct SurfaceImpulse {
    glm::dvec3 place; ///< in exemplar pixels
    float sign = 1.0F;
    int kernel = 0;
    std::uint32_t choice = 0; ///< 10 random bits: see TextonField
};

/// The random impulses of a surface noise, one cubic cell of space at a time: as ImpulseProcess
/// with one dimension more. A cell has the volume 1 / lambda = r^3 / MNI, r the longer side of the
/// footprint. [TN17] section 6. A regular value.
class SurfaceImpulses {
  public:
    /// params: checked by checkNoiseParams; a period is ignored.
    SurfaceImpulses(const NoiseParams& params, Size footprint, int kernelCount);

    NoiseProcess process() const { return m_process; }
    /// r: the longer side of the footprint, in exemplar pixels.
    double side() const { return m_side; }
    /// Side of a cell, in exemplar pixels.
    double cell() const { return m_cell; }
    /// lambda: impulses per cubic exemplar pixel.
    double intensity() const { return 1.0 / (m_cell * m_cell * m_cell); }

    /// Calls visit(const SurfaceImpulse&) for all impulses of the cells that meet the box from low
    /// to high; some may lie just outside.
    template <class Visit>
    void visit(const glm::dvec3& low, const glm::dvec3& high, Visit&& visit) const {
        const auto index = [&](double at) {
            return static_cast<std::int32_t>(std::floor(at / m_cell));
        };
        for (std::int32_t z = index(low.z); z <= index(high.z); ++z) {
            for (std::int32_t y = index(low.y); y <= index(high.y); ++y) {
                for (std::int32_t x = index(low.x); x <= index(high.x); ++x)
                    visitCell(x, y, z, visit);
            }
        }
    }

  private:
    template <class Visit>
    void visitCell(std::int32_t x, std::int32_t y, std::int32_t z, Visit& visit) const {
        const auto draw = [&](std::uint32_t index) {
            // Golden ratio steps keep the draws of one cell, and those of near seeds, apart.
            return hash4(static_cast<std::uint32_t>(x),
                         static_cast<std::uint32_t>(y),
                         static_cast<std::uint32_t>(z),
                         m_seed + index * 0x9e3779b9U);
        };
        const int count = m_process == NoiseProcess::Stratified ? 1 : poissonCount(draw(0)[0]);
        for (int i = 0; i < count; ++i) {
            const auto h = draw(static_cast<std::uint32_t>(i) + 1U);
            const glm::dvec3 place{x + static_cast<double>(h[0] >> 8U) * 0x1p-24,
                                   y + static_cast<double>(h[1] >> 8U) * 0x1p-24,
                                   z + static_cast<double>(h[2] >> 8U) * 0x1p-24};
            visit(SurfaceImpulse{
                place * m_cell,
                m_process != NoiseProcess::Poisson && (h[3] >> 31U) != 0 ? -1.0F : 1.0F,
                static_cast<int>((((h[3] >> 15U) & 0xffffU) * m_kernelCount) >> 16U),
                (h[3] >> 5U) & 0x3ffU});
        }
    }

    NoiseProcess m_process;
    std::uint32_t m_seed;
    std::uint32_t m_kernelCount;
    double m_side = 0.0;
    double m_cell = 0.0;
};

} // namespace txn
