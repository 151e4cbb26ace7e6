// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/Mixture.h"

#include "core/mixing/TextonField.h"

#include <algorithm>
#include <cmath>

namespace txn {
namespace {

bool isFinite(const Texton& texton) {
    const auto finite = [](auto v) { return std::isfinite(v); };
    return std::ranges::all_of(texton.mean, finite) &&
           std::ranges::all_of(texton.kernels, [&](const Image& kernel) {
               return std::ranges::all_of(kernel.samples(), finite);
           });
}

} // namespace

Result<void> checkMixedTextons(std::span<const Texton> textons) {
    if (textons.empty() || textons.size() > static_cast<std::size_t>(TextonField::kMaxTextons))
        return Error{ErrorCode::InvalidArgument,
                     "a mixture has 1 to " + std::to_string(TextonField::kMaxTextons) + " textons"};
    const Texton& first = textons.front();
    for (const Texton& texton : textons) {
        if (texton.support.size() != first.support.size() ||
            texton.interpolationOrder != first.interpolationOrder ||
            texton.kernelCount() != first.kernelCount() || texton.channels() != first.channels() ||
            texton.transfer != first.transfer)
            return Error{ErrorCode::SizeMismatch,
                         "the textons of a mixture must have one size, order and number of kernels "
                         "and channels"};
        if (!isFinite(texton))
            return Error{ErrorCode::Degenerate, "the texton holds values that are not numbers"};
    }
    return {};
}

Result<void> checkMixture(const Mixture& mixture) {
    if (const auto ok = checkMixedTextons(mixture.textons); !ok)
        return ok.error();
    return checkMixingMap(mixture.map);
}

} // namespace txn
