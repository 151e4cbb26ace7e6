// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texton/Texton.h"

#include <functional>

namespace txn {

/// What is known of a texton after an iteration, whichever way it is computed. Valid during the
/// call only.
struct TextonProgress {
    int iteration = 0;  ///< from 1
    int iterations = 0; ///< at most so many
    /// What the method makes small, relative to the exemplar: the relative model error of
    /// projections, the square root of CovarianceObjective's J of fits. May cost half an iteration.
    std::function<double()> error;
    /// The texton as it is now, without colour correction. Costs a copy.
    std::function<Texton()> texton;
};

/// Called after every iteration, on the computing thread.
using TextonObserver = std::function<void(const TextonProgress&)>;

} // namespace txn
