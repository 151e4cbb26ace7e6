// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"
#include "core/image/ColorTransfer.h"
#include "core/image/FileSink.h"
#include "core/image/ImageFormats.h"
#include "core/image/ImageIo.h"
#include "core/image/TextAttributes.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <system_error>

namespace txn {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kWrittenBlockBytes = std::size_t{1} << 24U;
constexpr int kRowUnit = 32; // a strip of OpenImageIO's TIFF, two blocks of EXR's zip
constexpr float kLargestHalf = 65504.0F;

Error unwritable(const Path& path, const std::string& reason) {
    return {ErrorCode::Unwritable, "cannot write " + quoted(path) + ": " + reason};
}

Error invalid(const Path& path, const std::string& reason) {
    return {ErrorCode::InvalidArgument, "cannot write " + quoted(path) + ": " + reason};
}

/// "8-bit or 16-bit".
template <class Range, class Name>
std::string listed(const Range& range, Name name) {
    std::string text;
    for (const auto& item : range)
        text += (text.empty() ? "" : " or ") + std::string(name(item));
    return text;
}

Result<void> checkFits(const Path& path,
                       const FormatTraits& traits,
                       const ImageWriter::Layout& layout,
                       SampleFormat format) {
    const std::string type(traits.name);
    const auto unsupported = [&](const std::string& reason) {
        return Error{ErrorCode::Unsupported, "cannot write " + quoted(path) + ": " + reason};
    };
    if (layout.size.width < 1 || layout.size.height < 1 || layout.channels < 1)
        return invalid(path, "the image is empty");
    if (layout.channels > kMaxChannels)
        return unsupported("at most " + std::to_string(kMaxChannels) + " channels are written");
    const auto& counts = traits.channelCounts;
    if (!counts.empty() &&
        std::find(counts.begin(), counts.end(), layout.channels) == counts.end()) {
        const bool png = layout.channels == 1;
        return unsupported(type + " holds " +
                           listed(counts, [](int n) { return std::to_string(n); }) +
                           " channels; use " + (png ? "PNG, EXR or TIFF" : "EXR or TIFF") +
                           " for " + std::to_string(layout.channels));
    }
    const auto& formats = traits.sampleFormats;
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
        const char* instead = format == SampleFormat::UInt8    ? "PNG or TIFF"
                              : format == SampleFormat::UInt16 ? "PNG or TIFF"
                              : format == SampleFormat::Half   ? "EXR"
                                                               : "EXR or TIFF";
        return unsupported(type + " holds " + listed(formats, sampleFormatName) + " samples; use " +
                           instead + " for " + std::string(sampleFormatName(format)));
    }
    if (std::max(layout.size.width, layout.size.height) > traits.maxSidePx)
        return unsupported(type + " holds at most " + std::to_string(traits.maxSidePx) +
                           " pixels a side; use EXR or TIFF for " +
                           std::to_string(layout.size.width) + " x " +
                           std::to_string(layout.size.height));
    // The sizes and offsets in these headers have 32 bits.
    const double bytes = static_cast<double>(layout.size.area()) * layout.channels;
    if ((traits.format == ImageFormat::Bmp || traits.format == ImageFormat::Tga) && bytes > 2.1e9)
        return unsupported(type + " holds at most 2 GB; use EXR or TIFF");
    return {};
}

/// Y, RGB or numbers, of equal length since EXR sorts them as text. None is ever taken for alpha.
std::vector<std::string> defaultChannelNames(int channels) {
    if (channels == 1)
        return {"Y"};
    if (channels == 3)
        return {"R", "G", "B"};
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(channels));
    for (int c = 0; c < channels; ++c)
        names.push_back(std::string(channels > 10 && c < 10 ? 1 : 0, '0') + std::to_string(c));
    return names;
}

