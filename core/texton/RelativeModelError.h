// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/gaussian/GaussianModel.h"
#include "core/texton/Texton.h"

namespace txn {

/// Relative model error between the Gaussian textures of a texton with one kernel and of an
/// exemplar: 0 = same law. It stays near 0.46 even for excellent textons, since a small kernel can
/// only follow the local mean of the exemplar's rough periodogram.
/// Errors: SizeMismatch if the support exceeds the model's domain or the channels differ;
/// Unsupported for several kernels; Degenerate for a model without variance.
[[nodiscard]] Result<double> relativeModelError(const GaussianModel& model, const Texton& texton);

} // namespace txn
