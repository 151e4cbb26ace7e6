// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/TextureAnalysis.h"

#include "core/spectral/Fft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace txn {
namespace {

constexpr int kMostSquaresAlong = 8;
constexpr double kHistogramFrom = -0.25;
constexpr double kHistogramTo = 1.25;

/// Hann, as a periodic window.
std::vector<float> window(int length) {
    std::vector<float> weights(static_cast<std::size_t>(length));
    for (int i = 0; i < length; ++i)
        weights[static_cast<std::size_t>(i)] =
            static_cast<float>(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / length));
    return weights;
}

/// Left ends of squares that overlap by half and reach from end to end, up to kMostSquaresAlong.
std::vector<int> starts(int length, int side) {
    if (length <= side)
        return {0};
    const int count = std::min(kMostSquaresAlong, (2 * (length - side) + side - 1) / side + 1);
    std::vector<int> result;
    result.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        result.push_back(count == 1 ? 0 : (length - side) * i / (count - 1));
    return result;
}

/// Adds |DFT|^2 of the windowed square to power.
void addSquare(const Image& image,
               int channel,
               float mean,
               int left,
               int top,
               const std::vector<float>& weights,
               const RealFft2d& fft,
               HalfSpectrum& power) {
    const int side = fft.size().width;
    std::vector<float> square(fft.size().area());
    for (int y = 0; y < side; ++y) {
        const auto row = image.row(channel, (top + y) % image.height());
        const float vertical = weights[static_cast<std::size_t>(y)];
        float* out = square.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(side);
        for (int x = 0; x < side; ++x)
            out[x] = (row[static_cast<std::size_t>((left + x) % image.width())] - mean) * vertical *
                     weights[static_cast<std::size_t>(x)];
    }
    const HalfSpectrum spectrum = fft.forward(square);
    for (int b = 0; b < power.blocks(); ++b) {
        const auto from = spectrum.block(b);
        const auto to = power.block(b);
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += std::norm(from[i]);
    }
}

HalfSpectrum zeros(Size size) {
    HalfSpectrum spectrum(size);
    for (int b = 0; b < spectrum.blocks(); ++b)
        std::ranges::fill(spectrum.block(b), Complex{});
    return spectrum;
}

double peakOf(const HalfSpectrum& power) {
    double peak = 0.0;
    for (int row = 0; row < power.imageSize().height; ++row) {
        for (int column = 0; column < power.columns(); ++column)
            peak = std::max(peak, static_cast<double>(power.at(row, column).real()));
    }
    return peak;
}

Image logPicture(const HalfSpectrum& power) {
    const int side = power.imageSize().width;
    const double peak = peakOf(power);
    Image picture({side, side}, 1);
    if (!(peak > 0.0))
        return picture;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            int column = (x + side / 2) % side;
            int row = (y + side / 2) % side;
            if (column > side / 2) { // the other half mirrors the one that is stored
                column = side - column;
                row = (side - row) % side;
            }
            const double share = static_cast<double>(power.at(row, column).real()) / peak;
            const double decibels = share > 0.0 ? 10.0 * std::log10(share) : -1e9;
            picture.at(x, y, 0) =
                static_cast<float>(std::max(0.0, 1.0 + decibels / TextureAnalysis::kDecibels));
        }
    }
    return picture;
}

/// The inverse DFT of the power over that of the window alone: each lag by the products that there
/// were.
Image correlationPicture(HalfSpectrum power,
                         const std::vector<float>& weights,
                         const RealFft2d& fft) {
    const int side = fft.size().width;
    std::vector<float> square(fft.size().area());
    for (std::size_t i = 0; i < square.size(); ++i)
        square[i] = weights[i / static_cast<std::size_t>(side)] *
                    weights[i % static_cast<std::size_t>(side)];
    HalfSpectrum windowPower = fft.forward(square);
    for (int b = 0; b < windowPower.blocks(); ++b) {
        for (Complex& v : windowPower.block(b))
            v = std::norm(v);
    }
    std::vector<float> windowed(square.size());
    fft.inverse(std::move(power), square);
    fft.inverse(std::move(windowPower), windowed);
    const int half = side / 2;
    Image picture({half, half}, 1);
    const double variance = static_cast<double>(square[0]) / windowed[0];
    if (!(variance > 0.0))
        return picture;
    for (int y = 0; y < half; ++y) {
        for (int x = 0; x < half; ++x) {
            const auto i = static_cast<std::size_t>((y - half / 2 + side) % side) *
                               static_cast<std::size_t>(side) +
                           static_cast<std::size_t>((x - half / 2 + side) % side);
            picture.at(x, y, 0) = static_cast<float>(square[i] / windowed[i] / variance);
        }
    }
    return picture;
}

std::vector<double> histogram(std::span<const float> samples) {
    std::vector<double> bins(TextureAnalysis::kBins);
    const double scale = TextureAnalysis::kBins / (kHistogramTo - kHistogramFrom);
    for (const float v : samples) {
        const double place = (static_cast<double>(v) - kHistogramFrom) * scale;
        if (place >= 0.0 && place < TextureAnalysis::kBins)
            bins[static_cast<std::size_t>(place)] += 1.0;
    }
    for (double& bin : bins)
        bin /= static_cast<double>(samples.size());
    return bins;
}

} // namespace

TextureAnalysis analyseTexture(const Image& image, int sidePx) {
    const RealFft2d fft({sidePx, sidePx});
    const auto weights = window(sidePx);
    HalfSpectrum power = zeros(fft.size());
    TextureAnalysis analysis;
    analysis.histogramFrom = kHistogramFrom;
    analysis.histogramTo = kHistogramTo;
    for (int c = 0; c < image.channels(); ++c) {
        const auto plane = image.plane(c);
        const double mean =
            std::accumulate(plane.begin(), plane.end(), 0.0) / static_cast<double>(plane.size());
        for (const int top : starts(image.height(), sidePx)) {
            for (const int left : starts(image.width(), sidePx))
                addSquare(image, c, static_cast<float>(mean), left, top, weights, fft, power);
        }
        analysis.histograms.push_back(histogram(plane));
    }
    const auto squares =
        starts(image.height(), sidePx).size() * starts(image.width(), sidePx).size();
    analysis.peakPower =
        peakOf(power) / (static_cast<double>(squares) * static_cast<double>(image.channels()));
    analysis.logPower = logPicture(power);
    analysis.autocorrelation = correlationPicture(std::move(power), weights, fft);
    return analysis;
}

} // namespace txn
