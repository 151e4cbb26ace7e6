// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/FileBytes.h"

#include "core/base/OutputFiles.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace txn {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 16U;

Error unreadable(const std::filesystem::path& path, const std::string& reason) {
    return {ErrorCode::Unreadable, "cannot read " + quoted(path) + ": " + reason};
}

Error systemError(const std::filesystem::path& path, int code) {
    if (code == ENOENT || code == ENOTDIR)
        return {ErrorCode::NotFound,
                "there is no file " + quoted(path) + "; was it moved or renamed?"};
    return unreadable(path, std::generic_category().message(code));
}

} // namespace

Result<FileBytes> FileBytes::open(const std::filesystem::path& path) {
    struct stat info {};
    // Before opening: that alone would wait for ever on a pipe and may act on a device.
    if (::stat(path.c_str(), &info) != 0)
        return systemError(path, errno);
    if (S_ISDIR(info.st_mode))
        return unreadable(path, "it is a folder; give an image file");
    if (!S_ISREG(info.st_mode))
        return unreadable(path, "it is not a plain file; give an image file");
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file)
        return systemError(path, errno);
    return of(std::move(file), path);
}

Result<FileBytes> FileBytes::of(FileDescriptor file, const std::filesystem::path& name) {
    struct stat info {};
    if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode))
        return unreadable(name, "it is not a plain file; give an image file");
    if (info.st_size <= 0)
        return unreadable(name, "the file is empty");
    return FileBytes(std::move(file), static_cast<std::uint64_t>(info.st_size));
}

Result<FileBytes> FileBytes::holding(std::span<const std::uint8_t> content,
                                     const std::filesystem::path& name) {
    FileDescriptor file(::memfd_create("picture", MFD_CLOEXEC));
    if (!file || !writeAll(file.get(), content.data(), content.size()))
        return unreadable(name, std::generic_category().message(errno));
    return of(std::move(file), name);
}

bool FileBytes::load(std::uint64_t offset) {
    m_begin = offset;
    m_window.resize(kWindow);
    ssize_t got = -1;
    do {
        got = ::pread(m_file.get(), m_window.data(), kWindow, static_cast<off_t>(offset));
    } while (got < 0 && errno == EINTR);
    m_window.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return got > 0;
}

std::uint8_t FileBytes::u8(std::uint64_t offset) {
    if (offset < m_begin || offset - m_begin >= m_window.size()) {
        if (offset >= m_size || !load(offset)) {
            m_ok = false;
            return 0;
        }
    }
    return m_window[offset - m_begin];
}

std::uint16_t FileBytes::le16(std::uint64_t offset) {
    return static_cast<std::uint16_t>(u8(offset) | (u8(offset + 1) << 8U));
}

std::uint32_t FileBytes::le24(std::uint64_t offset) {
    return le16(offset) | (static_cast<std::uint32_t>(u8(offset + 2)) << 16U);
}

std::uint32_t FileBytes::le32(std::uint64_t offset) {
    return le16(offset) | (static_cast<std::uint32_t>(le16(offset + 2)) << 16U);
}

std::uint16_t FileBytes::be16(std::uint64_t offset) {
    return static_cast<std::uint16_t>((u8(offset) << 8U) | u8(offset + 1));
}

std::uint32_t FileBytes::be32(std::uint64_t offset) {
    return (static_cast<std::uint32_t>(be16(offset)) << 16U) | be16(offset + 2);
}

bool FileBytes::matches(std::uint64_t offset, std::string_view bytes) {
    if (!has(offset, bytes.size()))
        return false;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (u8(offset + i) != static_cast<std::uint8_t>(bytes[i]))
            return false;
    }
    return true;
}

std::optional<std::uint64_t> FileBytes::find(std::uint8_t value, std::uint64_t offset) {
    while (offset < m_size) {
        u8(offset); // brings the window there
        if (!m_ok)
            return std::nullopt;
        const auto from = m_window.begin() + static_cast<std::ptrdiff_t>(offset - m_begin);
        const auto hit = std::find(from, m_window.end(), value);
        if (hit != m_window.end())
            return m_begin + static_cast<std::uint64_t>(hit - m_window.begin());
        offset = m_begin + m_window.size();
    }
    return std::nullopt;
}

std::vector<std::uint8_t> FileBytes::copy(std::uint64_t offset, std::uint64_t length) {
    std::vector<std::uint8_t> bytes;
    if (!has(offset, length))
        return bytes;
    bytes.reserve(length);
    for (std::uint64_t i = 0; i < length; ++i)
        bytes.push_back(u8(offset + i));
    if (!m_ok)
        bytes.clear();
    return bytes;
}

} // namespace txn