Result<void>
checkChannelNames(const Path& path, const std::vector<std::string>& names, int channels) {
    if (names.size() != static_cast<std::size_t>(channels))
        return invalid(path,
                       std::to_string(names.size()) + " channel names for " +
                           std::to_string(channels) + " channels");
    if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
        return invalid(path, "two channels have the same name");
    for (const std::string& name : names) {
        std::string last = name.substr(name.rfind('.') + 1);
        std::transform(last.begin(), last.end(), last.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        });
        if (last.empty())
            return invalid(path, "a channel has no name");
        if (last == "a" || last == "alpha")
            return invalid(path,
                           "a channel named '" + name +
                               "' would be read as transparency; give it another name");
    }
    return {};
}

OIIO::TypeDesc typeInFile(SampleFormat format) {
    switch (format) {
    case SampleFormat::UInt8:
        return OIIO::TypeUInt8;
    case SampleFormat::UInt16:
        return OIIO::TypeUInt16;
    case SampleFormat::Half:
        return OIIO::TypeHalf;
    case SampleFormat::Float:
        break;
    }
    return OIIO::TypeFloat;
}

/// Names with the prefix, and the note of the transfer for types that keep values as they are.
ImageAttributes fullAttributes(const SaveOptions& options, SampleFormat format, Transfer transfer) {
    ImageAttributes attributes;
    for (const auto& [name, value] : options.attributes)
        attributes[(name.starts_with(kAttributePrefix) ? "" : std::string(kAttributePrefix)) +
                   name] = value;
    if (isInteger(format))
        attributes.erase(kTransferAttribute);
    else
        attributes[kTransferAttribute] = transfer == Transfer::Linear ? "linear" : "encoded";
    return attributes;
}

void describe(OIIO::ImageSpec& spec, ImageFormat format, const ImageAttributes& attributes) {
    switch (format) {
    case ImageFormat::OpenExr:
        spec.attribute("compression", "zip");
        // OpenImageIO adds the time of day otherwise, and equal images would give unequal files.
        spec.attribute("DateTime", "");
        break;
    case ImageFormat::Tiff:
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", "");
        spec.attribute("tiff:write_exif", 0);
        if (!attributes.empty())
            spec.attribute("ImageDescription", textFromAttributes(attributes));
        return;
    case ImageFormat::Jpeg:
        spec.attribute("compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
        return;
    case ImageFormat::WebP:
        // Lossy: OpenImageIO 2.4 halves the chroma even when asked for "lossless", and that is
        // slow.
        spec.attribute("compression", "webp:100");
        return;
    case ImageFormat::Png:
        break;
    default:
        return;
    }
    for (const auto& [name, value] : attributes)
        spec.attribute(name, value);
}

} // namespace

struct ImageWriter::State {
    // In this order: the writer is destroyed before its sink, and both before the file.
    OutputFiles files;
    OutputFiles* together = nullptr; ///< instead of files
    std::unique_ptr<FileSink> sink;
    std::unique_ptr<OIIO::ImageOutput> output;

    Path path;
    ImageFormat fileFormat = ImageFormat::Png;
    Layout layout;
    SampleFormat format = SampleFormat::UInt8;
    int blockRows = 0;
    int rowsWritten = 0;
    int rowsHeld = 0;
    std::vector<float> held; ///< interleaved rows not yet given to the output
    std::vector<std::uint8_t> integers;
    std::size_t clipped = 0;
    std::optional<Error> failure;

    std::size_t rowSamples() const {
        return static_cast<std::size_t>(layout.size.width) *
               static_cast<std::size_t>(layout.channels);
    }
    Result<void> openOutput(const std::string& temporary,
                            const SaveOptions& options,
                            const std::vector<std::string>& names);
    void hold(const Image& band, int row);
    Result<void> flush();
    Result<void> finish();
    Error failed(const std::string& said);
    template <class Integer>
    const void* quantized();
};

Error ImageWriter::State::failed(const std::string& said) {
    const std::string reason = sink->failure() != 0
                                   ? std::generic_category().message(sink->failure())
                                   : said.substr(0, said.find('\n'));
    failure = unwritable(path, reason.empty() ? "the encoder failed" : reason);
    return *failure;
}

