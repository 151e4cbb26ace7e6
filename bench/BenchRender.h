// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "gl/HeadlessContext.h"

namespace txn::bench {

/// Registers the rows about drawing with OpenGL: wall time per frame, after one frame that does not
/// count. context: where to draw, or why there is nowhere; must outlive the run of the benchmarks.
void registerRenderBenchmarks(const Result<HeadlessContext>& context);

} // namespace txn::bench
