// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageHeader.h"

#include "core/base/OutputFiles.h"
#include "core/image/ImageFormats.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace txn {
namespace {

using namespace std::string_view_literals;
using Path = std::filesystem::path;

constexpr auto kCutShort = "the file is cut short or damaged"sv;
constexpr std::uint64_t kMaxProfileBytes = std::uint64_t{1} << 24U;
constexpr std::uint64_t kDeflateRatio = 1032; // a property of the format

/// One look at one file: the checks of each type share the path and the bytes.
class HeaderReader {
  public:
    HeaderReader(const Path& path, FileBytes& bytes) : m_path(path), m_bytes(bytes) {}

    Result<ImageHeader> read(const LoadOptions& options);

  private:
    std::optional<ImageFormat> sniff();
    bool looksLikeTga();

    Result<void> readPng();
    Result<void> readJpeg();
    Result<void> checkJpegSegment(std::uint8_t marker, std::uint64_t at, std::uint64_t length);
    Result<void> readTiff();
    Result<void> readExr();
    Result<void> readHdr();
    Result<void> readTga();
    Result<void> checkTgaPalette(std::uint64_t at, std::uint64_t pixels, bool runLength);
    Result<void> readBmp();
    Result<void> readWebP();
    void readExifOrientation(std::uint64_t at, std::uint64_t length);

    Error damaged(std::string_view reason) const {
        return damagedImage(m_path, m_header.format, reason);
    }
    Error variant(std::string_view which) const {
        return {ErrorCode::Unreadable,
                "cannot read " + quoted(m_path) + ": " + std::string(which) +
                    "; save it in another way, for example as PNG"};
    }
    std::uint64_t pixels() const { return m_header.width * m_header.height; }

