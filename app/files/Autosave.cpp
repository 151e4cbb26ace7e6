// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"

#include "app/files/Thumbnail.h"

#include <QCborMap>
#include <QCborValue>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>
#include <algorithm>

namespace txn::app {
namespace {

const QString kEnding = QStringLiteral(".recovery");
const QString kFormat = QStringLiteral("texton-studio-recovery");
const QString kContent = QStringLiteral("content");
const QString kLockEnding = QStringLiteral(".lock");

/// Held as long as this process lives.
std::unique_ptr<FileLock> lockOf(const QString& file) {
    return std::make_unique<FileLock>(file + kLockEnding);
}

QByteArray hashOf(const QByteArray& content) {
    return QCryptographicHash::hash(content, QCryptographicHash::Sha256);
}

/// Empty: not a copy, or not a whole one.
QCborMap readWrapper(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QCborParserError problem;
    const QCborMap map = QCborValue::fromCbor(file.readAll(), &problem).toMap();
    if (problem.error != QCborError::NoError) // Qt's maps that end in a key crash on look-ups
        return {};
    const QByteArray content = map.value(kContent).toByteArray();
    if (map.value(QStringLiteral("format")).toString() != kFormat ||
        map.value(QStringLiteral("hash")).toByteArray() != hashOf(content))
        return {};
    return QCborValue::fromCbor(content).toMap();
}

QByteArray wrapped(const QCborMap& content) {
    QCborMap map;
    map[QStringLiteral("format")] = kFormat;
    map[kContent] = content.toCborValue().toCbor();
    map[QStringLiteral("hash")] = hashOf(map.value(kContent).toByteArray());
    return map.toCborValue().toCbor();
}

} // namespace

Autosave::Autosave(ProjectDocument& document, JobRunner& runner, const QString& folder, int delayMs)
    : m_document(document), m_runner(runner) {
    QDir().mkpath(folder);
    m_file = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + kEnding);
    m_lock = lockOf(m_file);
    m_soon.setSingleShot(true);
    m_soon.setInterval(delayMs);
    connect(&m_soon, &QTimer::timeout, this, &Autosave::write);
    connect(&m_document, &ProjectDocument::projectChanged, this, &Autosave::schedule);
    connect(&m_document, &ProjectDocument::titleChanged, this, &Autosave::schedule);
}

Autosave::~Autosave() {
    giveUp();
}

void Autosave::giveUp() {
    m_soon.stop();
    m_runner.cancel(JobKind::Autosave);
    m_givenUp->store(true);
    m_givenUp = std::make_shared<std::atomic<bool>>(false);
    QFile::remove(m_file);
}

void Autosave::schedule() {
    if (!m_document.isModified()) {
        giveUp();
        return;
    }
    // Not put off by further changes: while somebody drags, something is kept, too.
    if (!m_soon.isActive())
        m_soon.start();
}

void Autosave::adopt(const RecoveredProject& copy) {
    giveUp();
    m_file = copy.file;
    m_lock = lockOf(m_file);
    m_soon.start();
}

void Autosave::write() {
    if (m_runner.isBusy(JobKind::Autosave)) {
        m_soon.start(); // a large copy is finished before the next one begins
        return;
    }
    m_runner.submit(
        JobKind::Autosave,
        tr("Keeping a copy"),
        [this,
         file = m_file,
         project = m_document.project(),
         view = m_document.view(),
         title = m_document.title(),
         original = m_document.filePath(),
         givenUp = m_givenUp](JobContext&) -> Delivery {
            QCborMap map;
            map[QStringLiteral("title")] = title;
            map[QStringLiteral("original")] = original;
            map[QStringLiteral("thumbnail")] = thumbnail(project);
            map[QStringLiteral("project")] =
                encodeProject(project, view, ExemplarStorage::Embedded, QFileInfo(file).path());
            map[QStringLiteral("written")] = QDateTime::currentMSecsSinceEpoch();
            const auto written = writeWhole(file, wrapped(map));
            // Whoever gives it up removes it, too: it must not come back.
            if (*givenUp)
                QFile::remove(file);
            if (written)
                return {};
            return [this, reason = QString::fromStdString(written.error().message)] {
                emit failed(
                    tr("No copy of your work can be kept (%1). Please save it.").arg(reason));
            };
        });
}

bool mayBeRecoverable(const QString& folder) {
    return !QDir(folder).entryList({QStringLiteral("*") + kEnding}, QDir::Files).isEmpty();
}

std::vector<RecoveredProject> findRecoverable(const QString& folder) {
    // Taking the lock of a program that died, and letting go of it, removes it.
    for (const QString& lock :
         QDir(folder).entryList({QStringLiteral("*") + kEnding + kLockEnding}, QDir::Files))
        const FileLock left(QDir(folder).filePath(lock));
    std::vector<RecoveredProject> found;
    for (const QFileInfo& info :
         QDir(folder).entryInfoList({QStringLiteral("*") + kEnding}, QDir::Files)) {
        if (lockOf(info.filePath())->isTaken())
            continue; // of a program that lives
        const QCborMap map = readWrapper(info.filePath());
        if (map.isEmpty())
            continue;
        const auto written = map.value(QStringLiteral("written")).toInteger();
        found.push_back({info.filePath(),
                         map.value(QStringLiteral("title")).toString(),
                         map.value(QStringLiteral("original")).toString(),
                         QDateTime::fromMSecsSinceEpoch(written),
                         QImage::fromData(map.value(QStringLiteral("thumbnail")).toByteArray())});
    }
    std::ranges::stable_sort(found, std::ranges::greater(), &RecoveredProject::time);
    return found;
}

Result<SavedProject> readRecovered(const RecoveredProject& copy) {
    return decodeProject(readWrapper(copy.file).value(QStringLiteral("project")).toByteArray(),
                         copy.file,
                         Trust::full()); // what this program wrote itself
}

void discard(const RecoveredProject& copy) {
    QFile::remove(copy.file);
    QFile::remove(copy.file + kLockEnding);
}

} // namespace txn::app
