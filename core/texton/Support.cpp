// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/Support.h"

#include <algorithm>
#include <cassert>

namespace txn {

Support Support::rectangle(Size size) {
    assert(size.width > 0 && size.height > 0);
    return {SupportShape::Rectangle, size, {}};
}

Support Support::disc(int diameter) {
    assert(diameter > 0);
    const auto side = static_cast<std::size_t>(diameter);
    std::vector<std::uint8_t> inside(side * side);
    for (int y = 0; y < diameter; ++y) {
        for (int x = 0; x < diameter; ++x) {
            // Doubled coordinates keep the test exact: |2x - (r - 1)|^2 <= r^2.
            const long long dx = 2LL * x - (diameter - 1);
            const long long dy = 2LL * y - (diameter - 1);
            const bool in = dx * dx + dy * dy <= 1LL * diameter * diameter;
            inside[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] = in ? 1 : 0;
        }
    }
    return {SupportShape::Disc, {diameter, diameter}, std::move(inside)};
}

Result<Support> Support::mask(Size size, std::vector<std::uint8_t> inside) {
    if (size.width < 1 || size.height < 1 || inside.size() != size.area())
        return Error{ErrorCode::InvalidArgument, "the mask does not match its size"};
    if (std::none_of(inside.begin(), inside.end(), [](std::uint8_t v) { return v != 0; }))
        return Error{ErrorCode::InvalidArgument, "the mask of the support is empty"};
    // Equal supports have equal bytes, whatever stood for "inside".
    std::ranges::transform(inside, inside.begin(), [](std::uint8_t v) -> std::uint8_t {
        return v != 0 ? 1 : 0;
    });
    return Support{SupportShape::Mask, size, std::move(inside)};
}

} // namespace txn
