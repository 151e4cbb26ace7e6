// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs that pictures are decoded in a process of their own.
#include "core/image/DecoderProcess.h"
#include "core/image/ImageDecoder.h"
#include "core/image/ImageIo.h"
#include "core/samples/Samples.h"

#include <benchmark/benchmark.h>
#include <cstdlib>
#include <filesystem>

namespace {

using namespace txn;

/// A generated material of 1024 x 1024, as a PNG that goes away with the object.
class Photo {
  public:
    Photo() {
        std::string name = (std::filesystem::temp_directory_path() / "txn_bench_XXXXXX").string();
        m_folder = ::mkdtemp(name.data());
        m_path = m_folder / "photo.png";
        const auto picture = makeSample("stone", {1024, 1024}, Seed{1});
        m_written = picture && saveImage(*picture, m_path);
    }
    Photo(const Photo&) = delete;
    Photo& operator=(const Photo&) = delete;
    ~Photo() { std::filesystem::remove_all(m_folder); }

    bool written() const { return m_written; }
    const std::filesystem::path& path() const { return m_path; }

  private:
    std::filesystem::path m_folder;
    std::filesystem::path m_path;
    bool m_written = false;
};

/// In this process, as it was once.
void decodingHere(benchmark::State& state) {
    const Photo photo;
    for ([[maybe_unused]] auto _ : state) {
        auto file = FileBytes::open(photo.path());
        if (!file || !decodeImage(*std::move(file), photo.path(), {}))
            state.SkipWithError("cannot decode");
    }
}
BENCHMARK(decodingHere)->Unit(benchmark::kMillisecond)->UseRealTime();

/// By the helper, once it runs.
void decodingByHelper(benchmark::State& state) {
    const Photo photo;
    startImageReading();
    for ([[maybe_unused]] auto _ : state) {
        if (!loadImage(photo.path()))
            state.SkipWithError("cannot decode");
    }
}
BENCHMARK(decodingByHelper)->Unit(benchmark::kMillisecond)->UseRealTime();

void startingTheHelper(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        auto decoder = DecoderProcess::start();
        if (!decoder || !decoder->becomesReady())
            state.SkipWithError("cannot start");
    }
}
BENCHMARK(startingTheHelper)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
