// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/WhiteNoise.h"
#include "core/noise/NoiseGrid.h"

#include <benchmark/benchmark.h>

namespace {

using namespace txn;

Texton randomTexton(int side) {
    Texton texton;
    texton.support = Support::rectangle({side, side});
    texton.mean = {0.5, 0.4, 0.3};
    texton.kernels = {whiteNoise({side, side}, 3, Seed{1})};
    return texton;
}

void report(benchmark::State& state, Size size) {
    state.counters["megapixels"] = benchmark::Counter(static_cast<double>(state.iterations()) *
                                                          static_cast<double>(size.area()) * 1e-6,
                                                      benchmark::Counter::kIsRate);
}

/// RGB noise in memory, one output pixel per exemplar pixel.
void baking(benchmark::State& state) {
    constexpr Size kSize{4096, 4096};
    NoiseParams params;
    params.meanImpacts = static_cast<double>(state.range(1));
    const auto grid = NoiseGrid::create(randomTexton(static_cast<int>(state.range(0))), params);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(grid->render({0, 0, kSize}));
    report(state, kSize);
}
BENCHMARK(baking)
    ->ArgNames({"support", "mni"})
    ->ArgsProduct({{64}, {4, 12, 30, 100}})
    ->Args({32, 12})
    ->Args({128, 12})
    ->Args({256, 12})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same at other scales; the argument is the scale in percent.
void bakingScaled(benchmark::State& state) {
    constexpr Size kSize{1024, 1024};
    const auto grid =
        NoiseGrid::create(randomTexton(64), {}, static_cast<double>(state.range(0)) / 100.0);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(grid->render({0, 0, kSize}));
    report(state, kSize);
}
BENCHMARK(bakingScaled)
    ->ArgName("percent")
    ->Arg(400)
    ->Arg(200)
    ->Arg(50)
    ->Arg(25)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
