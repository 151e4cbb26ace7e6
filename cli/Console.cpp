// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Console.h"

#include <fcntl.h>
#include <string_view>
#include <unistd.h>

#ifdef TXN_SANITIZED
#include <sanitizer/common_interface_defs.h>
#endif

namespace txn::cli {
namespace {

/// The real standard error.
int errorFd = STDERR_FILENO;

void writeAll(std::string_view text) noexcept {
    while (!text.empty()) {
        const ssize_t written = ::write(errorFd, text.data(), text.size());
        if (written <= 0)
            return; // nobody left to tell
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

} // namespace

void hushLibraries() {
    const int real = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (real >= 0 && nowhere >= 0 && ::dup2(nowhere, STDERR_FILENO) >= 0) {
        errorFd = real;
#ifdef TXN_SANITIZED
        __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<long>(real)));
#endif
    }
    if (nowhere >= 0)
        ::close(nowhere);
}

void printError(const std::string& text) {
    writeAll(text);
}

void printStopped() noexcept {
    writeAll("texton: stopped; nothing was written\n");
}

bool errorIsTerminal() {
    return ::isatty(errorFd) == 1;
}

} // namespace txn::cli
