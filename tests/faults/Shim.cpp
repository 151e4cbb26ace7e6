// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into a program (LD_PRELOAD), it lets calls to the system fail or end the program.
//
// TXN_FAULT=CALL:N:WHAT  the N-th CALL (write, sync, rename or link), and with N+ all later ones,
//                        fails with WHAT (ENOSPC, EIO, EACCES or EDQUOT), or the program is killed
//                        just before it (kill) or aborts (abort)
// TXN_FAULT_UNDER=FOLDER only what concerns files in there counts
// TXN_FAULT_MARK=FILE    appears when the call has come
// TXN_NAMELESS=0         there are no files without names, as on some file systems
// TXN_HARD_LINKS=0       nor second names of files
//
// A program can also ask for it itself: txnSetFault() and txnFailMemory().

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

struct Plan {
    char call[16] = "";
    char under[PATH_MAX] = "";
    long at = 0;
    bool andLater = false;
    int error = 0;  ///< or
    int signal = 0; ///< the program ends by this
    bool nameless = true;
    bool hardLinks = true;
    std::atomic<long> count{0};
    std::atomic<bool> come{false};
};

/// text: as TXN_FAULT; anything else for nothing.
void set(Plan& plan, const char* text, const char* under, bool nameless, bool hardLinks) {
    plan.call[0] = '\0';
    plan.nameless = nameless;
    plan.hardLinks = hardLinks;
    plan.count = 0;
    plan.come = false;
    std::snprintf(plan.under, sizeof(plan.under), "%s", under == nullptr ? "" : under);
    char call[16];
    char number[32];
    char what[16];
    if (text == nullptr || std::sscanf(text, "%15[^:]:%31[^:]:%15s", call, number, what) != 3)
        return;
    plan.at = std::strtol(number, nullptr, 10);
    plan.andLater = std::strchr(number, '+') != nullptr;
    const struct {
        const char* name;
        int error;
        int signal;
    } known[] = {{"ENOSPC", ENOSPC, 0},
                 {"EIO", EIO, 0},
                 {"EACCES", EACCES, 0},
                 {"EDQUOT", EDQUOT, 0},
                 {"kill", 0, SIGKILL},
                 {"abort", 0, SIGABRT}};
    for (const auto& each : known) {
        if (std::strcmp(what, each.name) == 0) {
            plan.error = each.error;
            plan.signal = each.signal;
        }
    }
    std::memcpy(plan.call, call, sizeof(call));
}

bool isOff(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && std::strcmp(value, "0") == 0;
}

Plan& plan() {
    static Plan made;
    static const bool read = [] {
        set(made,
            std::getenv("TXN_FAULT"),
            std::getenv("TXN_FAULT_UNDER"),
            !isOff("TXN_NAMELESS"),
            !isOff("TXN_HARD_LINKS"));
        return true;
    }();
    static_cast<void>(read);
    return made;
}

bool concerns(const char* path) {
    const char* under = plan().under;
    return std::strncmp(path, under, std::strlen(under)) == 0;
}

/// Regular files and folders; not what goes to a terminal or a pipe.
bool concerns(int fd) {
    struct stat info {};
    if (::fstat(fd, &info) != 0 || (!S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)))
        return false;
    char link[64];
    char path[PATH_MAX];
    std::snprintf(link, sizeof(link), "/proc/self/fd/%d", fd);
    const ssize_t length = ::readlink(link, path, sizeof(path) - 1);
    if (length <= 0)
        return false;
    path[length] = '\0';
    return concerns(path);
}

/// Whether this call is to fail; sets errno then. Does not return where the program is to end.
template <class Where>
bool fails(const char* call, Where where) {
    Plan& p = plan();
    if (std::strcmp(p.call, call) != 0 || !concerns(where))
        return false;
    const long number = ++p.count;
    if (number < p.at || (number > p.at && !p.andLater))
        return false;
    p.come = true;
    if (const char* mark = std::getenv("TXN_FAULT_MARK"))
        ::close(::creat(mark, 0600));
    if (p.signal == SIGKILL)
        ::kill(::getpid(), SIGKILL);
    if (p.signal == SIGABRT)
        std::abort();
    errno = p.error;
    return true;
}

struct Memory {
    std::atomic<long> left{-1}; ///< allocations that still succeed; below 0: all do
    std::atomic<std::size_t> atLeast{0};
    std::atomic<long> refused{0};
};
Memory memory;

/// Drivers for graphics are not this program; what they do without memory is theirs.
bool isDriver(const void* caller) {
    Dl_info info{};
    if (::dladdr(caller, &info) == 0 || info.dli_fname == nullptr)
        return false;
    for (const char* part : {"dri", "LLVM", "gallium", "libGL", "libEGL", "libX", "libxcb"}) {
        if (std::strstr(info.dli_fname, part) != nullptr)
            return true;
    }
    return false;
}

bool refuses(std::size_t size, const void* caller) {
    if (memory.left < 0 || size < memory.atLeast || isDriver(caller))
        return false;
    long left = memory.left;
    while (left > 0) {
        if (memory.left.compare_exchange_weak(left, left - 1))
            return false;
    }
    if (left < 0)
        return false;
    ++memory.refused;
    errno = ENOMEM;
    return true;
}

} // namespace

