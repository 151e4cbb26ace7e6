// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/MixedProcess.h"
#include "core/noise/TileEvaluator.h"
#include "core/spectral/BSpline.h"
#include "core/spectral/ComplexLanes.h"
#include "core/spectral/Fft.h"

#include <algorithm>
#include <cmath>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <vector>

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
    ConvolutionEvaluator(Mixture mixture, const NoiseParams& params)
        : m_process(std::move(mixture), params), m_order(first().interpolationOrder),
          m_frame(first().frame()), m_channels(first().channels()),
          m_kernels(first().kernelCount()),
          m_support(first().support.size()), m_size{transformLength(m_support.width),
                                                    transformLength(m_support.height)},
          m_blocks(HalfSpectrum::blocksFor(m_size.width)),
          m_kernelSpectra(m_process.textons().size() * static_cast<std::size_t>(m_kernels) *
                          static_cast<std::size_t>(m_channels)),
          m_rowForward(FftPlan::realForward(m_size.width)),
          m_rowInverse(FftPlan::realInverse(m_size.width)),
          m_columnForward(FftPlan::columnsForward(m_size.height)),
          m_columnInverse(FftPlan::columnsInverse(m_size.height)),
          m_scratch([this] { return Scratch(*this); }) {
        computeKernelSpectra();
    }

    Size tileSize() const override {
        return {m_size.width - m_support.width + 1, m_size.height - m_support.height + 1};
    }

    void evaluate(std::int64_t tileX,
                  std::int64_t tileY,
                  Image& tile,
                  const CancelToken& /*cancel*/) const override {
        Scratch& scratch = m_scratch.local();
        const std::int64_t left = tileX * tileSize().width;
        const std::int64_t top = tileY * tileSize().height;
        // Splats down to one support left of and above the tile reach into it.
        collect(left - (m_support.width - 1), top - (m_support.height - 1), scratch);
        bool first = true;
        for (std::size_t k = 0; k < scratch.splats.size(); ++k) {
            if (scratch.splats[k].empty())
                continue;
            splat(scratch.splats[k], scratch);
            addConvolution(k, first, scratch);
            first = false;
        }
        if (first) // no impulse anywhere near
            std::fill(tile.samples().begin(), tile.samples().end(), 0.0F);
        for (int c = 0; c < m_channels && !first; ++c)
            inverse(c, scratch, tile);
        m_process.addMean(centres(left, tile.width()), centres(top, tile.height()), tile);
    }

  private:
    /// An impulse as the splat it becomes, on the pixels of the transform.
    struct Splat {
        int x = 0; ///< of the first weight; may lie outside, as may the others
        int y = 0;
        float horizontal[6] = {};
        float vertical[6] = {}; ///< with the sign
    };

    struct Scratch {
        std::vector<std::vector<Splat>> splats; ///< of every kernel of every texton
        AlignedBuffer<float> pixels;            ///< [H][W], zero between uses
        std::vector<std::uint8_t> usedRows;     ///< [H]
        AlignedBuffer<Complex> splatRows;       ///< [block][H][lane]
        AlignedBuffer<Complex> channelRows;     ///< [channel][block][H][lane]
        AlignedBuffer<Complex> line;            ///< one row of a half spectrum
        AlignedBuffer<float> row;               ///< one row of pixels

        explicit Scratch(const ConvolutionEvaluator& e)
            : splats(e.m_process.textons().size() * static_cast<std::size_t>(e.m_kernels)),
              pixels(e.m_size.area()), usedRows(static_cast<std::size_t>(e.m_size.height)),
              splatRows(e.spectrumSize()),
              channelRows(static_cast<std::size_t>(e.m_channels) * e.spectrumSize()),
              line(static_cast<std::size_t>(e.m_blocks) * kLanes),
              row(static_cast<std::size_t>(e.m_size.width)) {
            pixels.fill(0.0F);
            line.fill({});
        }
    };

    const Texton& first() const { return m_process.first(); }
    std::size_t blockSize() const { return static_cast<std::size_t>(m_size.height) * kLanes; }
    std::size_t spectrumSize() const { return static_cast<std::size_t>(m_blocks) * blockSize(); }

    static std::vector<double> centres(std::int64_t first, int count) {
        std::vector<double> result(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = static_cast<double>(first) + static_cast<double>(i) + 0.5;
        return result;
    }

    void computeKernelSpectra() {
        const RealFft2d fft(m_size);
        // The kernels' spectra carry the gain and the inverse transform's 1 / (H W).
        const double factor = m_process.gain() / static_cast<double>(m_size.area());
        tbb::parallel_for(std::size_t{0}, m_kernelSpectra.size(), [&](std::size_t i) {
            const auto channels = static_cast<std::size_t>(m_channels);
            const auto kernels = static_cast<std::size_t>(m_kernels);
            const Image& kernel =
                m_process.textons()[i / channels / kernels].kernels[i / channels % kernels];
            Image padded(m_size, 1);
            for (int y = 0; y < m_support.height; ++y) {
                const auto from = kernel.row(static_cast<int>(i % channels), y);
                std::transform(from.begin(), from.end(), padded.row(0, y).begin(), [&](float v) {
                    return static_cast<float>(factor * v);
                });
            }
            m_kernelSpectra[i] = fft.forward(padded.plane(0));
        });
    }

    /// Sorts the impulses that reach the pixels from (left, top) on by kernel and texton.
    void collect(std::int64_t left, std::int64_t top, Scratch& scratch) const {
        for (auto& splats : scratch.splats)
            splats.clear();
        const double reach = m_order + 2.0;
        const auto x0 = static_cast<double>(left) - m_frame;
        const auto y0 = static_cast<double>(top) - m_frame;
        m_process.impulses().visit(x0 - reach,
                                   y0 - reach,
                                   x0 + m_size.width + reach,
                                   y0 + m_size.height + reach,
                                   [&](const Impulse& j) {
                                       const auto wx = bsplineWeights(m_order, j.x + m_frame);
                                       const auto wy = bsplineWeights(m_order, j.y + m_frame);
                                       const long long px = wx.first - left;
                                       const long long py = wy.first - top;
                                       if (px < -m_order || py < -m_order || px >= m_size.width ||
                                           py >= m_size.height)
                                           return;
                                       Splat splat;
                                       splat.x = static_cast<int>(px);
                                       splat.y = static_cast<int>(py);
                                       for (int i = 0; i <= m_order; ++i) {
                                           splat.horizontal[i] = wx.weight[i];
                                           splat.vertical[i] = j.sign * wy.weight[i];
                                       }
                                       scratch
                                           .splats[static_cast<std::size_t>(m_process.textonOf(j)) *
                                                       static_cast<std::size_t>(m_kernels) +
                                                   static_cast<std::size_t>(j.kernel)]
                                           .push_back(splat);
                                   });
    }

    /// P(n) = sum of e_j psi(n - x_j) over these impulses.
    void splat(const std::vector<Splat>& splats, Scratch& scratch) const {
        std::ranges::fill(scratch.usedRows, std::uint8_t{0});
        for (const Splat& splat : splats) {
            for (int v = std::max(0, -splat.y); v <= m_order && splat.y + v < m_size.height; ++v) {
                const auto y = static_cast<std::size_t>(splat.y + v);
                scratch.usedRows[y] = 1;
                float* row = scratch.pixels.data() + y * static_cast<std::size_t>(m_size.width);
                for (int u = std::max(0, -splat.x); u <= m_order && splat.x + u < m_size.width; ++u)
                    row[splat.x + u] += splat.vertical[v] * splat.horizontal[u];
            }
        }
    }

    /// Adds the convolution of the splats with kernel k to the channels; takes the splats away.
    void addConvolution(std::size_t k, bool first, Scratch& scratch) const {
        scratch.splatRows.fill({});
        for (std::size_t y = 0; y < scratch.usedRows.size(); ++y) {
            if (scratch.usedRows[y] == 0)
                continue; // zeros, as most rows of a kernel that is seldom taken
            float* row = scratch.pixels.data() + y * static_cast<std::size_t>(m_size.width);
            m_rowForward.run(row, scratch.line.data());
            std::fill_n(row, m_size.width, 0.0F);
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(scratch.line.data() + b * kLanes,
                            kLanes,
                            scratch.splatRows.data() + static_cast<std::size_t>(b) * blockSize() +
                                y * kLanes);
        }
        for (int b = 0; b < m_blocks; ++b) {
            const std::size_t at = static_cast<std::size_t>(b) * blockSize();
            Complex* splats = scratch.splatRows.data() + at;
            m_columnForward.run(splats);
            for (std::size_t c = 0; c < static_cast<std::size_t>(m_channels); ++c) {
                Complex* out = scratch.channelRows.data() + c * spectrumSize() + at;
                const Complex* kernel =
                    m_kernelSpectra[k * static_cast<std::size_t>(m_channels) + c].block(b).data();
                if (first)
                    multiply(splats, kernel, out, blockSize());
                else
                    addProducts(splats, kernel, out, blockSize());
            }
        }
    }

    void inverse(int channel, Scratch& scratch, Image& tile) const {
        Complex* spectrum =
            scratch.channelRows.data() + static_cast<std::size_t>(channel) * spectrumSize();
        for (int b = 0; b < m_blocks; ++b)
            m_columnInverse.run(spectrum + static_cast<std::size_t>(b) * blockSize());
        for (int y = 0; y < tile.height(); ++y) {
            const auto row = static_cast<std::size_t>(y + m_support.height - 1);
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(spectrum + static_cast<std::size_t>(b) * blockSize() + row * kLanes,
                            kLanes,
                            scratch.line.data() + b * kLanes);
            m_rowInverse.run(scratch.line.data(), scratch.row.data());
            const auto out = tile.row(channel, y);
            std::copy_n(scratch.row.data() + (m_support.width - 1), out.size(), out.begin());
        }
    }

    MixedProcess m_process;
    int m_order;
    int m_frame;
    int m_channels;
    int m_kernels;
    Size m_support;
    Size m_size; ///< of the transforms
    int m_blocks;
    std::vector<HalfSpectrum> m_kernelSpectra; ///< [texton][kernel][channel]
    FftPlan m_rowForward;
    FftPlan m_rowInverse;
    FftPlan m_columnForward;
    FftPlan m_columnInverse;
    mutable tbb::enumerable_thread_specific<Scratch> m_scratch;
};

} // namespace

std::size_t convolutionBytes(const Mixture& mixture) {
    const Texton& first = mixture.textons.front();
    const Size support = first.support.size();
    const Size size{transformLength(support.width), transformLength(support.height)};
    return mixture.textons.size() * static_cast<std::size_t>(first.kernelCount()) *
           static_cast<std::size_t>(first.channels()) * (size.area() / 2) * sizeof(Complex);
}

std::unique_ptr<TileEvaluator> makeConvolutionEvaluator(Mixture mixture,
                                                        const NoiseParams& params) {
    return std::make_unique<ConvolutionEvaluator>(std::move(mixture), params);
}

} // namespace txn
