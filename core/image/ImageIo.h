// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/OutputFiles.h"
#include "core/base/Result.h"
#include "core/image/Image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace txn {

/// Number type of the samples in a file.
enum class SampleFormat { UInt8, UInt16, Half, Float };

/// File types that are read and written; the content decides on reading, the ending on writing.
enum class ImageFormat { Png, Jpeg, Tiff, OpenExr, Hdr, Tga, Bmp, WebP };

/// Free text stored in the file's header under a name (EXR and TIFF keep them; others may not).
using ImageAttributes = std::map<std::string, std::string>;

/// What loadImage gives: colour (or data) channels, the alpha channel kept apart, and what the
/// file said of itself.
struct LoadedImage {
    Image image;                           ///< alpha not among its channels
    std::optional<Image> alpha;            ///< one channel, unassociated
    ImageFormat format = ImageFormat::Png; ///< by content
    SampleFormat sampleFormat = SampleFormat::UInt8;
    std::vector<std::string> channelNames; ///< as stored, alpha left out
    ImageAttributes attributes;            ///< text attributes whose name starts with "texton:"
    bool iccConverted = false;             ///< an embedded profile was converted to sRGB
};

struct LoadOptions {
    /// Refuse files whose header promises more samples (width x height x channels) than this.
    std::size_t maxSamples = std::size_t{1} << 28U;

    /// For a file that the user insists on: as much as there is memory for.
    static constexpr LoadOptions insisted() { return {.maxSamples = std::size_t{1} << 40U}; }
};

/// Reads PNG, JPEG, TIFF, EXR, HDR, TGA, BMP or WebP, told by the content, not by the name.
/// Palette, grey, RGB, RGBA, 8 and 16 bit, half, float; integers become [0, 1]; EXIF orientation is
/// applied; embedded ICC profiles are converted to sRGB; an EXR data window becomes the image. HDR
/// and EXR are Linear unless their attribute texton:transfer says "encoded"; the rest is Encoded,
/// unless a float TIFF says "linear".
/// Errors (message names the file): NotFound; Unreadable for folders, pipes, other or broken or
/// truncated files, also when the decoder gives pixels and reports the damage afterwards;
/// OverBudget for more than maxSamples; TooLarge for more than there is memory for. Decoding runs
/// in a process of its own, texton-decode, which a hostile file may crash or keep busy; that is an
/// error like others, and comes in time. Thread-safe. NaN and infinite samples are passed on:
/// makeExemplar refuses them.
[[nodiscard]] Result<LoadedImage> loadImage(const std::filesystem::path& path,
                                            const LoadOptions& options = {});

/// The same for the content of a file; name is for messages.
[[nodiscard]] Result<LoadedImage> loadImage(std::span<const std::uint8_t> content,
                                            const std::filesystem::path& name,
                                            const LoadOptions& options = {});

/// Starts the helper in which loadImage decodes, so that the first picture need not wait for it.
/// Where that fails, loadImage says so. Thread-safe.
void startImageReading();

struct SaveOptions {
    std::optional<ImageFormat> fileFormat; ///< unset: by the ending of the name
    /// Unset: 8 bits for PNG, JPEG, TIFF, TGA, BMP, WebP; half for EXR; float for HDR.
    std::optional<SampleFormat> sampleFormat;
    std::vector<std::string> channelNames; ///< empty: Y, RGB or the channel's number
    ImageAttributes attributes;
};

/// File type by the ending of the name. Errors: Unsupported, naming the endings that work.
[[nodiscard]] Result<ImageFormat> imageFormatForPath(const std::filesystem::path& path);

/// Writes the image whole: an existing file is replaced by a complete one or stays as it was. With
/// together, the file joins those and appears when they are committed. Integer formats hold encoded
/// values in [0, 1]: Linear images are encoded, values outside are clamped. Float formats keep the
/// values and note the transfer in the attribute texton:transfer.
/// Errors: Unsupported (ending, channel count or sample format that the type cannot hold);
/// Unwritable. Thread-safe.
[[nodiscard]] Result<void> saveImage(const Image& image,
                                     const std::filesystem::path& path,
                                     const SaveOptions& options = {},
                                     OutputFiles* together = nullptr);

/// Writes an image in bands of rows, from the top down, without ever holding it whole. The file
/// appears under its name at finish(); a writer that is destroyed before leaves nothing behind.
/// One thread at a time.
class ImageWriter {
  public:
    struct Layout {
        Size size;
        int channels = 3;
        Transfer transfer = Transfer::Encoded;
    };

    /// Same formats, errors and rules as saveImage.
    [[nodiscard]] static Result<ImageWriter> open(const std::filesystem::path& path,
                                                  const Layout& layout,
                                                  const SaveOptions& options = {},
                                                  OutputFiles* together = nullptr);
    ImageWriter(ImageWriter&&) noexcept;
    ImageWriter& operator=(ImageWriter&&) noexcept;
    ~ImageWriter();

    /// Appends the rows of band, as wide as the file. TIFF and EXR are stored in strips or
    /// scanlines, so any band height will do.
    [[nodiscard]] Result<void> writeRows(const Image& band);

    /// Samples so far that the file cannot hold and that were clamped: outside [0, 1] for integer
    /// formats, negative ones for HDR.
    std::size_t clippedSamples() const;
    /// Whether the file has such limits: integer formats and HDR.
    bool clips() const;

    /// Closes the file and gives it its name.
    [[nodiscard]] Result<void> finish();

  private:
    struct State;
    explicit ImageWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace txn
