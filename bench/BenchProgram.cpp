// SPDX-License-Identifier: GPL-3.0-or-later
// The real program on large pictures: wall time and peak memory as the system counts them.
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace {

namespace fs = std::filesystem;

/// A folder that goes away with the object.
struct Folder {
    fs::path path;
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "txn_bench_XXXXXX").string();
        path = ::mkdtemp(pattern.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path); }
};

/// Runs `texton` and returns its peak resident memory in megabytes, or -1 if it failed.
double run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), TXN_TEXTON_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1, 0);
    pid_t child = 0;
    const int code =
        posix_spawn(&child, TXN_TEXTON_PROGRAM, &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    rusage usage{};
    if (code != 0 || ::wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0)
        return -1.0;
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// From a 4096 x 4096 PNG to the texton files; the argument is the number of iterations.
void programCompute4096(benchmark::State& state) {
    const Folder folder;
    const std::string photo = folder.path / "photo.png";
    if (run({"sample", "rust", "-o", photo, "--size", "4096x4096"}) < 0.0) {
        state.SkipWithError("cannot make the exemplar");
        return;
    }
    double memory = 0.0;
    for ([[maybe_unused]] auto _ : state)
        memory = run({"compute",
                      photo,
                      "-o",
                      folder.path / "t.exr",
                      "--support",
                      "64",
                      "--iterations",
                      std::to_string(state.range(0))});
    state.counters["peak_MB"] = memory;
}
BENCHMARK(programCompute4096)
    ->ArgName("iterations")
    ->Arg(5)
    ->Arg(50)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(3);

/// A half-float EXR of side x side pixels, streamed to disk.
void programStreamExr(benchmark::State& state) {
    const Folder folder;
    const std::string photo = folder.path / "photo.png";
    const std::string texton = folder.path / "t.exr";
    if (run({"sample", "rust", "-o", photo}) < 0.0 || run({"compute", photo, "-o", texton}) < 0.0) {
        state.SkipWithError("cannot make the texton");
        return;
    }
    const std::string side = std::to_string(state.range(0));
    double memory = 0.0;
    for ([[maybe_unused]] auto _ : state)
        memory =
            run({"noise", texton, "-o", folder.path / "noise.exr", "--size", side + "x" + side});
    state.counters["peak_MB"] = memory;
}
BENCHMARK(programStreamExr)
    ->ArgName("side")
    ->Arg(4096)
    ->Arg(16384)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

} // namespace
