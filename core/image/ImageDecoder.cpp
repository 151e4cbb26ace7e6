// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageDecoder.h"

#include "core/base/OutputFiles.h"
#include "core/image/IccProfile.h"
#include "core/image/ImageFormats.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageHeader.h"
#include "core/image/TextAttributes.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace txn {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kBlockBytes = std::size_t{1} << 25U;
constexpr int kFarthestOrigin = 1 << 29; // keeps the decoders' sums of offset and size in range

/// Uncompressed bytes that one stored byte can stand for at most; 0 where there is no such bound.
std::uint64_t largestExpansion(std::string_view compression) {
    if (compression == "none")
        return 1;
    if (compression == "rle" || compression == "packbits")
        return 64;
    if (compression == "zip" || compression == "zips")
        return 1032;
    if (compression == "pxr24" || compression == "lzw")
        return 4096;
    return 0;
}

/// One line without control characters, short enough for a message.
std::string oneLine(std::string text) {
    text = text.substr(0, text.find('\n')).substr(0, 200);
    // libjpeg's messages end in the name of the file, which ours begin with.
    text = text.substr(0, text.find(" (\""));
    // OpenEXR's begin with it: Cannot read image file "...". Reason.
    if (const auto reason = text.rfind("\". "); reason != std::string::npos)
        text.erase(0, reason + 3);
    std::replace_if(
        text.begin(),
        text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20; },
        '?');
    return text.empty() ? "the file is damaged" : text;
}

/// Reads one file by the decoder that its content asks for.
class RowReader {
  public:
    RowReader(FileBytes& file,
              const Path& path,
              ImageHeader header,
              const LoadOptions& options,
              const SamplesKnown& samplesKnown)
        : m_file(file), m_path(path), m_header(std::move(header)), m_options(options),
          m_samplesKnown(samplesKnown) {}

    Result<LoadedImage> read();

  private:
    Result<void> open();
    Result<void> checkSpec() const;
    Result<void> readSamples();
    bool readRows(int top, int rows, std::vector<float>& block);
    void store(int firstRow, int rows, const std::vector<float>& block);
    void readAttributes();
    void settleAlpha();
    void settleColor();
    bool alphaIsAssociated() const;

    Error damaged(const std::string& reason) const {
        return damagedImage(m_path, m_header.format, oneLine(reason));
    }

    void tellSamples(std::uint64_t width, std::uint64_t height, int channels) const {
        if (m_samplesKnown)
            m_samplesKnown(width * height * static_cast<std::uint64_t>(channels));
    }

    FileBytes& m_file;
    const Path& m_path;
    ImageHeader m_header;
    const LoadOptions& m_options;
    const SamplesKnown& m_samplesKnown;
    std::unique_ptr<OIIO::ImageInput> m_input;
    OIIO::ImageSpec m_spec;
    int m_alphaChannel = -1;
    LoadedImage m_loaded;
};

Result<LoadedImage> RowReader::read() {
    // Some decoders decode all of it when they open it.
    if (m_header.width > 0)
        tellSamples(m_header.width, m_header.height, m_header.channels);
    if (auto opened = open(); !opened)
        return opened.error();
    if (auto checked = checkSpec(); !checked)
        return checked.error();
    tellSamples(static_cast<std::uint64_t>(m_spec.width),
                static_cast<std::uint64_t>(m_spec.height),
                m_spec.nchannels);
    readAttributes();
    if (auto read = readSamples(); !read)
        return read.error();
    m_input.reset();
    settleAlpha();
    settleColor();
    return std::move(m_loaded);
}

Result<void> RowReader::open() {
    const FormatTraits& traits = formatTraits(m_header.format);
    m_input = OIIO::ImageInput::create(traits.oiioName);
    if (!m_input)
        return Error{ErrorCode::Unsupported,
                     "cannot read " + quoted(m_path) +
                         ": this OpenImageIO was built without support for " +
                         std::string(traits.name)};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    config.attribute("bmp:monochrome_detect", m_header.grayPaletteIsSafe ? 1 : 0);
    if (!m_input->open(m_file.pathOfDescriptor(), m_spec, config))
        return damaged(m_input->geterror());
    return {};
}

