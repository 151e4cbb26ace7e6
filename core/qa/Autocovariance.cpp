// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/Autocovariance.h"

#include "core/spectral/BSpline.h"
#include "core/spectral/Fft.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace txn {
namespace {

/// Sums over n of u_i(n + lag) u_j(n) for images that are zero outside, by FFT.
class Correlator {
  public:
    Correlator(Size size, int maxLag)
        : m_size{fastLength(size.width + maxLag), fastLength(size.height + maxLag)}, m_fft(m_size) {
    }

    void addChannel(std::span<const float> plane, Size size, float offset) {
        std::vector<float> padded(m_size.area(), 0.0F);
        for (int y = 0; y < size.height; ++y) {
            const auto row =
                plane.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width),
                              static_cast<std::size_t>(size.width));
            std::transform(row.begin(),
                           row.end(),
                           padded.begin() + static_cast<std::ptrdiff_t>(y) * m_size.width,
                           [offset](float v) { return v + offset; });
        }
        m_spectra.push_back(m_fft.forward(padded));
    }

    /// visit(i, j, dx, dy, sum) for all lags and all pairs of channels with j <= i.
    template <class Visit>
    void correlate(int maxLag, Visit visit) const {
        std::vector<float> plane(m_size.area());
        const int channels = static_cast<int>(m_spectra.size());
        for (int i = 0; i < channels; ++i) {
            for (int j = 0; j <= i; ++j) {
                HalfSpectrum product(m_size);
                for (int b = 0; b < product.blocks(); ++b) {
                    const auto left = m_spectra[static_cast<std::size_t>(i)].block(b);
                    const auto right = m_spectra[static_cast<std::size_t>(j)].block(b);
                    std::transform(left.begin(),
                                   left.end(),
                                   right.begin(),
                                   product.block(b).begin(),
                                   [](Complex x, Complex y) { return x * std::conj(y); });
                }
                m_fft.inverse(std::move(product), plane);
                for (int dy = -maxLag; dy <= maxLag; ++dy) {
                    for (int dx = -maxLag; dx <= maxLag; ++dx) {
                        const int x = dx < 0 ? dx + m_size.width : dx;
                        const int y = dy < 0 ? dy + m_size.height : dy;
                        visit(i,
                              j,
                              dx,
                              dy,
                              static_cast<double>(plane[static_cast<std::size_t>(y) *
                                                            static_cast<std::size_t>(m_size.width) +
                                                        static_cast<std::size_t>(x)]));
                    }
                }
            }
        }
    }

  private:
    Size m_size;
    RealFft2d m_fft;
    std::vector<HalfSpectrum> m_spectra;
};

} // namespace

Autocovariance::Autocovariance(int channels, int maxLag) : m_channels(channels), m_maxLag(maxLag) {
    const auto side = static_cast<std::size_t>(2 * maxLag + 1);
    m_values.resize(static_cast<std::size_t>(channels) * static_cast<std::size_t>(channels) * side *
                    side);
}

std::size_t Autocovariance::index(int i, int j, int dx, int dy) const {
    assert(std::abs(dx) <= m_maxLag && std::abs(dy) <= m_maxLag);
    const auto side = static_cast<std::size_t>(2 * m_maxLag + 1);
    const auto pair = static_cast<std::size_t>(i * m_channels + j);
    return (pair * side + static_cast<std::size_t>(dy + m_maxLag)) * side +
           static_cast<std::size_t>(dx + m_maxLag);
}

Autocovariance Autocovariance::weighted(const std::vector<double>& weights) const {
    assert(weights.size() == static_cast<std::size_t>(m_channels));
    Autocovariance result = *this;
    for (int i = 0; i < m_channels; ++i) {
        for (int j = 0; j < m_channels; ++j) {
            const double factor =
                weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)];
            const auto begin = result.m_values.begin() +
                               static_cast<std::ptrdiff_t>(index(i, j, -m_maxLag, -m_maxLag));
            const auto end = result.m_values.begin() +
                             static_cast<std::ptrdiff_t>(index(i, j, m_maxLag, m_maxLag)) + 1;
            std::for_each(begin, end, [factor](double& v) { v *= factor; });
        }
    }
    return result;
}

