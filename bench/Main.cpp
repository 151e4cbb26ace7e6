// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/BenchRender.h"

#include <benchmark/benchmark.h>

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    const auto context = txn::HeadlessContext::create();
    benchmark::AddCustomContext("opengl_renderer",
                                context ? context->gl().renderer()
                                        : "none: " + context.error().message);
    txn::bench::registerRenderBenchmarks(context);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
