// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/OutputFiles.h"
#include "core/export/TextonAsset.h"
#include "core/image/ImageIo.h"

#include <filesystem>
#include <span>
#include <variant>
#include <vector>

namespace txn {

/// Writes a texton to one or several files, told by their endings: `.texton`, `.exr` (float,
/// without loss) or `.png` (16 bit), each with a sidecar named like the file plus ".json". A PNG of
/// a stack is a set: one file for each map, named like the output plus "_" and the map's name, and
/// one sidecar. All appear together or none does. Returns the paths, sidecars included. Errors:
/// Unsupported (ending, or a texton that the format cannot hold); Unwritable.
[[nodiscard]] Result<std::vector<std::filesystem::path>>
saveTexton(const TextonAsset& asset, std::span<const std::filesystem::path> outputs);

/// The same for one output, among files that appear together. Appends the paths to written.
[[nodiscard]] Result<void> addTexton(const TextonAsset& asset,
                                     const std::filesystem::path& path,
                                     OutputFiles& files,
                                     std::vector<std::filesystem::path>& written);

/// All files of a texton that is stored under path: its pictures and its sidecar.
[[nodiscard]] std::vector<std::filesystem::path> textonFiles(const std::filesystem::path& path,
                                                             const MaterialMaps& maps);

/// Whether saveTexton could write these, as far as can be known before there is a texton (of these
/// maps, if it is one of a stack): endings, folders, permissions. Errors: the same.
[[nodiscard]] Result<void> checkTextonOutputs(std::span<const std::filesystem::path> outputs,
                                              const MaterialMaps& maps = {});

/// Reads a texton back from any of these files, or from a sidecar. A PNG needs its sidecar beside
/// it, and a set of PNGs is called by the name that all of it has in common; for a `.texton`
/// the sidecar, if there is one that fits, adds what the format cannot hold. Errors (naming
/// the file): NotFound, Unreadable, Unsupported.
[[nodiscard]] Result<TextonAsset> loadTexton(const std::filesystem::path& path);

/// Reads a texton where the file is one, a picture otherwise.
[[nodiscard]] Result<std::variant<TextonAsset, LoadedImage>>
loadTextonOrImage(const std::filesystem::path& path, const LoadOptions& options = {});

} // namespace txn
