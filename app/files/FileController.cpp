// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileController.h"

#include "app/files/Thumbnail.h"
#include "app/look/Words.h"
#include "app/settings/Settings.h"
#include "core/mixing/MixingMap.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>

namespace txn::app {
namespace {

const QLatin1String kProjectEnding(".txnproj");

} // namespace

FileController::FileController(ProjectDocument& document,
                               JobRunner& runner,
                               Settings& settings,
                               QWidget& window)
    : QObject(&window), m_document(document), m_runner(runner), m_settings(settings),
      m_window(window), m_lock(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                               QStringLiteral("/locks")) {}

void FileController::tell(const Error& error) {
    if (error.code != ErrorCode::Cancelled)
        emit problem(inWords(error));
}

void FileController::askForMore(const Error& error, const std::function<void()>& openAnyway) {
    auto* box = new QMessageBox(QMessageBox::Question,
                                tr("Open a very large picture?"),
                                inWords(error),
                                QMessageBox::Cancel,
                                &m_window);
    box->setObjectName(QStringLiteral("largePictureQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("Opening it may take long and much memory. Open only files that you "
                               "trust this way."));
    box->addButton(tr("Open anyway"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [box, openAnyway](int) {
        if (box->buttonRole(box->clickedButton()) == QMessageBox::AcceptRole)
            openAnyway();
    });
    box->open();
}

LoadOptions FileController::usual() const {
    return {.maxSamples = m_settings.pictureBudget()};
}

void FileController::remember(const QString& path) {
    m_settings.addRecentFile(path);
    m_settings.setFolder(QStringLiteral("open"), QFileInfo(path).absolutePath());
    emit recentFilesChanged();
}

void FileController::open(const QString& path) {
    if (path.endsWith(kProjectEnding, Qt::CaseInsensitive)) {
        whenSafe([this, path] { openProjectFile(path, {.pictures = usual()}); });
        return;
    }
    openPictureOrTexton(path, usual());
}

void FileController::open(const QStringList& paths) {
    if (paths.size() == 1) {
        open(paths.front());
        return;
    }
    openSource({tr("Opening the maps of a material"),
                [paths](const LoadOptions& options) { return openStack(paths, options); }},
               usual());
}

void FileController::show(const Opened& opened, const QString& name) {
    // Nothing would get lost by closing a picture that was only looked at.
    const bool nothingToSave = !m_document.isModified() && m_document.filePath().isEmpty();
    m_document.change(tr("Open %1").arg(name), [&](Project& project) {
        // What was cut out of another picture means nothing in this one.
        project.edit = ExemplarEdit{};
        project.mix.edit.linear = project.edit.linear;
        project.source.reset();
        project.importedTexton.reset();
        project.noise.map.clear();
        if (const auto* source = std::get_if<std::shared_ptr<const Source>>(&opened)) {
            project.source = *source;
            return;
        }
        project.importedTexton = std::get<std::shared_ptr<const TextonAsset>>(opened);
        project.mix = MixSettings{}; // textons from files cannot be mixed
        project.noise.process = project.importedTexton->process;
        project.noise.meanImpacts = project.importedTexton->meanImpacts;
    });
    if (nothingToSave)
        m_document.undoStack().setClean();
}

void FileController::showSecond(const std::shared_ptr<const Source>& source) {
    if (!m_document.project().source) { // gone while this one was read
        emit problem(tr("Open a photo first, then a second one to mix it with."));
        return;
    }
    m_document.change(tr("Open %1 as B").arg(source->name()), [&](Project& project) {
        // The first one shows at once what mixing is.
        if (!project.mix.source)
            project.mix.map = PaintedMap::fromImage(
                gradientMap({PaintedMap::kStandardSide, PaintedMap::kStandardSide},
                            0.0,
                            Ease::Smooth));
        project.mix.source = source;
        project.mix.edit = ExemplarEdit{};
        project.mix.edit.linear = project.edit.linear;
    });
}

void FileController::openSource(const SourceRequest& request, const LoadOptions& options) {
    m_runner.submit(JobKind::Open,
                    request.title,
                    [this, request, options](JobContext&) -> Delivery {
                        auto source = request.load(options);
                        return [this, source = std::move(source), request] {
                            if (!source && source.error().code == ErrorCode::OverBudget) {
                                askForMore(source.error(), [this, request] {
                                    openSource(request, LoadOptions::insisted());
                                });
                                return;
                            }
                            if (!source) {
                                tell(source.error());
                                return;
                            }
                            if (request.place == Place::Second)
                                showSecond(*source);
                            else
                                show(*source, (*source)->name());
                            if (!request.recent.isEmpty())
                                remember(request.recent);
                        };
                    });
}

void FileController::openSample(const QString& name) {
    openSource({tr("Making the sample"), [name](const LoadOptions&) { return sampleSource(name); }},
               usual());
}

void FileController::openPictureOrTexton(const QString& path, const LoadOptions& options) {
    const QString name = QFileInfo(path).fileName();
    m_runner.submit(JobKind::Open,
                    tr("Opening %1").arg(name),
                    [this, path, name, options](JobContext&) -> Delivery {
                        auto opened = openFile(path, options);
                        return [this, opened = std::move(opened), path, name] {
                            if (!opened && opened.error().code == ErrorCode::OverBudget) {
                                askForMore(opened.error(), [this, path] {
                                    openPictureOrTexton(path, LoadOptions::insisted());
                                });
                                return;
                            }
                            if (!opened) {
                                tell(opened.error());
                                m_settings.removeRecentFile(path);
                                emit recentFilesChanged();
                                return;
                            }
                            show(*opened, name);
                            remember(path);
                        };
                    });
}

void FileController::openProjectFile(const QString& path, const Trust& trust) {
    m_runner.submit(JobKind::Open,
                    tr("Opening %1").arg(QFileInfo(path).fileName()),
                    [this, path, trust, before = m_document.project()](JobContext&) -> Delivery {
                        auto saved = openProject(path, trust);
                        return [this, saved = std::move(saved), path, trust, before] {
                            if (!saved && saved.error().code == ErrorCode::OverBudget) {
                                askForMore(saved.error(), [this, path, trust] {
                                    openProjectFile(path, {trust.outside, LoadOptions::insisted()});
                                });
                                return;
                            }
                            if (!saved) {
                                tell(saved.error());
                                m_settings.removeRecentFile(path);
                                emit recentFilesChanged();
                                return;
                            }
                            if (!saved->outside.isEmpty()) {
                                askForOutside(path, saved->outside, trust);
                                return;
                            }
                            const auto show = [this, saved = *saved, path] {
                                showProject(saved, QFileInfo(path).absoluteFilePath());
                                remember(path);
                            };
                            // What was changed while it was read has not been asked about.
                            if (m_document.project() == before)
                                show();
                            else
                                whenSafe(show);
                        };
                    });
}

void FileController::askForOutside(const QString& path,
                                   const QStringList& files,
                                   const Trust& trust) {
    auto* box = new QMessageBox(QMessageBox::Question,
                                tr("Files outside the project's folder"),
                                tr("%1 wants to open files outside its own folder. Do that only if "
                                   "you know where it comes from.")
                                    .arg(QFileInfo(path).fileName()),
                                QMessageBox::Open | QMessageBox::Cancel,
                                &m_window);
    box->setObjectName(QStringLiteral("outsideQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(files.join(QLatin1Char('\n')));
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, path, trust](int answer) {
        if (answer == QMessageBox::Open)
            openProjectFile(path, {true, trust.pictures});
    });
    box->open();
}

void FileController::showDialog(const QString& title,
                                const QString& filter,
                                const std::function<void(const QStringList&)>& open) {
    auto* dialog =
        new QFileDialog(&m_window, title, m_settings.folder(QStringLiteral("open")), filter);
    dialog->setObjectName(QStringLiteral("openDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, open);
    dialog->open();
}

void FileController::openDialog() {
    showDialog(tr("Open a photo, texton or project"),
               tr("All that can be opened (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr "
                  "*.tga *.bmp *.webp *.texton "
                  "*.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga "
                  "*.bmp *.webp);;Textons "
                  "(*.texton *.exr *.png);;Projects (*.txnproj);;All files (*)"),
               [this](const QStringList& paths) { open(paths); });
}

void FileController::openSecondDialog() {
    showDialog(tr("Open the second material"),
               tr("Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;"
                  "All files (*)"),
               [this](const QStringList& paths) { openSecond(paths); });
}

void FileController::openSecond(const QStringList& paths) {
    if (paths.size() == 1) {
        openSource({tr("Opening %1").arg(QFileInfo(paths.front()).fileName()),
                    [path = paths.front()](const LoadOptions& options) {
                        return app::openSource(path, options);
                    },
                    paths.front(),
                    Place::Second},
                   usual());
        return;
    }
    openSource({tr("Opening the maps of a material"),
                [paths](const LoadOptions& options) { return openStack(paths, options); },
                {},
                Place::Second},
               usual());
}

void FileController::openSecondSample(const QString& name) {
    openSource({tr("Making the sample"),
                [name](const LoadOptions&) { return sampleSource(name); },
                {},
                Place::Second},
               usual());
}

bool FileController::canOpen(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    return data.hasImage() ||
           std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
}

bool FileController::openMime(const QMimeData& data) {
    return openMime(data, Place::First);
}

bool FileController::openSecondMime(const QMimeData& data) {
    return openMime(data, Place::Second);
}

bool FileController::openMime(const QMimeData& data, Place place) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile())
            paths.append(url.toLocalFile());
    }
    if (!paths.isEmpty()) {
        if (place == Place::Second)
            openSecond(paths);
        else
            open(paths);
        return true;
    }
    // A PNG is passed on as it is; other pictures are unpacked by Qt and packed again in the job.
    const QByteArray png = data.data(QStringLiteral("image/png"));
    const auto image =
        png.isEmpty() && data.hasImage() ? qvariant_cast<QImage>(data.imageData()) : QImage();
    if (png.isEmpty() && image.isNull())
        return false;
    openSource(
        {tr("Pasting a picture"),
         [png, image, name = tr("Pasted picture") + QStringLiteral(".png")](
             const LoadOptions& options) -> Result<std::shared_ptr<const Source>> {
             QByteArray bytes = png;
             QBuffer buffer(&bytes);
             if (bytes.isEmpty() &&
                 (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")))
                 return Error{
                     ErrorCode::Unreadable,
                     "the pasted picture cannot be read; please save it as a file and open that"};
             return decodeSource(bytes, name, options);
         },
         {},
         place},
        usual());
    return true;
}

void FileController::newProject() {
    whenSafe([this] {
        m_runner.cancel(JobKind::Open);
        m_document.reset({}, {}, {});
        m_lock.release();
    });
}

void FileController::save() {
    if (m_document.filePath().isEmpty())
        saveAs();
    else
        saveTo(m_document.filePath(), {});
}

void FileController::saveAs(const std::function<void()>& then) {
    auto* dialog = new QFileDialog(&m_window,
                                   tr("Save the project"),
                                   m_settings.folder(QStringLiteral("save")),
                                   tr("Texton Studio projects (*.txnproj)"));
    dialog->setObjectName(QStringLiteral("saveDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("txnproj"));
    const QString base = QFileInfo(m_document.title()).completeBaseName();
    dialog->selectFile(base + kProjectEnding);
    connect(dialog, &QFileDialog::fileSelected, this, [this, then](const QString& path) {
        m_settings.setFolder(QStringLiteral("save"), QFileInfo(path).absolutePath());
        saveTo(path, then);
    });
    dialog->open();
}

void FileController::saveTo(const QString& path, const std::function<void()>& then) {
    if (m_runner.isBusy(JobKind::Save)) { // a second one would take the place of the first
        emit note(tr("Still saving. Please try again in a moment."));
        return;
    }
    if (!m_lock.take(path)) {
        warn({tr("%1 is open in another Texton Studio. Please choose another name.")
                  .arg(QFileInfo(path).fileName())});
        return;
    }
    m_runner.submit(JobKind::Save,
                    tr("Saving"),
                    [this, path, then, project = m_document.project(), view = m_document.view()](
                        JobContext&) -> Delivery {
                        const auto saved = saveProject(project, view, path, thumbnail(project));
                        return [this, saved, path, then, project] {
                            if (!saved) {
                                tell(saved.error());
                                return;
                            }
                            // Changes that were made meanwhile are still to be saved.
                            if (m_document.project() == project)
                                m_document.setSaved(path);
                            remember(path);
                            emit note(tr("Saved %1").arg(QFileInfo(path).fileName()));
                            if (then)
                                whenSafe(then);
                        };
                    });
}

void FileController::whenSafe(const std::function<void()>& proceed) {
    if (!m_document.isModified()) {
        proceed();
        return;
    }
    auto* box = new QMessageBox(QMessageBox::Question,
                                tr("Save before closing?"),
                                tr("%1 has changes that are not saved.").arg(m_document.title()),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
                                &m_window);
    box->setObjectName(QStringLiteral("saveQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        tr("Saving keeps the photo, all settings and the view in one project file."));
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QMessageBox::finished, this, [this, proceed](int answer) {
        if (answer == QMessageBox::Discard) {
            proceed();
        } else if (answer == QMessageBox::Save) {
            if (m_document.filePath().isEmpty())
                saveAs(proceed);
            else
                saveTo(m_document.filePath(), proceed);
        }
    });
    box->open();
}

void FileController::showProject(const SavedProject& saved, const QString& path) {
    const bool isFree = path.isEmpty() || m_lock.take(path);
    if (!isFree || path.isEmpty())
        m_lock.release(); // of the project that was open before
    m_document.reset(saved.project, saved.view, isFree ? path : QString());
    QStringList warnings = saved.warnings;
    if (!isFree)
        warnings.prepend(
            tr("%1 is open in another Texton Studio. This is a copy of it; please save "
               "it under another name.")
                .arg(QFileInfo(path).fileName()));
    warn(warnings);
}

void FileController::recover(const SavedProject& saved, const QString& originalPath) {
    showProject(saved, originalPath);
    m_document.markRecovered();
}

void FileController::warn(const QStringList& warnings) {
    if (!warnings.isEmpty())
        emit warning(warnings.join(QLatin1Char(' ')));
}

} // namespace txn::app
