// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/CovarianceObjective.h"

#include "core/gaussian/Variation.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/spectral/BSpline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

/// Of the side, at each end.
constexpr double kTaperShare = 0.25;
/// What variables near the border cost. The taper alone could be undone by large ones, and then
/// long grain would end in lines.
constexpr double kBorderCost = 0.002;
/// Up to which share of the support's side lags count. A tapered kernel can do little about longer
/// ones, and trying costs what matters: with 1 instead, errors up to half the side on pictures that
/// the fit has not seen are a tenth higher.
constexpr double kReach = 0.7;
constexpr int kMaxKernels = 16;

/// The grid on which autocorrelations of the support, widened by b, do not wrap.
Size gridFor(const CovarianceObjective::Shape& shape) {
    const Size size = shape.support.size();
    const int margin = 2 * shape.interpolationOrder;
    return {fastLength(2 * size.width + margin), fastLength(2 * size.height + margin)};
}

/// 1 in the middle, falling to 0 over the first and last share of [0, 1].
double tukey(double t) {
    const double edge = std::min(t, 1.0 - t);
    if (edge <= 0.0)
        return 0.0;
    return edge >= kTaperShare ? 1.0
                               : 0.5 * (1.0 - std::cos(std::numbers::pi * edge / kTaperShare));
}

double lagWeight(int lag, int side) {
    const double share = std::abs(lag) / (kReach * side);
    return share >= 1.0 ? 0.0 : 0.5 * (1.0 + std::cos(std::numbers::pi * share));
}

/// The fewer pairs of pixels there are a lag apart, the less a covariance found from them can be
/// trusted, and the smaller it is taken to be.
double trust(int lag, int length) {
    return std::sqrt(1.0 - static_cast<double>(std::abs(lag)) / length);
}

/// Of a position on a circle of the given length.
int signedLag(int position, int length) {
    return position <= length / 2 ? position : position - length;
}

Result<void> check(const GaussianModel& model,
                   const CovarianceObjective::Shape& shape,
                   const std::vector<double>& weights) {
    const Size support = shape.support.size();
    const Size domain = model.domain();
    if (support.width > domain.width || support.height > domain.height)
        return Error{ErrorCode::SizeMismatch,
                     "the support of " + sizeText(support) + " is larger than the exemplar of " +
                         sizeText(domain) + "; choose a smaller support"};
    if (!isInterpolationOrder(shape.interpolationOrder))
        return Error{ErrorCode::InvalidArgument, "the interpolation order must be 0, 1, 3 or 5"};
    if (shape.kernels < 1 || shape.kernels > kMaxKernels)
        return Error{ErrorCode::InvalidArgument,
                     "the number of kernels must be between 1 and " + std::to_string(kMaxKernels)};
    if (!weights.empty() && weights.size() != static_cast<std::size_t>(model.channels()))
        return Error{ErrorCode::SizeMismatch, "there must be one weight for each channel"};
    if (!std::all_of(weights.begin(), weights.end(), [](double v) {
            return v > 0.0 && std::isfinite(v);
        }))
        return Error{ErrorCode::InvalidArgument, "weights of channels must be above 0"};
    if (!varies(model))
        return Error{ErrorCode::Degenerate,
                     "the exemplar is one flat colour: there is no texture to summarise"};
    return {};
}

/// product = a conj(b), element by element.
void addTimesConjugate(const HalfSpectrum& a,
                       const HalfSpectrum& b,
                       HalfSpectrum& sum,
                       bool first) {
    for (int block = 0; block < a.blocks(); ++block) {
        const auto x = a.block(block);
        const auto y = b.block(block);
        const auto out = sum.block(block);
        for (std::size_t k = 0; k < out.size(); ++k) {
            const float re = x[k].real() * y[k].real() + x[k].imag() * y[k].imag();
            const float im = x[k].imag() * y[k].real() - x[k].real() * y[k].imag();
            out[k] = first ? Complex(re, im) : Complex(out[k].real() + re, out[k].imag() + im);
        }
    }
}

