// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Exemplars.h"
#include "bench/TextbookSolver.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/spectral/PeriodicComponent.h"
#include "core/texton/RelativeModelError.h"
#include "core/texton/TextonSolver.h"

#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>

namespace {

using namespace txn;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

TextonParams params(int side, int iterations) {
    TextonParams result;
    result.support = Support::rectangle({side, side});
    result.iterations = iterations;
    return result;
}

/// The library against the textbook, from one initial noise: 50 plain iterations there, as many
/// iterations with momentum here as it takes for an error that is no larger.
void solverAgainstTextbook(benchmark::State& state) {
    const Exemplar exemplar = bench::photographOrSample("rust_768x384.png", {768, 384});
    const int side = static_cast<int>(state.range(0));
    const auto iterations = static_cast<int>(state.range(1));
    const GaussianModel model(exemplar);
    const Image noise = whiteNoise(model.domain(), model.channels(), Seed{1});
    Image spot = periodicComponent(exemplar.image);
    const auto scale = 1.0 / std::sqrt(static_cast<double>(spot.size().area()));
    for (int c = 0; c < spot.channels(); ++c) {
        for (float& v : spot.plane(c))
            v = static_cast<float>(scale * (v - model.mean()[static_cast<std::size_t>(c)]));
    }
    double textbookTime = 0.0;
    double libraryTime = 0.0;
    double textbookError = 0.0;
    double libraryError = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        const double start = seconds();
        const auto coefficients = bench::textbookTexton(spot, noise, {side, side}, 1, 50);
        const double middle = seconds();
        const GaussianModel fresh(exemplar); // its transforms count, as the textbook's do
        auto solver = TextonSolver::create(fresh, params(side, iterations), noise);
        while (!solver->done())
            solver->step();
        const double end = seconds();
        textbookTime += middle - start;
        libraryTime += end - middle;
        state.SetIterationTime(end - middle);
        libraryError = solver->relativeModelError();
        Texton texton = solver->texton();
        std::copy(coefficients.begin(),
                  coefficients.end(),
                  texton.kernels.front().samples().begin());
        textbookError = *relativeModelError(model, texton);
    }
    state.counters["rme_textbook"] = textbookError;
    state.counters["rme"] = libraryError;
    state.counters["times_faster"] = textbookTime / libraryTime;
}
BENCHMARK(solverAgainstTextbook)
    ->ArgNames({"support", "iterations"})
    ->Args({128, 20})
    ->Args({128, 50})
    ->Args({64, 20})
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

void solverStep(benchmark::State& state) {
    const Exemplar exemplar = bench::photographOrSample("rust_768x384.png", {768, 384});
    const GaussianModel model(exemplar);
    auto solver = TextonSolver::create(model, params(static_cast<int>(state.range(0)), 100000));
    for ([[maybe_unused]] auto _ : state)
        solver->step();
}
BENCHMARK(solverStep)
    ->ArgName("support")
    ->Arg(32)
    ->Arg(64)
    ->Arg(128)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void gaussianModel(benchmark::State& state) {
    const Exemplar exemplar = bench::photographOrSample("rust_768x384.png", {768, 384});
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(GaussianModel(exemplar));
}
BENCHMARK(gaussianModel)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
