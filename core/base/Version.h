// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace txn {

/// Set by the build from the project's version.
inline constexpr const char* kProgramVersion = TXN_VERSION;

/// Name and version of each library that the program was built with, such as "FFTW 3.3.10".
[[nodiscard]] std::span<const char* const> libraryVersions();

} // namespace txn
