// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/FileDescriptor.h"
#include "core/base/Result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace txn {

/// Bytes of a plain file at any offset, through a small window, so that headers can be checked
/// before a decoder trusts them. Reads past the end give 0 and make ok() false. Move-only.
class FileBytes {
  public:
    /// Errors: NotFound; Unreadable for folders, pipes, devices, empty or forbidden files.
    [[nodiscard]] static Result<FileBytes> open(const std::filesystem::path& path);
    /// The same for a file that is open already; name is for messages.
    [[nodiscard]] static Result<FileBytes> of(FileDescriptor file,
                                              const std::filesystem::path& name);

    /// A file in memory with that content. Errors: Unreadable for nothing, and where the system has
    /// no room.
    [[nodiscard]] static Result<FileBytes> holding(std::span<const std::uint8_t> content,
                                                   const std::filesystem::path& name);

    int descriptor() const { return m_file.get(); }
    /// Opens this very file, whatever has since come under its name.
    std::string pathOfDescriptor() const { return "/proc/self/fd/" + std::to_string(m_file.get()); }

    std::uint64_t size() const { return m_size; }
    /// Whether length bytes exist from offset on.
    bool has(std::uint64_t offset, std::uint64_t length) const {
        return offset <= m_size && length <= m_size - offset;
    }
    /// False after any read past the end or any failed read.
    bool ok() const { return m_ok; }

    std::uint8_t u8(std::uint64_t offset);
    std::uint16_t le16(std::uint64_t offset);
    std::uint32_t le24(std::uint64_t offset);
    std::uint32_t le32(std::uint64_t offset);
    std::uint16_t be16(std::uint64_t offset);
    std::uint32_t be32(std::uint64_t offset);
    /// Whether these bytes stand at offset; past the end they do not, and ok() stays.
    bool matches(std::uint64_t offset, std::string_view bytes);
    /// Offset of the next byte of that value at or after offset.
    std::optional<std::uint64_t> find(std::uint8_t value, std::uint64_t offset);
    /// Nothing where they are not all there.
    std::vector<std::uint8_t> copy(std::uint64_t offset, std::uint64_t length);

  private:
    FileBytes(FileDescriptor file, std::uint64_t size) : m_file(std::move(file)), m_size(size) {}
    bool load(std::uint64_t offset);

    FileDescriptor m_file;
    std::uint64_t m_size = 0;
    std::uint64_t m_begin = 0;
    std::vector<std::uint8_t> m_window;
    bool m_ok = true;
};

} // namespace txn
