// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Geometry.h"
#include "core/base/Result.h"

#include <cstdint>
#include <vector>

namespace txn {

enum class SupportShape { Rectangle, Disc, Mask };

/// The set S of positions where a texton may have non-zero coefficients: a w x h rectangle, a disc
/// inside one, or any mask of it. A regular value type; never empty.
class Support {
  public:
    /// All of w x h.
    static Support rectangle(Size size);
    /// Positions with |x - (r - 1) / 2|^2 <= (r / 2)^2 in an r x r square.
    static Support disc(int diameter);
    /// Any subset: size.area() flags, row-major. Errors: InvalidArgument if no flag is set or the
    /// count is wrong.
    static Result<Support> mask(Size size, std::vector<std::uint8_t> inside);

    Size size() const { return m_size; }
    SupportShape shape() const { return m_shape; }
    bool contains(int x, int y) const {
        return m_inside.empty() ||
               m_inside[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                        static_cast<std::size_t>(x)] != 0;
    }
    bool operator==(const Support&) const = default;

  private:
    Support(SupportShape shape, Size size, std::vector<std::uint8_t> inside)
        : m_shape(shape), m_size(size), m_inside(std::move(inside)) {}

    SupportShape m_shape;
    Size m_size;
    std::vector<std::uint8_t> m_inside; ///< empty: everything
};

} // namespace txn
