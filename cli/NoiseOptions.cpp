// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/NoiseOptions.h"

#include "cli/Parse.h"

namespace txn::cli {

NoiseParams NoiseOptions::params(const NoiseParams& fallback) const {
    NoiseParams result;
    result.process = process ? *noiseProcessFromString(*process) : fallback.process;
    const double usual = result.process == fallback.process ? fallback.meanImpacts
                                                            : defaultMeanImpacts(result.process);
    result.meanImpacts = meanImpacts.value_or(usual);
    result.seed.value = seed;
    return result;
}

void addNoiseOptions(CLI::App& app,
                     NoiseOptions& options,
                     const std::string& seedName,
                     const std::string& hint) {
    app.add_option("--mni",
                   options.meanImpacts,
                   "Mean number of impacts per pixel: higher is closer to Gaussian (default: the "
                   "texton's own, else 12 for stratified, 30 otherwise" +
                       hint + ")")
        ->type_name("N")
        ->check(between(NoiseParams::kMinMeanImpacts, NoiseParams::kMaxMeanImpacts));
    app.add_option("--process",
                   options.process,
                   "How impacts are scattered: stratified, signed or poisson (default: stratified)")
        ->check(CLI::IsMember({"stratified", "signed", "poisson"}));
    app.add_option(seedName, options.seed, "Another number gives other noise of the same kind")
        ->capture_default_str();
}

} // namespace txn::cli
