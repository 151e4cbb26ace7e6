// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"

namespace txn {

struct SupportSuggestion {
    int side = 0; ///< of a square, in pixels
    /// What a texton of that size must leave out: the norm of the covariance at lags over half the
    /// side, relative to all of it, as far as it is more than chance.
    double error = 0.0;
};

/// The smallest side of 16, 24, 32, 48, 64, 96, 128, 192 and 256 whose error is at most 0.2; the
/// largest where none is, up to three eighths of the exemplar's shorter side. Lags up to a quarter
/// of that side are looked at. Chance is told from texture by how far the exemplar's halves are
/// apart. Of exemplars over 1024 pixels the middle is looked at. Errors: SizeMismatch for exemplars
/// below 32 pixels; Degenerate for a flat one. Thread-safe.
[[nodiscard]] Result<SupportSuggestion> suggestSupport(const Exemplar& exemplar);

} // namespace txn
