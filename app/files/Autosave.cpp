// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"

#include "app/display/PicturePyramid.h"

#include <QBuffer>
#include <QCborMap>
#include <QCborValue>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QUuid>
#include <algorithm>

namespace txn::app {
namespace {

const QString kEnding = QStringLiteral(".recovery");
const QString kFormat = QStringLiteral("texton-studio-recovery");
constexpr int kThumbnailPx = 96;

QByteArray thumbnail(const Project& project) {
    if (!project.source)
        return {};
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (buffer.open(QIODevice::WriteOnly))
        toQImage(project.source->loaded.image)
            .scaled(kThumbnailPx, kThumbnailPx, Qt::KeepAspectRatio, Qt::SmoothTransformation)
            .save(&buffer, "PNG");
    return bytes;
}

QCborMap readWrapper(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QCborMap map = QCborValue::fromCbor(file.readAll()).toMap();
    return map.value(QStringLiteral("format")).toString() == kFormat ? map : QCborMap();
}

} // namespace

Autosave::Autosave(ProjectDocument& document, JobRunner& runner, const QString& folder, int delayMs)
    : m_document(document), m_runner(runner), m_folder(folder) {
    QDir().mkpath(folder);
    m_file = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + kEnding);
    m_lock = std::make_unique<QLockFile>(m_file + QStringLiteral(".lock"));
    m_lock->setStaleLockTime(0); // as long as the process lives
    m_lock->tryLock(0);
    m_soon.setSingleShot(true);
    m_soon.setInterval(delayMs);
    connect(&m_soon, &QTimer::timeout, this, &Autosave::write);
    connect(&m_document, &ProjectDocument::projectChanged, this, &Autosave::schedule);
    connect(&m_document, &ProjectDocument::titleChanged, this, &Autosave::schedule);
}

Autosave::~Autosave() {
    m_runner.cancel(JobKind::Autosave);
    QFile::remove(m_file);
}

void Autosave::schedule() {
    if (!m_document.isModified()) {
        m_soon.stop();
        m_runner.cancel(JobKind::Autosave);
        QFile::remove(m_file);
        return;
    }
    // Not put off by further changes: while somebody drags, something is kept, too.
    if (!m_soon.isActive())
        m_soon.start();
}

void Autosave::write() {
    m_runner.submit(
        JobKind::Autosave,
        tr("Keeping a copy"),
        [file = m_file,
         project = m_document.project(),
         view = m_document.view(),
         title = m_document.title(),
         original = m_document.filePath()](JobContext& context) -> Delivery {
            QCborMap map;
            map[QStringLiteral("format")] = kFormat;
            map[QStringLiteral("title")] = title;
            map[QStringLiteral("original")] = original;
            map[QStringLiteral("thumbnail")] = thumbnail(project);
            map[QStringLiteral("project")] =
                encodeProject(project, view, ExemplarStorage::Embedded, QFileInfo(file).path());
            const QByteArray bytes = QCborValue(map).toCbor();
            QSaveFile output(file);
            // Once it is given up, it must not come back.
            if (output.open(QIODevice::WriteOnly) && output.write(bytes) == bytes.size() &&
                !context.cancelled())
                output.commit();
            return {};
        });
}

std::vector<RecoveredProject> findRecoverable(const QString& folder) {
    std::vector<RecoveredProject> found;
    for (const QFileInfo& info :
         QDir(folder).entryInfoList({QStringLiteral("*") + kEnding}, QDir::Files, QDir::Time)) {
        QLockFile lock(info.filePath() + QStringLiteral(".lock"));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0))
            continue; // its program is alive
        lock.unlock();
        const QCborMap map = readWrapper(info.filePath());
        if (map.isEmpty())
            continue;
        found.push_back({info.filePath(),
                         map.value(QStringLiteral("title")).toString(),
                         map.value(QStringLiteral("original")).toString(),
                         info.lastModified(),
                         QImage::fromData(map.value(QStringLiteral("thumbnail")).toByteArray())});
    }
    return found;
}

Result<SavedProject> readRecovered(const RecoveredProject& copy) {
    return decodeProject(readWrapper(copy.file).value(QStringLiteral("project")).toByteArray(),
                         copy.file);
}

void discard(const RecoveredProject& copy) {
    QFile::remove(copy.file);
    QFile::remove(copy.file + QStringLiteral(".lock"));
}

} // namespace txn::app
