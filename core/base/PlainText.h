// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace txn {

// Names come from files of anybody. In text that people and compilers read, no character of theirs
// may end a line or turn the order in which the others are shown: control characters, line and
// paragraph separators, and the controls of bidirectional text. UTF-8 in and out. Thread-safe.

/// Each of them as a space: for one line of a file or of a comment.
[[nodiscard]] std::string inOneLine(std::string_view text);

/// JSON text that means the same, with those within its strings escaped.
[[nodiscard]] std::string withEscapedControls(std::string_view json);

} // namespace txn
