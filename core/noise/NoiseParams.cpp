// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseParams.h"

namespace txn {

std::string_view toString(NoiseProcess process) {
    switch (process) {
    case NoiseProcess::Stratified:
        return "stratified";
    case NoiseProcess::Signed:
        return "signed";
    case NoiseProcess::Poisson:
        break;
    }
    return "poisson";
}

std::optional<NoiseProcess> noiseProcessFromString(std::string_view text) {
    for (const auto process :
         {NoiseProcess::Stratified, NoiseProcess::Signed, NoiseProcess::Poisson}) {
        if (text == toString(process))
            return process;
    }
    return std::nullopt;
}

Result<void> checkNoiseParams(const NoiseParams& params) {
    if (!(params.meanImpacts >= NoiseParams::kMinMeanImpacts &&
          params.meanImpacts <= NoiseParams::kMaxMeanImpacts))
        return Error{ErrorCode::InvalidArgument,
                     "the mean number of impacts (MNI) must be between 0.1 and 1000"};
    if (params.period && !(params.period->width > 0.0 && params.period->height > 0.0 &&
                           params.period->width <= NoiseParams::kFarthest &&
                           params.period->height <= NoiseParams::kFarthest))
        return Error{ErrorCode::InvalidArgument, "the size of the tile is out of range"};
    return {};
}

} // namespace txn
