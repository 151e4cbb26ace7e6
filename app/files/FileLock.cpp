// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileLock.h"

#include <QFile>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace txn::app {

FileLock::FileLock(QString file) : m_file(std::move(file)) {
    constexpr int kTries = 10;
    const QByteArray name = QFile::encodeName(m_file);
    for (int i = 0; i < kTries; ++i) {
        const int fd = ::open(name.constData(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
        if (fd < 0)
            return;
        const bool mine = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
        m_taken = !mine && errno == EWOULDBLOCK;
        struct stat info {};
        if (mine && ::fstat(fd, &info) == 0 && info.st_nlink > 0) {
            m_fd = fd;
            return;
        }
        ::close(fd);
        if (!mine)
            return;
        // Whoever had it before removed the file just now: there is to be another one.
    }
}

FileLock::~FileLock() {
    if (m_fd < 0)
        return;
    QFile::remove(m_file); // while nobody else can have locked it
    ::close(m_fd);
}

} // namespace txn::app
