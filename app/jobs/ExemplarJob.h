// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"
#include "app/jobs/JobRunner.h"
#include "app/jobs/Results.h"

namespace txn::app {

/// Crops, straightens, evens out and converts the picture, in this order, and makes its model and
/// the pictures that the panel shows. Errors: those of the steps, naming the source; Cancelled.
[[nodiscard]] Result<std::shared_ptr<const ExemplarResult>> makeExemplarResult(
    const std::shared_ptr<const Source>& source, const ExemplarEdit& edit, JobContext& context);

} // namespace txn::app
