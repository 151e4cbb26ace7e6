// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/ExemplarOptions.h"
#include "cli/Paths.h"
#include "cli/Report.h"
#include "cli/SolveOptions.h"
#include "core/base/OutputFiles.h"
#include "core/export/Exporter.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

struct ComputeArguments {
    ExemplarOptions exemplar;
    SolveOptions solve;
    std::vector<std::filesystem::path> outputs;
    bool json = false;
};

/// A .texton holds one kernel: then no other number is tried, and none is computed for nothing.
Result<SolveOptions> fitFor(const std::vector<std::filesystem::path>& outputs,
                            SolveOptions options) {
    const auto oneKernel = std::ranges::find(outputs, ".texton", [](const auto& path) {
        return path.extension().string();
    });
    if (oneKernel == outputs.end() || options.kernels == "1")
        return options;
    if (options.kernels != "auto" && options.method == "fit")
        return Error{ErrorCode::Unsupported,
                     "cannot write " + quoted(*oneKernel) +
                         ": a .texton file holds one kernel; use EXR or --kernels 1"};
    options.kernels = "1";
    return options;
}

/// That nothing which is read is written over, and all can be written.
Result<void> checkOutputs(const ComputeArguments& options, const MaterialMaps& maps) {
    for (const auto& output : options.outputs) {
        for (const auto& file : textonFiles(output, maps)) {
            for (const auto& input : inputFiles(options.exemplar)) {
                if (const auto ok = checkNotInput(input, file); !ok)
                    return ok.error();
            }
        }
    }
    return checkTextonOutputs(options.outputs, maps);
}

Result<void> run(const ComputeArguments& options, const CancelToken& cancel) {
    const bool stack = !options.exemplar.stack.empty();
    if (!stack) {
        if (const auto ok = checkOutputs(options, {}); !ok)
            return ok.error();
    }
    Stopwatch watch;
    const auto exemplar = loadExemplar(options.exemplar);
    if (!exemplar)
        return exemplar.error();
    if (stack) { // what files it becomes is known only now
        if (const auto ok = checkOutputs(options, exemplar->maps); !ok)
            return ok.error();
    }
    const double load = watch.lap();
    const GaussianModel model(*exemplar, !options.solve.noPeriodic);
    const auto how = fitFor(options.outputs, options.solve);
    if (!how)
        return how.error();
    auto solved = solve(*exemplar, model, *how, cancel);
    if (!solved)
        return Error{solved.error().code,
                     quoted(mainFile(options.exemplar)) + ": " + solved.error().message};
    const double solving = watch.lap();

    TextonAsset asset;
    asset.texton = solved->computed.texton;
    asset.maps = exemplar->maps;
    asset.exemplarName = exemplar->name;
    asset.seed.value = options.solve.seed;
    const auto written = saveTexton(asset, options.outputs);
    if (!written)
        return written.error();
    const double writing = watch.lap();

    const auto& dial = solved->dial;
    const auto& corrected = solved->computed.relativeModelError;
    const Size size = exemplar->image.size();
    const Size support = asset.texton.support.size();
    if (options.json) {
        nlohmann::ordered_json json;
        json["width"] = size.width;
        json["height"] = size.height;
        json["channels"] = exemplar->image.channels();
        json["support"] = {support.width, support.height};
        if (solved->suggestion)
            json["support_error"] = solved->suggestion->error;
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
        json["rme"] = corrected ? nlohmann::json(solved->computed.error) : nlohmann::json();
        json["rme_corrected"] = corrected ? nlohmann::json(*corrected) : nlohmann::json();
        json["seconds"] = {{"load", load}, {"solve", solving}, {"write", writing}};
        for (const auto& path : *written)
            json["outputs"].push_back(path.string());
        printJson(json);
        return {};
    }
    std::cout << exemplar->name << ": " << size.width << " x " << size.height << ", "
              << exemplar->image.channels() << " channels; ";
    if (dial)
        std::cout << inWords(*dial) << "; ";
    std::cout << "texton " << support.width << " x " << support.height;
    if (solved->suggestion)
        std::cout << " (as suggested: " << shortNumber(100.0 * solved->suggestion->error)
                  << " % of the correlation reaches further)";
    if (asset.texton.kernelCount() > 1)
        std::cout << ", " << asset.texton.kernelCount() << " kernels";
    std::cout << ", " << shortNumber(solving) << " s\n";
    if (corrected)
        std::cout << "relative model error " << shortNumber(solved->computed.error) << " ("
                  << shortNumber(*corrected) << " with corrected colours)\n"
                  << kWhyModelErrorStays << '\n';
    printWritten(*written);
    return {};
}

} // namespace

void addCompute(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand("compute", "Compute the texton of a material");
    command->footer(
        "Examples:\n"
        "  texton compute wood.jpg -o wood.exr -o wood.png --support auto\n"
        "  texton compute --stack color=rock_albedo.png --stack normal=rock_normal.png \\\n"
        "                 --stack roughness=rock_rough.png -o rock.exr\n"
        "The covariance error tells how far the texton's noise is from the material; at 1 x the\n"
        "floor it is as close as one half of the photograph is to all of it.\n"
        "With --method projections:\n" +
        std::string(kWhyModelErrorStays));
    auto options = std::make_shared<ComputeArguments>();
    addMaterialOptions(*command, options->exemplar);
    command
        ->add_option(
            "-o,--output",
            options->outputs,
            "Where to write: .exr, .png or .texton (one kernel); may be given several times")
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
