// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/Report.h"
#include "core/export/Exporter.h"
#include "core/image/ImageFormats.h"
#include "core/spectral/PeriodicComponent.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
    std::filesystem::path path;
    bool json = false;
};

Json describe(const LoadedImage& loaded) {
    Json json;
    json["kind"] = "picture";
    json["format"] = formatTraits(loaded.format).name;
    json["width"] = loaded.image.width();
    json["height"] = loaded.image.height();
    json["channels"] = loaded.image.channels();
    json["samples"] = sampleFormatName(loaded.sampleFormat);
    json["alpha"] = loaded.alpha.has_value();
    json["color_space"] = loaded.image.transfer() == Transfer::Linear ? "linear" : "encoded";
    json["icc_converted"] = loaded.iccConverted;
    json["seam_ratio"] = seamRatio(loaded.image);
    return json;
}

Json describe(const TextonAsset& asset) {
    Json json = txn::describe(asset, {});
    json.erase("scale");
    json.erase("bias");
    json["kind"] = "texton";
    json["footprint_width"] = asset.texton.footprint().width;
    json["footprint_height"] = asset.texton.footprint().height;
    return json;
}

Result<void> run(const InfoArguments& options) {
    const auto loaded = loadTextonOrImage(options.path);
    if (!loaded)
        return loaded.error();
    Json json{{"file", options.path.string()}};
    json.update(std::visit([](const auto& value) { return describe(value); }, *loaded));
    if (options.json) {
        printJson(json);
        return {};
    }
    for (const auto& [key, value] : json.items()) {
        std::cout << key << std::string(key.size() < 20 ? 20 - key.size() : 1, ' ')
                  << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
    }
    return {};
}

} // namespace

void addInfo(CLI::App& app, Session& session) {
    auto* command = app.add_subcommand("info", "Tell what a picture or texton file holds");
    command->footer("Example:\n  texton info wood.exr");
    auto options = std::make_shared<InfoArguments>();
    command->add_option("FILE", options->path, "Picture or texton")->required();
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
