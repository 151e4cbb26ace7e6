// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/ImageIo.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace txn {

/// What a program and its image decoder (`texton-decode`) say to each other, as bytes. A decoder
/// that was taken over by a picture may answer anything: the readers here trust no byte, allocate
/// no more than the message is long, and give nothing for what is not well formed. Both ends are
/// of one build and on one machine, so that numbers are in its own byte order. Internal to
/// core/image.
using Message = std::vector<std::uint8_t>;

/// No message is longer, nor the description of a picture.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{1} << 16U;
inline constexpr std::size_t kMaxDescriptionBytes = std::size_t{1} << 24U;

/// Asks for the file whose descriptor comes with the message.
struct DecodeRequest {
    std::string name; ///< for messages and, where the content is not enough, the ending
    std::uint64_t maxSamples = 0;
};
[[nodiscard]] Message toMessage(const DecodeRequest& request);
[[nodiscard]] std::optional<DecodeRequest> requestFrom(std::span<const std::uint8_t> bytes);

/// A decoder says once that it is ready (not done, no samples). Then two kinds of answer to each
/// request: the header was read, and the end, whereupon it writes a description into the pipe and,
/// for a picture, the samples behind it, as floats in the order of Image, then those of alpha.
struct DecodeNews {
    bool done = false;
    std::uint64_t samples = 0;          ///< promised by the header, while not done
    std::uint64_t descriptionBytes = 0; ///< when done
};
[[nodiscard]] Message toMessage(const DecodeNews& news);
[[nodiscard]] std::optional<DecodeNews> newsFrom(std::span<const std::uint8_t> bytes);

/// All of a picture but its samples.
struct PictureDescription {
    LoadedImage loaded; ///< image and alpha are empty
    Size size;
    int channels = 0;
    bool hasAlpha = false;
    Transfer transfer = Transfer::Encoded;

    /// Of image and alpha together.
    std::uint64_t samples() const {
        return std::uint64_t{size.area()} *
               static_cast<std::uint64_t>(channels + (hasAlpha ? 1 : 0));
    }
};
[[nodiscard]] Message describe(const LoadedImage& loaded);
[[nodiscard]] Message describe(const Error& error);
/// Nothing for what describe() does not write, and for a picture of more than maxSamples.
[[nodiscard]] std::optional<Result<PictureDescription>>
descriptionFrom(std::span<const std::uint8_t> bytes, std::uint64_t maxSamples);

} // namespace txn
