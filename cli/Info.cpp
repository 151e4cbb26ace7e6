// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/Report.h"
#include "core/export/Exporter.h"
#include "core/spectral/PeriodicComponent.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace txn::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::filesystem::path path;
    bool json = false;
};

const char* name(ImageFormat format) {
    switch (format) {
    case ImageFormat::Png:
        return "PNG";
    case ImageFormat::Jpeg:
        return "JPEG";
    case ImageFormat::Tiff:
        return "TIFF";
    case ImageFormat::OpenExr:
        return "EXR";
    case ImageFormat::Hdr:
        return "HDR";
    case ImageFormat::Tga:
        return "TGA";
    case ImageFormat::Bmp:
        return "BMP";
    case ImageFormat::WebP:
        break;
    }
    return "WebP";
}

const char* name(SampleFormat format) {
    switch (format) {
    case SampleFormat::UInt8:
        return "8 bit";
    case SampleFormat::UInt16:
        return "16 bit";
    case SampleFormat::Half:
        return "half float";
    case SampleFormat::Float:
        break;
    }
    return "float";
}

Json describe(const LoadedImage& loaded) {
    Json json;
    json["kind"] = "picture";
    json["format"] = name(loaded.format);
    json["width"] = loaded.image.width();
    json["height"] = loaded.image.height();
    json["channels"] = loaded.image.channels();
    json["samples"] = name(loaded.sampleFormat);
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

Result<void> run(const Options& options) {
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
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->path, "Picture or texton")->required();
    command->add_flag("--json", options->json, "Print a JSON object instead of text");
    command->callback([options, &session] { session.run = [options] { return run(*options); }; });
}

} // namespace txn::cli
