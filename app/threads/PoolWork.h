// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QThreadPool;

namespace txn::app {

/// Work for a thread of the pool; higher priorities come first where threads are short.
void startOn(QThreadPool& pool, std::function<void()> work, int priority = 0);

/// Until all of the pool's work has ended.
void waitFor(QThreadPool& pool);

} // namespace txn::app
