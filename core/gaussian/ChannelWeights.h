// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/Exemplar.h"

#include <vector>

namespace txn {

/// By what the channels are multiplied where they are added up, so that the maps of a stack, in
/// their different units, count alike: 1 / max(standard deviation, 1/255) each. All 1 for plain
/// pictures, whose channels share a unit. Thread-safe.
[[nodiscard]] std::vector<double> channelWeights(const Exemplar& exemplar);

} // namespace txn
