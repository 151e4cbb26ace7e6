// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/TextonAsset.h"

#include "core/base/Version.h"
#include "core/gaussian/Exemplar.h"
#include "core/spectral/BSpline.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace txn {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr int kMaxSupport = 16384;
constexpr int kMaxKernels = 64;
constexpr double kLargest = Exemplar::kLargestSample;

std::string_view shapeName(SupportShape shape) {
    switch (shape) {
    case SupportShape::Rectangle:
        return "rectangle";
    case SupportShape::Disc:
        return "disc";
    case SupportShape::Mask:
        break;
    }
    return "mask";
}

Error broken(const std::string& key) {
    return {ErrorCode::Unreadable, "its description has no usable '" + key + "'"};
}

/// A whole number within bounds, or a broken() error's key through ok.
bool readInt(const Json& json, const char* key, long long low, long long high, long long& value) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_number_integer())
        return false;
    value = it->get<long long>();
    return value >= low && value <= high;
}

bool readNumbers(const Json& json,
                 const char* key,
                 std::size_t count,
                 std::vector<double>& values) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_array() || it->size() != count)
        return false;
    values.clear();
    for (const auto& item : *it) {
        if (!item.is_number() || !(std::abs(item.get<double>()) <= kLargest))
            return false;
        values.push_back(item.get<double>());
    }
    return true;
}

bool readText(const Json& json, const char* key, std::string& text) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_string())
        return false;
    text = it->get<std::string>();
    return true;
}

bool readMaps(const Json& json, int channels, MaterialMaps& maps) {
    const auto it = json.find("maps");
    if (it == json.end())
        return true;
    if (!it->is_array())
        return false;
    for (const auto& item : *it) {
        MaterialMap map;
        std::string kind;
        long long count = 0;
        if (!item.is_object() || !readText(item, "name", map.name) ||
            !readText(item, "kind", kind) || !mapKindFromString(kind) ||
            !readInt(item, "channels", 1, kMaxExemplarChannels, count))
            return false;
        map.kind = *mapKindFromString(kind);
        map.channels = static_cast<int>(count);
        maps.push_back(std::move(map));
    }
    return areMapsOf(maps, channels);
}

} // namespace

Json describe(const TextonAsset& asset, const SampleCode& code) {
    const Texton& texton = asset.texton;
    Json json;
    json["format"] = "texton";
    json["version"] = kVersion;
    json["program"] = std::string("Texton Studio ") + kProgramVersion;
    json["exemplar"] = asset.exemplarName;
    json["channels"] = texton.channels();
    json["kernels"] = texton.kernelCount();
    json["interpolation_order"] = texton.interpolationOrder;
    json["frame"] = texton.frame();
    json["support_width"] = texton.support.size().width;
    json["support_height"] = texton.support.size().height;
    json["support_shape"] = shapeName(texton.support.shape());
    json["mean"] = texton.mean;
    json["scale"] = code.scale;
    json["bias"] = code.bias;
    json["color_space"] = texton.transfer == Transfer::Linear ? "linear" : "encoded";
    json["mni"] = asset.meanImpacts;
    json["process"] = toString(asset.process);
    json["seed"] = asset.seed.value;
    for (const MaterialMap& map : asset.maps)
        json["maps"].push_back(
            {{"name", map.name}, {"kind", toString(map.kind)}, {"channels", map.channels}});
    return json;
}

Result<Description> parseDescription(const Json& json) {
    if (!json.is_object())
        return Error{ErrorCode::Unreadable, "it is not a description of a texton"};
    std::string text;
    if (!readText(json, "format", text) || text != "texton")
        return Error{ErrorCode::Unreadable, "it is not a description of a texton"};
    long long number = 0;
    if (!readInt(json, "version", 1, 1 << 30, number))
        return broken("version");
    if (number > kVersion)
        return Error{ErrorCode::Unsupported, "it was made by a newer version of Texton Studio"};

    Description result;
    Texton& texton = result.asset.texton;
    long long channels = 0;
    long long width = 0;
    long long height = 0;
    if (!readInt(json, "channels", 1, kMaxExemplarChannels, channels))
        return broken("channels");
    if (!readInt(json, "kernels", 1, kMaxKernels, number))
        return broken("kernels");
    result.kernels = static_cast<int>(number);
    if (!readInt(json, "interpolation_order", 0, 5, number) ||
        !isInterpolationOrder(static_cast<int>(number)))
        return broken("interpolation_order");
    texton.interpolationOrder = static_cast<int>(number);
    if (!readInt(json, "frame", texton.frame(), texton.frame(), number))
        return broken("frame");
    if (!readInt(json, "support_width", 1, kMaxSupport, width))
        return broken("support_width");
    if (!readInt(json, "support_height", 1, kMaxSupport, height))
        return broken("support_height");
    const Size support{static_cast<int>(width), static_cast<int>(height)};
    if (!readText(json, "support_shape", text))
        return broken("support_shape");
    if (text == "disc" && width == height) {
        texton.support = Support::disc(support.width);
    } else if (text == "rectangle") {
        texton.support = Support::rectangle(support);
    } else if (text == "mask") {
        // Which samples: told by the kernels, see restoreMask().
        texton.support = *Support::mask(support, std::vector<std::uint8_t>(support.area(), 1));
    } else {
        return broken("support_shape");
    }
    const auto count = static_cast<std::size_t>(channels);
    if (!readNumbers(json, "mean", count, texton.mean))
        return broken("mean");
    if (!readNumbers(json, "scale", count, result.code.scale))
        return broken("scale");
    if (!readNumbers(json, "bias", count, result.code.bias))
        return broken("bias");
    if (!readText(json, "color_space", text) || (text != "linear" && text != "encoded"))
        return broken("color_space");
    texton.transfer = text == "linear" ? Transfer::Linear : Transfer::Encoded;
    const auto it = json.find("mni");
    if (it == json.end() || !it->is_number())
        return broken("mni");
    result.asset.meanImpacts = it->get<double>();
    if (!readText(json, "process", text) || !noiseProcessFromString(text))
        return broken("process");
    result.asset.process = *noiseProcessFromString(text);
    if (!checkNoiseParams({result.asset.process, result.asset.meanImpacts, {}, {}}))
        return broken("mni");
    if (!readInt(json, "seed", 0, 0xffffffffLL, number))
        return broken("seed");
    result.asset.seed.value = static_cast<std::uint32_t>(number);
    if (!readText(json, "exemplar", result.asset.exemplarName))
        return broken("exemplar");
    if (!readMaps(json, static_cast<int>(channels), result.asset.maps))
        return broken("maps");
    return result;
}

} // namespace txn
