// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/ImageIo.h"

#include <span>
#include <string_view>

namespace txn {

/// What each file type is called and can hold. Internal to core/image.
struct FormatTraits {
    ImageFormat format;
    std::string_view name;                       ///< in messages
    const char* oiioName;                        ///< of OpenImageIO's reader and writer
    std::span<const std::string_view> endings;   ///< lower case, no dot
    std::span<const SampleFormat> sampleFormats; ///< that can be written, the default first
    std::span<const int> channelCounts;          ///< that can be written; empty: 1 to kMaxChannels
    int maxSidePx;
};

/// More channels than this are refused on reading and writing.
inline constexpr int kMaxChannels = 64;

[[nodiscard]] const FormatTraits& formatTraits(ImageFormat format);
[[nodiscard]] std::string_view sampleFormatName(SampleFormat format);
[[nodiscard]] constexpr bool isInteger(SampleFormat format) {
    return format == SampleFormat::UInt8 || format == SampleFormat::UInt16;
}

} // namespace txn
