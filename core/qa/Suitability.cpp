// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/Suitability.h"

#include "core/gaussian/GaussianSampler.h"
#include "core/image/ImageGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace txn {
namespace {

constexpr int kMaxSidePx = 512;
constexpr int kBands = 5;
constexpr int kGaussianVersions = 6;
/// Six samples tell a standard deviation badly: none counts as smaller than this.
constexpr double kSmallestSpread = 0.04;

struct Moments {
    double mean = 0.0;
    double deviation = 0.0;
    double skewness = 0.0;
    double excessKurtosis = 0.0;
};

Moments moments(std::span<const float> samples) {
    Moments m;
    const auto n = static_cast<double>(samples.size());
    m.mean = std::accumulate(samples.begin(), samples.end(), 0.0) / n;
    double second = 0.0;
    double third = 0.0;
    double fourth = 0.0;
    for (const float v : samples) {
        const double d = static_cast<double>(v) - m.mean;
        second += d * d;
        third += d * d * d;
        fourth += d * d * d * d;
    }
    second /= n;
    if (!(second > 0.0))
        return m;
    m.deviation = std::sqrt(second);
    m.skewness = third / n / (second * m.deviation);
    m.excessKurtosis = fourth / n / (second * second) - 3.0;
    return m;
}

/// Share of a normal law outside [0, 1].
double shareOutside(const Moments& m) {
    if (!(m.deviation > 0.0))
        return 0.0;
    const auto below = [&](double x) {
        return 0.5 * std::erfc((m.mean - x) / (m.deviation * std::numbers::sqrt2));
    };
    return below(0.0) + 1.0 - below(1.0);
}

/// Mean over (2 r + 1)^2 pixels, border pixels repeated, by running sums.
std::vector<float> boxMean(const std::vector<float>& plane, Size size, int radius) {
    const auto pass = [&](const std::vector<float>& in, int count, int lines, int step, int jump) {
        std::vector<float> out(in.size());
        const double share = 1.0 / (2 * radius + 1);
        for (int line = 0; line < lines; ++line) {
            const auto at = [&](int i) {
                return static_cast<std::size_t>(line * jump + std::clamp(i, 0, count - 1) * step);
            };
            double sum = 0.0;
            for (int i = -radius; i <= radius; ++i)
                sum += static_cast<double>(in[at(i)]);
            for (int i = 0; i < count; ++i) {
                out[at(i)] = static_cast<float>(sum * share);
                sum += static_cast<double>(in[at(i + radius + 1)]) -
                       static_cast<double>(in[at(i - radius)]);
            }
        }
        return out;
    };
    return pass(pass(plane, size.width, size.height, 1, size.width),
                size.height,
                size.width,
                size.width,
                1);
}

/// Kurtosis and unevenness of the energy, band by band: what shapes change and Gaussian textures
/// hold constant.
using BandStatistics = std::array<double, 2 * kBands>;

BandStatistics bandStatistics(const Image& image) {
    std::vector<float> gray(image.size().area());
    for (int c = 0; c < image.channels(); ++c) {
        const auto plane = image.plane(c);
        for (std::size_t i = 0; i < gray.size(); ++i)
            gray[i] += plane[i];
    }
    BandStatistics result{};
    std::vector<float> smooth = gray;
    for (int band = 0; band < kBands; ++band) {
        const int radius = 1 << band;
        std::vector<float> smoother = boxMean(smooth, image.size(), radius);
        std::vector<float> energy(gray.size());
        for (std::size_t i = 0; i < gray.size(); ++i)
            smooth[i] -= smoother[i];
        for (std::size_t i = 0; i < gray.size(); ++i)
            energy[i] = smooth[i] * smooth[i];
        const Moments band1 = moments(smooth);
        const Moments local = moments(boxMean(energy, image.size(), 4 * radius));
        const auto k = static_cast<std::size_t>(band);
        // Logarithms: both are ratios.
        result[2 * k] = std::log(std::max(0.1, band1.excessKurtosis + 3.0));
        result[2 * k + 1] = local.mean > 0.0 ? std::log(0.05 + local.deviation / local.mean) : 0.0;
        smooth = std::move(smoother);
    }
    return result;
}

Verdict judge(const Suitability& s) {
    constexpr double kShapes = 14.0;
    constexpr double kClipped = 0.02;
    constexpr double kSkewed = 1.0;
    constexpr double kPeaked = 2.5;
    if (s.subbandDeviation > kShapes)
        return Verdict::HasShapes;
    if (s.clippedShare > kClipped)
        return Verdict::ColoursClip;
    if (std::abs(s.skewness) > kSkewed || s.excessKurtosis > kPeaked)
        return Verdict::ColoursDiffer;
    return Verdict::Suits;
}

} // namespace

Result<Suitability>
assessSuitability(const Exemplar& exemplar, const GaussianModel& model, const CancelToken& cancel) {
    const Error cancelled{ErrorCode::Cancelled, "cancelled"};
    if (!(model.covariance().trace() > 0.0))
        return Error{ErrorCode::Degenerate,
                     "the exemplar is one flat colour: there is no texture to judge"};
    Suitability result;
    for (int c = 0; c < exemplar.image.channels(); ++c) {
        const Moments m = moments(exemplar.image.plane(c));
        if (std::abs(m.skewness) > std::abs(result.skewness))
            result.skewness = m.skewness;
        if (std::abs(m.excessKurtosis) > std::abs(result.excessKurtosis))
            result.excessKurtosis = m.excessKurtosis;
        result.clippedShare += shareOutside(m) / exemplar.image.channels();
    }
    if (cancel.cancelled())
        return cancelled;

    // The middle is enough, and takes the same time for every picture.
    const Size full = exemplar.image.size();
    const Size size{std::min(full.width, kMaxSidePx), std::min(full.height, kMaxSidePx)};
    auto middle = crop(exemplar.image,
                       {(full.width - size.width) / 2, (full.height - size.height) / 2, size});
    if (!middle)
        return middle.error();
    auto part = makeExemplar(std::move(*middle), exemplar.name);
    if (!part)
        return part.error();
    const GaussianModel partModel(*part);
    const BandStatistics own = bandStatistics(part->image);
    BandStatistics sum{};
    BandStatistics squares{};
    for (int i = 0; i < kGaussianVersions; ++i) {
        if (cancel.cancelled())
            return cancelled;
        const Image version = sampleGaussian(partModel,
                                             GaussianMethod::Adsn,
                                             Seed{static_cast<std::uint32_t>(i + 1)});
        const BandStatistics statistics = bandStatistics(version);
        for (std::size_t k = 0; k < statistics.size(); ++k) {
            sum[k] += statistics[k];
            squares[k] += statistics[k] * statistics[k];
        }
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
        const double mean = sum[k] / kGaussianVersions;
        const double variance = std::max(0.0, squares[k] / kGaussianVersions - mean * mean) *
                                kGaussianVersions / (kGaussianVersions - 1.0);
        const double spread = std::max(std::sqrt(variance), kSmallestSpread);
        result.subbandDeviation =
            std::max(result.subbandDeviation, std::abs(own[k] - mean) / spread);
    }
    result.verdict = judge(result);
    return result;
}

} // namespace txn
