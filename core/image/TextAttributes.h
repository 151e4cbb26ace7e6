// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/ImageIo.h"

#include <string_view>

namespace txn {

/// Internal to core/image: how ImageAttributes are named and put into a single text.
inline constexpr std::string_view kAttributePrefix = "texton:";
inline const std::string kTransferAttribute = "texton:transfer";

/// One line "name=value" each; line ends and backslashes in values are escaped.
[[nodiscard]] std::string textFromAttributes(const ImageAttributes& attributes);
/// Inverse; other lines are passed over.
[[nodiscard]] ImageAttributes attributesFromText(std::string_view text);

} // namespace txn