    const Path& m_path;
    FileBytes& m_bytes;
    ImageHeader m_header;
};

Result<ImageHeader> HeaderReader::read(const LoadOptions& options) {
    const auto format = sniff();
    if (!format)
        return Error{ErrorCode::Unreadable,
                     quoted(m_path) +
                         " is not a PNG, JPEG, TIFF, EXR, HDR, TGA, BMP or WebP image"};
    m_header.format = *format;
    Result<void> result;
    switch (*format) {
    case ImageFormat::Png:
        result = readPng();
        break;
    case ImageFormat::Jpeg:
        result = readJpeg();
        break;
    case ImageFormat::Hdr:
        result = readHdr();
        break;
    case ImageFormat::Tga:
        result = readTga();
        break;
    case ImageFormat::Bmp:
        result = readBmp();
        break;
    case ImageFormat::WebP:
        result = readWebP();
        break;
    case ImageFormat::Tiff:
        result = readTiff();
        break;
    case ImageFormat::OpenExr:
        result = readExr();
        break;
    }
    // First, since a file that is both too large and too short is better called too large.
    if (m_header.channels > 0) {
        if (auto checked = checkImageSize(m_path,
                                          m_header.width,
                                          m_header.height,
                                          static_cast<std::uint64_t>(m_header.channels),
                                          options);
            !checked)
            return checked.error();
    }
    if (!result)
        return result.error();
    if (!m_bytes.ok())
        return damaged(kCutShort);
    return std::move(m_header);
}

std::optional<ImageFormat> HeaderReader::sniff() {
    const auto starts = [&](std::string_view magic) { return m_bytes.matches(0, magic); };
    if (starts("\x89PNG\r\n\x1a\n"sv))
        return ImageFormat::Png;
    if (starts("\xff\xd8\xff"sv))
        return ImageFormat::Jpeg;
    if (starts("II*\0"sv) || starts("MM\0*"sv) || starts("II+\0"sv) || starts("MM\0+"sv))
        return ImageFormat::Tiff;
    if (starts("\x76\x2f\x31\x01"sv))
        return ImageFormat::OpenExr;
    if (starts("#?RADIANCE"sv) || starts("#?RGBE"sv))
        return ImageFormat::Hdr;
    if (starts("RIFF"sv) && m_bytes.matches(8, "WEBP"sv))
        return ImageFormat::WebP;
    if (starts("BM"sv) && m_bytes.has(0, 26))
        return ImageFormat::Bmp;
    if (looksLikeTga())
        return ImageFormat::Tga;
    return std::nullopt;
}

bool HeaderReader::looksLikeTga() {
    // There is no magic number: the name or the footer of version 2 must vouch for it.
    const auto ending = imageFormatForPath(m_path);
    const bool named = ending && *ending == ImageFormat::Tga;
    const bool signedBelow =
        m_bytes.size() >= 44 && m_bytes.matches(m_bytes.size() - 18, "TRUEVISION-XFILE.\0"sv);
    if (!m_bytes.has(0, 18) || (!named && !signedBelow))
        return false;
    const auto type = m_bytes.u8(2);
    const auto bits = m_bytes.u8(16);
    return m_bytes.u8(1) <= 1 && ((type >= 1 && type <= 3) || (type >= 9 && type <= 11)) &&
           (bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32);
}

Result<void> HeaderReader::readPng() {
    if (!m_bytes.has(8, 25) || m_bytes.be32(8) != 13 || !m_bytes.matches(12, "IHDR"sv))
        return damaged(kCutShort);
    m_header.width = m_bytes.be32(16);
    m_header.height = m_bytes.be32(20);
    const std::uint64_t depth = m_bytes.u8(24);
    const auto colorType = m_bytes.u8(25);
    const bool palette = colorType == 3;
    const std::uint64_t stored = colorType == 2 ? 3 : colorType == 4 ? 2 : colorType == 6 ? 4 : 1;
    m_header.channels = palette ? 3 : static_cast<int>(stored);

    // Without this walk a file that lost its end but no pixels, or its last checksum, would pass.
    std::uint64_t compressed = 0;
    bool transparency = false;
    std::uint64_t at = 8;
    while (true) {
        if (!m_bytes.has(at, 12))
            return damaged(kCutShort);
        const std::uint64_t length = m_bytes.be32(at);
        if (!m_bytes.has(at, length + 12))
            return damaged(kCutShort);
        if (m_bytes.matches(at + 4, "IDAT"sv))
            compressed += length;
        else if (m_bytes.matches(at + 4, "tRNS"sv))
            transparency = true;
        else if (m_bytes.matches(at + 4, "IEND"sv))
            break;
        at += length + 12;
    }
    m_header.channels += transparency ? 1 : 0;
    const std::uint64_t rowBytes = (m_header.width * stored * depth + 7) / 8 + 1;
    const std::uint64_t possible = kDeflateRatio * (compressed + 1);
    if (m_header.height > possible / rowBytes)
        return damaged("it holds too little data for its size");
    return {};
}

Result<void> HeaderReader::readJpeg() {
    std::uint64_t at = 2;
    bool scanSeen = false;
    bool arithmetic = false;
    while (true) {
        // At a marker: fill bytes may stand before it.
        if (!m_bytes.has(at, 2))
            return damaged(kCutShort);
        if (m_bytes.u8(at) != 0xff)
            return damaged("a marker is missing");
        const auto marker = m_bytes.u8(at + 1);
        if (marker == 0xff) {
            ++at;
            continue;
        }
        if (marker == 0xd9)
            break;
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
            at += 2;
            continue;
        }
        const std::uint64_t length = m_bytes.be16(at + 2);
        if (length < 2 || !m_bytes.has(at + 2, length))
            return damaged(kCutShort);
        if (auto checked = checkJpegSegment(marker, at + 4, length - 2); !checked)
            return checked.error();
        arithmetic = arithmetic || (marker >= 0xc9 && marker <= 0xcf && marker != 0xcc);
        at += 2 + length;
        if (marker != 0xda)
            continue;
        scanSeen = true;
        // Coded data: a marker is ff followed by neither 0, nor another ff, nor a restart.
        while (true) {
            const auto found = m_bytes.find(0xff, at);
            if (!found || !m_bytes.has(*found, 2))
                return damaged(kCutShort);
            at = *found;
            const auto next = m_bytes.u8(at + 1);
            if (next != 0 && next != 0xff && (next < 0xd0 || next > 0xd7))
                break;
            at += next == 0xff ? 1 : 2;
        }
    }
    if (!scanSeen || m_header.channels == 0)
        return damaged("it holds no picture");
    // A Huffman coded block of 64 samples takes two bits or more, or one in a progressive file,
    // and chroma may be stored at a sixteenth: below 1500 samples a byte.
    const std::uint64_t samples = pixels() * static_cast<std::uint64_t>(m_header.channels);
    if (!arithmetic && samples / 4096 > m_bytes.size())
        return damaged("it holds too little data for its size");
    return {};
}

