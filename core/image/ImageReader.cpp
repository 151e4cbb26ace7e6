// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"
#include "core/image/DecoderProcess.h"
#include "core/image/ImageIo.h"

#include <mutex>
#include <new>
#include <vector>

namespace txn {
namespace {

using Path = std::filesystem::path;

/// Decoders that wait for their next picture: starting one takes longer than most pictures do.
class IdleDecoders {
  public:
    std::optional<DecoderProcess> take() {
        const std::lock_guard lock(m_mutex);
        if (m_idle.empty())
            return std::nullopt;
        auto decoder = std::move(m_idle.back());
        m_idle.pop_back();
        return decoder;
    }
    void give(DecoderProcess decoder) {
        constexpr std::size_t kMost = 2;
        const std::lock_guard lock(m_mutex);
        if (m_idle.size() < kMost)
            m_idle.push_back(std::move(decoder));
    }

  private:
    std::mutex m_mutex;
    std::vector<DecoderProcess> m_idle;
};

IdleDecoders& idleDecoders() {
    static IdleDecoders decoders;
    return decoders;
}

Error failed(const Path& path, DecodeFailure failure) {
    const std::string reason = failure == DecodeFailure::TooSlow ? "decoding it takes far too long"
                                                                 : "its decoder crashed";
    return {ErrorCode::Unreadable,
            "cannot read " + quoted(path) + ": " + reason +
                "; the file is damaged, or made to do harm"};
}

Result<LoadedImage>
decodeWithIdle(const FileBytes& file, const Path& path, const LoadOptions& options) {
    auto decoder = idleDecoders().take();
    const bool fresh = !decoder;
    if (fresh) {
        auto started = DecoderProcess::start();
        if (!started)
            return started.error();
        decoder = *std::move(started);
    }
    auto answer = decoder->decode(file, path, options);
    if (const auto* failure = std::get_if<DecodeFailure>(&answer)) {
        // One that waited may have ended for a reason of its own, such as want of memory.
        if (!fresh && *failure == DecodeFailure::Died)
            return decodeWithIdle(file, path, options);
        return failed(path, *failure);
    }
    idleDecoders().give(*std::move(decoder));
    if (auto* error = std::get_if<Error>(&answer))
        return std::move(*error);
    return std::move(std::get<LoadedImage>(answer));
}

Result<LoadedImage>
decode(const Result<FileBytes>& file, const Path& path, const LoadOptions& options) {
    if (!file)
        return file.error();
    try {
        return decodeWithIdle(*file, path, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, "there is not enough memory to read " + quoted(path)};
    }
}

} // namespace

void startImageReading() {
    if (auto decoder = idleDecoders().take())
        idleDecoders().give(*std::move(decoder));
    else if (auto started = DecoderProcess::start())
        idleDecoders().give(*std::move(started));
}

Result<LoadedImage> loadImage(const Path& path, const LoadOptions& options) {
    return decode(FileBytes::open(path), path, options);
}

Result<LoadedImage>
loadImage(std::span<const std::uint8_t> content, const Path& name, const LoadOptions& options) {
    return decode(FileBytes::holding(content, name), name, options);
}

} // namespace txn
