// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/DecodeChannel.h"
#include "core/image/FileBytes.h"

#include <variant>

namespace txn {

/// Why a decoder gave no answer. It is of no more use then.
enum class DecodeFailure { Died, TooSlow, Nonsense };
using DecodeAnswer = std::variant<LoadedImage, Error, DecodeFailure>;

/// The program's ends of what it shares with a decoder.
struct DecoderConnection {
    DecodeChannel messages;
    FileDescriptor pictures; ///< of a pipe, and reading it never waits (O_NONBLOCK)
};

/// Has the decoder at the other end decode the file, and waits as long as a picture of its size
/// may take. name is for messages. Trusts nothing that comes back. Internal to core/image.
[[nodiscard]] DecodeAnswer askDecoder(const DecoderConnection& decoder,
                                      const FileBytes& file,
                                      const std::filesystem::path& name,
                                      const LoadOptions& options);

/// Whether the decoder says, in time for a busy machine, that it is there.
[[nodiscard]] bool waitUntilReady(const DecoderConnection& decoder);

} // namespace txn
