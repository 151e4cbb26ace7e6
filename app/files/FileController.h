// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/document/ProjectFile.h"
#include "app/files/ProjectLock.h"
#include "app/jobs/JobRunner.h"

#include <QObject>

class QMimeData;
class QWidget;

namespace txn::app {

class Settings;

/// Opening, pasting, saving and closing: the questions that have to be asked on the way, and the
/// jobs that read and write. What fails leaves the document as it was.
class FileController : public QObject {
    Q_OBJECT

  public:
    FileController(ProjectDocument& document,
                   JobRunner& runner,
                   Settings& settings,
                   QWidget& window);

    /// A picture, texton or project, told by its content. Pictures and textons are undoable steps;
    /// a project takes the place of the open one, after asking to save that.
    void open(const QString& path);
    /// Several pictures are the maps of one material, told by their names.
    void open(const QStringList& paths);
    void openSample(const QString& name);
    void openDialog();
    /// A file's path or a picture. False if there is nothing of the kind in it.
    bool openMime(const QMimeData& data);

    // The same for the second exemplar of a mixture: pictures and maps only.
    void openSecond(const QStringList& paths);
    void openSecondSample(const QString& name);
    void openSecondDialog();
    bool openSecondMime(const QMimeData& data);
    static bool canOpen(const QMimeData& data);

    void newProject();
    void save();
    void saveAs() { saveAs({}); }
    /// Calls proceed once nothing can get lost: at once, or after the question and the saving.
    void whenSafe(const std::function<void()>& proceed);
    /// The project that a crash left behind.
    void recover(const SavedProject& saved, const QString& originalPath);

  signals:
    void problem(const QString& message);
    void note(const QString& message);
    void warning(const QString& message);
    /// A file was opened or saved and is among the recent ones now.
    void recentFilesChanged();

  private:
    /// Which exemplar.
    enum class Place { First, Second };

    struct SourceRequest {
        QString title; ///< of the job
        std::function<Result<std::shared_ptr<const Source>>(const LoadOptions&)> load;
        QString recent{}; ///< the file to remember, if there is one
        Place place = Place::First;
    };

    /// As large as pictures may be before the user is asked.
    LoadOptions usual() const;
    void askForMore(const Error& error, const std::function<void()>& openAnyway);
    void openSource(const SourceRequest& request, const LoadOptions& options);
    bool openMime(const QMimeData& data, Place place);
    void showDialog(const QString& title,
                    const QString& filter,
                    const std::function<void(const QStringList&)>& open);
    void showSecond(const std::shared_ptr<const Source>& source);
    void openPictureOrTexton(const QString& path, const LoadOptions& options);
    void openProjectFile(const QString& path, const Trust& trust);
    /// Whether a project may open files that lie outside its folder; then opens it again.
    void askForOutside(const QString& path, const QStringList& files, const Trust& trust);
    void show(const Opened& opened, const QString& name);
    /// As a copy without a file of its own where another program has it open.
    void showProject(const SavedProject& saved, const QString& path);
    void saveAs(const std::function<void()>& then);
    void saveTo(const QString& path, const std::function<void()>& then);
    void remember(const QString& path);
    void tell(const Error& error);
    void warn(const QStringList& warnings);

    ProjectDocument& m_document;
    JobRunner& m_runner;
    Settings& m_settings;
    QWidget& m_window;
    ProjectLock m_lock; ///< of the project that is open
};

} // namespace txn::app
