// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace txn {

/// Width and height in samples.
struct Size {
    int width = 0;
    int height = 0;

    std::size_t area() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    bool operator==(const Size&) const = default;
};

/// "640 x 480".
[[nodiscard]] inline std::string sizeText(Size size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// A rectangle of pixels of the plane or of an image: y down, right and bottom excluded.
struct Rect {
    std::int64_t x = 0;
    std::int64_t y = 0;
    Size size;

    bool operator==(const Rect&) const = default;
};

} // namespace txn
