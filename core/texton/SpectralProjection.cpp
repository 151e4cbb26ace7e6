// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/SpectralProjection.h"

#include "core/spectral/BSpline.h"
#include "core/spectral/ComplexLanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

constexpr int kLanes = FftPlan::kLanes;

int largestPrimeFactor(int n) {
    int largest = 1;
    for (int p = 2; p * p <= n; ++p) {
        for (; n % p == 0; n /= p)
            largest = p;
    }
    return std::max(largest, n);
}

/// Divisor L >= minimum of length for which length / L transforms cost least.
int shortTransformLength(int length, int minimum) {
    int best = length;
    double bestCost = std::numeric_limits<double>::max();
    for (int candidate = minimum; candidate <= length; ++candidate) {
        if (length % candidate != 0)
            continue;
        // Operations per output: log2 L for small prime factors, growing with large ones, plus the
        // product with the phase factors on the way in and out.
        const int prime = largestPrimeFactor(candidate);
        const double transform = std::log2(candidate) * (prime <= 7    ? 1.0
                                                         : prime <= 13 ? 1.5
                                                                       : 4.0);
        const double phases = candidate == length ? 0.0 : 1.0 * minimum / candidate;
        if (transform + phases < bestCost) {
            bestCost = transform + phases;
            best = candidate;
        }
    }
    return best;
}

} // namespace

struct SpectralProjection::Scratch {
    AlignedBuffer<Complex> spectrum; ///< [channel][L][lane]
    AlignedBuffer<Complex> dot;      ///< [L][lane]
    AlignedBuffer<Complex> sum;      ///< [channel][h][lane]

    explicit Scratch(const SpectralProjection& p)
        : spectrum(static_cast<std::size_t>(p.m_channels) * p.residueSize()), dot(p.residueSize()),
          sum(static_cast<std::size_t>(p.m_channels) * p.rowsPerChannel()) {}
};