Result<void> ImageWriter::State::openOutput(const std::string& temporary,
                                            const SaveOptions& options,
                                            const std::vector<std::string>& names) {
    const FormatTraits& traits = formatTraits(fileFormat);
    const auto attributes = fullAttributes(options, format, layout.transfer);
    // The writer has no place for the note. A line before its own is a legal header too.
    const std::string prefix =
        traits.format == ImageFormat::Hdr
            ? "#?RADIANCE\n" + kTransferAttribute + "=" + attributes.at(kTransferAttribute) + "\n"
            : "";
    sink = std::make_unique<FileSink>(temporary, prefix);
    if (sink->failure() != 0)
        return failed({});
    output = OIIO::ImageOutput::create(traits.oiioName);
    if (!output)
        return Error{ErrorCode::Unsupported,
                     "cannot write " + quoted(path) +
                         ": this OpenImageIO was built without support for " +
                         std::string(traits.name)};
    OIIO::ImageSpec spec(layout.size.width,
                         layout.size.height,
                         layout.channels,
                         typeInFile(format));
    spec.channelnames = names;
    spec.alpha_channel = -1;
    spec.z_channel = -1;
    describe(spec, traits.format, attributes);
    OIIO::Filesystem::IOProxy* proxy = sink.get();
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
    if (!output->open(temporary, spec))
        return failed(output->geterror());
    return {};
}

/// Appends one row of the band to those held, as the file's values. Counts what will be clamped.
void ImageWriter::State::hold(const Image& band, int row) {
    const bool clips = isInteger(format);
    // RGBE has no signs, and its encoder makes something bright of what is below black.
    const bool unsignedFloats = fileFormat == ImageFormat::Hdr;
    const bool encode = clips && layout.transfer == Transfer::Linear;
    const auto channels = static_cast<std::size_t>(layout.channels);
    float* to = held.data() + static_cast<std::size_t>(rowsHeld) * rowSamples();
    for (std::size_t c = 0; c < channels; ++c) {
        const auto from = band.row(static_cast<int>(c), row);
        for (std::size_t x = 0; x < from.size(); ++x) {
            float value = from[x];
            if (clips) {
                // Written so that NaN counts, and becomes 0.
                if (!(value >= 0.0F && value <= 1.0F)) {
                    ++clipped;
                    value = value > 1.0F ? 1.0F : 0.0F;
                }
                if (encode)
                    value = std::clamp(encodedFromLinear(value), 0.0F, 1.0F);
            } else if (unsignedFloats) {
                if (!(value >= 0.0F)) {
                    ++clipped;
                    value = 0.0F;
                }
            } else if (format == SampleFormat::Half && std::isfinite(value)) {
                value = std::clamp(value, -kLargestHalf, kLargestHalf); // not to infinity
            }
            to[x * channels + c] = value;
        }
    }
    ++rowsHeld;
}

template <class Integer>
const void* ImageWriter::State::quantized() {
    const std::size_t count = static_cast<std::size_t>(rowsHeld) * rowSamples();
    integers.resize(count * sizeof(Integer));
    auto* to = reinterpret_cast<Integer*>(integers.data());
    constexpr float kWhite = std::numeric_limits<Integer>::max();
    for (std::size_t i = 0; i < count; ++i) {
        const float code = held[i] * kWhite + 0.5F; // of values in [0, 1]
        to[i] = static_cast<Integer>(code);
    }
    return to;
}

Result<void> ImageWriter::State::flush() {
    if (rowsHeld == 0)
        return {};
    const void* data = held.data();
    OIIO::TypeDesc given = OIIO::TypeFloat;
    if (isInteger(format)) {
        given = typeInFile(format);
        data =
            format == SampleFormat::UInt8 ? quantized<std::uint8_t>() : quantized<std::uint16_t>();
    }
    const bool done = output->write_scanlines(rowsWritten, rowsWritten + rowsHeld, 0, given, data);
    if (!done || sink->failure() != 0)
        return failed(output->geterror());
    rowsWritten += rowsHeld;
    rowsHeld = 0;
    return {};
}

Result<void> ImageWriter::State::finish() {
    if (auto flushed = flush(); !flushed)
        return flushed;
    const bool closed = output->close();
    const std::string said = closed ? std::string() : output->geterror();
    output.reset();
    if (sink->finish() != 0 || !closed)
        return failed(said);
    return together != nullptr ? Result<void>() : files.commit();
}

