// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"

#include <optional>
#include <string_view>

namespace txn {

/// How impulses are scattered and weighed. Same covariance for all three.
/// Stratified: exactly one impulse in each cell, random signs (ours: closest to Gaussian for a
/// given cost). Signed: Poisson process, random signs ([TN17] section 7). Poisson: Poisson process,
/// all signs +1, mean subtracted ([TN17] eq. 1, the papers' own).
enum class NoiseProcess { Stratified, Signed, Poisson };

[[nodiscard]] std::string_view toString(NoiseProcess process);
[[nodiscard]] std::optional<NoiseProcess> noiseProcessFromString(std::string_view text);

/// The MNI at which the eye no longer tells the noise from a Gaussian texture.
[[nodiscard]] constexpr double defaultMeanImpacts(NoiseProcess process) {
    return process == NoiseProcess::Stratified ? 12.0 : 30.0;
}

/// A rectangle after which tileable noise repeats exactly, in exemplar pixels.
struct Period {
    double width = 0.0;
    double height = 0.0;
    bool operator==(const Period&) const = default;
};

/// Which texton noise. meanImpacts is the MNI, the mean number of kernels that overlap at a point:
/// the intensity is lambda = MNI / (Fx Fy) impulses per square exemplar pixel, F the footprint.
struct NoiseParams {
    static constexpr double kMinMeanImpacts = 0.1;
    static constexpr double kMaxMeanImpacts = 1000.0;
    /// Beyond this the 32-bit cells would wrap around.
    static constexpr double kFarthest = 1e8;

    NoiseProcess process = NoiseProcess::Stratified;
    double meanImpacts = defaultMeanImpacts(NoiseProcess::Stratified);
    Seed seed;
    std::optional<Period> period; ///< unset: endless

    bool operator==(const NoiseParams&) const = default;
};

/// Errors: InvalidArgument for an MNI or a period out of range.
[[nodiscard]] Result<void> checkNoiseParams(const NoiseParams& params);

} // namespace txn
