// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/TextbookSolver.h"

#include "core/spectral/BSpline.h"

#include <cmath>
#include <complex>
#include <fftw3.h>

namespace txn::bench {
namespace {

using Value = std::complex<double>;
using Plane = std::vector<Value>;

/// Complex transforms of whole planes in place, planned once.
class Transform {
  public:
    Transform(Size size, int sign) : m_scratch(size.area()) {
        auto* data = reinterpret_cast<fftw_complex*>(m_scratch.data());
        m_plan = fftw_plan_dft_2d(size.height, size.width, data, data, sign, FFTW_ESTIMATE);
    }
    Transform(const Transform&) = delete;
    Transform& operator=(const Transform&) = delete;
    ~Transform() { fftw_destroy_plan(m_plan); }

    void run(Plane& plane) const {
        auto* data = reinterpret_cast<fftw_complex*>(plane.data());
        // std::vector aligns by 16, which is what FFTW's plan was made for.
        fftw_execute_dft(m_plan, data, data);
    }

  private:
    Plane m_scratch;
    fftw_plan m_plan;
};

} // namespace

std::vector<double> textbookTexton(const Image& spot,
                                   const Image& initialNoise,
                                   Size support,
                                   int interpolationOrder,
                                   int iterations) {
    const Size size = spot.size();
    const Transform forward(size, FFTW_FORWARD);
    const Transform backward(size, FFTW_BACKWARD);
    const auto channels = static_cast<std::size_t>(spot.channels());
    const auto bx = bsplineSpectrum(interpolationOrder, size.width);
    const auto by = bsplineSpectrum(interpolationOrder, size.height);
    std::vector<Plane> target(channels);
    std::vector<Plane> alpha(channels);
    const auto width = static_cast<std::size_t>(size.width);
    for (std::size_t c = 0; c < channels; ++c) {
        const auto plane = spot.plane(static_cast<int>(c));
        target[c].assign(plane.begin(), plane.end());
        forward.run(target[c]);
        for (std::size_t i = 0; i < size.area(); ++i)
            target[c][i] /= std::sqrt(bx[i % width] * by[i / width]);
        const auto noise = initialNoise.plane(static_cast<int>(c));
        alpha[c].assign(noise.begin(), noise.end());
    }
    for (int n = 0; n < iterations; ++n) {
        for (auto& plane : alpha)
            forward.run(plane);
        for (std::size_t i = 0; i < size.area(); ++i) {
            Value dot = 0.0;
            for (std::size_t c = 0; c < channels; ++c)
                dot += std::conj(target[c][i]) * alpha[c][i];
            const double modulus = std::abs(dot);
            const Value phase = modulus > 0.0 ? dot / modulus : Value(1.0);
            for (std::size_t c = 0; c < channels; ++c)
                alpha[c][i] = target[c][i] * phase;
        }
        for (auto& plane : alpha) {
            backward.run(plane);
            for (std::size_t i = 0; i < size.area(); ++i) {
                const bool inside = i % width < static_cast<std::size_t>(support.width) &&
                                    i / width < static_cast<std::size_t>(support.height);
                plane[i] = inside ? plane[i].real() / static_cast<double>(size.area()) : 0.0;
            }
        }
    }
    std::vector<double> result;
    for (const auto& plane : alpha) {
        for (int y = 0; y < support.height; ++y) {
            for (int x = 0; x < support.width; ++x)
                result.push_back(
                    plane[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)]
                        .real());
        }
    }
    return result;
}

} // namespace txn::bench