double Autocovariance::norm(int lag) const {
    assert(lag <= m_maxLag);
    double sum = 0.0;
    for (int i = 0; i < m_channels; ++i) {
        for (int j = 0; j < m_channels; ++j) {
            for (int dy = -lag; dy <= lag; ++dy) {
                for (int dx = -lag; dx <= lag; ++dx)
                    sum += at(i, j, dx, dy) * at(i, j, dx, dy);
            }
        }
    }
    return std::sqrt(sum);
}

double Autocovariance::distance(const Autocovariance& other, int lag) const {
    assert(other.m_channels == m_channels && lag <= m_maxLag && lag <= other.m_maxLag);
    double sum = 0.0;
    for (int i = 0; i < m_channels; ++i) {
        for (int j = 0; j < m_channels; ++j) {
            for (int dy = -lag; dy <= lag; ++dy) {
                for (int dx = -lag; dx <= lag; ++dx) {
                    const double difference = at(i, j, dx, dy) - other.at(i, j, dx, dy);
                    sum += difference * difference;
                }
            }
        }
    }
    return std::sqrt(sum);
}

Autocovariance autocovariance(const Image& image, int maxLag) {
    assert(maxLag < image.width() && maxLag < image.height());
    Correlator correlator(image.size(), maxLag);
    for (int c = 0; c < image.channels(); ++c) {
        const auto plane = image.plane(c);
        const double mean =
            std::accumulate(plane.begin(), plane.end(), 0.0) / static_cast<double>(plane.size());
        correlator.addChannel(plane, image.size(), static_cast<float>(-mean));
    }
    Autocovariance result(image.channels(), maxLag);
    correlator.correlate(maxLag, [&](int i, int j, int dx, int dy, double sum) {
        const double pairs = static_cast<double>(image.width() - std::abs(dx)) *
                             static_cast<double>(image.height() - std::abs(dy));
        result.at(i, j, dx, dy) = sum / pairs;
        result.at(j, i, -dx, -dy) = sum / pairs;
    });
    return result;
}

Autocovariance autocovariance(const Texton& texton, int maxLag) {
    // b reaches order lags further than what is asked for.
    const auto b = bsplineAutocorrelation(texton.interpolationOrder);
    const int reach = static_cast<int>(b.size()) - 1;
    const int wide = maxLag + reach;
    Autocovariance plain(texton.channels(), wide);
    for (const Image& kernel : texton.kernels) {
        Correlator correlator(kernel.size(), wide);
        for (int c = 0; c < kernel.channels(); ++c)
            correlator.addChannel(kernel.plane(c), kernel.size(), 0.0F);
        const int reachX = kernel.width() - 1;
        const int reachY = kernel.height() - 1;
        correlator.correlate(wide, [&](int i, int j, int dx, int dy, double sum) {
            if (std::abs(dx) > reachX || std::abs(dy) > reachY)
                return; // nothing but rounding errors
            plain.at(i, j, dx, dy) += sum;
            if (i != j)
                plain.at(j, i, -dx, -dy) += sum;
        });
    }
    Autocovariance result(texton.channels(), maxLag);
    for (int i = 0; i < texton.channels(); ++i) {
        for (int j = 0; j < texton.channels(); ++j) {
            for (int dy = -maxLag; dy <= maxLag; ++dy) {
                for (int dx = -maxLag; dx <= maxLag; ++dx) {
                    double sum = 0.0;
                    for (int v = -reach; v <= reach; ++v) {
                        for (int u = -reach; u <= reach; ++u)
                            sum += b[static_cast<std::size_t>(std::abs(u))] *
                                   b[static_cast<std::size_t>(std::abs(v))] *
                                   plain.at(i, j, dx + u, dy + v);
                    }
                    result.at(i, j, dx, dy) = sum;
                }
            }
        }
    }
    return result;
}

} // namespace txn
