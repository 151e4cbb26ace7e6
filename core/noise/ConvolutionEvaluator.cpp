// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/Normalization.h"
#include "core/noise/TileEvaluator.h"
#include "core/spectral/BSpline.h"
#include "core/spectral/ComplexLanes.h"
#include "core/spectral/Fft.h"

#include <algorithm>
#include <cmath>
#include <tbb/enumerable_thread_specific.h>

namespace txn {
namespace {

constexpr int kLanes = FftPlan::kLanes;

/// Transform length for kernels of the given side: a power of two, at least four sides, so that
/// three quarters of every tile are of use.
int transformLength(int side) {
    int length = 256;
    while (length < 4 * side)
        length *= 2;
    return length;
}

class ConvolutionEvaluator final : public TileEvaluator {
  public:
    ConvolutionEvaluator(const Texton& texton, const NoiseParams& params)
        : m_order(texton.interpolationOrder), m_frame(texton.frame()),
          m_channels(texton.channels()), m_kernels(texton.kernelCount()),
          m_support(texton.support.size()), m_size{transformLength(m_support.width),
                                                   transformLength(m_support.height)},
          m_blocks(HalfSpectrum::blocksFor(m_size.width)),
          m_impulses(params, texton.footprint(), texton.kernelCount()),
          m_normalization(normalization(texton, m_impulses)),
          m_rowForward(FftPlan::realForward(m_size.width)),
          m_rowInverse(FftPlan::realInverse(m_size.width)),
          m_columnForward(FftPlan::columnsForward(m_size.height)),
          m_columnInverse(FftPlan::columnsInverse(m_size.height)),
          m_scratch([this] { return Scratch(*this); }) {
        const RealFft2d fft(m_size);
        // The kernels' spectra carry the gain and the inverse transform's 1 / (H W).
        const double factor = m_normalization.gain / static_cast<double>(m_size.area());
        Image padded(m_size, 1);
        for (const Image& kernel : texton.kernels) {
            for (int c = 0; c < m_channels; ++c) {
                std::fill(padded.samples().begin(), padded.samples().end(), 0.0F);
                for (int y = 0; y < m_support.height; ++y) {
                    const auto from = kernel.row(c, y);
                    std::transform(from.begin(),
                                   from.end(),
                                   padded.row(0, y).begin(),
                                   [&](float v) { return static_cast<float>(factor * v); });
                }
                m_kernelSpectra.push_back(fft.forward(padded.plane(0)));
            }
        }
    }

    Size tileSize() const override {
        return {m_size.width - m_support.width + 1, m_size.height - m_support.height + 1};
    }

    void evaluate(std::int64_t tileX,
                  std::int64_t tileY,
                  Image& tile,
                  const CancelToken& /*cancel*/) const override {
        Scratch& scratch = m_scratch.local();
        // Splats down to one support left of and above the tile reach into it.
        splat(tileX * tileSize().width - (m_support.width - 1),
              tileY * tileSize().height - (m_support.height - 1),
              scratch);
        for (int q = 0; q < m_kernels; ++q)
            forwardRows(scratch.splats.data() + static_cast<std::size_t>(q) * m_size.area(),
                        scratch.splatRows.data() + static_cast<std::size_t>(q) * spectrumSize(),
                        scratch);
        for (int b = 0; b < m_blocks; ++b)
            convolveBlock(b, scratch);
        for (int c = 0; c < m_channels; ++c)
            inverseRows(c, scratch, tile);
    }

  private:
    struct Scratch {
        AlignedBuffer<float> splats;        ///< [kernel][H][W]
        AlignedBuffer<Complex> splatRows;   ///< [kernel][block][H][lane]
        AlignedBuffer<Complex> channelRows; ///< [channel][block][H][lane]
        AlignedBuffer<Complex> line;        ///< one row of a half spectrum
        AlignedBuffer<float> row;           ///< one row of pixels
        AlignedBuffer<Complex> columns;     ///< one block: [H][lane]

        explicit Scratch(const ConvolutionEvaluator& e)
            : splats(static_cast<std::size_t>(e.m_kernels) * e.m_size.area()),
              splatRows(static_cast<std::size_t>(e.m_kernels) * e.spectrumSize()),
              channelRows(static_cast<std::size_t>(e.m_channels) * e.spectrumSize()),
              line(static_cast<std::size_t>(e.m_blocks) * kLanes),
              row(static_cast<std::size_t>(e.m_size.width)), columns(e.blockSize()) {
            line.fill({});
        }
    };

    std::size_t blockSize() const { return static_cast<std::size_t>(m_size.height) * kLanes; }
    std::size_t spectrumSize() const { return static_cast<std::size_t>(m_blocks) * blockSize(); }