ImageWriter::ImageWriter(std::unique_ptr<State> state) : m_state(std::move(state)) {}
ImageWriter::ImageWriter(ImageWriter&&) noexcept = default;
ImageWriter& ImageWriter::operator=(ImageWriter&&) noexcept = default;
ImageWriter::~ImageWriter() = default;

Result<ImageWriter> ImageWriter::open(const Path& path,
                                      const Layout& layout,
                                      const SaveOptions& options,
                                      OutputFiles* together) {
    const auto type = options.fileFormat ? Result(*options.fileFormat) : imageFormatForPath(path);
    if (!type)
        return type.error();
    const FormatTraits& traits = formatTraits(*type);
    auto state = std::make_unique<State>();
    state->path = path;
    state->fileFormat = *type;
    state->layout = layout;
    state->format = options.sampleFormat.value_or(traits.sampleFormats.front());
    if (auto fits = checkFits(path, traits, layout, state->format); !fits)
        return fits.error();
    const auto names =
        options.channelNames.empty() ? defaultChannelNames(layout.channels) : options.channelNames;
    if (auto named = checkChannelNames(path, names, layout.channels); !named)
        return named.error();

    state->together = together;
    auto temporary = (together != nullptr ? *together : state->files).add(path);
    if (!temporary)
        return temporary.error();
    try {
        if (auto opened = state->openOutput(temporary->string(), options, names); !opened)
            return opened.error();
        const std::size_t rowBytes = state->rowSamples() * sizeof(float);
        state->blockRows =
            static_cast<int>(
                std::clamp<std::size_t>(kWrittenBlockBytes / rowBytes / kRowUnit, 1, 8)) *
            kRowUnit;
        state->blockRows = std::min(state->blockRows, layout.size.height);
        state->held.resize(static_cast<std::size_t>(state->blockRows) * state->rowSamples());
    } catch (const std::bad_alloc&) {
        return unwritable(path, "there is not enough memory");
    } catch (const std::exception& failure) {
        return unwritable(path, failure.what());
    }
    return ImageWriter(std::move(state));
}

Result<void> ImageWriter::writeRows(const Image& band) {
    State& state = *m_state;
    if (state.failure)
        return *state.failure;
    const Size size = state.layout.size;
    if (band.width() != size.width || band.channels() != state.layout.channels ||
        band.height() > size.height - state.rowsWritten - state.rowsHeld ||
        band.transfer() != state.layout.transfer)
        return invalid(state.path, "a band of rows does not fit the image");
    try {
        for (int y = 0; y < band.height(); ++y) {
            state.hold(band, y);
            if (state.rowsHeld == state.blockRows) {
                if (auto flushed = state.flush(); !flushed)
                    return flushed;
            }
        }
    } catch (const std::exception& failure) {
        return state.failed(failure.what());
    }
    return {};
}

std::size_t ImageWriter::clippedSamples() const {
    return m_state->clipped;
}

bool ImageWriter::clips() const {
    return isInteger(m_state->format) || m_state->fileFormat == ImageFormat::Hdr;
}

Result<void> ImageWriter::finish() {
    State& state = *m_state;
    if (state.failure)
        return *state.failure;
    const int rows = state.rowsWritten + state.rowsHeld;
    if (rows != state.layout.size.height)
        return invalid(state.path,
                       "only " + std::to_string(rows) + " of " +
                           std::to_string(state.layout.size.height) + " rows were given");
    try {
        return state.finish();
    } catch (const std::exception& failure) {
        return state.failed(failure.what());
    }
}

Result<void>
saveImage(const Image& image, const Path& path, const SaveOptions& options, OutputFiles* together) {
    auto writer = ImageWriter::open(
        path,
        {.size = image.size(), .channels = image.channels(), .transfer = image.transfer()},
        options,
        together);
    if (!writer)
        return writer.error();
    if (auto written = writer->writeRows(image); !written)
        return written;
    return writer->finish();
}

} // namespace txn
