// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"
#include "core/image/ImageIo.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace txn::cli {

/// One map of a stack, as given with --stack.
struct StackEntry {
    std::string name;
    MapKind kind = MapKind::Data;
    std::filesystem::path path;
};

/// The exemplar and how it is prepared, for all commands that start from a photograph.
struct ExemplarOptions {
    std::filesystem::path path;          ///< or
    std::vector<StackEntry> stack;       ///< registered maps of one material
    std::string stackOption = "--stack"; ///< what that is called
    std::optional<Rect> crop;
    double rotate = 0.0;
    std::optional<double> flatten;
    bool linear = false;
    LoadOptions load;
};

void addExemplarOptions(CLI::App& app, ExemplarOptions& options);
/// The same, for commands that take stacks as well: --stack instead of a picture.
void addMaterialOptions(CLI::App& app, ExemplarOptions& options);

/// That option alone.
void addStackOption(CLI::App& app, ExemplarOptions& options);

/// All files that are read.
[[nodiscard]] std::vector<std::filesystem::path> inputFiles(const ExemplarOptions& options);
/// For messages: the picture, or the first map.
[[nodiscard]] std::filesystem::path mainFile(const ExemplarOptions& options);

/// Loads and prepares: crop, then straighten, then even lighting, then convert. Of stacks, the
/// lighting of the colors is evened.
[[nodiscard]] Result<Exemplar> loadExemplar(const ExemplarOptions& options);

} // namespace txn::cli