extern "C" {

/// As by the variables, from now on. Returns whether the call that was to fail before has come.
int txnSetFault(const char* fault, const char* under, int nameless, int hardLinks) {
    const bool come = plan().come;
    set(plan(), fault, under, nameless != 0, hardLinks != 0);
    return come ? 1 : 0;
}

/// After `left` more allocations of at least `atLeast` bytes, all others of that size fail; below 0
/// none does. Returns how many failed since the last call.
long txnFailMemory(long left, std::size_t atLeast) {
    memory.left = -1;
    memory.atLeast = atLeast;
    const long refused = memory.refused.exchange(0);
    memory.left = left;
    return refused;
}

ssize_t write(int fd, const void* data, size_t size) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    return fails("write", fd) ? -1 : real(fd, data, size);
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
    static const auto real = next<ssize_t (*)(int, const struct iovec*, int)>("writev");
    return fails("write", fd) ? -1 : real(fd, parts, count);
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
    return fails("write", fd) ? -1 : real(fd, data, size, at);
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
    return fails("write", fd) ? -1 : real(fd, data, size, at);
}

int fsync(int fd) {
    static const auto real = next<int (*)(int)>("fsync");
    return fails("sync", fd) ? -1 : real(fd);
}
int fdatasync(int fd) {
    static const auto real = next<int (*)(int)>("fdatasync");
    return fails("sync", fd) ? -1 : real(fd);
}

int rename(const char* from, const char* to) {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    return fails("rename", to) ? -1 : real(from, to);
}
int renameat(int fromFolder, const char* from, int toFolder, const char* to) {
    static const auto real = next<int (*)(int, const char*, int, const char*)>("renameat");
    return fails("rename", to) ? -1 : real(fromFolder, from, toFolder, to);
}
int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
    static const auto real =
        next<int (*)(int, const char*, int, const char*, unsigned)>("renameat2");
    return fails("rename", to) ? -1 : real(fromFolder, from, toFolder, to, flags);
}

int link(const char* from, const char* to) {
    static const auto real = next<int (*)(const char*, const char*)>("link");
    if (!plan().hardLinks) {
        errno = EPERM;
        return -1;
    }
    return fails("link", to) ? -1 : real(from, to);
}
int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) {
    static const auto real = next<int (*)(int, const char*, int, const char*, int)>("linkat");
    if (!plan().hardLinks && std::strncmp(from, "/proc/", 6) != 0) {
        errno = EPERM;
        return -1;
    }
    return fails("link", to) ? -1 : real(fromFolder, from, toFolder, to, flags);
}

static bool isRefused(int flags) {
    if ((flags & O_TMPFILE) != O_TMPFILE || plan().nameless)
        return false;
    errno = EOPNOTSUPP;
    return true;
}
int open(const char* path, int flags, ...) {
    static const auto real = next<int (*)(const char*, int, ...)>("open");
    va_list rest;
    va_start(rest, flags);
    const auto mode = static_cast<mode_t>(va_arg(rest, int));
    va_end(rest);
    return isRefused(flags) ? -1 : real(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    static const auto real = next<int (*)(const char*, int, ...)>("open64");
    va_list rest;
    va_start(rest, flags);
    const auto mode = static_cast<mode_t>(va_arg(rest, int));
    va_end(rest);
    return isRefused(flags) ? -1 : real(path, flags, mode);
}

// What glibc itself offers under other names, so that nothing has to be looked up while there is
// no memory yet.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

void* malloc(size_t size) {
    return refuses(size, __builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
    const bool refused = size > 0 && refuses(count * size, __builtin_return_address(0));
    return refused ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
    return refuses(size, __builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}
void* memalign(size_t alignment, size_t size) {
    return refuses(size, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
    return refuses(size, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** made, size_t alignment, size_t size) {
    if (refuses(size, __builtin_return_address(0)))
        return ENOMEM;
    void* memoryMade = __libc_memalign(alignment, size);
    if (memoryMade == nullptr)
        return ENOMEM;
    *made = memoryMade;
    return 0;
}

} // extern "C"

namespace {

void* newMemory(std::size_t size, std::size_t alignment, const void* caller) {
    if (refuses(size, caller))
        return nullptr;
    return alignment == 0 ? __libc_malloc(size) : __libc_memalign(alignment, size);
}

void* orThrow(void* made) {
    if (made == nullptr)
        throw std::bad_alloc();
    return made;
}

} // namespace

// As the standard library has them; here since its own would hide who asks.
void* operator new(std::size_t size) {
    return orThrow(newMemory(size, 0, __builtin_return_address(0)));
}
void* operator new[](std::size_t size) {
    return orThrow(newMemory(size, 0, __builtin_return_address(0)));
}
void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    return newMemory(size, 0, __builtin_return_address(0));
}
void* operator new[](std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    return newMemory(size, 0, __builtin_return_address(0));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return orThrow(
        newMemory(size, static_cast<std::size_t>(alignment), __builtin_return_address(0)));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return orThrow(
        newMemory(size, static_cast<std::size_t>(alignment), __builtin_return_address(0)));
}
void operator delete(void* made) noexcept {
    std::free(made);
}
void operator delete[](void* made) noexcept {
    std::free(made);
}
void operator delete(void* made, std::size_t /*size*/) noexcept {
    std::free(made);
}
void operator delete[](void* made, std::size_t /*size*/) noexcept {
    std::free(made);
}
void operator delete(void* made, std::align_val_t /*alignment*/) noexcept {
    std::free(made);
}
void operator delete[](void* made, std::align_val_t /*alignment*/) noexcept {
    std::free(made);
}
