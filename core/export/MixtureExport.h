// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/OutputFiles.h"
#include "core/base/Result.h"
#include "core/material/MaterialMap.h"
#include "core/mixing/Mixture.h"
#include "core/noise/NoiseParams.h"

#include <filesystem>
#include <string>
#include <vector>

namespace txn {

/// A mixture with what is worth knowing of it beside its textons and its map.
struct MixtureAsset {
    Mixture mixture;
    std::vector<double> rhos;      ///< of each texton
    std::vector<double> distances; ///< d_OT of each from A
    NoiseProcess process = NoiseProcess::Stratified;
    double meanImpacts = defaultMeanImpacts(NoiseProcess::Stratified);
    Seed seed; ///< that the textons were computed with
    std::string exemplarA;
    std::string exemplarB;
    MaterialMaps maps; ///< of stacks; empty for plain pictures
};

/// The files that saveMixture writes into a folder: "textons.exr" with a layer for each texton,
/// "mixture.json" that describes it (docs/FORMATS.md), "map.png", and each texton as a file of its
/// own with its sidecar, "texton_00.exr" ...
[[nodiscard]] std::vector<std::filesystem::path> mixtureFiles(const std::filesystem::path& folder,
                                                              std::size_t textons);

/// Writes all of them, or none. The folder is made where it is missing, if
/// the one that it lies in is there. Returns the paths. Errors:
/// Unwritable.
[[nodiscard]] Result<std::vector<std::filesystem::path>>
saveMixture(const MixtureAsset& asset, const std::filesystem::path& folder);

/// Whether saveMixture could write these, as far as can be known before there are any. Errors: the
/// same.
[[nodiscard]] Result<void> checkMixtureOutputs(const std::filesystem::path& folder,
                                               std::size_t textons);

/// Adds the map alone to files that appear together: grey, 16 bits where the type has them, black
/// for A and white for B. Errors: those of saveImage.
[[nodiscard]] Result<void>
addMixingMap(const MixingMap& map, const std::filesystem::path& path, OutputFiles& files);

} // namespace txn
