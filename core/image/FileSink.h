// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <mutex>
#include <string_view>
#include <vector>

namespace txn {

/// Where OpenImageIO's writers put their bytes. Its own file output loses the errors of the last
/// writes, so that a full disk would go unnoticed; this one keeps the first. Internal to
/// core/image.
class FileSink final : public OIIO::Filesystem::IOProxy {
  public:
    /// path must exist. prefix is written first, and the writer sees what follows as the file.
    explicit FileSink(const std::string& path, std::string_view prefix = {});
    FileSink(const FileSink&) = delete;
    FileSink& operator=(const FileSink&) = delete;
    ~FileSink() override;

    /// Writes what is still held and closes; 0 or the errno of the first failure.
    int finish();
    /// The errno of the first failure so far, or 0.
    int failure() const { return m_failure; }

    const char* proxytype() const override { return "texton"; }
    void close() override {} // by finish(): writers close it without looking
    size_t write(const void* data, size_t size) override;
    size_t pwrite(const void* data, size_t size, int64_t offset) override;
    size_t size() const override { return static_cast<size_t>(m_end); }

  private:
    bool flushBuffer();
    bool writeAt(const char* data, size_t size, int64_t offset);

    std::mutex m_mutex;
    int m_fd = -1;
    int m_failure = 0;
    int64_t m_base = 0; // bytes of the prefix
    int64_t m_end = 0;
    int64_t m_bufferAt = 0;
    std::vector<char> m_buffer;
};

} // namespace txn