Result<void>
HeaderReader::checkJpegSegment(std::uint8_t marker, std::uint64_t at, std::uint64_t length) {
    const bool frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) {
        if (length < 6 || m_header.channels != 0)
            return damaged("its frame header is wrong");
        if (m_bytes.u8(at) != 8)
            return variant("this JPEG does not have 8 bits per sample");
        m_header.height = m_bytes.be16(at + 1);
        m_header.width = m_bytes.be16(at + 3);
        const int stored = m_bytes.u8(at + 5);
        if (stored != 1 && stored != 3 && stored != 4)
            return variant("this JPEG has neither 1 nor 3 nor 4 channels");
        m_header.channels = stored == 4 ? 3 : stored;
    }
    // OpenImageIO 2.4 computes negative lengths from blocks shorter than their own headers.
    if ((marker == 0xe1 && m_bytes.matches(at, "Exif"sv) && length < 14) ||
        (marker == 0xe2 && m_bytes.matches(at, "ICC_PROFILE"sv) && length < 14))
        return damaged("a block of metadata is broken");
    if (marker == 0xed && m_bytes.matches(at, "Photoshop 3.0"sv)) {
        if (length < 26)
            return damaged("a block of metadata is broken");
        if (m_bytes.matches(at + 14, "8BIM\x04\x04"sv) && m_bytes.be16(at + 24) > length - 26)
            return damaged("a block of metadata is broken");
    }
    return {};
}

/// Whether the first directory and all that it points to lie inside the file: libtiff passes over
/// tags that do not. The sizes are left to it.
Result<void> HeaderReader::readTiff() {
    const bool little = m_bytes.u8(0) == 'I';
    const bool big = m_bytes.u8(little ? 2 : 3) == '+';
    const auto u16 = [&](std::uint64_t at) -> std::uint64_t {
        return little ? m_bytes.le16(at) : m_bytes.be16(at);
    };
    const auto u32 = [&](std::uint64_t at) -> std::uint64_t {
        return little ? m_bytes.le32(at) : m_bytes.be32(at);
    };
    const auto u64 = [&](std::uint64_t at) -> std::uint64_t {
        return little ? u32(at) | (u32(at + 4) << 32U) : (u32(at) << 32U) | u32(at + 4);
    };
    const auto word = [&](std::uint64_t at) { return big ? u64(at) : u32(at); };
    const std::uint64_t wordBytes = big ? 8 : 4;

    const std::uint64_t directory = word(big ? 8 : 4);
    const std::uint64_t countBytes = big ? 8 : 2;
    if (!m_bytes.has(directory, countBytes))
        return damaged(kCutShort);
    const std::uint64_t entries = big ? u64(directory) : u16(directory);
    const std::uint64_t entryBytes = 4 + 2 * wordBytes;
    if (entries > UINT16_MAX || !m_bytes.has(directory, countBytes + entries * entryBytes))
        return damaged(kCutShort);
    // Bytes of one value of each field type; 0 for those that nobody knows.
    constexpr std::array<std::uint8_t, 19>
        kTypeBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t entry = directory + countBytes + i * entryBytes;
        const std::uint64_t type = u16(entry + 2);
        const std::uint64_t count = word(entry + 4);
        const std::uint64_t each = type < kTypeBytes.size() ? kTypeBytes[type] : 0;
        if (each == 0 || count <= wordBytes / each)
            continue;
        if (count > m_bytes.size() || !m_bytes.has(word(entry + 4 + wordBytes), count * each))
            return damaged(kCutShort);
    }
    return {};
}

