// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Random.h"
#include "core/texton/Support.h"

namespace txn {

/// How a texton is computed by alternating projections.
struct TextonParams {
    Support support = Support::rectangle({64, 64});
    int interpolationOrder = 1; ///< 0, 1, 3 or 5
    int iterations = 50;        ///< 1 to 100000
    /// 0 to below 1; 0 gives the papers' plain iteration. 0.9 needs a third of the iterations.
    double momentum = 0.9;
    Seed seed;

    bool operator==(const TextonParams&) const = default;
};

} // namespace txn
