// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianSampler.h"

#include "core/gaussian/WhiteNoise.h"
#include "core/image/ImageGeometry.h"
#include "core/spectral/PeriodicComponent.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

/// Width of the faded border, as a share of the side, at each end.
constexpr double kRamp = 0.1;

/// Smooth weights: 0 outside, 1 inside, half a cosine in between.
std::vector<float> rampWeights(int length) {
    std::vector<float> weights(static_cast<std::size_t>(length), 1.0F);
    const double ramp = kRamp * length;
    for (int i = 0; i < length; ++i) {
        const double distance = std::min(i, length - 1 - i) + 0.5;
        if (distance < ramp)
            weights[static_cast<std::size_t>(i)] =
                static_cast<float>(0.5 - 0.5 * std::cos(std::numbers::pi * distance / ramp));
    }
    return weights;
}

} // namespace

Image sampleGaussian(const GaussianModel& model, GaussianMethod method, Seed seed) {
    const Size domain = model.domain();
    const RealFft2d fft(domain);
    HalfSpectrum noise = [&] {
        const Image white = whiteNoise(domain, 1, seed);
        return fft.forward(white.plane(0));
    }();
    if (method == GaussianMethod::RandomPhase) {
        // t_u carries 1 / sqrt(H W): the modulus of a unit white noise's DFT, on average.
        const auto modulus = static_cast<float>(std::sqrt(static_cast<double>(domain.area())));
        tbb::parallel_for(0, noise.blocks(), [&](int b) {
            for (Complex& v : noise.block(b)) {
                const float size = std::abs(v);
                v = size > 0.0F ? v * (modulus / size) : Complex(modulus);
            }
        });
    }
    Image result(domain, model.channels(), 0.0F, model.transfer());
    for (int c = 0; c < model.channels(); ++c) {
        HalfSpectrum product(domain);
        tbb::parallel_for(0, noise.blocks(), [&](int b) {
            const auto spot = model.spot(c).block(b);
            const auto phase = noise.block(b);
            const auto out = product.block(b);
            for (std::size_t k = 0; k < out.size(); ++k)
                out[k] = spot[k] * phase[k];
        });
        const auto plane = result.plane(c);
        fft.inverse(std::move(product), plane);
        const auto mean = static_cast<float>(model.mean()[static_cast<std::size_t>(c)]);
        for (float& v : plane)
            v += mean;
    }
    return result;
}

Result<GaussianModel> enlarged(const Exemplar& exemplar, Size size, bool periodic) {
    constexpr std::size_t kMaxSamples = std::size_t{1} << 28U;
    const Size domain = exemplar.image.size();
    if (size.width < domain.width || size.height < domain.height)
        return Error{ErrorCode::InvalidArgument,
                     "the enlarged size may not be smaller than the exemplar"};
    if (size.area() * static_cast<std::size_t>(exemplar.image.channels()) > kMaxSamples)
        return Error{ErrorCode::TooLarge,
                     "a Gaussian version of " + std::to_string(size.width) + " x " +
                         std::to_string(size.height) +
                         " is too large; make texton noise for sizes without limit"};
    const Image source = periodic ? periodicComponent(exemplar.image) : exemplar.image;
    const auto horizontal = rampWeights(domain.width);
    const auto vertical = rampWeights(domain.height);
    double energy = 0.0; // sum of the squared weights: what the ramp leaves of the variance
    for (const float v : vertical)
        for (const float h : horizontal)
            energy += static_cast<double>(v) * v * h * h;
    const double scale = 1.0 / std::sqrt(energy);

    Image spot(size, source.channels(), 0.0F, source.transfer());
    const int left = (size.width - domain.width) / 2;
    const int top = (size.height - domain.height) / 2;
    std::vector<double> means;
    for (int c = 0; c < source.channels(); ++c) {
        const auto plane = source.plane(c);
        const double mean =
            std::accumulate(plane.begin(), plane.end(), 0.0) / static_cast<double>(plane.size());
        means.push_back(mean);
        for (int y = 0; y < domain.height; ++y) {
            const auto from = source.row(c, y);
            const auto to = spot.row(c, top + y).subspan(static_cast<std::size_t>(left));
            const double weight = scale * vertical[static_cast<std::size_t>(y)];
            for (std::size_t x = 0; x < from.size(); ++x)
                to[x] = static_cast<float>(weight * horizontal[x] * (from[x] - mean));
        }
    }
    return GaussianModel(spot, std::move(means));
}

Result<Image> gaussianVersion(
    const Exemplar& exemplar, Size size, GaussianMethod method, Seed seed, bool periodic) {
    if (size.width < 1 || size.height < 1)
        return Error{ErrorCode::InvalidArgument, "width and height must be at least 1"};
    const Size domain = exemplar.image.size();
    const Size working{std::max(size.width, domain.width), std::max(size.height, domain.height)};
    if (working == domain) {
        return crop(sampleGaussian(GaussianModel(exemplar, periodic), method, seed), {0, 0, size});
    }
    const auto model = enlarged(exemplar, working, periodic);
    if (!model)
        return model.error();
    return crop(sampleGaussian(*model, method, seed), {0, 0, size});
}

} // namespace txn
