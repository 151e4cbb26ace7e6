// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeClient.h"

#include "core/image/DecodeLimits.h"

#include <algorithm>
#include <cerrno>
#include <unistd.h>

namespace txn {
namespace {

using Clock = std::chrono::steady_clock;
using Got = DecodeChannel::Got;

/// What the decoder writes into the pipe until a deadline. Waits for no byte longer than that.
class PictureBytes {
  public:
    PictureBytes(const FileDescriptor& pipe, Clock::time_point deadline)
        : m_pipe(pipe.get()), m_deadline(deadline) {}

    /// Reads size bytes; or says why they do not come.
    std::optional<DecodeFailure> read(void* data, std::size_t size) const {
        auto* bytes = static_cast<char*>(data);
        while (size > 0) {
            const ssize_t got = ::read(m_pipe, bytes, size);
            if (got == 0)
                return DecodeFailure::Died;
            if (got < 0 && errno == EAGAIN && !waitForReading(m_pipe, &m_deadline))
                return DecodeFailure::TooSlow;
            if (got < 0 && errno != EINTR && errno != EAGAIN)
                return DecodeFailure::Died;
            const auto count = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
            bytes += count;
            size -= count;
        }
        return std::nullopt;
    }
    std::optional<DecodeFailure> read(Image& image) const {
        return read(image.samples().data(), image.samples().size_bytes());
    }

  private:
    int m_pipe;
    Clock::time_point m_deadline;
};

DecodeAnswer
received(const PictureBytes& from, std::uint64_t descriptionBytes, const LoadOptions& options) {
    Message bytes(descriptionBytes);
    if (const auto failure = from.read(bytes.data(), bytes.size()))
        return *failure;
    auto described = descriptionFrom(bytes, options.maxSamples);
    if (!described)
        return DecodeFailure::Nonsense;
    if (!*described)
        return described->error();
    PictureDescription& picture = **described;
    LoadedImage& loaded = picture.loaded;
    loaded.image = Image(picture.size, picture.channels, 0.0F, picture.transfer);
    if (const auto failure = from.read(loaded.image))
        return *failure;
    if (picture.hasAlpha) {
        loaded.alpha = Image(picture.size, 1);
        if (const auto failure = from.read(*loaded.alpha))
            return *failure;
    }
    return std::move(loaded);
}

} // namespace

DecodeAnswer askDecoder(const DecoderConnection& decoder,
                        const FileBytes& file,
                        const std::filesystem::path& name,
                        const LoadOptions& options) {
    const DecodeRequest request{.name = name.string(), .maxSamples = options.maxSamples};
    if (!decoder.messages.send(toMessage(request), file.descriptor()))
        return DecodeFailure::Died;
    const auto begin = Clock::now();
    auto deadline = begin + decodingTime(file.size(), kSamplesBeforeHeader);
    while (true) {
        const auto message = decoder.messages.receive(&deadline);
        if (message.got == Got::Closed)
            return DecodeFailure::Died;
        if (message.got == Got::Nothing)
            return DecodeFailure::TooSlow;
        const auto news = newsFrom(message.message);
        if (!news)
            return DecodeFailure::Nonsense;
        if (news->done)
            return received({decoder.pictures, deadline}, news->descriptionBytes, options);
        // More time for a large picture, but never more than the largest may take.
        deadline = begin + decodingTime(file.size(),
                                        std::min<std::uint64_t>(news->samples, options.maxSamples));
    }
}

bool waitUntilReady(const DecoderConnection& decoder) {
    constexpr std::chrono::seconds kPatience(30);
    const auto deadline = Clock::now() + kPatience;
    const auto message = decoder.messages.receive(&deadline);
    return message.got == Got::Whole && newsFrom(message.message).has_value();
}

} // namespace txn
