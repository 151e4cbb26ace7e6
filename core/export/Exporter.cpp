// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/Exporter.h"

#include "core/base/PlainText.h"
#include "core/export/Coefficients.h"
#include "core/export/TextonFile.h"
#include "core/gaussian/Exemplar.h"
#include "core/image/TextAttributes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace txn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxSidecar = std::uintmax_t{1} << 20U;
constexpr double kLargestCode = 65535.0;
/// The code that stands for 0 in a 16-bit file, so that the frame decodes to exactly 0.
constexpr double kZeroCode = 32768.0;

enum class TextonFormat { Texton, OpenExr, Png };

Error inFile(const std::string& verb, const fs::path& path, const Error& error) {
    return {error.code, "cannot " + verb + " " + quoted(path) + ": " + error.message};
}

/// JSON text; file names in it may hold bytes that are not UTF-8.
std::string asText(const Json& json, int indent = -1) {
    return withEscapedControls(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

Result<TextonFormat> formatForPath(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    if (ending == ".texton")
        return TextonFormat::Texton;
    if (ending == ".exr")
        return TextonFormat::OpenExr;
    if (ending == ".png")
        return TextonFormat::Png;
    return Error{ErrorCode::Unsupported,
                 "cannot tell what to write to " + quoted(path) +
                     ": a texton is stored as .texton, .exr or .png"};
}

fs::path sidecarPath(const fs::path& path) {
    fs::path sidecar = path;
    sidecar += ".json";
    return sidecar;
}

SampleCode identityCode(int channels) {
    const auto count = static_cast<std::size_t>(channels);
    return {std::vector<double>(count, 1.0), std::vector<double>(count, 0.0)};
}

/// Scale and bias under which every coefficient fits into 16 bits and 0 stays 0.
SampleCode pngCode(const Texton& texton) {
    SampleCode code;
    for (int c = 0; c < texton.channels(); ++c) {
        double least = 0.0;
        double most = 0.0;
        for (const Image& kernel : texton.kernels) {
            const auto [low, high] = std::ranges::minmax(kernel.plane(c));
            least = std::min(least, static_cast<double>(low));
            most = std::max(most, static_cast<double>(high));
        }
        const double perCode = std::max(-least / kZeroCode, most / (kLargestCode - kZeroCode));
        const double scale = perCode > 0.0 ? perCode * kLargestCode : 1.0;
        code.scale.push_back(scale);
        code.bias.push_back(-scale * kZeroCode / kLargestCode);
    }
    return code;
}

/// The files that hold the samples of a texton that is written to path.
std::vector<fs::path>
pictureFiles(const fs::path& path, TextonFormat format, const MaterialMaps& maps) {
    if (format != TextonFormat::Png || maps.empty())
        return {path};
    std::vector<fs::path> files;
    for (const MaterialMap& map : maps)
        files.push_back(mapFile(path, map.name));
    return files;
}

/// Calls visit(kernel, channel, x, y, px, py): coefficient (x, y) and its place in the frame.
template <class Visit>
void forEachCoefficient(const Texton& texton, int kernels, Visit visit) {
    const Size support = texton.support.size();
    for (int q = 0; q < kernels; ++q) {
        for (int c = 0; c < texton.channels(); ++c) {
            for (int y = 0; y < support.height; ++y) {
                for (int x = 0; x < support.width; ++x)
                    visit(q, c, x, y, x + texton.frame(), y + texton.frame());
            }
        }
    }
}

Result<void> writeExr(const TextonAsset& asset,
                      const Json& description,
                      const fs::path& path,
                      OutputFiles& files) {
    SaveOptions options;
    options.sampleFormat = SampleFormat::Float;
    options.channelNames = coefficientNames(asset);
    for (const auto& [key, value] : description.items())
        options.attributes[std::string(kAttributePrefix) + key] = asText(value);
    return saveImage(framedCoefficients(asset.texton), path, options, &files);
}

/// count channels of the texton from the first one on, kernels below each other. Two channels are
/// red and green.
Result<void> writePng(const TextonAsset& asset,
                      const SampleCode& code,
                      int first,
                      int count,
                      const fs::path& path,
                      OutputFiles& files) {
    const Texton& texton = asset.texton;
    if (count > 3 || (count == 2 && asset.maps.empty()))
        return inFile("write",
                      path,
                      {ErrorCode::Unsupported,
                       "a PNG texton holds 1 or 3 channels and this one has " +
                           std::to_string(count) + "; use EXR"});
    const Size footprint = texton.footprint();
    Image image({footprint.width, footprint.height * texton.kernelCount()}, count == 1 ? 1 : 3);
    for (int c = 0; c < image.channels(); ++c)
        std::ranges::fill(image.plane(c), static_cast<float>(kZeroCode / kLargestCode));
    forEachCoefficient(texton,
                       texton.kernelCount(),
                       [&](int q, int c, int x, int y, int px, int py) {
                           if (c < first || c >= first + count)
                               return;
                           const auto i = static_cast<std::size_t>(c);
                           const double value =
                               texton.kernels[static_cast<std::size_t>(q)].at(x, y, c);
                           image.at(px, q * footprint.height + py, c - first) =
                               static_cast<float>((value - code.bias[i]) / code.scale[i]);
                       });
    SaveOptions options;
    options.sampleFormat = SampleFormat::UInt16;
    return saveImage(image, path, options, &files);
}

Result<void> writePngs(const TextonAsset& asset,
                       const SampleCode& code,
                       const fs::path& path,
                       OutputFiles& files) {
    if (asset.maps.empty())
        return writePng(asset, code, 0, asset.texton.channels(), path, files);
    const auto paths = pictureFiles(path, TextonFormat::Png, asset.maps);
    for (std::size_t m = 0; m < paths.size(); ++m) {
        if (auto ok = writePng(asset,
                               code,
                               firstChannel(asset.maps, m),
                               asset.maps[m].channels,
                               paths[m],
                               files);
            !ok)
            return ok;
    }
    return {};
}

Result<std::string> readText(const fs::path& path, std::uintmax_t limit) {
    std::error_code ec;
    const auto status = fs::status(path, ec);
    if (!fs::exists(status))
        return Error{ErrorCode::NotFound,
                     "there is no file " + quoted(path) + "; was it moved or renamed?"};
    if (!fs::is_regular_file(status))
        return Error{ErrorCode::Unreadable, quoted(path) + " is not a plain file"};
    const auto size = fs::file_size(path, ec);
    if (ec || size > limit)
        return Error{ErrorCode::TooLarge, quoted(path) + " is too large"};
    std::ifstream stream(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
        return Error{ErrorCode::Unreadable, "cannot read " + quoted(path) + "; may you open it?"};
    return text;
}

/// Whether there is a sidecar that claims to be one of ours, right or not.
bool hasSidecar(const fs::path& path) {
    const auto text = readText(sidecarPath(path), kMaxSidecar);
    if (!text)
        return false;
    const auto json = Json::parse(*text, nullptr, false);
    return json.is_object() && json.value("format", Json()) == "texton";
}

Result<Description> readSidecar(const fs::path& path) {
    const auto text = readText(sidecarPath(path), kMaxSidecar);
    if (!text)
        return text.error();
    const auto json = Json::parse(*text, nullptr, false);
    if (json.is_discarded())
        return Error{ErrorCode::Unreadable, quoted(sidecarPath(path)) + " is not valid JSON"};
    auto description = parseDescription(json);
    if (!description)
        return inFile("read", sidecarPath(path), description.error());
    return description;
}

/// A support of any shape is told by where the kernels are not zero.
void restoreMask(Texton& texton) {
    if (texton.support.shape() != SupportShape::Mask)
        return;
    std::vector<std::uint8_t> inside(texton.support.size().area(), 0);
    for (const Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c) {
            const auto plane = kernel.plane(c);
            for (std::size_t i = 0; i < plane.size(); ++i) {
                if (plane[i] != 0.0F)
                    inside[i] = 1;
            }
        }
    }
    if (auto mask = Support::mask(texton.support.size(), std::move(inside)))
        texton.support = *mask;
}

/// Whether the picture has the size and the channels of what is described.
bool fits(const Description& description, const LoadedImage& loaded, TextonFormat format) {
    const Texton& texton = description.asset.texton;
    const Size footprint = texton.footprint();
    const bool png = format == TextonFormat::Png;
    return loaded.image.size() ==
               Size{footprint.width, footprint.height * (png ? description.kernels : 1)} &&
           loaded.image.channels() == texton.channels() * (png ? 1 : description.kernels);
}

Result<TextonAsset> withKernels(Description description,
                                const LoadedImage& loaded,
                                TextonFormat format,
                                const fs::path& path) {
    Texton& texton = description.asset.texton;
    const Image& image = loaded.image;
    const Size footprint = texton.footprint();
    const int kernels = description.kernels;
    const bool png = format == TextonFormat::Png;
    const int channels = image.channels();
    if (!fits(description, loaded, format))
        return Error{ErrorCode::Unreadable,
                     "the picture in " + quoted(path) + " does not match its description"};
    texton.kernels.assign(static_cast<std::size_t>(kernels),
                          Image(texton.support.size(), texton.channels(), 0.0F, texton.transfer));
    // EXR files list their channels by name, in an order of their own.
    std::vector<int> source(static_cast<std::size_t>(channels));
    const auto names = coefficientNames(description.asset);
    for (std::size_t i = 0; !png && i < names.size(); ++i) {
        const auto it = std::ranges::find(loaded.channelNames, names[i]);
        if (it == loaded.channelNames.end())
            return Error{ErrorCode::Unreadable,
                         "the channel '" + names[i] + "' is missing in " + quoted(path)};
        source[i] = static_cast<int>(it - loaded.channelNames.begin());
    }
    bool usable = true;
    forEachCoefficient(texton, kernels, [&](int q, int c, int x, int y, int px, int py) {
        const int from = png ? c : source[static_cast<std::size_t>(q * texton.channels() + c)];
        const double sample = image.at(px, png ? q * footprint.height + py : py, from);
        const auto i = static_cast<std::size_t>(c);
        // 16-bit samples are whole codes: rounding undoes the float in between.
        const double value =
            png ? (std::round(sample * kLargestCode) / kLargestCode) * description.code.scale[i] +
                      description.code.bias[i]
                : sample * description.code.scale[i] + description.code.bias[i];
        const auto coefficient = static_cast<float>(value);
        usable = usable && std::abs(coefficient) <= Exemplar::kLargestSample; // not NaN either
        texton.kernels[static_cast<std::size_t>(q)].at(x, y, c) = coefficient;
    });
    if (!usable)
        return Error{ErrorCode::Unreadable,
                     quoted(path) + " holds coefficients that are not usable numbers"};
    restoreMask(texton);
    return std::move(description.asset);
}

/// The description in an EXR header, or nothing for other pictures.
std::optional<Json> headerDescription(const LoadedImage& loaded) {
    Json json;
    for (const auto& [name, value] : loaded.attributes) {
        if (!name.starts_with(kAttributePrefix))
            continue;
        auto parsed = Json::parse(value, nullptr, false);
        if (!parsed.is_discarded())
            json[name.substr(kAttributePrefix.size())] = std::move(parsed);
    }
    return json.contains("format") ? std::optional(std::move(json)) : std::nullopt;
}

Result<TextonAsset> loadTextonText(const fs::path& path) {
    const auto text = readText(path, std::uintmax_t{1} << 31U);
    if (!text)
        return text.error();
    auto asset = fromTextonFile(*text);
    if (!asset)
        return inFile("read", path, asset.error());
    if (!hasSidecar(path))
        return asset;
    const auto sidecar = readSidecar(path);
    if (!sidecar)
        return sidecar.error();
    const Texton& described = sidecar->asset.texton;
    Texton& texton = asset->texton;
    if (described.support.size() == texton.support.size() &&
        described.interpolationOrder == texton.interpolationOrder) {
        texton.support = described.support;
        texton.transfer = described.transfer;
        texton.kernels.front().setTransfer(described.transfer);
        restoreMask(texton);
        asset->process = sidecar->asset.process;
        asset->meanImpacts = sidecar->asset.meanImpacts;
        asset->seed = sidecar->asset.seed;
        asset->exemplarName = sidecar->asset.exemplarName;
        asset->maps = sidecar->asset.maps;
    }
    return asset;
}

/// The picture that the PNGs of a set would be in one file.
Result<LoadedImage>
loadSet(const fs::path& path, const MaterialMaps& maps, const LoadOptions& options) {
    std::optional<LoadedImage> whole;
    int next = 0;
    for (const MaterialMap& map : maps) {
        const fs::path file = mapFile(path, map.name);
        auto part = loadImage(file, options);
        if (!part)
            return part.error();
        const Image& image = part->image;
        if (!whole) {
            whole = *part;
            whole->image = Image(image.size(), channelCount(maps));
        }
        if (image.size() != whole->image.size() || image.channels() < map.channels)
            return Error{ErrorCode::Unreadable,
                         "the picture in " + quoted(file) + " does not match its description"};
        for (int c = 0; c < map.channels; ++c)
            std::ranges::copy(image.plane(c), whole->image.plane(next++).begin());
    }
    return std::move(*whole);
}

bool startsLikeTextonText(const fs::path& path) {
    std::error_code ec;
    if (!fs::is_regular_file(path, ec))
        return false; // a pipe would block
    std::ifstream stream(path, std::ios::binary);
    std::string start(6, '\0');
    return stream.read(start.data(), 6) && start == "TEXTON";
}

} // namespace

Result<void> addTexton(const TextonAsset& asset,
                       const fs::path& path,
                       OutputFiles& files,
                       std::vector<fs::path>& written) {
    const auto format = formatForPath(path);
    if (!format)
        return format.error();
    const SampleCode code = *format == TextonFormat::Png ? pngCode(asset.texton)
                                                         : identityCode(asset.texton.channels());
    const Json description = describe(asset, code);
    if (*format == TextonFormat::Texton) {
        const auto text = toTextonFile(asset);
        if (!text)
            return inFile("write", path, text.error());
        if (const auto ok = files.addText(path, *text); !ok)
            return ok.error();
    } else {
        const auto ok = *format == TextonFormat::Png ? writePngs(asset, code, path, files)
                                                     : writeExr(asset, description, path, files);
        if (!ok)
            return ok.error();
    }
    std::ranges::copy(pictureFiles(path, *format, asset.maps), std::back_inserter(written));
    written.push_back(sidecarPath(path));
    return files.addText(sidecarPath(path), asText(description, 2) + "\n");
}

Result<std::vector<fs::path>> saveTexton(const TextonAsset& asset,
                                         std::span<const fs::path> outputs) {
    OutputFiles files;
    std::vector<fs::path> written;
    for (const fs::path& path : outputs) {
        if (const auto ok = addTexton(asset, path, files, written); !ok)
            return ok.error();
    }
    if (const auto ok = files.commit(); !ok)
        return ok.error();
    return written;
}

std::vector<fs::path> textonFiles(const fs::path& path, const MaterialMaps& maps) {
    const fs::path base = path.extension() == ".json" ? fs::path(path).replace_extension() : path;
    const auto format = formatForPath(base);
    auto files = pictureFiles(base, format ? *format : TextonFormat::OpenExr, maps);
    files.push_back(sidecarPath(base));
    return files;
}

Result<void> checkTextonOutputs(std::span<const fs::path> outputs, const MaterialMaps& maps) {
    OutputFiles files;
    for (const fs::path& path : outputs) {
        const auto format = formatForPath(path);
        if (!format)
            return format.error();
        const int channels = channelCount(maps);
        if (*format == TextonFormat::Texton && !maps.empty() && channels != 1 && channels != 3)
            return inFile("write",
                          path,
                          {ErrorCode::Unsupported,
                           "a .texton file holds 1 or 3 channels and these maps have " +
                               std::to_string(channels) + "; use EXR"});
        for (const MaterialMap& map : maps) {
            if (*format == TextonFormat::Png && map.channels > 3)
                return inFile("write",
                              path,
                              {ErrorCode::Unsupported,
                               "a PNG holds at most 3 channels and the map '" + map.name +
                                   "' has " + std::to_string(map.channels) + "; use EXR"});
        }
        for (const fs::path& file : textonFiles(path, maps)) {
            if (const auto ok = files.add(file); !ok)
                return ok.error();
        }
    }
    return {};
}

Result<std::variant<TextonAsset, LoadedImage>> loadTextonOrImage(const fs::path& path,
                                                                 const LoadOptions& options) {
    using Loaded = std::variant<TextonAsset, LoadedImage>;
    const auto asLoaded = [](Result<TextonAsset> asset) -> Result<Loaded> {
        if (!asset)
            return asset.error();
        return Loaded(std::move(*asset));
    };
    if (const fs::path base = fs::path(path).replace_extension();
        path.extension() == ".json" && hasSidecar(base)) {
        auto loaded = loadTextonOrImage(base, options);
        if (!loaded || std::holds_alternative<TextonAsset>(*loaded))
            return loaded;
        return Error{ErrorCode::Unreadable,
                     "the picture in " + quoted(base) + " does not match its description"};
    }
    const auto format = formatForPath(path);
    std::error_code unknown; // of names too long, say: loadImage tells
    if (format && *format == TextonFormat::Png && !fs::exists(path, unknown) && !unknown &&
        hasSidecar(path)) {
        auto description = readSidecar(path);
        if (!description)
            return description.error();
        if (!description->asset.maps.empty()) {
            const auto set = loadSet(path, description->asset.maps, options);
            if (!set)
                return set.error();
            return asLoaded(withKernels(std::move(*description), *set, TextonFormat::Png, path));
        }
    }
    if (startsLikeTextonText(path) || (format && *format == TextonFormat::Texton))
        return asLoaded(loadTextonText(path));
    auto image = loadImage(path, options);
    if (!image)
        return image.error();
    if (const auto json = headerDescription(*image)) {
        auto description = parseDescription(*json);
        if (!description)
            return inFile("read", path, description.error());
        return asLoaded(withKernels(std::move(*description), *image, TextonFormat::OpenExr, path));
    }
    if (image->format == ImageFormat::Png && hasSidecar(path)) {
        auto description = readSidecar(path);
        if (!description)
            return description.error();
        // A sidecar may be left over from a texton that this picture has replaced.
        if (fits(*description, *image, TextonFormat::Png))
            return asLoaded(withKernels(std::move(*description), *image, TextonFormat::Png, path));
    }
    return Loaded(std::move(*image));
}

Result<TextonAsset> loadTexton(const fs::path& path) {
    auto loaded = loadTextonOrImage(path);
    if (!loaded)
        return loaded.error();
    if (auto* asset = std::get_if<TextonAsset>(&*loaded))
        return std::move(*asset);
    if (hasSidecar(path))
        return Error{ErrorCode::Unreadable,
                     "the picture in " + quoted(path) + " does not match its description"};
    return Error{ErrorCode::Unreadable,
                 quoted(path) + " is a picture and not a texton" +
                     (std::get<LoadedImage>(*loaded).format == ImageFormat::Png
                          ? "; a PNG texton needs its .json file beside it"
                          : "; make one with 'texton compute'")};
}

} // namespace txn
