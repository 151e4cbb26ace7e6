// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/RadialSpectrum.h"

#include "core/spectral/BSpline.h"
#include "core/spectral/Fft.h"

#include <algorithm>
#include <cmath>

namespace txn {
namespace {

/// Averages values over rings; at(row, column) is the power at a frequency of the half spectrum.
template <class Power>
RadialSpectrum ringMeans(Size size, Power at) {
    RadialSpectrum result;
    std::array<double, RadialSpectrum::kRings> counts{};
    for (int row = 0; row < size.height; ++row) {
        const double fy = static_cast<double>(std::min(row, size.height - row)) / size.height;
        for (int column = 0; column <= size.width / 2; ++column) {
            const double fx = static_cast<double>(column) / size.width;
            const auto ring =
                static_cast<std::size_t>(std::hypot(fx, fy) * 2 * RadialSpectrum::kRings);
            if (ring >= RadialSpectrum::kRings || (row == 0 && column == 0))
                continue;
            const double count = column == 0 || 2 * column == size.width ? 1.0 : 2.0;
            counts[ring] += count;
            result.power[ring] += count * at(row, column);
        }
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0.0)
            result.power[i] /= counts[i];
    }
    return result;
}

} // namespace

RadialSpectrum radialSpectrum(const GaussianModel& model) {
    return ringMeans(model.domain(), [&](int row, int column) {
        double sum = 0.0;
        for (int c = 0; c < model.channels(); ++c)
            sum += std::norm(std::complex<double>(model.spot(c).at(row, column)));
        return sum;
    });
}

RadialSpectrum radialSpectrum(const Texton& texton) {
    const Size support = texton.support.size();
    // Fine enough to see all that the kernel's spectrum does.
    const Size size{2 * std::max(support.width, RadialSpectrum::kRings),
                    2 * std::max(support.height, RadialSpectrum::kRings)};
    const RealFft2d fft(size);
    const auto bx = bsplineSpectrum(texton.interpolationOrder, size.width);
    const auto by = bsplineSpectrum(texton.interpolationOrder, size.height);
    std::vector<HalfSpectrum> spectra;
    Image padded(size, 1);
    for (const Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c) {
            for (int y = 0; y < kernel.height(); ++y)
                std::copy(kernel.row(c, y).begin(),
                          kernel.row(c, y).end(),
                          padded.row(0, y).begin());
            spectra.push_back(fft.forward(padded.plane(0)));
        }
    }
    return ringMeans(size, [&](int row, int column) {
        double sum = 0.0;
        for (const HalfSpectrum& spectrum : spectra)
            sum += std::norm(std::complex<double>(spectrum.at(row, column)));
        return sum * bx[static_cast<std::size_t>(column)] * by[static_cast<std::size_t>(row)];
    });
}

double differenceInDecibels(const RadialSpectrum& a, const RadialSpectrum& b) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < a.power.size(); ++i) {
        if (!(a.power[i] > 0.0 && b.power[i] > 0.0))
            continue;
        const double decibels = 10.0 * std::log10(a.power[i] / b.power[i]);
        sum += decibels * decibels;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
}

} // namespace txn
