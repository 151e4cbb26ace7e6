// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/CancelToken.h"
#include "core/base/Result.h"
#include "core/gaussian/Exemplar.h"

namespace txn {

/// The exemplar turned as `rotated` does; slopes turn with it. Errors: those of rotated.
[[nodiscard]] Result<Exemplar>
turned(Exemplar exemplar, double degreesCounterClockwise, const CancelToken& cancel = {});

/// The exemplar with its lighting evened as flattenLighting does; of a stack, that of its colors.
/// Errors: those of flattenLighting.
[[nodiscard]] Result<Exemplar>
lightingEvened(Exemplar exemplar, double radiusPx, const CancelToken& cancel = {});

} // namespace txn
