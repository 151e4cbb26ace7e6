// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeMessages.h"
#include "tests/fuzz/FuzzTarget.h"

namespace txn::fuzz {
namespace {

constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 28U;

/// What is understood comes back as it was said.
bool checkRequest(std::span<const std::uint8_t> bytes) {
    const auto request = requestFrom(bytes);
    if (!request)
        return false;
    const auto again = requestFrom(toMessage(*request));
    require(again && again->name == request->name && again->maxSamples == request->maxSamples,
            "a request arrives as it was sent");
    return true;
}

bool checkNews(std::span<const std::uint8_t> bytes) {
    const auto news = newsFrom(bytes);
    if (!news)
        return false;
    const auto again = newsFrom(toMessage(*news));
    require(again && again->done == news->done && again->samples == news->samples &&
                again->descriptionBytes == news->descriptionBytes,
            "news arrive as they were sent");
    return true;
}

bool checkDescription(std::span<const std::uint8_t> bytes) {
    const auto description = descriptionFrom(bytes, kMostSamples);
    if (!description || !*description)
        return description.has_value();
    const PictureDescription& said = **description;
    require(said.size.width > 0 && said.size.height > 0 && said.channels > 0,
            "a picture has samples");
    require(said.samples() <= kMostSamples, "a picture keeps to the budget");
    require(said.loaded.image.empty() && !said.loaded.alpha, "samples come later");
    return true;
}

} // namespace

bool readOne(std::string_view bytes) {
    const std::span<const std::uint8_t> message(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                                bytes.size());
    const bool isRequest = checkRequest(message);
    const bool isNews = checkNews(message);
    return checkDescription(message) || isRequest || isNews;
}

std::vector<std::string> seeds() {
    LoadedImage loaded;
    loaded.image = Image({5, 3}, 3);
    loaded.alpha = Image({5, 3}, 1);
    loaded.channelNames = {"R", "G", ""};
    loaded.attributes = {{"texton:a", "1"}, {"texton:b", ""}};
    std::vector<std::string> all;
    for (const Message& message : {toMessage(DecodeRequest{"some.png", 1000}),
                                   toMessage(DecodeNews{.done = false, .samples = 45}),
                                   toMessage(DecodeNews{.done = true, .descriptionBytes = 99}),
                                   describe(loaded),
                                   describe(Error{ErrorCode::Unreadable, "some.png is damaged"})})
        all.emplace_back(message.begin(), message.end());
    return all;
}

} // namespace txn::fuzz
