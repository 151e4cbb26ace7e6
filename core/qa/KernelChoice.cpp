// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/KernelChoice.h"

#include "core/gaussian/GaussianModel.h"
#include "core/image/ImageGeometry.h"
#include "core/qa/Autocovariance.h"
#include "core/texton/ColorCorrection.h"

#include <algorithm>

namespace txn {
namespace {

constexpr double kAsGood = 1.05;
constexpr int kMostForStacks = 4;

} // namespace

int mostTrialKernels(int channels) {
    return channels > 3 ? std::min(channels, kMostForStacks) : 2;
}

Result<KernelChoice> chooseKernels(const Exemplar& exemplar,
                                   bool periodic,
                                   const LeastSquaresParams& params,
                                   const KernelTrialObserver& observe,
                                   const CancelToken& cancel) {
    const Image& image = exemplar.image;
    const Size support = params.support.size();
    const bool leftRight = image.width() >= image.height();
    if (std::min(image.width(), image.height()) < 2)
        return KernelChoice{};
    auto [training, rest] = halves(image, leftRight);
    const Size half = rest.size();
    const int lag = std::min(support.width, support.height) / 2;
    if (half.width < support.width || half.height < support.height)
        return KernelChoice{}; // nothing to try on
    const GaussianModel model(Exemplar{std::move(training), exemplar.name}, periodic);
    const auto unseen = autocovariance(rest, std::min(lag, std::min(half.width, half.height) - 1));

    const auto weighted = [&](const Autocovariance& covariance) {
        return params.channelWeights.empty() ? covariance
                                             : covariance.weighted(params.channelWeights);
    };
    const auto target = weighted(unseen);
    const double norm = target.norm(target.maxLag());
    std::vector<double> errors;
    for (int kernels = 1; kernels <= mostTrialKernels(image.channels()); ++kernels) {
        LeastSquaresParams trial = params;
        trial.kernels = kernels;
        const auto fitted = fitTexton(
            model,
            trial,
            [&](const TextonProgress& now) {
                if (observe)
                    observe(kernels, now);
            },
            cancel);
        if (!fitted)
            return fitted.error();
        const Texton corrected = colorCorrected(*fitted, model.covariance());
        errors.push_back(
            weighted(autocovariance(corrected, target.maxLag())).distance(target, target.maxLag()) /
            norm);
    }
    const double best = *std::min_element(errors.begin(), errors.end());
    const auto chosen = std::find_if(errors.begin(), errors.end(), [&](double error) {
        return error <= kAsGood * best;
    });
    return KernelChoice{static_cast<int>(chosen - errors.begin()) + 1, std::move(errors)};
}

} // namespace txn
