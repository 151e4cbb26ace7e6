// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef TXN_THREAD_SANITIZED
#include <sanitizer/tsan_interface.h>
#endif

namespace txn::app {

/// For ThreadSanitizer, which does not see the locks of libraries that are built without it: what a
/// thread did before it gave something to another by Qt's queues is done when the other one takes
/// it. Nothing in other builds.
class HandOver {
  public:
    static void give() {
#ifdef TXN_THREAD_SANITIZED
        __tsan_release(&s_place);
#endif
    }
    static void take() {
#ifdef TXN_THREAD_SANITIZED
        __tsan_acquire(&s_place);
#endif
    }

  private:
    static inline char s_place = 0;
};

} // namespace txn::app
