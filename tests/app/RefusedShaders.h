// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace txn::test {

/// As long as it lives, the driver finds an error in all shaders that contain the word. One at a
/// time; begins and ends while nothing is compiled.
class RefusedShaders {
  public:
    explicit RefusedShaders(std::string word);
    ~RefusedShaders();
    RefusedShaders(const RefusedShaders&) = delete;
    RefusedShaders& operator=(const RefusedShaders&) = delete;

    /// So far.
    int count() const;
};

} // namespace txn::test