    /// P_q(n) = sum of e_j psi(n - x_j) over the impulses of kernel q, on the pixels from (left,
    /// top).
    void splat(std::int64_t left, std::int64_t top, Scratch& scratch) const {
        scratch.splats.fill(0.0F);
        const int width = m_size.width;
        const int height = m_size.height;
        const double reach = m_order + 2.0;
        const auto x0 = static_cast<double>(left) - m_frame;
        const auto y0 = static_cast<double>(top) - m_frame;
        m_impulses.visit(x0 - reach,
                         y0 - reach,
                         x0 + width + reach,
                         y0 + height + reach,
                         [&](const Impulse& j) {
                             const auto wx = bsplineWeights(m_order, j.x + m_frame);
                             const auto wy = bsplineWeights(m_order, j.y + m_frame);
                             const long long px = wx.first - left;
                             const long long py = wy.first - top;
                             if (px < -m_order || py < -m_order || px >= width || py >= height)
                                 return;
                             float* plane = scratch.splats.data() +
                                            static_cast<std::size_t>(j.kernel) * m_size.area();
                             for (int v = 0; v <= m_order; ++v) {
                                 if (py + v < 0 || py + v >= height)
                                     continue;
                                 float* row = plane + (py + v) * width;
                                 const float weight = j.sign * wy.weight[v];
                                 for (int u = 0; u <= m_order; ++u) {
                                     if (px + u >= 0 && px + u < width)
                                         row[px + u] += weight * wx.weight[u];
                                 }
                             }
                         });
    }

    void forwardRows(const float* pixels, Complex* spectrum, Scratch& scratch) const {
        for (int y = 0; y < m_size.height; ++y) {
            m_rowForward.run(pixels + static_cast<std::size_t>(y) *
                                          static_cast<std::size_t>(m_size.width),
                             scratch.line.data());
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(scratch.line.data() + b * kLanes,
                            kLanes,
                            spectrum + static_cast<std::size_t>(b) * blockSize() +
                                static_cast<std::size_t>(y) * kLanes);
        }
    }

    void convolveBlock(int block, Scratch& scratch) const {
        const std::size_t at = static_cast<std::size_t>(block) * blockSize();
        for (int q = 0; q < m_kernels; ++q)
            m_columnForward.run(scratch.splatRows.data() +
                                static_cast<std::size_t>(q) * spectrumSize() + at);
        for (int c = 0; c < m_channels; ++c) {
            Complex* out =
                scratch.channelRows.data() + static_cast<std::size_t>(c) * spectrumSize() + at;
            for (int q = 0; q < m_kernels; ++q) {
                const Complex* splats =
                    scratch.splatRows.data() + static_cast<std::size_t>(q) * spectrumSize() + at;
                const Complex* kernel =
                    m_kernelSpectra[static_cast<std::size_t>(q * m_channels + c)]
                        .block(block)
                        .data();
                if (q == 0)
                    multiply(splats, kernel, out, blockSize());
                else
                    addProducts(splats, kernel, out, blockSize());
            }
            m_columnInverse.run(out);
        }
    }

    void inverseRows(int channel, Scratch& scratch, Image& tile) const {
        const Complex* spectrum =
            scratch.channelRows.data() + static_cast<std::size_t>(channel) * spectrumSize();
        const auto offset =
            static_cast<float>(m_normalization.offset[static_cast<std::size_t>(channel)]);
        for (int y = 0; y < tile.height(); ++y) {
            const auto row = static_cast<std::size_t>(y + m_support.height - 1);
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(spectrum + static_cast<std::size_t>(b) * blockSize() + row * kLanes,
                            kLanes,
                            scratch.line.data() + b * kLanes);
            m_rowInverse.run(scratch.line.data(), scratch.row.data());
            const float* useful = scratch.row.data() + (m_support.width - 1);
            const auto out = tile.row(channel, y);
            for (std::size_t x = 0; x < out.size(); ++x)
                out[x] = useful[x] + offset;
        }
    }

    int m_order;
    int m_frame;
    int m_channels;
    int m_kernels;
    Size m_support;
    Size m_size; ///< of the transforms
    int m_blocks;
    ImpulseProcess m_impulses;
    Normalization m_normalization;
    std::vector<HalfSpectrum> m_kernelSpectra; ///< [kernel][channel]
    FftPlan m_rowForward;
    FftPlan m_rowInverse;
    FftPlan m_columnForward;
    FftPlan m_columnInverse;
    mutable tbb::enumerable_thread_specific<Scratch> m_scratch;
};

} // namespace

std::unique_ptr<TileEvaluator> makeConvolutionEvaluator(const Texton& texton,
                                                        const NoiseParams& params) {
    return std::make_unique<ConvolutionEvaluator>(texton, params);
}

} // namespace txn
