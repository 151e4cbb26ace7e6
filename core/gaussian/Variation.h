// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/GaussianModel.h"

namespace txn {

/// Whether the texture is more than one flat colour: its deviation is above what rounding leaves of
/// a constant picture, some 1e-7 of its mean. Thread-safe.
[[nodiscard]] bool varies(const GaussianModel& model);

} // namespace txn
