// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/document/ProjectFile.h"
#include "app/files/FileLock.h"
#include "app/jobs/JobRunner.h"

#include <QDateTime>
#include <QImage>
#include <QTimer>
#include <atomic>
#include <memory>
#include <vector>

namespace txn::app {

/// What a program that died has left.
struct RecoveredProject {
    QString file;         ///< of the copy
    QString title;        ///< of the project
    QString originalPath; ///< empty: it was never saved
    QDateTime time;       ///< of the copy
    QImage thumbnail;
};

/// Writes a copy of unsaved work into a folder of its own, some seconds after a change, in a job.
/// The copy goes when the work is saved or given up; if the program dies, it stays and can be
/// found. The project's own file is never touched. Interface thread.
class Autosave : public QObject {
    Q_OBJECT

  public:
    Autosave(ProjectDocument& document,
             JobRunner& runner,
             const QString& folder,
             int delayMs = 5000);
    /// Gives the copy up: closing is a decision.
    ~Autosave() override;

    const QString& file() const { return m_file; }
    /// What came back from a copy counts as kept in it until the first copy of its own.
    void adopt(const RecoveredProject& copy);

  signals:
    /// No copy can be written; one line for the message bar.
    void failed(const QString& message);

  private:
    void schedule();
    void write();
    void giveUp();

    ProjectDocument& m_document;
    JobRunner& m_runner;
    QString m_file;
    std::unique_ptr<FileLock> m_lock; ///< held while this program lives
    /// Tells a job that still writes: what it wrote is to go again.
    std::shared_ptr<std::atomic<bool>> m_givenUp = std::make_shared<std::atomic<bool>>(false);
    QTimer m_soon;
};

/// Whether findRecoverable() may find something. Cheap.
[[nodiscard]] bool mayBeRecoverable(const QString& folder);

/// Whole copies whose programs have died, newest first: what counts is their content, not names and
/// dates of files. Others stay where they are. Reads them all: belongs into a job.
[[nodiscard]] std::vector<RecoveredProject> findRecoverable(const QString& folder);

/// Errors: those of decodeProject. Decodes the exemplar: belongs into a job.
[[nodiscard]] Result<SavedProject> readRecovered(const RecoveredProject& copy);

void discard(const RecoveredProject& copy);

} // namespace txn::app
