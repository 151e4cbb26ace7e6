// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/SolveOptions.h"

#include "cli/Parse.h"
#include "cli/Report.h"

#include <algorithm>

namespace txn::cli {
namespace {

/// "auto" gives no size.
std::optional<std::optional<Size>> parseSupport(const std::string& text) {
    if (text == "auto")
        return std::optional<Size>();
    if (const auto size = parseSize(text))
        return std::optional(*size);
    return std::nullopt;
}

} // namespace

void addSolveOptions(CLI::App& app, SolveOptions& options) {
    addParsed(app,
              "--support",
              options.support,
              parseSupport,
              "N|WxH|auto",
              "Size of the texton, in pixels; auto: as large as the material needs (default: 64)");
    app.add_option("--shape", options.shape, "square (all of the support) or disc")
        ->check(CLI::IsMember({"square", "disc"}))
        ->capture_default_str();
    app.add_option("--order",
                   options.order,
                   "Interpolation order: 0 nearest, 1 linear, 3 cubic, 5 quintic")
        ->check(CLI::IsMember({0, 1, 3, 5}))
        ->capture_default_str();
    app.add_option("--method",
                   options.method,
                   "fit: closest to the material, by least squares; projections: the papers' way")
        ->check(CLI::IsMember({"fit", "projections"}))
        ->capture_default_str();
    app.add_option("--kernels",
                   options.kernels,
                   "Of a fit: how many kernels impulses choose from, 1 to 16; more follow colors "
                   "and maps that vary independently")
        ->type_name("auto|N")
        ->check(CLI::IsMember({"auto"}) | CLI::Range(1, 16))
        ->capture_default_str();
    app.add_option("--iterations",
                   options.iterations,
                   "Of projections: more are slower and a little better")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--momentum",
                   options.momentum,
                   "Of projections: 0 for the papers' plain iteration, below 1")
        ->check(between(0.0, 0.999))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Another number gives another, equally good result")
        ->capture_default_str();
    app.add_flag("--no-periodic",
                 options.noPeriodic,
                 "The exemplar tiles already: leave its borders alone");
    app.add_flag("--no-color-correction",
                 options.noColorCorrection,
                 "Leave the colours as the iteration found them");
}

Result<ComputeParams> computeParams(const SolveOptions& options, Size support, Size domain) {
    const bool disc = options.shape == "disc";
    if (disc && support.width != support.height)
        return Error{ErrorCode::InvalidArgument, "a disc needs one number for --support"};
    ComputeParams params;
    params.method = options.method == "fit" ? TextonMethod::Fit : TextonMethod::Projections;
    params.support = Support::rectangle(support);
    // A disc that does not fit is refused later for its size, before its mask takes any memory.
    if (disc && support.width <= std::min(domain.width, domain.height))
        params.support = Support::disc(support.width);
    params.interpolationOrder = options.order;
    if (options.kernels != "auto")
        params.kernels = std::stoi(options.kernels);
    params.iterations = options.iterations;
    params.momentum = options.momentum;
    params.seed.value = options.seed;
    params.colorCorrection = !options.noColorCorrection;
    return params;
}

Result<Solved> solve(const Exemplar& exemplar,
                     const GaussianModel& model,
                     const SolveOptions& options,
                     const CancelToken& cancel) {
    Solved result;
    Size support = options.support.value_or(Size{});
    if (!options.support) {
        const BusySign sign("Looking for a support");
        const auto suggestion = suggestSupport(exemplar);
        if (!suggestion)
            return suggestion.error();
        result.suggestion = *suggestion;
        support = {suggestion->side, suggestion->side};
    }
    const auto params = computeParams(options, support, model.domain());
    if (!params)
        return params.error();
    ProgressBar bar("Computing the texton");
    auto computed = computeTexton(
        exemplar,
        model,
        *params,
        [&](const ComputeProgress& now) { bar.update(now.share); },
        cancel);
    if (!computed)
        return computed.error();
    result.computed = std::move(*computed);
    if (const auto dial = covarianceError(exemplar, result.computed.texton))
        result.dial = *dial;
    return result;
}

std::string inWords(const CovarianceError& dial) {
    return "covariance error " + shortNumber(dial.error / dial.floor) + " x the floor";
}

} // namespace txn::cli
