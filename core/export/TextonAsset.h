// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/MaterialMap.h"
#include "core/noise/NoiseParams.h"
#include "core/texton/Texton.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace txn {

/// A texton as it is stored in files: with what is needed to make the intended noise of it.
struct TextonAsset {
    Texton texton;
    NoiseProcess process = NoiseProcess::Stratified;
    double meanImpacts = defaultMeanImpacts(NoiseProcess::Stratified);
    Seed seed; ///< that the texton was computed with
    std::string exemplarName;
    MaterialMaps maps; ///< of a stack; empty for a plain picture

    bool operator==(const TextonAsset&) const = default;
};

/// How stored samples become coefficients: alpha = sample * scale + bias, per channel.
struct SampleCode {
    std::vector<double> scale;
    std::vector<double> bias;
};

/// The description that goes into the sidecar and into EXR headers (docs/FORMATS.md).
[[nodiscard]] nlohmann::ordered_json describe(const TextonAsset& asset, const SampleCode& code);

/// The reverse: everything but the kernels, which are left empty. Errors: Unreadable for missing or
/// senseless entries; the message does not name a file.
struct Description {
    TextonAsset asset;
    SampleCode code;
    int kernels = 1;
};
[[nodiscard]] Result<Description> parseDescription(const nlohmann::ordered_json& json);

} // namespace txn
