// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>

namespace txn::cli {

/// Errors: InvalidArgument where a command would write over the very file that it reads.
[[nodiscard]] Result<void> checkOutput(const std::filesystem::path& input,
                                       const std::filesystem::path& output);

} // namespace txn::cli
