// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/Comparison.h"

#include "core/image/ColorTransfer.h"
#include "core/qa/Autocovariance.h"
#include "core/qa/CovarianceError.h"
#include "core/qa/RadialSpectrum.h"
#include "core/texton/RelativeModelError.h"

#include <algorithm>
#include <cmath>

namespace txn {
namespace {

constexpr int kDefaultLag = 32;

/// What is compared, of a picture or of the noise of a texton.
struct Statistics {
    std::vector<double> mean;
    Autocovariance covariance;
    RadialSpectrum spectrum;
};

Transfer transferOf(const Texture& texture) {
    if (const auto* texton = std::get_if<Texton>(&texture))
        return texton->transfer;
    return std::get<Exemplar>(texture).image.transfer();
}

int channelsOf(const Texture& texture) {
    if (const auto* texton = std::get_if<Texton>(&texture))
        return texton->channels();
    return std::get<Exemplar>(texture).image.channels();
}

/// Largest lag that leaves enough pairs of pixels.
int lagLimit(const Texture& texture) {
    if (const auto* exemplar = std::get_if<Exemplar>(&texture))
        return std::min(exemplar->image.width(), exemplar->image.height()) - 1;
    return 1 << 14;
}

Texture converted(Texture texture, Transfer transfer) {
    if (auto* exemplar = std::get_if<Exemplar>(&texture);
        exemplar != nullptr && exemplar->image.transfer() != transfer) {
        exemplar->image = transfer == Transfer::Linear ? toLinear(std::move(exemplar->image))
                                                       : toEncoded(std::move(exemplar->image));
    }
    return texture;
}

Statistics statistics(const Texture& texture, int lag) {
    if (const auto* texton = std::get_if<Texton>(&texture))
        return {texton->mean, autocovariance(*texton, lag), radialSpectrum(*texton)};
    const auto& exemplar = std::get<Exemplar>(texture);
    const GaussianModel model(exemplar);
    return {model.mean(), autocovariance(exemplar.image, lag), radialSpectrum(model)};
}

} // namespace

Result<Comparison> compare(const Texture& a, const Texture& b, std::optional<int> lag) {
    if (channelsOf(a) != channelsOf(b))
        return Error{ErrorCode::SizeMismatch,
                     "the two have " + std::to_string(channelsOf(a)) + " and " +
                         std::to_string(channelsOf(b)) + " channels"};
    const int limit = std::min(lagLimit(a), lagLimit(b));
    if (lag && (*lag < 0 || *lag > limit))
        return Error{ErrorCode::SizeMismatch,
                     "the lag must be between 0 and " + std::to_string(limit)};
    Comparison result;
    result.lag = lag.value_or(std::min(kDefaultLag, (limit + 1) / 4));

    const auto* textonA = std::get_if<Texton>(&a);
    const auto* textonB = std::get_if<Texton>(&b);
    const Transfer transfer = textonB != nullptr ? textonB->transfer : transferOf(a);
    const Texture left = converted(a, transfer);
    const Texture right = converted(b, transfer);
    if (transferOf(left) != transferOf(right))
        return Error{ErrorCode::SizeMismatch,
                     "one texton is for linear and the other for encoded values"};

    const Statistics first = statistics(left, result.lag);
    const Statistics second = statistics(right, result.lag);
    if (!(first.covariance.norm(0) > 0.0))
        return Error{ErrorCode::Degenerate, "the first one is a flat colour: nothing to compare"};
    result.meanA = first.mean;
    result.meanB = second.mean;
    for (std::size_t c = 0; c < first.mean.size(); ++c)
        result.meanDifference =
            std::max(result.meanDifference, std::abs(first.mean[c] - second.mean[c]));
    const auto error = [&](int upTo) {
        return first.covariance.distance(second.covariance, upTo) / first.covariance.norm(upTo);
    };
    result.covarianceError = error(result.lag);
    result.colorCovarianceError = error(0);
    const auto* picture = std::get_if<Exemplar>(textonA == nullptr ? &left : &right);
    if (picture != nullptr && 2 * (result.lag + 1) <= lagLimit(*picture) + 1)
        result.covarianceErrorFloor = covarianceErrorFloor(*picture, result.lag);
    result.spectrumDifference = differenceInDecibels(first.spectrum, second.spectrum);

    // Of a picture and a texton: what the texton's solver minimises.
    const Texton* texton = textonA != nullptr ? textonA : textonB;
    if (texton != nullptr && (textonA == nullptr || textonB == nullptr)) {
        const GaussianModel model(*picture);
        if (const auto rme = relativeModelError(model, *texton))
            result.relativeModelError = *rme;
    }
    return result;
}

} // namespace txn
