// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/image/Image.h"

#include <span>
#include <string_view>

namespace txn {

/// One of the materials that the program can draw by itself.
struct SampleInfo {
    std::string_view name;        ///< what makeSample is called with: lower case, one word
    std::string_view description; ///< one line for people
};

/// Every material, the default one first. Thread-safe.
[[nodiscard]] std::span<const SampleInfo> sampleCatalog();

/// An exemplar that looks like a photograph of the material: RGB, Encoded, values within [0, 1],
/// free of copyright. It tiles. Sizes are in pixels of which some 25 make a centimetre, so a larger
/// image shows more of the material, not larger features. Equal seeds give equal bytes for any
/// number of threads.
/// Errors: InvalidArgument for an unknown name (the message lists the names) and for a width or
/// height outside 16..16384. Thread-safe.
[[nodiscard]] Result<Image> makeSample(std::string_view name, Size size, Seed seed);

} // namespace txn
