// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "cli/SolveOptions.h"
#include "core/base/OutputFiles.h"
#include "core/export/Exporter.h"
#include "core/qa/CovarianceError.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

struct Options {
    ExemplarOptions exemplar;
    SolveOptions solve;
    std::vector<std::filesystem::path> outputs;
    bool json = false;
};

Result<void> run(const Options& options, const CancelToken& cancel) {
    for (const auto& output : options.outputs) {
        if (const auto ok = checkNotInput(options.exemplar.path, output); !ok)
            return ok.error();
    }
    if (const auto ok = checkTextonOutputs(options.outputs); !ok)
        return ok.error();
    Stopwatch watch;
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    const double load = watch.lap();
    const GaussianModel model(*exemplar, !options.solve.noPeriodic);
    auto solved = solve(*exemplar, model, options.solve, cancel);
    if (!solved)
        return Error{solved.error().code,
                     quoted(options.exemplar.path) + ": " + solved.error().message};
    const double solving = watch.lap();

    TextonAsset asset;
    asset.texton = std::move(solved->texton);
    asset.exemplarName = exemplar->name;
    asset.seed.value = options.solve.seed;
    const auto written = saveTexton(asset, options.outputs);
    if (!written)
        return written.error();
    const double writing = watch.lap();

    // Too small an exemplar cannot be measured against itself; it has a texton all the same.
    const auto dial = covarianceError(*exemplar, asset.texton);
    const Size size = exemplar->image.size();
    const Size support = asset.texton.support.size();
    if (options.json) {
        nlohmann::ordered_json json;
        json["width"] = size.width;
        json["height"] = size.height;
        json["channels"] = exemplar->image.channels();
        json["support"] = {support.width, support.height};
        json["shape"] = options.solve.shape;
        json["order"] = options.solve.order;
        json["method"] = options.solve.method;
        json["kernels"] = asset.texton.kernelCount();
        if (options.solve.method == "projections") {
            json["iterations"] = options.solve.iterations;
            json["momentum"] = options.solve.momentum;
        }
        json["seed"] = options.solve.seed;
        json["covariance_error"] = dial ? nlohmann::json(dial->error) : nlohmann::json();
        json["covariance_error_floor"] = dial ? nlohmann::json(dial->floor) : nlohmann::json();
        json["rme"] = solved->error ? nlohmann::json(*solved->error) : nlohmann::json();
        json["rme_corrected"] =
            solved->correctedError ? nlohmann::json(*solved->correctedError) : nlohmann::json();
        json["seconds"] = {{"load", load}, {"solve", solving}, {"write", writing}};
        for (const auto& path : *written)
            json["outputs"].push_back(path.string());
        printJson(json);
        return {};
    }
    std::cout << exemplar->name << ": " << size.width << " x " << size.height << ", "
              << exemplar->image.channels() << " channels; texton " << support.width << " x "
              << support.height;
    if (asset.texton.kernelCount() > 1)
        std::cout << ", " << asset.texton.kernelCount() << " kernels";
    if (dial)
        std::cout << ", covariance error " << shortNumber(dial->error / dial->floor)
                  << " x the floor";
    if (solved->error)
        std::cout << ", relative model error " << shortNumber(*solved->error) << " ("
                  << shortNumber(*solved->correctedError) << " with corrected colours)";
    std::cout << ", " << shortNumber(solving) << " s\n";
    printWritten(*written);
    return {};
}

} // namespace

void addCompute(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand("compute", "Compute the texton of a material");
    command->footer("Example:\n  texton compute wood.jpg -o wood.exr -o wood.png --support 96");
    auto options = std::make_shared<Options>();
    addExemplarOptions(*command, options->exemplar);
    command
        ->add_option("-o,--output",
                     options->outputs,
                     "Where to write: .exr, .png or .texton; may be given several times")
        ->required()
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addSolveOptions(*command, options->solve);
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] {
        session.run = [options, &session] { return run(*options, session.cancel); };
    });
}

} // namespace txn::cli
