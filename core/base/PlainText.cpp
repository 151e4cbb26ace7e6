// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/PlainText.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace txn {
namespace {

/// The character that begins there, if it is one of three bytes or fewer; else 0.
unsigned codePoint(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    if (byte(0) < 0x80U)
        return byte(0);
    if ((byte(0) & 0xe0U) == 0xc0U)
        return ((byte(0) & 0x1fU) << 6U) | (byte(1) & 0x3fU);
    if ((byte(0) & 0xf0U) == 0xe0U)
        return ((byte(0) & 0x0fU) << 12U) | ((byte(1) & 0x3fU) << 6U) | (byte(2) & 0x3fU);
    return 0;
}

std::size_t bytesOf(unsigned point) {
    return point < 0x80U ? 1 : point < 0x800U ? 2 : 3;
}

bool isControl(unsigned point) {
    return point < 0x20U || (point >= 0x7fU && point < 0xa0U) || point == 0x61cU ||
           point == 0x200eU || point == 0x200fU || (point >= 0x2028U && point <= 0x202eU) ||
           (point >= 0x2066U && point <= 0x2069U);
}

template <class Write>
std::string replaced(std::string_view text, bool alsoAscii, Write write) {
    std::string result;
    while (!text.empty()) {
        const unsigned point = codePoint(text);
        // 0 also stands for what is of four bytes or no UTF-8.
        const bool known = point != 0 || text.front() == '\0';
        if (known && isControl(point) && (alsoAscii || point >= 0x7fU)) {
            result += write(point);
            text.remove_prefix(std::min(bytesOf(point), text.size()));
        } else {
            result += text.front();
            text.remove_prefix(1);
        }
    }
    return result;
}

} // namespace

std::string inOneLine(std::string_view text) {
    return replaced(text, true, [](unsigned) { return std::string(" "); });
}

std::string withEscapedControls(std::string_view json) {
    // Those of ASCII are escaped already, or stand between the values.
    return replaced(json, false, [](unsigned point) {
        std::array<char, 12> text{};
        std::snprintf(text.data(), text.size(), "\\u%04x", point);
        return std::string(text.data());
    });
}

} // namespace txn
