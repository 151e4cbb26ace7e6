// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/FileBytes.h"
#include "core/image/ImageIo.h"

namespace txn {

/// What the first look at an image file's bytes tells, before any decoder sees it.
struct ImageHeader {
    ImageFormat format = ImageFormat::Png;
    /// 0 where only the decoder can tell (TIFF, EXR).
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    int channels = 0;

    std::vector<std::uint8_t> iccProfile; ///< of a WebP, whose decoder passes over it
    int orientation = 1;                  ///< likewise; EXIF numbering
    ImageAttributes attributes;           ///< of an HDR, likewise
    bool alphaIsPadding = false;          ///< BMP: the fourth byte means nothing
    bool grayPaletteIsSafe = false;       ///< BMP: OpenImageIO may return one channel
};

/// Tells the type by content and checks what decoders fail to: sizes, completeness, and the
/// malformed blocks that make them read out of bounds. Time grows with the file's size only.
/// name is for messages and tells a TGA, which has no magic number, by its ending.
/// Errors: Unreadable, TooLarge.
[[nodiscard]] Result<ImageHeader>
readImageHeader(FileBytes& bytes, const std::filesystem::path& name, const LoadOptions& options);

/// Errors: Unreadable for an impossible size, TooLarge beyond options.maxSamples.
[[nodiscard]] Result<void> checkImageSize(const std::filesystem::path& path,
                                          std::uint64_t width,
                                          std::uint64_t height,
                                          std::uint64_t channels,
                                          const LoadOptions& options);

/// Unreadable: this file of that type is damaged, with the reason.
[[nodiscard]] Error
damagedImage(const std::filesystem::path& path, ImageFormat format, std::string_view reason);

} // namespace txn
