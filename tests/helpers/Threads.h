// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace txn::test {

/// What f gives when run on that many threads.
template <class Function>
auto onThreads(int count, Function f) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
    tbb::task_arena arena(count);
    return arena.execute(f);
}

} // namespace txn::test
