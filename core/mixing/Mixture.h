// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mixing/MixingMap.h"
#include "core/texton/Texton.h"

#include <span>
#include <utility>
#include <vector>

namespace txn {

/// Textons on the way from A to B, evenly apart, and which of them each place takes. A texton is a
/// mixture of one. A regular value type.
struct Mixture {
    Mixture() = default;
    Mixture(Texton texton) { textons.push_back(std::move(texton)); }
    Mixture(std::vector<Texton> along, MixingMap where)
        : textons(std::move(along)), map(std::move(where)) {}

    std::vector<Texton> textons; ///< R >= 1, all of one size, order and number of kernels
    MixingMap map;
};

/// Errors: InvalidArgument for no or too many textons; SizeMismatch for textons that do not fit
/// together; Degenerate for coefficients that are not finite.
[[nodiscard]] Result<void> checkMixedTextons(std::span<const Texton> textons);

/// Errors: those of checkMixedTextons and checkMixingMap.
[[nodiscard]] Result<void> checkMixture(const Mixture& mixture);

} // namespace txn