/// sum += d a, or conj(d) a.
void addTimes(
    const HalfSpectrum& d, bool conjugate, const HalfSpectrum& a, HalfSpectrum& sum, bool first) {
    const float sign = conjugate ? -1.0F : 1.0F;
    for (int block = 0; block < a.blocks(); ++block) {
        const auto x = d.block(block);
        const auto y = a.block(block);
        const auto out = sum.block(block);
        for (std::size_t k = 0; k < out.size(); ++k) {
            const float im = sign * x[k].imag();
            const float re = x[k].real() * y[k].real() - im * y[k].imag();
            const float mixed = x[k].real() * y[k].imag() + im * y[k].real();
            out[k] =
                first ? Complex(re, mixed) : Complex(out[k].real() + re, out[k].imag() + mixed);
        }
    }
}

/// Times b^ of the row and of the column.
void multiplySpline(HalfSpectrum& spectrum,
                    const std::vector<float>& columns,
                    const std::vector<float>& rows) {
    constexpr std::size_t kLanes = FftPlan::kLanes;
    for (int block = 0; block < spectrum.blocks(); ++block) {
        const auto values = spectrum.block(block);
        const float* lanes = columns.data() + static_cast<std::size_t>(block) * kLanes;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                values[row * kLanes + lane] *= rows[row] * lanes[lane];
        }
    }
}

} // namespace

Result<CovarianceObjective> CovarianceObjective::create(const GaussianModel& model,
                                                        const Shape& shape,
                                                        const std::vector<double>& weights) {
    if (const auto ok = check(model, shape, weights); !ok)
        return ok.error();
    return CovarianceObjective(model, shape, weights);
}

CovarianceObjective::CovarianceObjective(const GaussianModel& model,
                                         const Shape& shape,
                                         std::vector<double> weights)
    : m_shape(shape), m_weights(std::move(weights)), m_mean(model.mean()),
      m_transfer(model.transfer()), m_fft(gridFor(shape)) {
    if (m_weights.empty())
        m_weights.assign(m_mean.size(), 1.0);
    const Size grid = m_fft.size();
    const auto splineX = bsplineSpectrum(shape.interpolationOrder, grid.width);
    const auto splineY = bsplineSpectrum(shape.interpolationOrder, grid.height);
    m_splineX.assign(static_cast<std::size_t>(HalfSpectrum::blocksFor(grid.width)) *
                         FftPlan::kLanes,
                     0.0F);
    std::transform(splineX.begin(),
                   splineX.begin() + grid.width / 2 + 1,
                   m_splineX.begin(),
                   [](double v) { return static_cast<float>(v); });
    m_splineY.assign(splineY.begin(), splineY.end());
    computeTaper();
    computeTarget(model);
}

std::size_t CovarianceObjective::pairs() const {
    return m_mean.size() * (m_mean.size() + 1) / 2;
}

std::size_t CovarianceObjective::variables() const {
    return static_cast<std::size_t>(m_shape.kernels) * m_mean.size() * m_taper.size();
}

void CovarianceObjective::computeTaper() {
    const Size size = m_shape.support.size();
    m_taper.resize(size.area());
    const bool disc = m_shape.support.shape() == SupportShape::Disc;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double u = (x + 0.5) / size.width;
            const double v = (y + 0.5) / size.height;
            const double e = disc ? tukey(0.5 + std::hypot(u - 0.5, v - 0.5)) : tukey(u) * tukey(v);
            m_taper[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                    static_cast<std::size_t>(x)] =
                m_shape.support.contains(x, y) ? static_cast<float>(e) : 0.0F;
        }
    }
}

