// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/RandomFields.h"

#include "core/gaussian/WhiteNoise.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <tbb/parallel_for.h>
#include <utility>

namespace txn {
namespace {

constexpr double square(double v) {
    return v * v;
}

/// The power spectrum of a Gaussian correlation of standard deviation radiusPx, times a constant.
double gaussianPower(double frequency, double radiusPx) {
    return std::exp(-2.0 * square(std::numbers::pi * radiusPx * frequency));
}

} // namespace

RandomFields::RandomFields(Size size, Seed seed) : m_fft(size), m_seed(seed) {}

Field RandomFields::draw(const SpectralDensity& density) {
    const Size size = m_fft.size();
    const Seed seed{hash4(m_seed.value, m_drawn++, 0, 0)[0]};
    HalfSpectrum spectrum = m_fft.forward(whiteNoise(size, 1, seed).plane(0));

    // One sum a block, added up in order: the same for any number of threads.
    std::vector<double> power(static_cast<std::size_t>(spectrum.blocks()), 0.0);
    tbb::parallel_for(0, spectrum.blocks(), [&](int b) {
        for (int row = 0; row < size.height; ++row) {
            const int wrapped = 2 * row > size.height ? row - size.height : row;
            for (int lane = 0; lane < FftPlan::kLanes; ++lane) {
                const int column = b * FftPlan::kLanes + lane;
                const bool counts = spectrum.multiplicity(column) > 0 && (row > 0 || column > 0);
                const double value = counts ? density({static_cast<double>(column) / size.width,
                                                       static_cast<double>(wrapped) / size.height})
                                            : 0.0;
                power[static_cast<std::size_t>(b)] += spectrum.multiplicity(column) * value;
                spectrum.at(row, column) *= static_cast<float>(std::sqrt(value));
            }
        }
    });
    const double total = std::accumulate(power.begin(), power.end(), 0.0);

    Field field(size.area());
    // Features far broader than the image are constant over it, and the mean does not count.
    constexpr double kLeastPower = 1e-12;
    if (total < kLeastPower)
        return field;
    m_fft.inverse(std::move(spectrum), field);
    const auto scale = static_cast<float>(std::sqrt(static_cast<double>(size.area()) / total));
    for (float& v : field)
        v *= scale;
    return field;
}

SpectralDensity blobs(double radiusPx) {
    return streaks(radiusPx, radiusPx);
}

SpectralDensity streaks(double radiusXPx, double radiusYPx) {
    return [=](const Frequency& f) {
        return gaussianPower(f.x, radiusXPx) * gaussianPower(f.y, radiusYPx);
    };
}

SpectralDensity fractal(double hurst, double outerPx, double innerPx) {
    const double lowest = square(1.0 / outerPx);
    return [=](const Frequency& f) {
        return std::pow(f.squared() + lowest, -hurst - 1.0) *
               gaussianPower(std::sqrt(f.squared()), innerPx);
    };
}

SpectralDensity grains(double periodPx, double octaves) {
    return [=](const Frequency& f) {
        const double distance = 0.5 * std::log2(f.squared() * square(periodPx)) / octaves;
        return std::exp(-0.5 * square(distance));
    };
}

SpectralDensity lit(SpectralDensity height) {
    return [height = std::move(height)](const Frequency& f) {
        return square(0.6 * f.x + 0.8 * f.y) * height(f);
    };
}

SpectralDensity grainLines(const GrainLines& lines) {
    const double lowest = square(1.0 / lines.outerPx);
    const double narrowest = square(0.5 * std::numbers::inv_pi / lines.lengthPx);
    const double slope = square(std::tan(lines.spread));
    return [=](const Frequency& f) {
        // arg f is f.y / f.x for small angles; near frequency 0 the cone would be thinner than one
        // DFT bin and the lines endless, so there it keeps the width of the longest lines.
        const double direction = square(f.y) / (square(f.x) * slope + narrowest);
        return std::exp(-0.5 * direction) * std::pow(f.squared() + lowest, -lines.hurst - 1.0) *
               gaussianPower(f.x, lines.innerPx);
    };
}

Field shiftedAcross(const Field& field, Size size, const Field& distancePx) {
    Field shifted(field.size());
    const auto width = static_cast<std::size_t>(size.width);
    tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(size.height), [&](std::size_t y) {
        const float* row = field.data() + y * width;
        for (std::size_t x = 0; x < width; ++x) {
            const float place = static_cast<float>(x) + distancePx[y * width + x];
            const float whole = std::floor(place);
            const float t = place - whole;
            // Catmull-Rom: keeps fine lines as sharp between pixels as on them, nearly.
            const float weights[4] = {t * (-0.5F + t * (1.0F - 0.5F * t)),
                                      1.0F + t * t * (-2.5F + 1.5F * t),
                                      t * (0.5F + t * (2.0F - 1.5F * t)),
                                      t * t * (-0.5F + 0.5F * t)};
            float sum = 0.0F;
            for (int k = 0; k < 4; ++k) {
                int column = (static_cast<int>(whole) + k - 1) % size.width;
                column += column < 0 ? size.width : 0;
                sum += weights[k] * row[column];
            }
            shifted[y * width + x] = sum;
        }
    });
    return shifted;
}

} // namespace txn
