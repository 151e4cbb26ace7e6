// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/SpotNoise.h"

#include "core/spectral/BSpline.h"

#include <algorithm>
#include <cassert>

namespace txn {

double kernelValue(const Texton& texton, int kernel, int channel, double x, double y) {
    const Image& coefficients = texton.kernels[static_cast<std::size_t>(kernel)];
    // psi(x - k) = psi(n - (-x)) for n = -k.
    const auto horizontal = bsplineWeights(texton.interpolationOrder, -x);
    const auto vertical = bsplineWeights(texton.interpolationOrder, -y);
    double sum = 0.0;
    for (int j = 0; j <= texton.interpolationOrder; ++j) {
        const long long row = -(vertical.first + j);
        if (row < 0 || row >= coefficients.height())
            continue;
        for (int i = 0; i <= texton.interpolationOrder; ++i) {
            const long long column = -(horizontal.first + i);
            if (column < 0 || column >= coefficients.width())
                continue;
            sum += static_cast<double>(vertical.weight[j]) * horizontal.weight[i] *
                   coefficients.at(static_cast<int>(column), static_cast<int>(row), channel);
        }
    }
    return sum;
}

void SpotNoise::evaluate(double x, double y, std::span<double> out) const {
    assert(out.size() == static_cast<std::size_t>(m_process.channels()));
    const Size footprint = m_process.first().footprint();
    const double corner = m_process.first().frame() + 0.5;
    std::fill(out.begin(), out.end(), 0.0);
    m_process.impulses()
        .visit(x - footprint.width, y - footprint.height, x, y, [&](const Impulse& impulse) {
            const Texton& texton =
                m_process.textons()[static_cast<std::size_t>(m_process.textonOf(impulse))];
            const double kx = x - impulse.x - corner;
            const double ky = y - impulse.y - corner;
            for (std::size_t c = 0; c < out.size(); ++c)
                out[c] += static_cast<double>(impulse.sign) *
                          kernelValue(texton, impulse.kernel, static_cast<int>(c), kx, ky);
        });
    const auto mean = m_process.meanAt(x, y);
    for (std::size_t c = 0; c < out.size(); ++c)
        out[c] = mean[c] + m_process.gain() * out[c];
}

} // namespace txn
