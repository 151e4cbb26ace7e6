// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/NoiseOptions.h"

namespace txn::cli {

NoiseParams NoiseOptions::params() const {
    NoiseParams result;
    result.process = *noiseProcessFromString(process);
    result.meanImpacts = meanImpacts.value_or(defaultMeanImpacts(result.process));
    result.seed.value = seed;
    return result;
}

void addNoiseOptions(CLI::App& app, NoiseOptions& options, const std::string& seedName) {
    app.add_option("--mni",
                   options.meanImpacts,
                   "Mean number of impacts per pixel: higher is closer to Gaussian (default: 12 "
                   "for stratified, 30 otherwise)")
        ->type_name("N")
        ->check(CLI::Range(NoiseParams::kMinMeanImpacts, NoiseParams::kMaxMeanImpacts));
    app.add_option("--process",
                   options.process,
                   "How impacts are scattered: stratified, signed or poisson")
        ->check(CLI::IsMember({"stratified", "signed", "poisson"}))
        ->capture_default_str();
    app.add_option(seedName, options.seed, "Another number gives other noise of the same kind")
        ->capture_default_str();
}

} // namespace txn::cli
