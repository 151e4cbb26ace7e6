// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn {

/// Drops the errors that OpenGL holds from before, so that the next one is ours. Ends even where
/// the context is lost, which reports errors forever.
void forgetGlErrors();

} // namespace txn
