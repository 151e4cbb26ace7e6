// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace txn::app {

/// Tells other programs, as long as it lives, that something is in use: by a file of that name,
/// which is there for that alone. Ends with its program, however that ends. (QLockFile, after a
/// crash and on a full disk, takes the dead program's lock for a living one's.) Where the file
/// cannot be made, it tells nothing and hears nothing.
class FileLock {
  public:
    explicit FileLock(QString file);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    /// The file goes, unless it is somebody else's.
    ~FileLock();

    const QString& file() const { return m_file; }
    /// Whether somebody else has it.
    bool isTaken() const { return m_taken; }

  private:
    QString m_file;
    int m_fd = -1;
    bool m_taken = false;
};

} // namespace txn::app
