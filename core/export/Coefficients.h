// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/TextonAsset.h"

#include <string>
#include <vector>

namespace txn {

/// The coefficients as they are stored: a picture of the footprint's size, zero on the frame, with
/// the channels of kernel after kernel.
[[nodiscard]] Image framedCoefficients(const Texton& texton);

/// A name for each of them: "R", "kernel1.G", "kernel0.normal.X" ...
[[nodiscard]] std::vector<std::string> coefficientNames(const TextonAsset& asset);

} // namespace txn
