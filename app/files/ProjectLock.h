// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/FileLock.h"

#include <QString>
#include <memory>

namespace txn::app {

/// Keeps two Texton Studios of one user from saving over each other: the project that is open here
/// is locked for the others, by a file in a folder of the program's own. Where that cannot be made,
/// nobody is kept from anything. Interface thread.
class ProjectLock {
  public:
    /// folder: of the locks; made if it is not there.
    explicit ProjectLock(QString folder);

    /// Locks this project instead of the last one. False where another program has it open; then
    /// nothing changes.
    bool take(const QString& project);
    void release() { m_lock.reset(); }

  private:
    QString m_folder;
    std::unique_ptr<FileLock> m_lock;
};

} // namespace txn::app