void CovarianceObjective::computeTarget(const GaussianModel& model) {
    const Size grid = m_fft.size();
    const Size side = m_shape.support.size();
    const Size domain = model.domain();
    m_lagWeights.assign(grid.area(), 0.0F);
    for (int y = 0; y < grid.height; ++y) {
        const double down = lagWeight(signedLag(y, grid.height), side.height);
        for (int x = 0; x < grid.width; ++x) {
            const double across = lagWeight(signedLag(x, grid.width), side.width);
            m_lagWeights[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                         static_cast<std::size_t>(x)] =
                static_cast<float>(std::sqrt(across * down));
        }
    }
    const RealFft2d fft(domain);
    std::vector<float> plane(domain.area());
    for (int i = 0; i < model.channels(); ++i) {
        for (int j = 0; j <= i; ++j) {
            HalfSpectrum product(domain);
            addTimesConjugate(model.spot(i), model.spot(j), product, true);
            fft.inverse(std::move(product), plane);
            const double factor =
                m_weights[static_cast<std::size_t>(i)] * m_weights[static_cast<std::size_t>(j)];
            std::vector<float> target(grid.area(), 0.0F);
            for (std::size_t k = 0; k < target.size(); ++k) {
                if (m_lagWeights[k] == 0.0F)
                    continue;
                const int dx = signedLag(static_cast<int>(k) % grid.width, grid.width);
                const int dy = signedLag(static_cast<int>(k) / grid.width, grid.height);
                const int x = (dx + domain.width) % domain.width;
                const int y = (dy + domain.height) % domain.height;
                const double value =
                    factor * trust(dx, domain.width) * trust(dy, domain.height) *
                    static_cast<double>(
                        plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(domain.width) +
                              static_cast<std::size_t>(x)]);
                target[k] = static_cast<float>(value);
                m_targetNorm +=
                    (i == j ? 1.0 : 2.0) * static_cast<double>(m_lagWeights[k]) * value * value;
            }
            if (i == j)
                m_targetTrace += static_cast<double>(target.front());
            m_target.push_back(std::move(target));
        }
    }
}

std::vector<HalfSpectrum> CovarianceObjective::spectra(std::span<const double> gamma) const {
    const Size size = m_shape.support.size();
    const Size grid = m_fft.size();
    const std::size_t planes = static_cast<std::size_t>(m_shape.kernels) * m_mean.size();
    std::vector<HalfSpectrum> result(planes);
    tbb::parallel_for(std::size_t{0}, planes, [&](std::size_t p) {
        std::vector<float> padded(grid.area(), 0.0F);
        for (int y = 0; y < size.height; ++y) {
            const std::size_t from =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width);
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width);
            for (std::size_t x = 0; x < static_cast<std::size_t>(size.width); ++x)
                padded[to + x] =
                    m_taper[from + x] * static_cast<float>(gamma[p * m_taper.size() + from + x]);
        }
        result[p] = m_fft.forward(padded);
    });
    return result;
}

double CovarianceObjective::evaluate(std::span<const double> gamma,
                                     std::span<double> gradient) const {
    const std::size_t channels = m_mean.size();
    const auto kernels = static_cast<std::size_t>(m_shape.kernels);
    const Size grid = m_fft.size();
    const auto a = spectra(gamma);

    // D^ of every pair of channels, and its part of J.
    std::vector<HalfSpectrum> differences(pairs());
    std::vector<double> parts(pairs());
    tbb::parallel_for(std::size_t{0}, pairs(), [&](std::size_t pair) {
        std::size_t i = 0;
        while ((i + 1) * (i + 2) / 2 <= pair)
            ++i;
        const std::size_t j = pair - i * (i + 1) / 2;
        HalfSpectrum sum(grid);
        for (std::size_t q = 0; q < kernels; ++q)
            addTimesConjugate(a[q * channels + i], a[q * channels + j], sum, q == 0);
        multiplySpline(sum, m_splineX, m_splineY);
        std::vector<float> plane(grid.area());
        m_fft.inverse(std::move(sum), plane);
        double part = 0.0;
        for (std::size_t k = 0; k < plane.size(); ++k) {
            const float difference = plane[k] - m_target[pair][k];
            const float weighted = m_lagWeights[k] * difference;
            part += static_cast<double>(weighted) * static_cast<double>(difference);
            plane[k] = weighted;
        }
        parts[pair] = (i == j ? 1.0 : 2.0) * part;
        differences[pair] = m_fft.forward(plane);
        multiplySpline(differences[pair], m_splineX, m_splineY);
    });

    const Size size = m_shape.support.size();
    const double scale = 4.0 / m_targetNorm;
    tbb::parallel_for(std::size_t{0}, a.size(), [&](std::size_t p) {
        const std::size_t q = p / channels;
        const std::size_t i = p % channels;
        HalfSpectrum sum(grid);
        for (std::size_t j = 0; j < channels; ++j) {
            const std::size_t pair = i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
            addTimes(differences[pair], i < j, a[q * channels + j], sum, j == 0);
        }
        std::vector<float> plane(grid.area());
        m_fft.inverse(std::move(sum), plane);
        for (int y = 0; y < size.height; ++y) {
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width);
            const std::size_t from =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width);
            for (std::size_t x = 0; x < static_cast<std::size_t>(size.width); ++x)
                gradient[p * m_taper.size() + to + x] = scale *
                                                        static_cast<double>(m_taper[to + x]) *
                                                        static_cast<double>(plane[from + x]);
        }
    });
    const double borderScale = kBorderCost / m_targetTrace;
    double border = 0.0;
    for (std::size_t k = 0; k < gamma.size(); ++k) {
        const double cost = borderScale * (1.0 - static_cast<double>(m_taper[k % m_taper.size()]));
        border += cost * gamma[k] * gamma[k];
        gradient[k] += 2.0 * cost * gamma[k];
    }
    return std::accumulate(parts.begin(), parts.end(), 0.0) / m_targetNorm + border;
}