SpectralProjection::SpectralProjection(const GaussianModel& model,
                                       int interpolationOrder,
                                       Size corner)
    : m_domain(model.domain()), m_corner(corner), m_channels(model.channels()),
      m_blocks(HalfSpectrum::blocksFor(model.domain().width)),
      m_length(shortTransformLength(model.domain().height, corner.height)),
      m_residues(model.domain().height / m_length),
      m_bHorizontal(bsplineSpectrum(interpolationOrder, model.domain().width)),
      m_bVertical(bsplineSpectrum(interpolationOrder, model.domain().height)),
      m_twiddles(static_cast<std::size_t>(m_residues) * static_cast<std::size_t>(corner.height)),
      m_target(static_cast<std::size_t>(m_blocks) * static_cast<std::size_t>(m_channels) *
               static_cast<std::size_t>(m_domain.height) * kLanes),
      m_rowForward(FftPlan::realForward(m_domain.width)),
      m_rowInverse(FftPlan::realInverse(m_domain.width)),
      m_columnForward(FftPlan::columnsForward(m_length)),
      m_columnInverse(FftPlan::columnsInverse(m_length)) {
    assert(corner.width <= m_domain.width && corner.height <= m_domain.height);
    for (int s = 0; s < m_residues; ++s) {
        for (int n = 0; n < corner.height; ++n) {
            const double angle = -2.0 * std::numbers::pi * s * n / m_domain.height;
            m_twiddles[static_cast<std::size_t>(s) * static_cast<std::size_t>(corner.height) +
                       static_cast<std::size_t>(n)] =
                Complex(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
        }
    }
    buildTarget(model);
}

const Complex* SpectralProjection::target(int block, int residue) const {
    const auto index = static_cast<std::size_t>(block) * static_cast<std::size_t>(m_residues) +
                       static_cast<std::size_t>(residue);
    return m_target.data() + index * static_cast<std::size_t>(m_channels) * residueSize();
}

void SpectralProjection::buildTarget(const GaussianModel& model) {
    const double variance = model.covariance().trace() / m_channels;
    m_scale = std::sqrt(variance);
    // Dividing by the scale makes the iteration blind to the units of the exemplar.
    const double inverse = m_scale > 0.0 ? 1.0 / m_scale : 0.0;
    std::vector<double> energy(static_cast<std::size_t>(m_blocks), 0.0);
    tbb::parallel_for(0, m_blocks, [&](int b) {
        Complex* out = m_target.data() + (target(b, 0) - m_target.data());
        for (int s = 0; s < m_residues; ++s) {
            for (int c = 0; c < m_channels; ++c) {
                const auto spot = model.spot(c).block(b);
                for (int q = 0; q < m_length; ++q) {
                    const auto row =
                        static_cast<std::size_t>(q) * static_cast<std::size_t>(m_residues) +
                        static_cast<std::size_t>(s);
                    for (int lane = 0; lane < kLanes; ++lane, ++out) {
                        const int column = b * kLanes + lane;
                        if (column >= model.spot(c).columns()) {
                            *out = Complex{};
                            continue;
                        }
                        const double bHat =
                            m_bHorizontal[static_cast<std::size_t>(column)] * m_bVertical[row];
                        const Complex value = spot[row * kLanes + static_cast<std::size_t>(lane)];
                        energy[static_cast<std::size_t>(b)] +=
                            model.spot(c).multiplicity(column) * inverse * inverse *
                            std::norm(std::complex<double>(value));
                        *out = value * static_cast<float>(inverse / std::sqrt(bHat));
                    }
                }
            }
        }
    });
    for (const double e : energy)
        m_targetEnergy += e;
}

AlignedBuffer<Complex> SpectralProjection::forwardRows(const Image& coefficients) const {
    assert(coefficients.size() == m_corner && coefficients.channels() == m_channels);
    AlignedBuffer<Complex> rows(static_cast<std::size_t>(m_blocks) *
                                static_cast<std::size_t>(m_channels) * rowsPerChannel());
    const auto total =
        static_cast<std::size_t>(m_channels) * static_cast<std::size_t>(m_corner.height);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, total, 8), [&](const auto& range) {
        AlignedBuffer<float> line(static_cast<std::size_t>(m_domain.width));
        AlignedBuffer<Complex> out(static_cast<std::size_t>(m_blocks) * kLanes);
        line.fill(0.0F);
        out.fill({});
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const auto height = static_cast<std::size_t>(m_corner.height);
            const auto source =
                coefficients.row(static_cast<int>(i / height), static_cast<int>(i % height));
            std::copy(source.begin(), source.end(), line.data());
            m_rowForward.run(line.data(), out.data());
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(out.data() + b * kLanes,
                            kLanes,
                            rows.data() + (static_cast<std::size_t>(b) * total + i) * kLanes);
        }
    });
    return rows;
}

void SpectralProjection::inverseRows(const AlignedBuffer<Complex>& rows, Image& result) const {
    const auto total =
        static_cast<std::size_t>(m_channels) * static_cast<std::size_t>(m_corner.height);
    const float scale = 1.0F / static_cast<float>(m_domain.area());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, total, 8), [&](const auto& range) {
        AlignedBuffer<Complex> in(static_cast<std::size_t>(m_blocks) * kLanes);
        AlignedBuffer<float> line(static_cast<std::size_t>(m_domain.width));
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            for (int b = 0; b < m_blocks; ++b)
                std::copy_n(rows.data() + (static_cast<std::size_t>(b) * total + i) * kLanes,
                            kLanes,
                            in.data() + b * kLanes);
            m_rowInverse.run(in.data(), line.data());
            const auto height = static_cast<std::size_t>(m_corner.height);
            const auto out = result.row(static_cast<int>(i / height), static_cast<int>(i % height));
            std::transform(line.data(), line.data() + out.size(), out.begin(), [scale](float v) {
                return v * scale;
            });
        }
    });
}

