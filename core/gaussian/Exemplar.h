// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

#include <string>

namespace txn {

/// A picture of a material that a Gaussian model can be made of: 1 to kMaxChannels channels, every
/// sample finite and at most kLargestSample in size. Made by makeExemplar only.
struct Exemplar {
    static constexpr int kMaxChannels = 16;
    /// Far beyond any light, and its square times any number of pixels still fits a float.
    static constexpr float kLargestSample = 1e12F;

    Image image;
    std::string name; ///< for messages and metadata: the file's name without folders
};

/// Errors: Unsupported for too many channels; Degenerate for NaN, infinite or huge samples (the
/// message says where the first one is). Thread-safe.
[[nodiscard]] Result<Exemplar> makeExemplar(Image image, std::string name);

} // namespace txn
