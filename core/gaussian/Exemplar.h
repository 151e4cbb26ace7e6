// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"
#include "core/material/MaterialMap.h"

#include <string>

namespace txn {

/// A picture of a material, or a stack of maps of it, that a Gaussian model can be made of: 1 to
/// kMaxExemplarChannels channels, every sample finite and at most kLargestSample in size. Made by
/// makeExemplar only.
struct Exemplar {
    /// Far beyond any light, and its square times any number of pixels still fits a float.
    static constexpr float kLargestSample = 1e12F;

    Image image;
    std::string name;    ///< for messages and metadata: the file's name without folders
    MaterialMaps maps{}; ///< of a stack; empty for a plain picture
};

/// Errors: Unsupported for too many channels; Degenerate for NaN, infinite or huge samples (the
/// message says where the first one is); SizeMismatch for maps of other numbers of channels.
/// Thread-safe.
[[nodiscard]] Result<Exemplar> makeExemplar(Image image, std::string name, MaterialMaps maps = {});

} // namespace txn