/// Frequencies residue, residue + H / L, ... of all channels of one block of columns.
void SpectralProjection::transformResidue(const Complex* rows,
                                          int residue,
                                          Complex* spectrum) const {
    const auto height = static_cast<std::size_t>(m_corner.height);
    for (int c = 0; c < m_channels; ++c) {
        const Complex* in = rows + static_cast<std::size_t>(c) * rowsPerChannel();
        Complex* out = spectrum + static_cast<std::size_t>(c) * residueSize();
        if (residue == 0)
            std::copy_n(in, rowsPerChannel(), out);
        else
            multiplyRows(in,
                         m_twiddles.data() + static_cast<std::size_t>(residue) * height,
                         out,
                         height);
        std::fill(out + rowsPerChannel(), out + residueSize(), Complex{});
        m_columnForward.run(out);
    }
}

void SpectralProjection::projectBlock(int block, Complex* rows, Scratch& scratch) const {
    const auto height = static_cast<std::size_t>(m_corner.height);
    scratch.sum.fill({});
    for (int s = 0; s < m_residues; ++s) {
        transformResidue(rows, s, scratch.spectrum.data());
        const Complex* p = target(block, s);
        scalarProducts(p,
                       scratch.spectrum.data(),
                       m_channels,
                       residueSize(),
                       scratch.dot.data(),
                       residueSize());
        rotateTarget(p,
                     scratch.dot.data(),
                     scratch.spectrum.data(),
                     m_channels,
                     residueSize(),
                     residueSize());
        for (int c = 0; c < m_channels; ++c) {
            Complex* spectrum =
                scratch.spectrum.data() + static_cast<std::size_t>(c) * residueSize();
            m_columnInverse.run(spectrum);
            addRowsTimesConjugate(spectrum,
                                  m_twiddles.data() + static_cast<std::size_t>(s) * height,
                                  scratch.sum.data() +
                                      static_cast<std::size_t>(c) * rowsPerChannel(),
                                  height);
        }
    }
    std::copy_n(scratch.sum.data(), scratch.sum.size(), rows);
}

void SpectralProjection::project(const Image& coefficients, Image& result) const {
    auto rows = forwardRows(coefficients);
    tbb::enumerable_thread_specific<Scratch> scratch([this] { return Scratch(*this); });
    const std::size_t blockSize = static_cast<std::size_t>(m_channels) * rowsPerChannel();
    tbb::parallel_for(0, m_blocks, [&](int b) {
        projectBlock(b, rows.data() + static_cast<std::size_t>(b) * blockSize, scratch.local());
    });
    inverseRows(rows, result);
}

Image SpectralProjection::projectFromDomain(const Image& guess) const {
    assert(guess.size() == m_domain && guess.channels() == m_channels);
    const RealFft2d fft(m_domain);
    std::vector<HalfSpectrum> spectra;
    spectra.reserve(static_cast<std::size_t>(m_channels));
    for (int c = 0; c < m_channels; ++c)
        spectra.push_back(fft.forward(guess.plane(c)));
    tbb::enumerable_thread_specific<Scratch> scratch([this] { return Scratch(*this); });
    // The same steps as projectBlock; gathering rows by residue stands in for the short transforms.
    tbb::parallel_for(0, m_blocks, [&](int b) {
        Scratch& local = scratch.local();
        const auto forEachRow = [&](int s, auto visit) {
            for (int c = 0; c < m_channels; ++c) {
                const auto block = spectra[static_cast<std::size_t>(c)].block(b);
                Complex* gathered =
                    local.spectrum.data() + static_cast<std::size_t>(c) * residueSize();
                for (int q = 0; q < m_length; ++q)
                    visit(block.data() + (q * m_residues + s) * kLanes, gathered + q * kLanes);
            }
        };
        for (int s = 0; s < m_residues; ++s) {
            const Complex* p = target(b, s);
            const std::size_t n = residueSize();
            forEachRow(s, [](const Complex* row, Complex* out) { std::copy_n(row, kLanes, out); });
            scalarProducts(p, local.spectrum.data(), m_channels, n, local.dot.data(), n);
            rotateTarget(p, local.dot.data(), local.spectrum.data(), m_channels, n, n);
            forEachRow(s, [](Complex* row, const Complex* in) { std::copy_n(in, kLanes, row); });
        }
    });
    Image result(m_corner, m_channels);
    Image whole(m_domain, 1);
    for (int c = 0; c < m_channels; ++c) {
        fft.inverse(std::move(spectra[static_cast<std::size_t>(c)]), whole.plane(0));
        for (int y = 0; y < m_corner.height; ++y) {
            const auto out = result.row(c, y);
            std::copy_n(whole.row(0, y).begin(), out.size(), out.begin());
        }
    }
    return result;
}

