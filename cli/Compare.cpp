// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/Report.h"
#include "core/export/Exporter.h"
#include "core/qa/Comparison.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

struct CompareArguments {
    std::filesystem::path a;
    std::filesystem::path b;
    std::optional<int> lag;
    bool json = false;
};

Result<Texture> loadTexture(const std::filesystem::path& path) {
    auto loaded = loadTextonOrImage(path);
    if (!loaded)
        return loaded.error();
    if (auto* asset = std::get_if<TextonAsset>(&*loaded))
        return Texture(std::move(asset->texton));
    auto exemplar =
        makeExemplar(std::move(std::get<LoadedImage>(*loaded).image), path.filename().string());
    if (!exemplar)
        return exemplar.error();
    return Texture(std::move(*exemplar));
}

Result<void> run(const CompareArguments& options) {
    std::optional<BusySign> busy("Comparing");
    const auto a = loadTexture(options.a);
    if (!a)
        return a.error();
    const auto b = loadTexture(options.b);
    if (!b)
        return b.error();
    const auto result = compare(*a, *b, options.lag);
    if (!result)
        return Error{result.error().code,
                     "'" + options.a.filename().string() + "' and '" +
                         options.b.filename().string() + "': " + result.error().message};
    busy.reset();
    if (options.json) {
        nlohmann::ordered_json json;
        json["a"] = options.a.string();
        json["b"] = options.b.string();
        json["lag"] = result->lag;
        json["covariance_error"] = result->covarianceError;
        json["covariance_error_floor"] = result->covarianceErrorFloor
                                             ? nlohmann::json(*result->covarianceErrorFloor)
                                             : nlohmann::json();
        json["color_covariance_error"] = result->colorCovarianceError;
        json["mean_a"] = result->meanA;
        json["mean_b"] = result->meanB;
        json["mean_difference"] = result->meanDifference;
        json["spectrum_difference_db"] = result->spectrumDifference;
        json["rme"] = nullptr;
        if (result->relativeModelError)
            json["rme"] = *result->relativeModelError;
        printJson(json);
        return {};
    }
    std::cout << "covariance error           " << shortNumber(result->covarianceError);
    if (result->covarianceErrorFloor && *result->covarianceErrorFloor > 0.0)
        std::cout << ", " << shortNumber(result->covarianceError / *result->covarianceErrorFloor)
                  << " x the floor";
    std::cout << " (lags up to " << result->lag << ")\n"
              << "mean colour differs by     " << shortNumber(result->meanDifference) << '\n'
              << "colour covariance error    " << shortNumber(result->colorCovarianceError) << '\n'
              << "power spectrum differs by  " << shortNumber(result->spectrumDifference)
              << " dB\n";
    if (result->relativeModelError)
        std::cout << "relative model error       " << shortNumber(*result->relativeModelError)
                  << '\n';
    return {};
}

} // namespace

void addCompare(CLI::App& app, Session& session) {
    auto* command =
        app.add_subcommand("compare", "Measure how far a texture B is from a texture A");
    command->footer("Pictures and textons may be mixed; errors are relative to A, 0 is equal.\n"
                    "At 1 x the floor the two are as close as half a picture is to all of it.\n"
                    "Of pictures the periodic component is taken, as in compute.\n" +
                    std::string(kWhyModelErrorStays) +
                    "\n"
                    "Example:\n  texton compare wood.jpg wood_4k.png");
    auto options = std::make_shared<CompareArguments>();
    command->add_option("A", options->a, "Picture or texton")->required();
    command->add_option("B", options->b, "Picture or texton")->required();
    command
        ->add_option("--lag",
                     options->lag,
                     "Compare correlations up to this distance, in pixels (default: 32)")
        ->type_name("N")
        ->check(CLI::Range(0, 512));
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
