// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace txn {

/// For main(): where files have a largest size (a quota, ulimit -f), writing more fails with a
/// message instead of ending the program.
void letFileSizeLimitsFail() noexcept;

/// Files that appear together or not at all: each is written without a name in the folder where it
/// belongs, and commit() gives them their names. Destroyed without commit(), or killed, it leaves
/// nothing behind, and existing files stay as they were. A kill in the instant of the renames
/// leaves every file whole, but may leave some old and some new, and files called .texton-...; so
/// does a kill at any time on the few file systems that know no nameless files. What is left of
/// programs that have ended goes with the next add() in that folder. Move-only; one thread at a
/// time.
class OutputFiles {
  public:
    OutputFiles() = default;
    OutputFiles(OutputFiles&& other) noexcept : m_files(std::move(other.m_files)) {
        other.m_files.clear();
    }
    OutputFiles& operator=(OutputFiles&& other) noexcept;
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;
    ~OutputFiles() { discard(); }

    /// The path to write to instead of target: it exists, is empty, and may be opened until
    /// commit(). Links are followed, so that the file behind one is replaced and not the link.
    /// Errors: Unwritable where the folder is missing or not writable, or where target is a folder
    /// or any other thing that is not a plain file; InvalidArgument if it is among the files
    /// already.
    [[nodiscard]] Result<std::filesystem::path> add(const std::filesystem::path& target);

    /// add() and write the whole text.
    [[nodiscard]] Result<void> addText(const std::filesystem::path& target, std::string_view text);

    /// Flushes every file to the disk and gives each its final name. Whatever can fail or takes
    /// time comes first, then the renames, one after another; if one of them fails, those before it
    /// are taken back (several files at once: where the file system has hard links).
    [[nodiscard]] Result<void> commit();

  private:
    struct File {
        std::filesystem::path target;
        std::filesystem::path temporary; ///< empty: nameless, known by fd only
        std::filesystem::path old;       ///< another name of what is to be replaced, if any
        int fd = -1;
        bool isNew = false; ///< nothing is to be replaced
        bool placed = false;
    };
    Result<void> place();
    void takeBack() noexcept;
    void discard() noexcept;
    std::vector<File> m_files;
};

/// 'path' for messages: quoted, with control characters replaced so that it stays on one line.
[[nodiscard]] std::string quoted(const std::filesystem::path& path);

} // namespace txn
