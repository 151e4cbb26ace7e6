// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>

namespace txn::cli {

/// Tells before the work what would fail after it. Errors: InvalidArgument where a command would
/// write over the very file that it reads.
[[nodiscard]] Result<void> checkNotInput(const std::filesystem::path& input,
                                         const std::filesystem::path& output);

/// For pictures. Errors: Unsupported endings; Unwritable places.
[[nodiscard]] Result<void> checkPictureOutput(const std::filesystem::path& output);
/// Both.
[[nodiscard]] Result<void> checkPictureOutput(const std::filesystem::path& input,
                                              const std::filesystem::path& output);

} // namespace txn::cli
