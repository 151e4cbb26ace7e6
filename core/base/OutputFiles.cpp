// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <set>
#include <sys/file.h>
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

constexpr std::string_view kTemporary = ".texton-";

/// A name that no other file in the folder has, short and apart from the target's: that one may be
/// as long as the file system allows.
fs::path uniqueName(const fs::path& folder, int number) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return folder / (std::string(kTemporary) + std::to_string(::getpid()) + "-" +
                     std::to_string(now) + "-" + std::to_string(number));
}

bool isUniqueName(const std::string& name) {
    return name.starts_with(kTemporary) &&
           name.find_first_not_of("0123456789-", kTemporary.size()) == std::string::npos;
}

/// Tells others that the file is in use, as long as it is open; false where somebody has it.
bool claim(int fd) {
    return ::flock(fd, LOCK_EX | LOCK_NB) == 0;
}

/// Removes temporary files of programs that have ended. Failing here loses nothing.
void sweep(const fs::path& folder) {
    std::error_code ec;
    std::vector<fs::path> found;
    for (auto entry = fs::directory_iterator(folder, ec); !ec && entry != fs::directory_iterator();
         entry.increment(ec)) {
        if (isUniqueName(entry->path().filename().string()))
            found.push_back(entry->path());
    }
    for (const fs::path& path : found) {
        const int fd = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (fd < 0)
            continue;
        struct stat info {};
        if (::fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && claim(fd))
            ::unlink(path.c_str());
        ::close(fd);
    }
}

/// A new file with a name, claimed; -1 and errno.
int createNamed(fs::path& path, const fs::path& folder, int number, mode_t mode) {
    constexpr int kTries = 10;
    int fd = -1;
    for (int i = 0; i < kTries; ++i) {
        path = uniqueName(folder, number);
        fd = ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, mode);
        if (fd < 0)
            return -1;
        claim(fd);
        // Unless another program has taken it for left over before it was claimed.
        struct stat info {};
        if (::fstat(fd, &info) == 0 && info.st_nlink > 0)
            return fd;
        ::close(fd);
    }
    errno = EAGAIN;
    return -1;
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

void letFileSizeLimitsFail() noexcept {
    std::signal(SIGXFSZ, SIG_IGN);
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
    const auto beside = [&](const File& file) { return folderOf(file.target) == folder; };
    if (std::none_of(m_files.begin(), m_files.end(), beside))
        sweep(folder);
    const auto same = [&](const File& file) {
        return fs::absolute(file.target).lexically_normal() ==
               fs::absolute(*real).lexically_normal();
    };
    if (std::any_of(m_files.begin(), m_files.end(), same))
        return Error{ErrorCode::InvalidArgument, quoted(target) + " is named twice"};

    constexpr mode_t kMode = 0666; // less what the umask forbids
    File file;
    file.target = *real;
    file.fd = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
    const bool nameless = file.fd >= 0 && fs::exists(pathOfDescriptor(file.fd), ec);
    if (nameless) {
        claim(file.fd); // for when it gets a name
    } else {
        if (file.fd >= 0)
            ::close(file.fd);
        file.fd = createNamed(file.temporary, folder, static_cast<int>(m_files.size()), kMode);
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
    for (File& file : m_files) {
        file.isNew = ::access(file.target.c_str(), F_OK) != 0;
        if (file.isNew || m_files.size() == 1) // a rename alone happens or does not
            continue;
        const fs::path name = uniqueName(folderOf(file.target), file.fd);
        if (::link(file.target.c_str(), name.c_str()) == 0)
            file.old = name;
    }
    if (auto ok = place(); !ok) {
        takeBack();
        return ok;
    }
    std::set<fs::path> folders;
    for (File& file : m_files) {
        if (!file.old.empty())
            ::unlink(file.old.c_str());
        folders.insert(folderOf(file.target));
        ::close(file.fd);
    }
    m_files.clear();
    for (const fs::path& folder : folders)
        flushFolder(folder);
    return {};
}

/// Nothing slow between one new name and the next.
Result<void> OutputFiles::place() {
    for (File& file : m_files) {
        if (::rename(file.temporary.c_str(), file.target.c_str()) != 0)
            return unwritable(file.target, systemReason(errno));
        file.placed = true;
    }
    return {};
}

void OutputFiles::takeBack() noexcept {
    for (File& file : m_files) {
        if (!file.placed)
            continue;
        if (file.isNew)
            ::unlink(file.target.c_str());
        else if (!file.old.empty() && ::rename(file.old.c_str(), file.target.c_str()) == 0)
            file.old.clear();
    }
}

void OutputFiles::discard() noexcept {
    for (const File& file : m_files) {
        if (!file.temporary.empty() && !file.placed)
            ::unlink(file.temporary.c_str());
        if (!file.old.empty())
            ::unlink(file.old.c_str());
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
