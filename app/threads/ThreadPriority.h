// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace txn::app {

/// Live pictures come before computations, and the interface before both.
enum class ThreadPriority { Drawing, Computing };

/// For the calling thread and those that it starts later. Does nothing where the system has no such
/// thing per thread.
void lowerThreadPriority(ThreadPriority priority);

} // namespace txn::app
