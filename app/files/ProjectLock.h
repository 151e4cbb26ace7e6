// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace txn::app {

/// Keeps two Texton Studios of one user from saving over each other: the project that is open here
/// is locked for the others, by a file in a folder of the program's own. Where that cannot be made,
/// nobody is kept from anything; a program that died holds nothing. (Not QLockFile: after a crash,
/// on a full disk, it takes the dead program's lock for a living one's.) Interface thread.
class ProjectLock {
  public:
    /// folder: of the locks; made if it is not there.
    explicit ProjectLock(QString folder);
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;
    ~ProjectLock();

    /// Locks this project instead of the last one. False where another program has it open; then
    /// nothing changes.
    bool take(const QString& project);
    void release();

  private:
    QString m_folder;
    QString m_file; ///< empty: nothing is locked
    int m_fd = -1;
};

} // namespace txn::app
