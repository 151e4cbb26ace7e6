// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace txn::app {

/// Runs work on the calling thread, with core's parallel loops on so many cores at most. Its own
/// file, since TBB and Qt both want the word "emit".
void runOnCores(int cores, const std::function<void()>& work);

} // namespace txn::app
