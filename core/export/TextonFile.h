// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/TextonAsset.h"

#include <string_view>

namespace txn {

/// Text of a `.texton` file, version 1, the format of the authors of [TN17]: coefficients with nine
/// significant digits, so that every float survives. Grey is written three times.
/// Errors: Unsupported for several kernels or channel counts other than 1 and 3.
[[nodiscard]] Result<std::string> toTextonFile(const TextonAsset& asset);

/// Reads such a text. The frame is stripped, whatever the order; the format says nothing of the
/// process, so the defaults apply. Errors: Unreadable, saying what is wrong and, where it helps, in
/// which line.
[[nodiscard]] Result<TextonAsset> fromTextonFile(std::string_view text);

} // namespace txn
