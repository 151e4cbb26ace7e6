// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/qa/SupportSuggestion.h"

#include "core/gaussian/ChannelWeights.h"
#include "core/image/ImageGeometry.h"
#include "core/qa/Autocovariance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace txn {
namespace {

constexpr std::array kSides{16, 24, 32, 48, 64, 96, 128, 192, 256};
constexpr double kSmallEnough = 0.2;
constexpr Size kLargestPart{1024, 1024};
/// A covariance of many channels at many lags takes much memory.
constexpr int kManyChannels = 4;
constexpr int kLongestLag = 176;
constexpr int kLongestLagOfMany = 88;

/// Sums of squares over the lags with max(|dx|, |dy|) = ring.
template <class Value>
std::vector<double> ringSums(const Autocovariance& like, Value value) {
    const int lag = like.maxLag();
    std::vector<double> sums(static_cast<std::size_t>(lag) + 1, 0.0);
    for (int i = 0; i < like.channels(); ++i) {
        for (int j = 0; j < like.channels(); ++j) {
            for (int dy = -lag; dy <= lag; ++dy) {
                for (int dx = -lag; dx <= lag; ++dx) {
                    const double v = value(i, j, dx, dy);
                    sums[static_cast<std::size_t>(std::max(std::abs(dx), std::abs(dy)))] += v * v;
                }
            }
        }
    }
    return sums;
}

} // namespace

Result<SupportSuggestion> suggestSupport(const Exemplar& exemplar) {
    const Image image = middlePart(exemplar.image, kLargestPart);
    const int shorter = std::min(image.width(), image.height());
    if (shorter < 2 * kSides.front())
        return Error{ErrorCode::SizeMismatch,
                     "the exemplar is too small to suggest a support; give one"};
    const auto weights = channelWeights(exemplar);
    const int lag =
        std::min(shorter / 4, image.channels() > kManyChannels ? kLongestLagOfMany : kLongestLag);
    const auto all = autocovariance(image, lag).weighted(weights);
    auto signal = ringSums(all, [&](int i, int j, int dx, int dy) { return all.at(i, j, dx, dy); });
    if (!(signal.front() > 0.0))
        return Error{ErrorCode::Degenerate,
                     "the exemplar is one flat colour: there is no texture to summarise"};
    for (const bool leftRight : {true, false}) {
        const auto [one, other] = halves(image, leftRight);
        const auto first = autocovariance(one, lag).weighted(weights);
        const auto second = autocovariance(other, lag).weighted(weights);
        // Of the mean of two halves, half their difference is chance; the two cuts count half each.
        const auto chance = ringSums(all, [&](int i, int j, int dx, int dy) {
            return 0.5 * (first.at(i, j, dx, dy) - second.at(i, j, dx, dy));
        });
        for (std::size_t ring = 0; ring < signal.size(); ++ring)
            signal[ring] -= 0.5 * chance[ring];
    }
    const double total = std::reduce(signal.begin(), signal.end());
    SupportSuggestion best{kSides.front(), 1.0};
    for (const int side : kSides) {
        // Of the last quarter of the lags, what would be left out cannot be told.
        if (side > kSides.front() && 2 * side > 3 * lag)
            break;
        const double beyond = std::reduce(signal.begin() + side / 2 + 1, signal.end());
        best = {side, total > 0.0 ? std::sqrt(std::max(0.0, beyond / total)) : 0.0};
        if (best.error <= kSmallEnough)
            break;
    }
    return best;
}

} // namespace txn