std::vector<double> CovarianceObjective::start(Seed seed) const {
    const Image noise =
        whiteNoise(m_shape.support.size(), m_shape.kernels * static_cast<int>(m_mean.size()), seed);
    std::vector<double> gamma(noise.samples().begin(), noise.samples().end());
    // What the noise has, b included, against what the exemplar has.
    Texton raw = texton(gamma);
    const auto covariance = noiseCovariance(raw);
    double trace = 0.0;
    for (std::size_t c = 0; c < m_mean.size(); ++c)
        trace += covariance[c * m_mean.size() + c] * m_weights[c] * m_weights[c];
    const double scale = std::sqrt(m_targetTrace / trace);
    for (double& v : gamma)
        v *= scale;
    return gamma;
}

bool CovarianceObjective::fits(const Texton& texton) const {
    return texton.support == m_shape.support && texton.kernelCount() == m_shape.kernels &&
           texton.interpolationOrder == m_shape.interpolationOrder &&
           texton.mean.size() == m_mean.size();
}

std::vector<double> CovarianceObjective::variablesOf(const Texton& texton) const {
    assert(fits(texton));
    std::vector<double> gamma;
    gamma.reserve(variables());
    for (const Image& kernel : texton.kernels) {
        for (std::size_t c = 0; c < m_mean.size(); ++c) {
            const auto plane = kernel.plane(static_cast<int>(c));
            for (std::size_t k = 0; k < plane.size(); ++k)
                gamma.push_back(m_taper[k] > 0.0F
                                    ? m_weights[c] * static_cast<double>(plane[k] / m_taper[k])
                                    : 0.0);
        }
    }
    return gamma;
}

Texton CovarianceObjective::texton(std::span<const double> gamma) const {
    Texton result;
    result.support = m_shape.support;
    result.interpolationOrder = m_shape.interpolationOrder;
    result.mean = m_mean;
    result.transfer = m_transfer;
    const std::size_t area = m_taper.size();
    for (std::size_t q = 0; q < static_cast<std::size_t>(m_shape.kernels); ++q) {
        Image kernel(m_shape.support.size(), static_cast<int>(m_mean.size()), 0.0F, m_transfer);
        for (std::size_t c = 0; c < m_mean.size(); ++c) {
            const auto plane = kernel.plane(static_cast<int>(c));
            const auto values = gamma.subspan((q * m_mean.size() + c) * area, area);
            for (std::size_t k = 0; k < area; ++k)
                plane[k] =
                    static_cast<float>(static_cast<double>(m_taper[k]) * values[k] / m_weights[c]);
        }
        result.kernels.push_back(std::move(kernel));
    }
    return result;
}

} // namespace txn
