// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/ProjectLock.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

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

} // namespace

ProjectLock::ProjectLock(QString folder) : m_folder(std::move(folder)) {}

bool ProjectLock::take(const QString& project) {
    const auto name =
        QCryptographicHash::hash(identityOf(project).toUtf8(), QCryptographicHash::Sha256).toHex();
    const QString file =
        m_folder + QLatin1Char('/') + QString::fromLatin1(name) + QStringLiteral(".lock");
    if (m_lock && m_lock->file() == file)
        return true;
    QDir().mkpath(m_folder);
    auto lock = std::make_unique<FileLock>(file);
    if (lock->isTaken())
        return false;
    m_lock = std::move(lock);
    return true;
}

} // namespace txn::app
