// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>

namespace txn {

/// Drops the errors that OpenGL holds from before, so that the next one is ours. Ends even where
/// the context is lost, which reports errors forever.
void forgetGlErrors();

/// For after memory of the graphics card was asked for. Errors: TooLarge if there was an error
/// since, saying that there is not enough for what.
[[nodiscard]] Result<void> checkGlMemory(const std::string& what);

} // namespace txn