/// Whether all header attributes lie inside the file: OpenEXR allocates what their lengths say. The
/// sizes of the image and its table of chunks it compares with the file itself.
Result<void> HeaderReader::readExr() {
    const bool multiPart = (m_bytes.le32(4) & 0x1000U) != 0;
    std::uint64_t at = 8;
    bool first = true; // of its header
    while (true) {
        const auto nameEnd = m_bytes.find(0, at);
        if (!nameEnd)
            return damaged(kCutShort);
        if (*nameEnd == at) { // an empty name ends a header, and an empty header ends the last
            if (!multiPart || first)
                return {};
            first = true;
            ++at;
            continue;
        }
        first = false;
        const auto typeEnd = m_bytes.find(0, *nameEnd + 1);
        if (!typeEnd || *typeEnd - at > 1024 || !m_bytes.has(*typeEnd + 1, 4))
            return damaged(kCutShort);
        const std::uint64_t length = m_bytes.le32(*typeEnd + 1);
        at = *typeEnd + 5;
        if (!m_bytes.has(at, length))
            return damaged(kCutShort);
        at += length;
    }
}

Result<void> HeaderReader::readHdr() {
    std::uint64_t at = 0;
    std::string line;
    // The reader of OpenImageIO stops after 100 lines as well.
    for (int count = 0; count < 102; ++count) {
        const auto end = m_bytes.find('\n', at);
        if (!end || *end - at > 4096)
            return damaged("its header has no end");
        const auto text = m_bytes.copy(at, *end - at);
        line.assign(text.begin(), text.end());
        at = *end + 1;
        if (line.empty())
            break;
        const auto equals = line.find('=');
        if (line.starts_with("texton:") && equals != std::string::npos)
            m_header.attributes[line.substr(0, equals)] = line.substr(equals + 1);
    }
    const auto end = m_bytes.find('\n', at);
    if (!line.empty() || !end || *end - at > 128)
        return damaged("it does not give its size");
    const auto text = m_bytes.copy(at, *end - at);
    std::string size(text.begin(), text.end());
    // "-Y height +X width", or the axes the other way round.
    char* rest = nullptr;
    if (size.size() < 7)
        return damaged("it does not give its size");
    const auto first = std::strtoull(size.c_str() + 2, &rest, 10);
    while (*rest == ' ')
        ++rest;
    const auto second = *rest != '\0' && rest[1] != '\0' ? std::strtoull(rest + 2, nullptr, 10) : 0;
    m_header.height = std::min<std::uint64_t>(first, UINT32_MAX);
    m_header.width = std::min<std::uint64_t>(second, UINT32_MAX);
    m_header.channels = 3;
    // Two bytes code at most 127 equal values of one of four planes.
    if (pixels() / 16 > m_bytes.size() - *end)
        return damaged(kCutShort);
    return {};
}

Result<void> HeaderReader::readTga() {
    const std::uint64_t idLength = m_bytes.u8(0);
    const bool palette = m_bytes.u8(1) != 0;
    const int type = m_bytes.u8(2) & 7;
    const bool runLength = m_bytes.u8(2) > 8;
    const auto firstEntry = m_bytes.le16(3);
    const std::uint64_t entries = m_bytes.le16(5);
    const int entryBits = m_bytes.u8(7);
    m_header.width = m_bytes.le16(12);
    m_header.height = m_bytes.le16(14);
    const int bits = m_bytes.u8(16);
    const bool alphaBits = (m_bytes.u8(17) & 8U) != 0;
    const bool known = type == 1   ? palette && bits == 8 && firstEntry == 0
                       : type == 2 ? bits != 8
                                   : !palette && (bits == 8 || (bits == 16 && alphaBits));
    if (!known ||
        (palette && entryBits != 15 && entryBits != 16 && entryBits != 24 && entryBits != 32))
        return variant("this kind of TGA is not supported");
    m_header.channels = (type == 3 ? 1 : 3) + ((bits == 32 || (type == 3 && bits == 16)) ? 1 : 0);

    const std::uint64_t paletteBytes =
        palette ? entries * static_cast<std::uint64_t>((entryBits + 7) / 8) : 0;
    const std::uint64_t at = 18 + idLength + paletteBytes;
    const auto pixelBytes = static_cast<std::uint64_t>((bits + 7) / 8);
    // A packet of at least two bytes codes 128 pixels at most.
    const bool enough =
        runLength ? m_bytes.has(at, pixels() / 64) : m_bytes.has(at, pixels() * pixelBytes);
    if (!enough)
        return damaged(kCutShort);
    if (type == 1)
        return checkTgaPalette(at, pixels(), runLength);
    return {};
}

