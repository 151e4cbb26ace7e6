// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"
#include "app/jobs/JobRunner.h"
#include "app/jobs/Results.h"

namespace txn::app {

/// Computes the texton, telling publish about it several times a second on the way. Errors: those
/// of txn::computeTexton, naming the exemplar; Cancelled.
[[nodiscard]] Result<std::shared_ptr<const TextonResult>>
computeTexton(const ExemplarResult& exemplar,
              const TextonSettings& settings,
              JobContext& context,
              const std::function<void(std::shared_ptr<const TextonResult>)>& publish);

/// A texton that was opened, as a result.
[[nodiscard]] std::shared_ptr<const TextonResult> importedTexton(const TextonAsset& asset);

/// The texton whose noise, or of a stack the noise's colors, has the given contrast and brightness:
/// noise is linear in it.
[[nodiscard]] Texton
adjusted(Texton texton, const MaterialMaps& maps, double contrast, double brightness);

} // namespace txn::app
