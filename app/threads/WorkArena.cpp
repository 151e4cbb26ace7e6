// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/WorkArena.h"

#include <tbb/task_arena.h>

namespace txn::app {

void runOnCores(int cores, const std::function<void()>& work) {
    tbb::task_arena arena(cores);
    arena.execute(work);
}

} // namespace txn::app
