// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Commands.h"
#include "core/noise/NoiseParams.h"

namespace txn::cli {

/// Which noise, for `noise` and `sheet`.
struct NoiseOptions {
    std::optional<std::string> process;
    std::optional<double> meanImpacts;
    std::uint32_t seed = 1;

    /// Without a period. What is not given: the fallback's process, its MNI with that process, and
    /// the usual MNI with another.
    NoiseParams params(const NoiseParams& fallback = {}) const;
};

/// The name of the seed option differs, since `sheet` has one already. hint: added to what is said
/// of the usual MNI.
void addNoiseOptions(CLI::App& app,
                     NoiseOptions& options,
                     const std::string& seedName,
                     const std::string& hint = {});

} // namespace txn::cli
