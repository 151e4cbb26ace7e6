// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"
#include "app/jobs/JobRunner.h"
#include "app/jobs/Results.h"

namespace txn::app {

/// What the textons between two exemplars depend on, but for their number.
struct MixInput {
    std::shared_ptr<const ExemplarResult> a;
    std::shared_ptr<const ExemplarResult> b;
    TextonSettings settings;

    bool operator==(const MixInput&) const = default;
};

/// Computes the textons, telling publish whenever some more are there. known: an earlier result for
/// the same input; what it has is not computed again. Errors: those of makeMixSolver and
/// MixSolver::step; Cancelled.
[[nodiscard]] Result<std::shared_ptr<const MixResult>>
computeMix(const MixInput& input,
           int textons,
           const std::shared_ptr<const MixResult>& known,
           JobContext& context,
           const std::function<void(std::shared_ptr<const MixResult>)>& publish);

/// The same from B to A.
[[nodiscard]] std::shared_ptr<const MixResult> reversed(const MixResult& result);

} // namespace txn::app
