// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/FileSink.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace txn {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18U;

} // namespace

FileSink::FileSink(const std::string& path, std::string_view prefix)
    : IOProxy(path, IOProxy::Write) {
    m_fd = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (m_fd < 0)
        m_failure = errno;
    m_buffer.reserve(kBufferBytes);
    if (writeAt(prefix.data(), prefix.size(), 0))
        m_base = static_cast<int64_t>(prefix.size());
}

FileSink::~FileSink() {
    finish();
}

int FileSink::finish() {
    const std::lock_guard lock(m_mutex);
    flushBuffer();
    if (m_fd >= 0 && ::close(m_fd) != 0 && m_failure == 0)
        m_failure = errno;
    m_fd = -1;
    return m_failure;
}

size_t FileSink::write(const void* data, size_t size) {
    const std::size_t written = pwrite(data, size, m_pos);
    m_pos += static_cast<int64_t>(written);
    return written;
}

size_t FileSink::pwrite(const void* data, size_t size, int64_t offset) {
    const std::lock_guard lock(m_mutex);
    if (m_fd < 0 || m_failure != 0 || offset < 0)
        return 0;
    const auto* bytes = static_cast<const char*>(data);
    if (offset != m_bufferAt + static_cast<int64_t>(m_buffer.size()) ||
        m_buffer.size() + size > kBufferBytes) {
        if (!flushBuffer())
            return 0;
        m_bufferAt = offset;
    }
    if (size > kBufferBytes) {
        if (!writeAt(bytes, size, m_base + offset))
            return 0;
        m_bufferAt = offset + static_cast<int64_t>(size);
    } else {
        m_buffer.insert(m_buffer.end(), bytes, bytes + size);
    }
    m_end = std::max(m_end, offset + static_cast<int64_t>(size));
    return size;
}

bool FileSink::flushBuffer() {
    const bool done = writeAt(m_buffer.data(), m_buffer.size(), m_base + m_bufferAt);
    m_bufferAt += static_cast<int64_t>(m_buffer.size());
    m_buffer.clear();
    return done;
}

bool FileSink::writeAt(const char* data, size_t size, int64_t offset) {
    while (size > 0) {
        if (m_fd < 0 || m_failure != 0)
            return false;
        const ssize_t written = ::pwrite(m_fd, data, size, static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            m_failure = written < 0 ? errno : ENOSPC;
            return false;
        }
        data += written;
        size -= static_cast<std::size_t>(written);
        offset += written;
    }
    return m_failure == 0;
}

} // namespace txn
