// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"

#include <filesystem>

namespace txn::cli {

/// Whether the file begins as a project of Texton Studio does.
[[nodiscard]] bool isProject(const std::filesystem::path& path);

/// The small picture that a project carries. Nothing else of the project is looked at, and no file
/// that it names. Errors (naming the file): NotFound, Unreadable; those of loadImage.
[[nodiscard]] Result<Image> projectThumbnail(const std::filesystem::path& path);

} // namespace txn::cli