/// The decoder looks indices up without comparing them with the length of the palette.
Result<void> HeaderReader::checkTgaPalette(std::uint64_t at, std::uint64_t pixels, bool runLength) {
    const int entries = m_bytes.le16(5);
    while (pixels > 0) {
        std::uint64_t count = 1;
        std::uint64_t indices = 1;
        if (runLength) {
            const auto packet = m_bytes.u8(at++);
            count = (packet & 0x7fU) + std::uint64_t{1};
            indices = (packet & 0x80U) != 0 ? 1 : count;
        }
        for (std::uint64_t i = 0; i < indices; ++i) {
            if (m_bytes.u8(at++) >= entries)
                return damaged("a pixel's color is not in the palette");
        }
        if (!m_bytes.ok())
            return damaged(kCutShort);
        pixels -= std::min(pixels, count);
    }
    return {};
}

Result<void> HeaderReader::readBmp() {
    const std::uint64_t dataAt = m_bytes.le32(10);
    const auto headerSize = m_bytes.le32(14);
    const bool os2 = headerSize == 12;
    if (!os2 && headerSize != 40 && headerSize != 52 && headerSize != 56 && headerSize != 108 &&
        headerSize != 124)
        return variant("this kind of BMP is not supported");
    if (!m_bytes.has(14, headerSize))
        return damaged(kCutShort);
    const auto height = os2 ? m_bytes.le16(20) : static_cast<std::int32_t>(m_bytes.le32(22));
    const auto width = os2 ? m_bytes.le16(18) : static_cast<std::int32_t>(m_bytes.le32(18));
    const int bits = m_bytes.le16(os2 ? 24 : 28);
    const auto compression = os2 ? 0 : m_bytes.le32(30);
    if (width <= 0 || height == 0 || height == INT32_MIN)
        return damaged("its size is wrong");
    m_header.width = static_cast<std::uint64_t>(width);
    m_header.height = static_cast<std::uint64_t>(std::abs(height));
    m_header.channels = bits == 32 ? 4 : 3;

    const bool runLength = compression == 1 || compression == 2;
    const bool known =
        (bits == 1 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32) &&
        (compression == 0 || (compression == 1 && bits == 8 && height > 0) ||
         (compression == 2 && bits == 4 && height > 0) ||
         (compression == 3 && (bits == 16 || bits == 32)));
    // The masks follow the first 40 bytes, as part of the header or behind it.
    const bool usualMasks =
        compression != 3 || bits != 32 ||
        (m_bytes.le32(54) == 0xff0000 && m_bytes.le32(58) == 0xff00 && m_bytes.le32(62) == 0xff);
    if (!known || !usualMasks)
        return variant("this kind of BMP is not supported");
    if (runLength && pixels() > INT32_MAX)
        return damaged("its size is wrong");
    if (!runLength) {
        const std::uint64_t row = (m_header.width * static_cast<std::uint64_t>(bits) + 31) / 32 * 4;
        if (dataAt > INT32_MAX || row > INT32_MAX || !m_bytes.has(dataAt, row * m_header.height))
            return damaged(kCutShort);
    }
    // Otherwise three samples a pixel are written to a row that has room for one.
    m_header.grayPaletteIsSafe = !runLength;
    m_header.alphaIsPadding =
        bits == 32 && (compression == 0 || headerSize < 56 || m_bytes.le32(66) == 0);
    if (headerSize == 124 && m_bytes.le32(70) == 0x4d424544) { // an embedded profile
        const std::uint64_t length = m_bytes.le32(130);
        if (length <= kMaxProfileBytes)
            m_header.iccProfile = m_bytes.copy(14 + std::uint64_t{m_bytes.le32(126)}, length);
    }
    return {};
}

