// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/JobRunner.h"
#include "app/jobs/Results.h"

namespace txn::app {

/// What can be expected of the exemplar; of a stack, its colors suit or not.
[[nodiscard]] std::shared_ptr<const Judgement> judge(const ExemplarResult& exemplar,
                                                     JobContext& context);

} // namespace txn::app
