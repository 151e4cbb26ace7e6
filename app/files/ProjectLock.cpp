// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/ProjectLock.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace txn::app {
namespace {

/// The same for all ways to write the path of a file, which need not be there yet.
QString identityOf(const QString& project) {
    const QFileInfo info(project);
    const QString known = info.canonicalFilePath();
    return known.isEmpty()
               ? QFileInfo(info.path()).canonicalFilePath() + QLatin1Char('/') + info.fileName()
               : known;
}

/// A locked file; -1 where there can be none, -2 where somebody else has it.
constexpr int kNone = -1;
constexpr int kTaken = -2;
int lock(const QByteArray& file) {
    constexpr int kTries = 10;
    for (int i = 0; i < kTries; ++i) {
        const int fd = ::open(file.constData(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
        if (fd < 0)
            return kNone;
        if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
            const bool isTaken = errno == EWOULDBLOCK;
            ::close(fd);
            return isTaken ? kTaken : kNone;
        }
        // Unless whoever had it before has just removed it.
        struct stat info {};
        if (::fstat(fd, &info) == 0 && info.st_nlink > 0)
            return fd;
        ::close(fd);
    }
    return kNone;
}

} // namespace

ProjectLock::ProjectLock(QString folder) : m_folder(std::move(folder)) {}

ProjectLock::~ProjectLock() {
    release();
}

bool ProjectLock::take(const QString& project) {
    const auto name =
        QCryptographicHash::hash(identityOf(project).toUtf8(), QCryptographicHash::Sha256).toHex();
    const QString file =
        m_folder + QLatin1Char('/') + QString::fromLatin1(name) + QStringLiteral(".lock");
    if (m_file == file)
        return true;
    QDir().mkpath(m_folder);
    const int fd = lock(QFile::encodeName(file));
    if (fd == kTaken)
        return false;
    release();
    if (fd >= 0) {
        m_file = file;
        m_fd = fd;
    }
    return true;
}

void ProjectLock::release() {
    if (m_fd < 0)
        return;
    QFile::remove(m_file); // while it is still locked
    ::close(m_fd);
    m_fd = -1;
    m_file.clear();
}

} // namespace txn::app