Result<void> HeaderReader::readWebP() {
    const std::uint64_t end = std::uint64_t{m_bytes.le32(4)} + 8;
    if (!m_bytes.has(0, end))
        return damaged(kCutShort);
    bool alpha = false;
    bool extended = false;
    for (std::uint64_t at = 12; at + 8 <= end;) {
        const std::uint64_t length = m_bytes.le32(at + 4);
        const std::uint64_t data = at + 8;
        if (data + length > end)
            return damaged(kCutShort);
        if (m_bytes.matches(at, "VP8X"sv) && length >= 10) {
            extended = true;
            const auto flags = m_bytes.u8(data);
            if ((flags & 2U) != 0)
                return variant("this WebP is an animation");
            alpha = (flags & 16U) != 0;
            m_header.width = m_bytes.le24(data + 4) + std::uint64_t{1};
            m_header.height = m_bytes.le24(data + 7) + std::uint64_t{1};
        } else if (m_bytes.matches(at, "VP8 "sv) && !extended && length >= 10) {
            m_header.width = m_bytes.le16(data + 6) & 0x3fffU;
            m_header.height = m_bytes.le16(data + 8) & 0x3fffU;
        } else if (m_bytes.matches(at, "VP8L"sv) && !extended && length >= 5) {
            const auto packed = m_bytes.le32(data + 1);
            m_header.width = (packed & 0x3fffU) + 1;
            m_header.height = ((packed >> 14U) & 0x3fffU) + 1;
            alpha = ((packed >> 28U) & 1U) != 0;
        } else if (m_bytes.matches(at, "ICCP"sv) && length <= kMaxProfileBytes) {
            m_header.iccProfile = m_bytes.copy(data, length);
        } else if (m_bytes.matches(at, "EXIF"sv)) {
            // OpenImageIO 2.4 subtracts six from the length.
            if (length < 14)
                return damaged("a block of metadata is broken");
            const std::uint64_t prefix = m_bytes.matches(data, "Exif\0\0"sv) ? 6 : 0;
            readExifOrientation(data + prefix, length - prefix);
        }
        at = data + length + (length & 1U);
    }
    m_header.channels = alpha ? 4 : 3;
    return {};
}

/// The tag 0x112 of the first directory of a TIFF structure.
void HeaderReader::readExifOrientation(std::uint64_t at, std::uint64_t length) {
    const bool little = m_bytes.matches(at, "II*\0"sv);
    if ((!little && !m_bytes.matches(at, "MM\0*"sv)) || length < 8)
        return;
    const auto u16 = [&](std::uint64_t o) { return little ? m_bytes.le16(o) : m_bytes.be16(o); };
    const std::uint64_t directory = little ? m_bytes.le32(at + 4) : m_bytes.be32(at + 4);
    if (directory + 2 > length)
        return;
    const std::uint64_t count = u16(at + directory);
    if (directory + 2 + 12 * count > length)
        return;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t entry = at + directory + 2 + 12 * i;
        if (u16(entry) == 0x112)
            m_header.orientation = u16(entry + 8);
    }
}

} // namespace

Result<ImageHeader>
readImageHeader(FileBytes& bytes, const Path& name, const LoadOptions& options) {
    return HeaderReader(name, bytes).read(options);
}

Result<void> checkImageSize(const Path& path,
                            std::uint64_t width,
                            std::uint64_t height,
                            std::uint64_t channels,
                            const LoadOptions& options) {
    const std::string dimensions = std::to_string(width) + " x " + std::to_string(height) +
                                   " with " + std::to_string(channels) +
                                   (channels == 1 ? " channel" : " channels");
    if (width == 0 || height == 0 || channels == 0)
        return Error{ErrorCode::Unreadable,
                     "cannot read " + quoted(path) + ": its size is " + dimensions};
    const std::uint64_t most = options.maxSamples;
    if (width > most || height > most / width || channels > most / (width * height) ||
        width > INT32_MAX || height > INT32_MAX)
        return Error{ErrorCode::OverBudget,
                     quoted(path) + " is too large: " + dimensions + ", and at most " +
                         std::to_string(most) + " samples are read; make it smaller first"};
    if (channels > kMaxChannels)
        return Error{ErrorCode::Unreadable,
                     "cannot read " + quoted(path) + ": it has " + std::to_string(channels) +
                         " channels, and at most " + std::to_string(kMaxChannels) + " are read"};
    return {};
}

Error damagedImage(const Path& path, ImageFormat format, std::string_view reason) {
    return {ErrorCode::Unreadable,
            "cannot read the " + std::string(formatTraits(format).name) + " image " + quoted(path) +
                ": " + std::string(reason)};
}

} // namespace txn
