// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/PeriodicComponent.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tbb/parallel_for.h>
#include <vector>

namespace txn {
namespace {

using DoubleComplex = std::complex<double>;

/// Full DFT of real values, in double from a single precision transform of centred data.
std::vector<DoubleComplex> realDft(const std::vector<float>& values) {
    const int length = static_cast<int>(values.size());
    AlignedBuffer<float> in(values.size());
    AlignedBuffer<Complex> out(values.size() / 2 + 1);
    std::copy(values.begin(), values.end(), in.data());
    FftPlan::realForward(length).run(in.data(), out.data());
    std::vector<DoubleComplex> result(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
        result[k] = 2 * k <= values.size() ? DoubleComplex(out[k])
                                           : std::conj(DoubleComplex(out[values.size() - k]));
    return result;
}

struct Wave {
    double cosine;
    DoubleComplex
        jump; ///< 1 - exp(2 pi i k / n): a value at the first sample, its negative at the last
};

std::vector<Wave> waves(int length) {
    std::vector<Wave> result(static_cast<std::size_t>(length));
    for (int k = 0; k < length; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / length;
        result[static_cast<std::size_t>(k)] = {std::cos(angle),
                                               1.0 -
                                                   DoubleComplex(std::cos(angle), std::sin(angle))};
    }
    return result;
}

} // namespace

void removeSmoothComponent(HalfSpectrum& spectrum, std::span<const float> plane) {
    const int height = spectrum.imageSize().height;
    const int width = spectrum.imageSize().width;
    const auto value = [&](int x, int y) {
        return plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    };
    // The jumps across the borders live on one row and one column: two short transforms suffice.
    std::vector<float> rowJump(static_cast<std::size_t>(width));
    std::vector<float> columnJump(static_cast<std::size_t>(height));
    for (int x = 0; x < width; ++x)
        rowJump[static_cast<std::size_t>(x)] = value(x, height - 1) - value(x, 0);
    for (int y = 0; y < height; ++y)
        columnJump[static_cast<std::size_t>(y)] = value(width - 1, y) - value(0, y);
    const auto rowDft = realDft(rowJump);
    const auto columnDft = realDft(columnJump);
    const auto vertical = waves(height);
    const auto horizontal = waves(width);

    tbb::parallel_for(0, spectrum.columns(), [&](int column) {
        const auto c = static_cast<std::size_t>(column);
        for (int row = 0; row < height; ++row) {
            if (row == 0 && column == 0)
                continue; // mean(p) = mean(u)
            const auto r = static_cast<std::size_t>(row);
            const DoubleComplex boundary =
                rowDft[c] * vertical[r].jump + columnDft[r] * horizontal[c].jump;
            const double laplacian = 2.0 * vertical[r].cosine + 2.0 * horizontal[c].cosine - 4.0;
            spectrum.at(row, column) -= Complex(boundary / laplacian);
        }
    });
}

Image periodicComponent(const Image& image) {
    Image result(image.size(), image.channels(), 0.0F, image.transfer());
    const RealFft2d fft(image.size());
    for (int c = 0; c < image.channels(); ++c) {
        const auto plane = image.plane(c);
        double sum = 0.0;
        for (const float v : plane)
            sum += v;
        const auto mean = static_cast<float>(sum / static_cast<double>(plane.size()));
        HalfSpectrum spectrum = fft.forward(plane, -mean); // centred: keeps single precision sharp
        removeSmoothComponent(spectrum, plane);
        fft.inverse(std::move(spectrum), result.plane(c));
        for (float& v : result.plane(c))
            v += mean;
    }
    return result;
}

double seamRatio(const Image& image) {
    double border = 0.0;
    double interior = 0.0;
    const int w = image.width();
    const int h = image.height();
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < h; ++y) {
            const auto row = image.row(c, y);
            const auto next = image.row(c, (y + 1) % h);
            double& vertical = y + 1 == h ? border : interior;
            for (std::size_t x = 0; x < row.size(); ++x) {
                const double down = static_cast<double>(next[x]) - row[x];
                vertical += down * down;
                const double right = static_cast<double>(row[(x + 1) % row.size()]) - row[x];
                (x + 1 == row.size() ? border : interior) += right * right;
            }
        }
    }
    const double borderPairs = static_cast<double>(w) + h;
    const double interiorPairs = 2.0 * w * h - borderPairs;
    if (interior <= 0.0 || interiorPairs <= 0.0)
        return 1.0;
    return std::sqrt((border / borderPairs) / (interior / interiorPairs));
}

} // namespace txn
