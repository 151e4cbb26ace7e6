// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

namespace txn::cli {

/// The exemplar and how it is prepared, for all commands that start from a photograph.
struct ExemplarOptions {
    std::filesystem::path path;
    std::optional<Rect> crop;
    double rotate = 0.0;
    std::optional<double> flatten;
    bool linear = false;
};

void addExemplarOptions(CLI::App& app, ExemplarOptions& options);

/// Loads and prepares: crop, then straighten, then even lighting, then convert.
[[nodiscard]] Result<Exemplar> loadExemplar(const ExemplarOptions& options);

} // namespace txn::cli
