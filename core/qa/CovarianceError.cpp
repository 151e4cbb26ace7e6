// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/CovarianceError.h"

#include "core/gaussian/ChannelWeights.h"
#include "core/image/ImageGeometry.h"
#include "core/qa/Autocovariance.h"

#include <algorithm>
#include <cmath>

namespace txn {
namespace {

constexpr int kSmallest = 4;
/// A covariance of many channels at many lags takes much memory.
constexpr double kMostValues = 8e6;

int mostLag(int channels) {
    return static_cast<int>((std::sqrt(kMostValues) / channels - 1.0) / 2.0);
}

/// |C_1 - C_2| of the two halves.
double
betweenHalves(const Image& image, bool leftRight, int lag, const std::vector<double>& weights) {
    const auto [first, second] = halves(image, leftRight);
    return autocovariance(first, lag)
        .weighted(weights)
        .distance(autocovariance(second, lag).weighted(weights), lag);
}

double floorOf(const Image& image, int lag, const std::vector<double>& weights, double norm) {
    const double across = betweenHalves(image, true, lag, weights) / (2.0 * norm);
    const double down = betweenHalves(image, false, lag, weights) / (2.0 * norm);
    return std::sqrt(0.5 * (across * across + down * down));
}

} // namespace

double covarianceErrorFloor(const Exemplar& exemplar, int lag) {
    const auto weights = channelWeights(exemplar);
    const double norm = autocovariance(exemplar.image, lag).weighted(weights).norm(lag);
    return floorOf(exemplar.image, lag, weights, norm);
}

Result<CovarianceError> covarianceError(const Exemplar& exemplar, const Texton& texton) {
    const Image& image = exemplar.image;
    if (image.channels() != texton.channels())
        return Error{ErrorCode::SizeMismatch, "exemplar and texton have other numbers of channels"};
    const int shorter = std::min(image.width(), image.height());
    if (shorter < kSmallest)
        return Error{ErrorCode::SizeMismatch, "the exemplar is too small to compare its halves"};
    const Size support = texton.support.size();
    const auto weights = channelWeights(exemplar);
    CovarianceError result;
    result.lag = std::min(
        {std::min(support.width, support.height) / 2, shorter / 2 - 1, mostLag(image.channels())});
    const auto own = autocovariance(image, result.lag).weighted(weights);
    const double norm = own.norm(result.lag);
    if (!(norm > 0.0))
        return Error{ErrorCode::Degenerate, "the exemplar is one flat colour"};
    result.error =
        autocovariance(texton, result.lag).weighted(weights).distance(own, result.lag) / norm;
    result.floor = floorOf(image, result.lag, weights, norm);
    return result;
}

} // namespace txn
