// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spectral/BSpline.h"
#include "core/texton/Texton.h"
#include "tests/helpers/Numbers.h"

#include <vector>

namespace txn::test {

struct TextonRecipe {
    int order = 1;
    int kernels = 1;
    Size size{9, 7};
    int channels = 3;
    std::uint64_t seed = 1;
    /// Added to every coefficient before scaling: gives the kernels a sum that is not zero.
    double offset = 0.0;
};

/// A texton with random smooth coefficients whose noise has variance 1 in every channel, or near
/// it: lopsided and different per channel and kernel, so that no mirroring or swapping of anything
/// goes unnoticed. Means 0.5, 0.6, ...
inline Texton makeTexton(const TextonRecipe& recipe) {
    TestRandom random(recipe.seed);
    Texton texton;
    texton.support = Support::rectangle(recipe.size);
    texton.interpolationOrder = recipe.order;
    for (int c = 0; c < recipe.channels; ++c)
        texton.mean.push_back(0.5 + 0.1 * c);
    for (int q = 0; q < recipe.kernels; ++q) {
        Image kernel(recipe.size, recipe.channels);
        for (int y = 0; y < recipe.size.height; ++y) {
            for (int x = 0; x < recipe.size.width; ++x) {
                const double shared = random.gaussian();
                for (int c = 0; c < recipe.channels; ++c) {
                    // A brighter corner and a link between channels.
                    const double slope = 1.0 + x * 0.2 + y * 0.1;
                    kernel.at(x, y, c) = static_cast<float>(
                        slope * (0.6 * shared + random.gaussian()) + recipe.offset * slope);
                }
            }
        }
        texton.kernels.push_back(std::move(kernel));
    }
    const auto covariance = noiseCovariance(texton);
    for (int c = 0; c < recipe.channels; ++c) {
        const auto i = static_cast<std::size_t>(c) * static_cast<std::size_t>(recipe.channels + 1);
        const auto scale = static_cast<float>(1.0 / std::sqrt(covariance[i]));
        for (Image& kernel : texton.kernels) {
            for (float& v : kernel.plane(c))
                v *= scale;
        }
    }
    return texton;
}

/// The same texton with its support cut to another shape of the same size.
inline Texton cutTo(Texton texton, const Support& support) {
    texton.support = support;
    for (Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c) {
            for (int y = 0; y < kernel.height(); ++y) {
                for (int x = 0; x < kernel.width(); ++x) {
                    if (!support.contains(x, y))
                        kernel.at(x, y, c) = 0.0F;
                }
            }
        }
    }
    return texton;
}

/// Covariance of channel i at x + (dx, dy) and channel j at x of the noise, by plain sums:
/// sum over kernels, k, l of alpha_i(k) alpha_j(l) beta(k - l - d), beta = psi * psi~.
inline double naiveCovariance(const Texton& texton, int i, int j, int dx, int dy) {
    const int order = texton.interpolationOrder;
    const auto b = bsplineAutocorrelation(order);
    const auto weight = [&](int n) {
        return std::abs(n) < static_cast<int>(b.size()) ? b[static_cast<std::size_t>(std::abs(n))]
                                                        : 0.0;
    };
    double sum = 0.0;
    const Size size = texton.support.size();
    for (const Image& kernel : texton.kernels) {
        for (int ky = 0; ky < size.height; ++ky) {
            for (int ly = 0; ly < size.height; ++ly) {
                const double wy = weight(ky - ly - dy);
                if (wy == 0.0)
                    continue;
                for (int kx = 0; kx < size.width; ++kx) {
                    for (int lx = 0; lx < size.width; ++lx)
                        sum += wy * weight(kx - lx - dx) *
                               static_cast<double>(kernel.at(kx, ky, i)) *
                               static_cast<double>(kernel.at(lx, ly, j));
                }
            }
        }
    }
    return sum;
}

} // namespace txn::test
