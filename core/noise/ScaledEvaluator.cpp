// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AlignedBuffer.h"
#include "core/base/Simd.h"
#include "core/noise/MixedProcess.h"
#include "core/noise/TileEvaluator.h"
#include "core/spectral/BSpline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace txn {
namespace {

constexpr int kTileSide = 128;

/// The coefficients that one output pixel sees along one axis, with their weights.
struct Band {
    int first = 0;
    int count = 0;
    std::size_t weights = 0; ///< where they start
};

/// All pixels of a tile along one axis that an impulse touches: begin, begin + 1, ...
struct Axis {
    int begin = 0;
    std::vector<Band> bands;
    std::vector<float> weights;
};

TXN_MULTIVERSION
void addScaled(const float* in, float factor, float* out, std::size_t count) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i)
        out[i] += factor * in[i];
}

class ScaledEvaluator final : public TileEvaluator {
  public:
    ScaledEvaluator(Mixture mixture, const NoiseParams& params, double scale)
        : m_process(std::move(mixture), params), m_scale(scale) {}

    Size tileSize() const override { return {kTileSide, kTileSide}; }

    void evaluate(std::int64_t tileX,
                  std::int64_t tileY,
                  Image& tile,
                  const CancelToken& cancel) const override {
        const std::int64_t left = tileX * kTileSide;
        const std::int64_t top = tileY * kTileSide;
        const Size footprint = m_process.first().footprint();
        std::fill(tile.samples().begin(), tile.samples().end(), 0.0F);
        Axis horizontal;
        Axis vertical;
        std::vector<float> rows;
        m_process.impulses().visit(static_cast<double>(left) / m_scale - footprint.width,
                                   static_cast<double>(top) / m_scale - footprint.height,
                                   static_cast<double>(left + kTileSide) / m_scale,
                                   static_cast<double>(top + kTileSide) / m_scale,
                                   [&](const Impulse& impulse) {
                                       if (cancel.cancelled())
                                           return;
                                       const Size support = m_process.first().support.size();
                                       fillAxis(impulse.x, left, support.width, horizontal);
                                       fillAxis(impulse.y, top, support.height, vertical);
                                       if (!horizontal.bands.empty() && !vertical.bands.empty())
                                           add(impulse, horizontal, vertical, rows, tile);
                                   });
        const auto gain = static_cast<float>(m_process.gain());
        for (float& v : tile.samples())
            v *= gain;
        m_process.addMean(centres(left), centres(top), tile);
    }

  private:
    std::vector<double> centres(std::int64_t first) const {
        std::vector<double> result(kTileSide);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = (static_cast<double>(first) + static_cast<double>(i) + 0.5) / m_scale;
        return result;
    }

    /// Bands of the tile's pixels that the footprint at position overlaps; count coefficients.
    void fillAxis(double position, std::int64_t tileStart, int count, Axis& axis) const {
        axis.bands.clear();
        axis.weights.clear();
        const int order = m_process.first().interpolationOrder;
        const double half = 0.5 * (order + 1);
        const double corner = position + m_process.first().frame() + 0.5;
        // Pixels further out see nothing of the kernel.
        const double begin = (corner - half) * m_scale - static_cast<double>(tileStart) - 1.0;
        const double end =
            (corner + count - 1 + half) * m_scale - static_cast<double>(tileStart) + 1.0;
        const int firstPixel = static_cast<int>(std::clamp(begin, 0.0, 1.0 * kTileSide));
        const int lastPixel = static_cast<int>(std::clamp(end, -1.0, kTileSide - 1.0));
        for (int i = firstPixel; i <= lastPixel; ++i) {
            const auto pixel = static_cast<double>(tileStart + i);
            // The part of the kernel's axis that the pixel averages; a point above scale 1.
            const double from = (m_scale < 1.0 ? pixel : pixel + 0.5) / m_scale - corner;
            const double to = m_scale < 1.0 ? (pixel + 1.0) / m_scale - corner : from;
            const int first = std::max(0, static_cast<int>(std::ceil(from - half)));
            const int last = std::min(count - 1, static_cast<int>(std::floor(to + half)));
            if (first > last) {
                if (!axis.bands.empty())
                    break;
                continue;
            }
            if (axis.bands.empty())
                axis.begin = i;
            axis.bands.push_back({first, last - first + 1, axis.weights.size()});
            for (int k = first; k <= last; ++k) {
                const double weight = m_scale < 1.0 ? m_scale * (bsplineIntegral(order, to - k) -
                                                                 bsplineIntegral(order, from - k))
                                                    : bspline(order, from - k);
                axis.weights.push_back(static_cast<float>(weight));
            }
        }
    }

    /// Interpolates the rows that matter along x, then combines them along y into the tile.
    void add(const Impulse& impulse,
             const Axis& horizontal,
             const Axis& vertical,
             std::vector<float>& rows,
             Image& tile) const {
        const Image& kernel =
            m_process.textons()[static_cast<std::size_t>(m_process.textonOf(impulse))]
                .kernels[static_cast<std::size_t>(impulse.kernel)];
        const int firstRow = vertical.bands.front().first;
        const int lastRow = vertical.bands.back().first + vertical.bands.back().count - 1;
        const std::size_t width = horizontal.bands.size();
        rows.resize(static_cast<std::size_t>(lastRow - firstRow + 1) * width);
        for (int c = 0; c < tile.channels(); ++c) {
            float* out = rows.data();
            for (int y = firstRow; y <= lastRow; ++y) {
                const auto in = kernel.row(c, y);
                for (const Band& band : horizontal.bands) {
                    const float* weight = horizontal.weights.data() + band.weights;
                    float sum = 0.0F;
                    for (int k = 0; k < band.count; ++k)
                        sum += weight[k] * in[static_cast<std::size_t>(band.first + k)];
                    *out++ = sum;
                }
            }
            int y = vertical.begin;
            for (const Band& band : vertical.bands) {
                float* pixels = tile.row(c, y++).data() + horizontal.begin;
                for (int k = 0; k < band.count; ++k)
                    addScaled(
                        rows.data() + static_cast<std::size_t>(band.first + k - firstRow) * width,
                        impulse.sign * vertical.weights[band.weights + static_cast<std::size_t>(k)],
                        pixels,
                        width);
            }
        }
    }

    MixedProcess m_process;
    double m_scale;
};

} // namespace

std::unique_ptr<TileEvaluator>
makeScaledEvaluator(Mixture mixture, const NoiseParams& params, double scale) {
    return std::make_unique<ScaledEvaluator>(std::move(mixture), params, scale);
}

} // namespace txn
