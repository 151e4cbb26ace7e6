// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn {

/// Set by the build from the project's version.
inline constexpr const char* kProgramVersion = TXN_VERSION;

} // namespace txn
