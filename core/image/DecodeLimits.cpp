// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeLimits.h"

#include "core/image/SystemCallFilter.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fcntl.h>
#include <fstream>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace txn {
namespace {

using std::chrono::milliseconds;

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20U;
constexpr std::uint64_t kOwnBytes = 512 * kMebi; // buffers of decoders, stacks of their threads
/// A picture as decoded, as floats, once more while it is converted or turned.
constexpr std::uint64_t kBytesASample = 20;
constexpr int kThreads = 4;

#ifdef TXN_SANITIZED
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
constexpr int kPatience = kSanitized ? 5 : 1; // its checks cost that much

void bound(__rlimit_resource resource, rlim_t soft) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0)
        return;
    limit.rlim_cur = std::min(soft, limit.rlim_max);
    ::setrlimit(resource, &limit);
}

void boundForEver(__rlimit_resource resource, rlim_t most) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0)
        return;
    limit.rlim_max = std::min(most, limit.rlim_max);
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(resource, &limit);
}

/// Of address space, as RLIMIT_AS counts it.
std::uint64_t bytesInUse() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t secondsUsed() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
}

} // namespace

milliseconds decodingTime(std::uint64_t fileBytes, std::uint64_t samples) {
    constexpr std::uint64_t kLeastMs = 1200;
    constexpr std::uint64_t kPerMs = 10'000; // bytes, and samples
    return kPatience * milliseconds(kLeastMs + fileBytes / kPerMs + samples / kPerMs);
}

void limitDecoding(std::uint64_t fileBytes, std::uint64_t samples) {
    // Its threads may work at the same time, and the program that waits is quicker to end it: this
    // is for the case that it has died.
    const auto seconds =
        static_cast<std::uint64_t>(decodingTime(fileBytes, samples).count()) / 1000;
    bound(RLIMIT_CPU, secondsUsed() + kThreads * (seconds + 1));
    if (!kSanitized) // which reserves terabytes of address space
        bound(RLIMIT_AS, bytesInUse() + kOwnBytes + fileBytes + kBytesASample * samples);
}

void giveUpRights() {
    constexpr rlim_t kOpenFiles = 32;
    boundForEver(RLIMIT_CORE, 0);
    boundForEver(RLIMIT_FSIZE, 0);
    boundForEver(RLIMIT_NOFILE, kOpenFiles);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    std::ofstream("/proc/self/oom_score_adj") << 1000;
    // A heap for every thread would count as address space in use.
    ::mallopt(M_ARENA_MAX, 2);
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nowhere >= 0) {
        ::dup2(nowhere, STDIN_FILENO);
        ::dup2(nowhere, STDOUT_FILENO);
        if (!kSanitized) // whose reports should be seen
            ::dup2(nowhere, STDERR_FILENO);
        ::close(nowhere);
    }
    if (!kSanitized) // whose search for leaks needs some of them
        forbidHarmfulSystemCalls();
    const int threads =
        std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kThreads);
    OIIO::attribute("threads", threads);
    OIIO::attribute("exr_threads", threads);
}

void freeUnused() {
    ::malloc_trim(0);
}

} // namespace txn
