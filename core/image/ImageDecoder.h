// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/FileBytes.h"
#include "core/image/ImageIo.h"

#include <cstdint>
#include <functional>

namespace txn {

/// Told how many samples a picture has as soon as that is known, before memory is taken for them.
using SamplesKnown = std::function<void(std::uint64_t samples)>;

/// What loadImage promises, in this process: decoders that a hostile picture can crash or take
/// over run here. name is for messages. Thread-safe.
[[nodiscard]] Result<LoadedImage> decodeImage(FileBytes file,
                                              const std::filesystem::path& name,
                                              const LoadOptions& options,
                                              const SamplesKnown& samplesKnown = {});

} // namespace txn
