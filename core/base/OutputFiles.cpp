// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
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

/// The file behind target, whether it exists or not: links are followed step by step.
Result<fs::path> followed(const fs::path& target) {
    constexpr int kMostLinks = 40; // as the system itself has it
    std::error_code ec;
    fs::path real = target;
    for (int i = 0; fs::is_symlink(real, ec); ++i) {
        const fs::path next = fs::read_symlink(real, ec);
        if (ec || i == kMostLinks)
            return unwritable(target, "it is a link that leads nowhere");
        real = next.is_absolute() ? next : real.parent_path() / next;
    }
    return real;
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A name that no other file in the folder has, short and apart from the target's: that one may be
/// as long as the file system allows.
fs::path uniqueName(const fs::path& folder, int number) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return folder / (".texton-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
                     std::to_string(number));
}

fs::path pathOfDescriptor(int fd) {
    return "/proc/self/fd/" + std::to_string(fd);
}

/// Gives a nameless file a name; 0 or the errno.
int linkNameless(int fd, const fs::path& path) {
    return ::linkat(AT_FDCWD,
                    pathOfDescriptor(fd).c_str(),
                    AT_FDCWD,
                    path.c_str(),
                    AT_SYMLINK_FOLLOW) == 0
               ? 0
               : errno;
}

/// Makes sure that a rename in the folder survives a power cut. Failing here loses nothing.
void flushFolder(const fs::path& folder) {
    const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd >= 0) {
        ::fsync(fd);
        ::close(fd);
    }
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
    const auto real = followed(target);
    if (!real)
        return real.error();
    std::error_code ec;
    const auto status = fs::status(*real, ec);
    if (fs::is_directory(status))
        return unwritable(target, "it is a folder; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return unwritable(target, "it is not a plain file");
    if (real->filename().empty())
        return unwritable(target, "give a file name");
    const fs::path folder = folderOf(*real);
    if (!fs::is_directory(folder, ec))
        return unwritable(target, "there is no folder " + quoted(folder));
    if (fs::exists(status) && ::access(real->c_str(), W_OK) != 0)
        return unwritable(target, systemReason(errno));
    // Found out now and not after the work.
    const long longest = ::pathconf(folder.c_str(), _PC_NAME_MAX);
    if (longest > 0 && real->filename().string().size() > static_cast<std::size_t>(longest))
        return unwritable(target, systemReason(ENAMETOOLONG));
    const auto same = [&](const File& file) {
        return fs::absolute(file.target).lexically_normal() ==
               fs::absolute(*real).lexically_normal();
    };
    if (std::any_of(m_files.begin(), m_files.end(), same))
        return Error{ErrorCode::InvalidArgument, quoted(target) + " is named twice"};

    constexpr mode_t kMode = 0666; // less what the umask forbids
    File file{*real, {}, ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode)};
    const bool nameless = file.fd >= 0 && fs::exists(pathOfDescriptor(file.fd), ec);
    if (!nameless) {
        if (file.fd >= 0)
            ::close(file.fd);
        file.temporary = uniqueName(folder, static_cast<int>(m_files.size()));
        file.fd = ::open(file.temporary.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMode);
        if (file.fd < 0)
            return unwritable(target, systemReason(errno));
    }
    struct stat info {};
    if (::stat(real->c_str(), &info) == 0)
        ::fchmod(file.fd, info.st_mode & 0777U);
    m_files.push_back(file);
    return nameless ? pathOfDescriptor(file.fd) : file.temporary;
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
        if (::fsync(file.fd) != 0)
            return unwritable(file.target, systemReason(errno));
    }
    // All that may fail comes before the first old file is replaced.
    for (File& file : m_files) {
        if (!file.temporary.empty())
            continue;
        const fs::path name = uniqueName(folderOf(file.target), file.fd);
        if (const int code = linkNameless(file.fd, name); code != 0)
            return unwritable(file.target, systemReason(code));
        file.temporary = name;
    }
    // Nothing slow between one new name and the next.
    std::vector<fs::path> folders;
    while (!m_files.empty()) {
        const File& file = m_files.front();
        if (::rename(file.temporary.c_str(), file.target.c_str()) != 0)
            return unwritable(file.target, systemReason(errno));
        folders.push_back(folderOf(file.target));
        ::close(file.fd);
        m_files.erase(m_files.begin());
    }
    for (const fs::path& folder : folders)
        flushFolder(folder);
    return {};
}

void OutputFiles::discard() noexcept {
    for (const File& file : m_files) {
        if (!file.temporary.empty())
            ::unlink(file.temporary.c_str());
        ::close(file.fd);
    }
    m_files.clear();
}

std::string quoted(const fs::path& path) {
    std::string text = "'";
    for (const char c : path.string())
        text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return text + "'";
}

} // namespace txn