Result<void> RowReader::checkSpec() const {
    const auto count = [](int n) { return static_cast<std::uint64_t>(std::max(n, 0)); };
    if (auto checked = checkImageSize(m_path,
                                      count(m_spec.width),
                                      count(m_spec.height),
                                      count(m_spec.nchannels),
                                      m_options);
        !checked)
        return checked.error();
    if (m_spec.deep)
        return damaged("it is a deep image; flatten it first");
    if (m_spec.depth > 1)
        return damaged("it is a volume; save one slice of it as an image");
    if (std::abs(std::int64_t{m_spec.x}) > kFarthestOrigin ||
        std::abs(std::int64_t{m_spec.y}) > kFarthestOrigin)
        return damaged("its origin is out of range");
    if (m_spec.tile_width > 0 &&
        (m_spec.tile_height <= 0 ||
         count(m_spec.tile_width) > m_options.maxSamples / count(m_spec.tile_height) ||
         count(m_spec.tile_width) * count(m_spec.tile_height) * count(m_spec.nchannels) >
             2 * m_options.maxSamples))
        return damaged("its tiles are too large");

    const auto expansion = largestExpansion(m_spec.get_string_attribute("compression"));
    // A TIFF may pack 24 of our bytes, 8 pixels of a palette, into one of its own.
    const std::uint64_t unpacked = m_header.format == ImageFormat::Tiff ? 24 : 1;
    if (expansion > 0 && m_spec.image_bytes(true) / (expansion * unpacked) > m_file.size())
        return damaged("it holds too little data for its size");
    return {};
}

Result<void> RowReader::readSamples() {
    m_alphaChannel = m_spec.nchannels > 1 ? m_spec.alpha_channel : -1;
    if (m_alphaChannel >= m_spec.nchannels)
        m_alphaChannel = -1;
    const bool tiled = m_spec.tile_width > 0;
    const std::size_t rowSamples =
        static_cast<std::size_t>(m_spec.width) * static_cast<std::size_t>(m_spec.nchannels);
    // OpenImageIO 2.4 loses decoding errors of TIFF when it is asked for several rows at once.
    const bool rowByRow = m_header.format == ImageFormat::Tiff && !tiled;
    const int unit = tiled ? m_spec.tile_height : rowByRow ? 1 : 32;
    const auto units = rowByRow
                           ? 1
                           : std::clamp<std::size_t>(kBlockBytes / (rowSamples * sizeof(float)) /
                                                         static_cast<std::size_t>(unit),
                                                     1,
                                                     1U << 16U);
    const auto blockRows = std::min<std::uint64_t>(units * static_cast<std::size_t>(unit),
                                                   static_cast<std::uint64_t>(m_spec.height));
    std::vector<float> block(rowSamples * blockRows);
    for (int y = 0; y < m_spec.height;) {
        const int rows = std::min(static_cast<int>(blockRows), m_spec.height - y);
        const bool done = readRows(m_spec.y + y, rows, block);
        // OpenImageIO's TIFF reader reports broken strips, and success all the same.
        if (!done || (m_header.format != ImageFormat::Jpeg && m_input->has_error()))
            return damaged(m_input->geterror());
        store(y, rows, block);
        y += rows;
    }
    // libjpeg paints what is missing grey and only mentions it, as it does some harmless things.
    if (m_input->has_error()) {
        const std::string message = m_input->geterror();
        const auto says = [&](const char* text) { return message.find(text) != std::string::npos; };
        const bool harmless = says("extraneous bytes before marker 0xd9") ||
                              says("unknown JFIF revision") ||
                              says("Unknown Adobe color transform");
        if (!harmless)
            return damaged(message);
    }
    return {};
}

/// From the top one on, whole rows of tiles where there are tiles.
bool RowReader::readRows(int top, int rows, std::vector<float>& block) {
    if (m_spec.tile_width > 0)
        return m_input->read_tiles(0,
                                   0,
                                   m_spec.x,
                                   m_spec.x + m_spec.width,
                                   top,
                                   top + rows,
                                   m_spec.z,
                                   m_spec.z + 1,
                                   0,
                                   m_spec.nchannels,
                                   OIIO::TypeFloat,
                                   block.data());
    if (rows == 1) // read_scanlines() allocates 64 MiB each time
        return m_input->read_scanline(top, m_spec.z, OIIO::TypeFloat, block.data());
    return m_input->read_scanlines(0,
                                   0,
                                   top,
                                   top + rows,
                                   m_spec.z,
                                   0,
                                   m_spec.nchannels,
                                   OIIO::TypeFloat,
                                   block.data());
}

/// Sorts interleaved rows into planes.
void RowReader::store(int firstRow, int rows, const std::vector<float>& block) {
    const Size size{m_spec.width, m_spec.height};
    // Only now, since a file that gives no rows at all should not cost its promised size.
    if (m_loaded.image.empty()) {
        m_loaded.image = Image(size, m_spec.nchannels - (m_alphaChannel >= 0 ? 1 : 0));
        if (m_alphaChannel >= 0 && !m_header.alphaIsPadding)
            m_loaded.alpha = Image(size, 1);
    }
    const auto channels = static_cast<std::size_t>(m_spec.nchannels);
    int plane = 0;
    for (int c = 0; c < m_spec.nchannels; ++c) {
        const bool isAlpha = c == m_alphaChannel;
        if (isAlpha && !m_loaded.alpha)
            continue;
        for (int y = 0; y < rows; ++y) {
            const auto row = isAlpha ? m_loaded.alpha->row(0, firstRow + y)
                                     : m_loaded.image.row(plane, firstRow + y);
            const float* from = block.data() + static_cast<std::size_t>(y) * row.size() * channels +
                                static_cast<std::size_t>(c);
            for (std::size_t x = 0; x < row.size(); ++x)
                row[x] = from[x * channels];
        }
        if (!isAlpha)
            ++plane;
    }
}

