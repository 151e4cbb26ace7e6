// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/base/Hash.h"
#include "core/noise/NoiseParams.h"

#include <cmath>
#include <cstdint>

namespace txn {

/// One impulse: a copy of a kernel dropped on the plane.
struct Impulse {
    double x = 0.0; ///< where the top left corner of the footprint lands, in exemplar pixels
    double y = 0.0;
    float sign = 1.0F;
    int kernel = 0;
    std::uint32_t choice = 0; ///< 10 random bits: see TextonField
};

/// Poisson(1) distributed count from 32 uniform bits: how many of the thresholds
/// round(2^32 P(N <= n)) the bits reach. Integers only, so that GLSL counts the same.
[[nodiscard]] constexpr int poissonCount(std::uint32_t bits) {
    constexpr std::uint32_t kThresholds[] = {1580030169U,
                                             3160060337U,
                                             3950075422U,
                                             4213413783U,
                                             4279248374U,
                                             4292415292U,
                                             4294609778U,
                                             4294923276U,
                                             4294962463U,
                                             4294966817U,
                                             4294967253U,
                                             4294967292U};
    int count = 0;
    for (const std::uint32_t threshold : kThresholds)
        count += bits >= threshold ? 1 : 0;
    return count;
}

/// The random impulses of a texton noise, one cell of the plane at a time. A cell has the area
/// 1 / lambda; everything about it follows from a hash of (cell x, cell y, index, seed), so that
/// any part of the endless plane can be visited in any order, on any thread or GPU. A regular
/// value.
class ImpulseProcess {
  public:
    /// params: checked by checkNoiseParams. With a period the cells are fitted to it and repeat.
    ImpulseProcess(const NoiseParams& params, Size footprint, int kernelCount);

    /// lambda: impulses per square exemplar pixel.
    double intensity() const { return 1.0 / (m_cellWidth * m_cellHeight); }
    NoiseProcess process() const { return m_process; }
    /// Of one cell, in exemplar pixels.
    double cellWidth() const { return m_cellWidth; }
    double cellHeight() const { return m_cellHeight; }
    /// In cells; 0: endless.
    std::int32_t periodX() const { return m_periodX; }
    std::int32_t periodY() const { return m_periodY; }

    /// Calls visit(const Impulse&) for all impulses of the cells that meet the rectangle
    /// [left, right] x [top, bottom], row by row of cells; some may lie just outside.
    template <class Visit>
    void visit(double left, double top, double right, double bottom, Visit&& visit) const {
        const auto x0 = static_cast<std::int32_t>(std::floor(left / m_cellWidth));
        const auto x1 = static_cast<std::int32_t>(std::floor(right / m_cellWidth));
        const auto y0 = static_cast<std::int32_t>(std::floor(top / m_cellHeight));
        const auto y1 = static_cast<std::int32_t>(std::floor(bottom / m_cellHeight));
        for (std::int32_t y = y0; y <= y1; ++y) {
            for (std::int32_t x = x0; x <= x1; ++x)
                visitCell(x, y, visit);
        }
    }

  private:
    /// Separates the draw of a cell's count from those of its impulses.
    static constexpr std::uint32_t kCountIndex = 0xffffffffU;

    static std::uint32_t wrapped(std::int32_t cell, std::int32_t period) {
        if (period == 0)
            return static_cast<std::uint32_t>(cell);
        const std::int32_t rest = cell % period;
        return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
    }

    template <class Visit>
    void visitCell(std::int32_t cellX, std::int32_t cellY, Visit& visit) const {
        const std::uint32_t x = wrapped(cellX, m_periodX);
        const std::uint32_t y = wrapped(cellY, m_periodY);
        const int count = m_process == NoiseProcess::Stratified
                              ? 1
                              : poissonCount(hash4(x, y, kCountIndex, m_seed)[0]);
        for (int i = 0; i < count; ++i) {
            const auto h = hash4(x, y, static_cast<std::uint32_t>(i), m_seed);
            // 24 bits: exact in single precision, too.
            const double u = static_cast<double>(h[0] >> 8U) * 0x1p-24;
            const double v = static_cast<double>(h[1] >> 8U) * 0x1p-24;
            visit(Impulse{(cellX + u) * m_cellWidth,
                          (cellY + v) * m_cellHeight,
                          m_process != NoiseProcess::Poisson && (h[2] >> 31U) != 0 ? -1.0F : 1.0F,
                          static_cast<int>(((h[3] >> 16U) * m_kernelCount) >> 16U),
                          (h[3] & 0xffffU) >> 6U});
        }
    }

    NoiseProcess m_process;
    std::uint32_t m_seed;
    std::uint32_t m_kernelCount;
    double m_cellWidth = 0.0;
    double m_cellHeight = 0.0;
    std::int32_t m_periodX = 0;
    std::int32_t m_periodY = 0;
};

} // namespace txn
