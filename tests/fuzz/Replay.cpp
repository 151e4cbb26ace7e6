// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/FuzzTarget.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

int writeSeeds(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : txn::fuzz::seeds()) {
        const auto file = folder / ("seed_" + std::to_string(number++));
        std::ofstream stream(file, std::ios::binary);
        if (!stream.write(seed.data(), static_cast<std::streamsize>(seed.size())))
            return 1;
    }
    return 0;
}

/// A seed that is refused teaches the fuzzer nothing of what lies behind the first check.
int checkSeeds() {
    const auto seeds = txn::fuzz::seeds();
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (!txn::fuzz::readOne(seeds[i])) {
            std::fprintf(stderr, "seed %zu is refused\n", i);
            return 1;
        }
    }
    return seeds.empty() ? 1 : 0;
}

} // namespace

/// FILE...: reads each; it crashes where the reader does. --seeds FOLDER: writes the seeds there.
/// --check: whether the reader takes all of them.
int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "--seeds")
        return writeSeeds(words[1]);
    if (words.size() == 1 && words[0] == "--check")
        return checkSeeds();
    for (const std::string& name : words) {
        std::ifstream stream(name, std::ios::binary);
        if (!stream) {
            std::fprintf(stderr, "cannot open %s\n", name.c_str());
            return 1;
        }
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        const bool accepted = txn::fuzz::readOne(bytes);
        std::printf("%s %s\n", accepted ? "accepted" : "refused", name.c_str());
    }
    return 0;
}
