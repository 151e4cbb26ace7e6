// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageFormats.h"

#include "core/base/OutputFiles.h"

#include <algorithm>
#include <array>
#include <limits>

namespace txn {
namespace {

using namespace std::string_view_literals;

constexpr std::array kPngEndings{"png"sv};
constexpr std::array kJpegEndings{"jpg"sv, "jpeg"sv, "jpe"sv, "jfif"sv};
constexpr std::array kTiffEndings{"tif"sv, "tiff"sv};
constexpr std::array kExrEndings{"exr"sv};
constexpr std::array kHdrEndings{"hdr"sv, "rgbe"sv};
constexpr std::array kTgaEndings{"tga"sv};
constexpr std::array kBmpEndings{"bmp"sv};
constexpr std::array kWebPEndings{"webp"sv};

constexpr std::array k8{SampleFormat::UInt8};
constexpr std::array k8And16{SampleFormat::UInt8, SampleFormat::UInt16};
constexpr std::array kTiffSamples{SampleFormat::UInt8, SampleFormat::UInt16, SampleFormat::Float};
constexpr std::array kExrSamples{SampleFormat::Half, SampleFormat::Float};
constexpr std::array kFloat{SampleFormat::Float};

// Types whose second or fourth channel could only be alpha hold one or three.
constexpr std::array kGrayOrRgb{1, 3};
constexpr std::array kRgb{3};

constexpr int kAnySide = std::numeric_limits<int>::max();
constexpr int kPngSide = 1'000'000; // libpng's own limit

constexpr std::array<FormatTraits, 8> kTraits{{
    {ImageFormat::Png, "PNG", "png", kPngEndings, k8And16, kGrayOrRgb, kPngSide},
    {ImageFormat::Jpeg, "JPEG", "jpeg", kJpegEndings, k8, kGrayOrRgb, 65500},
    {ImageFormat::Tiff, "TIFF", "tiff", kTiffEndings, kTiffSamples, {}, kAnySide},
    {ImageFormat::OpenExr, "EXR", "openexr", kExrEndings, kExrSamples, {}, kAnySide},
    {ImageFormat::Hdr, "HDR", "hdr", kHdrEndings, kFloat, kRgb, kAnySide},
    {ImageFormat::Tga, "TGA", "targa", kTgaEndings, k8, kGrayOrRgb, 65535},
    {ImageFormat::Bmp, "BMP", "bmp", kBmpEndings, k8, kGrayOrRgb, kAnySide},
    {ImageFormat::WebP, "WebP", "webp", kWebPEndings, k8, kRgb, 16383},
}};

} // namespace

const FormatTraits& formatTraits(ImageFormat format) {
    return *std::find_if(kTraits.begin(), kTraits.end(), [&](const FormatTraits& traits) {
        return traits.format == format;
    });
}

std::string_view sampleFormatName(SampleFormat format) {
    switch (format) {
    case SampleFormat::UInt8:
        return "8-bit";
    case SampleFormat::UInt16:
        return "16-bit";
    case SampleFormat::Half:
        return "half float";
    case SampleFormat::Float:
        break;
    }
    return "float";
}

Result<ImageFormat> imageFormatForPath(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    if (!ending.empty())
        ending.erase(0, 1);
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    for (const FormatTraits& traits : kTraits) {
        if (std::find(traits.endings.begin(), traits.endings.end(), ending) != traits.endings.end())
            return traits.format;
    }
    return Error{ErrorCode::Unsupported,
                 "the name " + quoted(path) +
                     " does not end in a known image type; use .png, .jpg, .tif, .exr, .hdr, "
                     ".tga, .bmp or .webp"};
}

} // namespace txn
