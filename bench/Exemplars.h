// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gaussian/Exemplar.h"

#include <optional>

namespace txn::bench {

/// The photograph of that name, if it is at hand.
std::optional<Exemplar> photograph(const char* fileName);

/// The photograph of that name when it is at hand, otherwise a generated material of the same size,
/// after saying so on standard error.
Exemplar photographOrSample(const char* fileName, Size size);

} // namespace txn::bench
