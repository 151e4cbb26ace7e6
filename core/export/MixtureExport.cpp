// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/MixtureExport.h"

#include "core/base/PlainText.h"
#include "core/base/Version.h"
#include "core/export/Coefficients.h"
#include "core/export/Exporter.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace txn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kArrayFile = "textons.exr";
constexpr const char* kMapFile = "map.png";
constexpr const char* kDescriptionFile = "mixture.json";

std::string twoDigits(std::size_t number) {
    return std::string(number < 10 ? 1 : 0, '0') + std::to_string(number);
}

std::string layerOf(std::size_t texton) {
    return "texton" + twoDigits(texton);
}

std::string fileOf(std::size_t texton) {
    return "texton_" + twoDigits(texton) + ".exr";
}

TextonAsset textonAsset(const MixtureAsset& asset, std::size_t texton) {
    return {asset.mixture.textons[texton],
            asset.process,
            asset.meanImpacts,
            asset.seed,
            asset.exemplarA + " to " + asset.exemplarB,
            asset.maps};
}

Json describe(const MixtureAsset& asset) {
    const Texton& first = asset.mixture.textons.front();
    const auto count = static_cast<std::size_t>(first.channels());
    // The parts that all textons have in common are said as for one of them.
    Json json = describe(textonAsset(asset, 0),
                         SampleCode{std::vector<double>(count, 1.0), std::vector<double>(count)});
    json["format"] = "texton-mixture";
    for (const char* ofOne : {"exemplar", "mean", "scale", "bias"})
        json.erase(ofOne);
    json["exemplars"] = {asset.exemplarA, asset.exemplarB};
    for (std::size_t r = 0; r < asset.mixture.textons.size(); ++r)
        json["textons"].push_back({{"rho", asset.rhos[r]},
                                   {"distance", asset.distances[r]},
                                   {"mean", asset.mixture.textons[r].mean},
                                   {"layer", layerOf(r)},
                                   {"file", fileOf(r)}});
    const MapPlacement& place = asset.mixture.map.placement;
    json["map"] = {
        {"file", kMapFile},
        {"left", place.left},
        {"top", place.top},
        {"width", place.width},
        {"height", place.height},
        {"boundary", asset.mixture.map.boundary == MapBoundary::Repeat ? "repeat" : "clamp"}};
    return json;
}

Result<void> addArray(const MixtureAsset& asset, const fs::path& path, OutputFiles& files) {
    const auto& textons = asset.mixture.textons;
    const auto names = coefficientNames(textonAsset(asset, 0));
    Image all(textons.front().footprint(),
              static_cast<int>(textons.size() * names.size()),
              0.0F,
              textons.front().transfer);
    SaveOptions options;
    options.sampleFormat = SampleFormat::Float;
    for (std::size_t r = 0; r < textons.size(); ++r) {
        std::ranges::copy(framedCoefficients(textons[r]).samples(),
                          all.plane(static_cast<int>(r * names.size())).begin());
        for (const std::string& name : names)
            options.channelNames.push_back(layerOf(r) + "." + name);
    }
    return saveImage(all, path, options, &files);
}

/// Whether it was missing.
Result<bool> makeFolder(const fs::path& folder) {
    std::error_code error;
    const bool made = fs::create_directory(folder, error);
    if (error)
        return Error{ErrorCode::Unwritable,
                     "cannot make the folder " + quoted(folder) + ": " + error.message()};
    return made;
}

Result<void> writeMixture(const MixtureAsset& asset, const fs::path& folder) {
    OutputFiles files;
    if (auto ok = addArray(asset, folder / kArrayFile, files); !ok)
        return ok;
    const std::string text =
        withEscapedControls(describe(asset).dump(2, ' ', false, Json::error_handler_t::replace)) +
        "\n";
    if (auto ok = files.addText(folder / kDescriptionFile, text); !ok)
        return ok;
    if (auto ok = addMixingMap(asset.mixture.map, folder / kMapFile, files); !ok)
        return ok;
    std::vector<fs::path> written;
    for (std::size_t r = 0; r < asset.mixture.textons.size(); ++r) {
        if (auto ok = addTexton(textonAsset(asset, r), folder / fileOf(r), files, written); !ok)
            return ok;
    }
    return files.commit();
}

} // namespace

std::vector<fs::path> mixtureFiles(const fs::path& folder, std::size_t textons) {
    std::vector<fs::path> files{folder / kArrayFile, folder / kDescriptionFile, folder / kMapFile};
    for (std::size_t r = 0; r < textons; ++r)
        std::ranges::copy(textonFiles(folder / fileOf(r), {}), std::back_inserter(files));
    return files;
}

Result<void> addMixingMap(const MixingMap& map, const fs::path& path, OutputFiles& files) {
    const auto format = imageFormatForPath(path);
    if (!format)
        return format.error();
    SaveOptions options;
    if (*format == ImageFormat::Png || *format == ImageFormat::Tiff)
        options.sampleFormat = SampleFormat::UInt16;
    return saveImage(map.rho, path, options, &files);
}

Result<void> checkMixtureOutputs(const fs::path& folder, std::size_t textons) {
    std::error_code unknown; // told below
    OutputFiles files;
    if (!fs::is_directory(folder, unknown)) {
        if (fs::exists(fs::symlink_status(folder, unknown)))
            return Error{ErrorCode::Unwritable, quoted(folder) + " is not a folder"};
        // A folder can be made where a file can.
        if (const auto ok = files.add(folder); !ok)
            return ok.error();
        return {};
    }
    for (const fs::path& file : mixtureFiles(folder, textons)) {
        if (const auto ok = files.add(file); !ok)
            return ok.error();
    }
    return {};
}

Result<std::vector<fs::path>> saveMixture(const MixtureAsset& asset, const fs::path& folder) {
    const auto made = makeFolder(folder);
    if (!made)
        return made.error();
    if (const auto ok = writeMixture(asset, folder); !ok) {
        std::error_code notEmpty;
        if (*made)
            fs::remove(folder, notEmpty);
        return ok.error();
    }
    return mixtureFiles(folder, asset.mixture.textons.size());
}

} // namespace txn
