// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/ThreadPriority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace txn::app {

void lowerThreadPriority([[maybe_unused]] ThreadPriority priority) {
#ifdef __linux__
    // On Linux this means the calling thread, not the process.
    setpriority(PRIO_PROCESS, 0, priority == ThreadPriority::Drawing ? 5 : 10);
#endif
}

} // namespace txn::app