void RowReader::readAttributes() {
    m_loaded.format = m_header.format;
    const auto baseType = static_cast<OIIO::TypeDesc::BASETYPE>(m_spec.format.basetype);
    m_loaded.sampleFormat = baseType == OIIO::TypeDesc::UINT8    ? SampleFormat::UInt8
                            : baseType == OIIO::TypeDesc::UINT16 ? SampleFormat::UInt16
                            : baseType == OIIO::TypeDesc::HALF   ? SampleFormat::Half
                                                                 : SampleFormat::Float;
    for (int c = 0; c < m_spec.nchannels; ++c) {
        if (c != m_spec.alpha_channel || m_spec.nchannels == 1)
            m_loaded.channelNames.emplace_back(m_spec.channel_name(c));
    }
    m_loaded.attributes = m_header.attributes;
    for (const OIIO::ParamValue& value : m_spec.extra_attribs) {
        const std::string name = value.name().string();
        if (name.starts_with(kAttributePrefix) && value.type() == OIIO::TypeString)
            m_loaded.attributes[name] = value.get_string();
    }
    if (m_header.format == ImageFormat::Tiff)
        m_loaded.attributes.merge(
            attributesFromText(std::string(m_spec.get_string_attribute("ImageDescription"))));
}

bool RowReader::alphaIsAssociated() const {
    switch (m_header.format) {
    case ImageFormat::OpenExr: // by the format's definition
    case ImageFormat::WebP:    // its reader multiplies, whatever it is asked
        return true;
    case ImageFormat::Tiff:
        return m_spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    case ImageFormat::Tga:
        return m_spec.get_int_attribute("targa:alpha_type") == 4;
    default:
        return false;
    }
}

void RowReader::settleAlpha() {
    if (!m_loaded.alpha)
        return;
    const auto alpha = m_loaded.alpha->plane(0);
    const bool mayBeMeaningless =
        m_header.format == ImageFormat::Tga || m_header.format == ImageFormat::Bmp;
    const int tgaType = m_spec.get_int_attribute("targa:alpha_type");
    if ((mayBeMeaningless &&
         std::all_of(alpha.begin(), alpha.end(), [](float a) { return a == 0.0F; })) ||
        tgaType == 1 || tgaType == 2) {
        m_loaded.alpha.reset();
        return;
    }
    if (!alphaIsAssociated())
        return;
    for (int c = 0; c < m_loaded.image.channels(); ++c) {
        const auto plane = m_loaded.image.plane(c);
        for (std::size_t i = 0; i < plane.size(); ++i) {
            if (alpha[i] > 0.0F)
                plane[i] /= alpha[i];
        }
    }
}

void RowReader::settleColor() {
    const auto noted = m_loaded.attributes.find(kTransferAttribute);
    const std::string note = noted == m_loaded.attributes.end() ? "" : noted->second;
    const bool linearType =
        m_header.format == ImageFormat::OpenExr || m_header.format == ImageFormat::Hdr;
    // A TIFF of floats that this program wrote says so too.
    const bool linear =
        linearType ? note != "encoded" : note == "linear" && !isInteger(m_loaded.sampleFormat);
    m_loaded.image.setTransfer(linear ? Transfer::Linear : Transfer::Encoded);

    if (!linearType && !linear) {
        std::vector<std::uint8_t> profile = std::move(m_header.iccProfile);
        const OIIO::ParamValue* embedded = m_spec.find_attribute("ICCProfile");
        if (embedded != nullptr && embedded->type().basetype == OIIO::TypeDesc::UINT8) {
            const auto* bytes = static_cast<const std::uint8_t*>(embedded->data());
            profile.assign(bytes, bytes + embedded->datasize());
        }
        m_loaded.iccConverted = convertToSrgb(m_loaded.image, profile);
    }

    const int orientation = m_header.format == ImageFormat::WebP
                                ? m_header.orientation
                                : m_spec.get_int_attribute("Orientation", 1);
    m_loaded.image = upright(std::move(m_loaded.image), orientation);
    if (m_loaded.alpha)
        m_loaded.alpha = upright(*std::move(m_loaded.alpha), orientation);
}

} // namespace

Result<LoadedImage> decodeImage(FileBytes file,
                                const Path& name,
                                const LoadOptions& options,
                                const SamplesKnown& samplesKnown) {
    auto header = readImageHeader(file, name, options);
    if (!header)
        return header.error();
    const ImageFormat format = header->format;
    try {
        return RowReader(file, name, *std::move(header), options, samplesKnown).read();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, "there is not enough memory to read " + quoted(name)};
    } catch (const std::exception& failure) {
        return damagedImage(name, format, oneLine(failure.what()));
    } catch (...) {
        return damagedImage(name, format, "the decoder failed");
    }
}

} // namespace txn