SpectralProjection::Sums
SpectralProjection::sumBlock(int block, const Complex* rows, Scratch& scratch) const {
    Sums sums;
    for (int s = 0; s < m_residues; ++s) {
        transformResidue(rows, s, scratch.spectrum.data());
        scalarProducts(target(block, s),
                       scratch.spectrum.data(),
                       m_channels,
                       residueSize(),
                       scratch.dot.data(),
                       residueSize());
        for (int q = 0; q < m_length; ++q) {
            const double bRow = m_bVertical[static_cast<std::size_t>(q * m_residues + s)];
            for (int lane = 0; lane < kLanes; ++lane) {
                const int column = block * kLanes + lane;
                if (2 * column > m_domain.width || (q == 0 && s == 0 && column == 0))
                    continue;
                const int count = column == 0 || 2 * column == m_domain.width ? 1 : 2;
                const double weight =
                    count * bRow * m_bHorizontal[static_cast<std::size_t>(column)];
                const auto at = static_cast<std::size_t>(q * kLanes + lane);
                double energy = 0.0;
                for (int c = 0; c < m_channels; ++c)
                    energy += static_cast<double>(std::norm(
                        scratch.spectrum[static_cast<std::size_t>(c) * residueSize() + at]));
                sums.energy += weight * energy;
                // t_u^* z = b^ P^* alpha^, since t_u^ = P sqrt(b^) and z = sqrt(b^) alpha^.
                sums.cross += weight * static_cast<double>(std::abs(scratch.dot[at]));
            }
        }
    }
    return sums;
}

double SpectralProjection::relativeModelError(const Image& coefficients) const {
    if (!(m_targetEnergy > 0.0))
        return 0.0;
    const auto rows = forwardRows(coefficients);
    tbb::enumerable_thread_specific<Scratch> scratch([this] { return Scratch(*this); });
    std::vector<Sums> partial(static_cast<std::size_t>(m_blocks));
    const std::size_t blockSize = static_cast<std::size_t>(m_channels) * rowsPerChannel();
    tbb::parallel_for(0, m_blocks, [&](int b) {
        partial[static_cast<std::size_t>(b)] =
            sumBlock(b, rows.data() + static_cast<std::size_t>(b) * blockSize, scratch.local());
    });
    Sums sums;
    for (const Sums& p : partial) {
        sums.energy += p.energy;
        sums.cross += p.cross;
    }
    const double square = 1.0 + (sums.energy - 2.0 * sums.cross) / m_targetEnergy;
    return std::sqrt(std::max(square, 0.0)); // rounding may leave it just below zero
}

double SpectralProjection::relativeModelError(const Texton& texton) const {
    assert(texton.kernelCount() == 1);
    Image scaled = texton.kernels.front();
    const auto inverse = static_cast<float>(m_scale > 0.0 ? 1.0 / m_scale : 0.0);
    for (float& v : scaled.samples())
        v *= inverse;
    return relativeModelError(scaled);
}

} // namespace txn
