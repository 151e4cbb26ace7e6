// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Exemplars.h"
#include "core/compute/MixSolver.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/noise/NoiseGrid.h"
#include "core/samples/Samples.h"

#include <benchmark/benchmark.h>
#include <cmath>

namespace {

using namespace txn;

/// 21 textons between two materials of 768 x 384, support 64, models included.
void mixTextons(benchmark::State& state, TextonMethod method) {
    const Exemplar a = bench::photographOrSample("rust_768x384.png", {768, 384});
    const Exemplar b = *makeExemplar(makeSample("stone", {768, 384}, Seed{1}).value(), "stone");
    MixRequest request{a, b, true, true, {}, 21};
    request.params.method = method;
    for ([[maybe_unused]] auto _ : state) {
        auto solver = makeMixSolver(request);
        while (!solver->done())
            (void)solver->step();
        benchmark::DoNotOptimize(solver->result());
    }
}
BENCHMARK_CAPTURE(mixTextons, projections, TextonMethod::Projections)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(mixTextons, fit, TextonMethod::Fit)->Unit(benchmark::kMillisecond)->UseRealTime();

enum class MapUse { Plain, Strips, Patches };

/// Where A and B are: a gradient over the picture, or patches of 64 pixels of anything between.
MixingMap mapFor(MapUse use, Size size) {
    MixingMap map;
    map.placement = {0.0, 0.0, 1.0 * size.width, 1.0 * size.height};
    if (use == MapUse::Strips)
        map.rho = gradientMap({2048, 2048}, 0.0);
    if (use == MapUse::Patches) {
        map.rho = whiteNoise({size.width / 64, size.height / 64}, 1, Seed{3});
        for (float& v : map.rho.samples())
            v = v - std::floor(v);
    }
    return map;
}

/// RGB noise in memory of 21 textons, or of one. Arguments: kernels of each, use of the map.
void bakingMixed(benchmark::State& state) {
    constexpr Size kSize{2048, 2048};
    const auto use = static_cast<MapUse>(state.range(1));
    Mixture mixture;
    mixture.map = mapFor(use, kSize);
    for (int r = 0; r < (use == MapUse::Plain ? 1 : 21); ++r) {
        Texton texton;
        texton.support = Support::rectangle({64, 64});
        texton.mean = {0.5 + 0.01 * r, 0.4, 0.3};
        for (int q = 0; q < state.range(0); ++q)
            texton.kernels.push_back(
                whiteNoise({64, 64}, 3, Seed{static_cast<std::uint32_t>(100 * r + q)}));
        mixture.textons.push_back(std::move(texton));
    }
    const auto grid = NoiseGrid::create(std::move(mixture), {});
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(grid->render({0, 0, kSize}));
    state.counters["megapixels"] = benchmark::Counter(static_cast<double>(state.iterations()) *
                                                          static_cast<double>(kSize.area()) * 1e-6,
                                                      benchmark::Counter::kIsRate);
}
BENCHMARK(bakingMixed)
    ->ArgNames({"kernels", "map"})
    ->ArgsProduct({{1, 2}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
