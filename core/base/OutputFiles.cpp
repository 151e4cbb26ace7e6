// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace txn {
namespace {

namespace fs = std::filesystem;

Error unwritable(const fs::path& path, const std::string& reason) {
    return {ErrorCode::Unwritable, "cannot write " + quoted(path) + ": " + reason};
}

std::string systemReason(int code) {
    return std::generic_category().message(code);
}

/// Opens, flushes and closes; 0 or the errno.
int flushToDisk(const fs::path& path, int flags) {
    const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
    if (fd < 0)
        return errno;
    const int code = ::fsync(fd) == 0 ? 0 : errno;
    ::close(fd);
    return code;
}

/// Permissions for a new file: those of the file it replaces, otherwise what the umask allows.
mode_t modeFor(const fs::path& target) {
    struct stat info {};
    if (::stat(target.c_str(), &info) == 0)
        return info.st_mode & 0777U;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666U & ~mask;
}

} // namespace

OutputFiles& OutputFiles::operator=(OutputFiles&& other) noexcept {
    if (this != &other) {
        discard();
        m_files = std::move(other.m_files);
        other.m_files.clear();
    }
    return *this;
}

Result<fs::path> OutputFiles::add(const fs::path& target) {
    std::error_code ec;
    fs::path real = target;
    // Step by step, since the file behind a link need not exist yet.
    constexpr int kMostLinks = 40; // as the system itself has it
    for (int i = 0; fs::is_symlink(real, ec); ++i) {
        const fs::path next = fs::read_symlink(real, ec);
        if (ec || i == kMostLinks)
            return unwritable(target, "it is a link that leads nowhere");
        real = next.is_absolute() ? next : real.parent_path() / next;
    }
    const auto status = fs::status(real, ec);
    if (fs::is_directory(status))
        return unwritable(target, "it is a folder; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return unwritable(target, "it is not a plain file");
    if (real.filename().empty())
        return unwritable(target, "give a file name");

    const fs::path folder = real.has_parent_path() ? real.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ec))
        return unwritable(target, "there is no folder " + quoted(folder));
    if (fs::exists(status) && ::access(real.c_str(), W_OK) != 0)
        return unwritable(target, systemReason(errno));

    // Short and apart from the target's name: that one may be as long as the file system allows.
    std::string pattern = (folder / ".texton-XXXXXX").string();
    const int fd = ::mkstemp(pattern.data());
    if (fd < 0)
        return unwritable(target, systemReason(errno));
    ::fchmod(fd, modeFor(real));
    ::close(fd);
    m_files.push_back({real, pattern});
    return fs::path(pattern);
}

Result<void> OutputFiles::addText(const fs::path& target, std::string_view text) {
    auto temporary = add(target);
    if (!temporary)
        return temporary.error();
    const int fd = ::open(temporary->c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (fd < 0)
        return unwritable(target, systemReason(errno));
    while (!text.empty()) {
        const ssize_t written = ::write(fd, text.data(), text.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            const int code = errno;
            ::close(fd);
            return unwritable(target, systemReason(code));
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::close(fd) != 0)
        return unwritable(target, systemReason(errno));
    return {};
}

Result<void> OutputFiles::commit() {
    for (const File& file : m_files) {
        if (const int code = flushToDisk(file.temporary, O_RDONLY); code != 0)
            return unwritable(file.target, systemReason(code));
    }
    while (!m_files.empty()) {
        const File& file = m_files.front();
        std::error_code ec;
        fs::rename(file.temporary, file.target, ec);
        if (ec)
            return unwritable(file.target, ec.message());
        // A failure here loses nothing: the rename itself has been done.
        flushToDisk(file.target.has_parent_path() ? file.target.parent_path() : fs::path("."),
                    O_RDONLY | O_DIRECTORY);
        m_files.erase(m_files.begin());
    }
    return {};
}

void OutputFiles::discard() noexcept {
    for (const File& file : m_files)
        ::unlink(file.temporary.c_str());
    m_files.clear();
}

std::string quoted(const fs::path& path) {
    std::string text = "'";
    for (const char c : path.string())
        text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return text + "'";
}

} // namespace txn
