// SPDX-License-Identifier: GPL-3.0-or-later
// What the main window can be told to do.
#include "app/MainWindow.h"
#include "app/document/ProjectDocument.h"
#include "app/export/ExportJob.h"
#include "app/files/FileController.h"
#include "app/look/Language.h"
#include "app/look/Theme.h"
#include "app/look/Words.h"
#include "app/panels/ExportDialog.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "app/views/ViewArea.h"
#include "app/widgets/ActionRegistry.h"
#include "app/widgets/CommandPalette.h"
#include "app/widgets/KeyMapOverlay.h"
#include "app/widgets/MessageBar.h"
#include "app/widgets/ShortcutEditor.h"
#include "core/base/Version.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRandomGenerator>
#include <QWhatsThis>

namespace txn::app {
namespace {

constexpr double kZoomStep = 1.4142135623730951;

} // namespace

QAction* MainWindow::action(const QString& id,
                            const QString& text,
                            const QString& toolTip,
                            const QString& shortcut,
                            const std::function<void()>& run) {
    QAction* made = m_actions->add(id, text, toolTip, shortcut);
    addAction(made);
    connect(made, &QAction::triggered, this, run);
    return made;
}

void MainWindow::createActions() {
    createFileActions();
    createEditActions();
    createViewActions();
    createTextonActions();
    createNoiseActions();
    createMixActions();
    createWindowActions();
    createHelpActions();
}

void MainWindow::createFileActions() {
    m_actions->beginGroup(tr("File"));
    action(QStringLiteral("file.new"),
           tr("&New"),
           tr("Close everything and start afresh."),
           QStringLiteral("Ctrl+N"),
           [this] { m_files->newProject(); });
    action(QStringLiteral("file.open"),
           tr("&Open..."),
           tr("Open a photo, a texton or a project."),
           QStringLiteral("Ctrl+O"),
           [this] { m_files->openDialog(); });
    action(QStringLiteral("file.save"),
           tr("&Save project"),
           tr("Keep the photo and all settings in one file."),
           QStringLiteral("Ctrl+S"),
           [this] { m_files->save(); });
    action(QStringLiteral("file.saveAs"),
           tr("Save project &as..."),
           tr("Save under another name."),
           QStringLiteral("Ctrl+Shift+S"),
           [this] { m_files->saveAs(); });
    QAction* embed = action(
        QStringLiteral("file.embed"),
        tr("&Photo inside the project"),
        tr("On, a project holds the photo itself; off, it only remembers where the photo is."),
        QStringLiteral("Ctrl+Shift+I"),
        [this] {
            const bool link = !m_document.project().linked;
            m_document.change(link ? tr("Link the photo") : tr("Photo inside the project"),
                              [link](Project& project) { project.linked = link; });
        });
    embed->setCheckable(true);
    const auto showEmbed = [this, embed] {
        // Only what came from a file can be found there again.
        const auto& source = m_document.project().source;
        const bool canLink = source && !source->path().isEmpty();
        embed->setEnabled(canLink);
        embed->setChecked(!canLink || !m_document.project().linked);
    };
    connect(&m_document, &ProjectDocument::projectChanged, embed, showEmbed);
    showEmbed();
    action(QStringLiteral("file.export"),
           tr("&Export..."),
           tr("Write textons, textures and shaders for other programs."),
           QStringLiteral("Ctrl+E"),
           [this] { openExport(); });
    action(QStringLiteral("file.screenshot"),
           tr("Save picture of &the noise..."),
           tr("Save what the noise view shows."),
           QStringLiteral("Ctrl+Shift+E"),
           [this] { saveScreenshot(); });
    action(QStringLiteral("file.quit"),
           tr("&Quit"),
           tr("Close the program."),
           QStringLiteral("Ctrl+Q"),
           [this] { close(); });
    connect(m_files, &FileController::recentFilesChanged, this, &MainWindow::fillRecentMenu);
}

void MainWindow::createEditActions() {
    m_actions->beginGroup(tr("Edit"));
    QUndoStack& stack = m_document.undoStack();
    QAction* undo = action(QStringLiteral("edit.undo"),
                           tr("&Undo"),
                           tr("Take the last change back."),
                           QStringLiteral("Ctrl+Z"),
                           [&stack] { stack.undo(); });
    QAction* redo = action(QStringLiteral("edit.redo"),
                           tr("&Redo"),
                           tr("Make the change again."),
                           QStringLiteral("Ctrl+Shift+Z"),
                           [&stack] { stack.redo(); });
    const auto show = [this, undo, redo, &stack] {
        undo->setEnabled(stack.canUndo());
        redo->setEnabled(stack.canRedo());
        undo->setText(stack.canUndo() ? tr("&Undo: %1").arg(stack.undoText()) : tr("&Undo"));
        redo->setText(stack.canRedo() ? tr("&Redo: %1").arg(stack.redoText()) : tr("&Redo"));
    };
    connect(&stack, &QUndoStack::indexChanged, this, show);
    show();
    action(QStringLiteral("edit.paste"),
           tr("&Paste"),
           tr("Open the picture or file in the clipboard."),
           QStringLiteral("Ctrl+V"),
           [this] {
               const QMimeData* content = QApplication::clipboard()->mimeData();
               if (content == nullptr || !m_files->openMime(*content))
                   m_messages->show(MessageBar::Kind::Note,
                                    tr("There is no picture in the clipboard."));
           });
    action(QStringLiteral("edit.resetExemplar"),
           tr("Reset the &exemplar"),
           tr("Back to the photo as it was opened."),
           QStringLiteral("Ctrl+Shift+X"),
           [this] {
               m_document.change(tr("Reset the exemplar"),
                                 [](Project& project) { project.edit = ExemplarEdit{}; });
           });
    action(QStringLiteral("edit.shortcuts"),
           tr("&Shortcuts..."),
           tr("Choose your own keys."),
           QStringLiteral("Ctrl+K"),
           [this] {
               auto* editor = new ShortcutEditor(*m_actions, this);
               editor->setAttribute(Qt::WA_DeleteOnClose);
               editor->show();
           });
}

void MainWindow::createViewActions() {
    m_actions->beginGroup(tr("View"));
    struct Layout {
        const char* id;
        QString text;
        QString tip;
        const char* icon;
        const char* key;
        ViewLayout layout;
    };
    const std::array layouts{Layout{"view.single",
                                    tr("&Single view"),
                                    tr("One picture fills the middle."),
                                    "single",
                                    "Ctrl+1",
                                    ViewLayout::Single},
                             Layout{"view.sideBySide",
                                    tr("Side &by side"),
                                    tr("Two pictures next to each other."),
                                    "side-by-side",
                                    "Ctrl+2",
                                    ViewLayout::SideBySide},
                             Layout{"view.quad",
                                    tr("&Four views"),
                                    tr("Exemplar, Gaussian version, texton and noise at once."),
                                    "quad",
                                    "Ctrl+4",
                                    ViewLayout::Quad},
                             Layout{"view.wipe",
                                    tr("&Wipe"),
                                    tr("Two pictures in one place, with a border to drag."),
                                    "wipe",
                                    "W",
                                    ViewLayout::Wipe}};
    auto* group = new QActionGroup(this);
    for (const Layout& each : layouts) {
        QAction* made = action(QLatin1String(each.id),
                               each.text,
                               each.tip,
                               QLatin1String(each.key),
                               [this, layout = each.layout] { m_views->setLayoutKind(layout); });
        made->setIcon(themeIcon(QLatin1String(each.icon)));
        made->setCheckable(true);
        group->addAction(made);
        connect(&m_document,
                &ProjectDocument::viewChanged,
                made,
                [this, made, layout = each.layout] {
                    made->setChecked(m_document.view().layout == layout);
                });
        made->setChecked(m_document.view().layout == each.layout);
    }
    action(QStringLiteral("view.fit"),
           tr("F&it"),
           tr("Show the whole exemplar."),
           QStringLiteral("F"),
           [this] { m_views->fit(); });
    action(QStringLiteral("view.zoomIn"),
           tr("&Zoom in"),
           tr("Larger, at the mouse."),
           QStringLiteral("Ctrl++"),
           [this] { m_views->zoomBy(kZoomStep); });
    action(QStringLiteral("view.zoomOut"),
           tr("Zoom &out"),
           tr("Smaller, at the mouse."),
           QStringLiteral("Ctrl+-"),
           [this] { m_views->zoomBy(1.0 / kZoomStep); });
    action(QStringLiteral("view.zoom100"),
           tr("&100 %"),
           tr("One pixel of the picture is one of the screen."),
           QStringLiteral("1"),
           [this] { m_views->setZoom(1.0); });
    action(QStringLiteral("view.zoom200"),
           tr("&200 %"),
           tr("Twice as large."),
           QStringLiteral("2"),
           [this] { m_views->setZoom(2.0); });
    action(QStringLiteral("view.gaussian"),
           tr("Show the &Gaussian version"),
           tr("In the view under the mouse."),
           QStringLiteral("G"),
           [this] { m_views->showGaussian(); });
    QAction* tiling = action(
        QStringLiteral("view.tiled"),
        tr("&Tile the exemplar"),
        tr("Repeat the photo, to see the repetition that the noise does away with."),
        QStringLiteral("T"),
        [this] { m_document.changeView([](ViewState& view) { view.tiled = !view.tiled; }); });
    tiling->setCheckable(true);
    connect(&m_document, &ProjectDocument::viewChanged, tiling, [this, tiling] {
        tiling->setChecked(m_document.view().tiled);
    });
    const auto expose = [this](const char* id,
                               const QString& text,
                               const QString& tip,
                               const char* key,
                               double step) {
        action(QLatin1String(id), text, tip, QLatin1String(key), [this, step] {
            m_document.changeView([step](ViewState& view) {
                view.exposure = step == 0.0 ? 0.0 : std::clamp(view.exposure + step, -10.0, 10.0);
            });
        });
    };
    expose("view.brighter",
           tr("B&righter"),
           tr("Show everything a third of a stop brighter."),
           "+",
           1.0 / 3.0);
    expose("view.darker",
           tr("&Darker"),
           tr("Show everything a third of a stop darker."),
           "-",
           -1.0 / 3.0);
    expose("view.exposureReset",
           tr("&Normal exposure"),
           tr("Show the values as they are."),
           "0",
           0.0);
    m_actions->beginGroup(tr("Channels"));
    const auto isolate = [this](const char* id,
                                const QString& text,
                                const char* key,
                                std::optional<int> channel) {
        action(QLatin1String(id),
               text,
               tr("Look at single channels as gray."),
               QLatin1String(key),
               [this, channel] {
                   m_document.changeView([channel](ViewState& view) { view.channel = channel; });
               });
    };
    isolate("view.channelAll", tr("&All channels"), "Shift+0", std::nullopt);
    isolate("view.channel1", tr("First channel (red)"), "Shift+1", 0);
    isolate("view.channel2", tr("Second channel (green)"), "Shift+2", 1);
    isolate("view.channel3", tr("Third channel (blue)"), "Shift+3", 2);
    m_actions->beginGroup(tr("Surround"));
    const auto surround =
        [this](const char* id, const QString& text, const char* key, Surround choice) {
            action(QLatin1String(id),
                   text,
                   tr("What is around the pictures."),
                   QLatin1String(key),
                   [this, choice] {
                       m_settings.setSurround(choice);
                       m_views->update();
                       emit m_document.viewChanged();
                   });
        };
    surround("view.surroundGrey", tr("Gray"), "Shift+G", Surround::Grey);
    surround("view.surroundBlack", tr("Black"), "Shift+B", Surround::Black);
    surround("view.surroundWhite", tr("White"), "Shift+W", Surround::White);
}

void MainWindow::createTextonActions() {
    m_actions->beginGroup(tr("Texton"));
    action(QStringLiteral("texton.compute"),
           tr("&Compute again"),
           tr("Compute the texton once more and watch it form."),
           QStringLiteral("F5"),
           [this] { m_pipeline.recomputeTexton(); });
    action(QStringLiteral("texton.cancel"),
           tr("C&ancel"),
           tr("Stop computing the texton."),
           QStringLiteral("Shift+F5"),
           [this] { m_pipeline.cancelTexton(); });
    action(
        QStringLiteral("texton.newSeed"),
        tr("New &seed"),
        tr("Another random result of what is under the mouse: Gaussian version, texton or noise."),
        QStringLiteral("R"),
        [this] { newSeed(); });
    action(QStringLiteral("texton.keep"),
           tr("&Keep to compare"),
           tr("Keep the present texton as A. Change something, then look at both by turns."),
           QStringLiteral("K"),
           [this] { m_pipeline.keepTexton(); });
    QAction* kept =
        action(QStringLiteral("texton.showKept"),
               tr("Show &the kept one (A/B)"),
               tr("Look at the kept texton and its noise, and back at the present one."),
               QStringLiteral("B"),
               [this] { m_pipeline.showKept(!m_pipeline.isShowingKept()); });
    kept->setCheckable(true);
    QAction* beside = action(
        QStringLiteral("texton.keptBeside"),
        tr("Kept and present side &by side"),
        tr("The noise of the kept texton on the left, that of the present one on the right."),
        QStringLiteral("Shift+K"),
        [this] {
            m_pipeline.showKept(false);
            m_document.changeView([](ViewState& view) {
                view.keptBeside = !view.keptBeside;
                if (!view.keptBeside)
                    return;
                view.layout = ViewLayout::SideBySide;
                view.shown[0] = Picture::Noise;
                view.shown[1] = Picture::Noise;
            });
        });
    beside->setCheckable(true);
    const auto showKept = [this, kept, beside] {
        kept->setEnabled(m_pipeline.keptTexton() != nullptr);
        kept->setChecked(m_pipeline.isShowingKept());
        beside->setEnabled(m_pipeline.keptTexton() != nullptr);
        beside->setChecked(m_document.view().keptBeside);
    };
    connect(&m_pipeline, &Pipeline::stateChanged, kept, showKept);
    connect(&m_document, &ProjectDocument::viewChanged, kept, showKept);
    showKept();
    const auto method = [this](const char* id,
                               const QString& text,
                               const QString& tip,
                               const char* key,
                               GaussianMethod choice) {
        action(QLatin1String(id), text, tip, QLatin1String(key), [this, choice] {
            m_document.change(tr("Gaussian method"),
                              [choice](Project& project) { project.gaussian.method = choice; });
        });
    };
    method("texton.adsn",
           tr("&Gaussian version: ADSN"),
           tr("Random phases and random strengths: what texton noise comes to."),
           "A",
           GaussianMethod::Adsn);
    method("texton.rpn",
           tr("Gaussian version: &RPN"),
           tr("Random phases only: keeps the exact spectrum of the photo."),
           "P",
           GaussianMethod::RandomPhase);
}

void MainWindow::createNoiseActions() {
    m_actions->beginGroup(tr("Noise"));
    struct Choice {
        const char* id;
        QString text;
        const char* key;
        NoiseScene scene;
    };
    for (const Choice& each :
         {Choice{"noise.flat", tr("&Flat"), "Ctrl+Shift+1", NoiseScene::Plane},
          Choice{"noise.ground", tr("&Ground"), "Ctrl+Shift+2", NoiseScene::Perspective},
          Choice{"noise.mesh", tr("Mesh, by its &UVs"), "Ctrl+Shift+3", NoiseScene::Mesh},
          Choice{"noise.surface", tr("Mesh, any &surface"), "Ctrl+Shift+4", NoiseScene::Surface}})
        action(QLatin1String(each.id),
               each.text,
               tr("What the noise is shown on."),
               QLatin1String(each.key),
               [this, scene = each.scene] {
                   m_document.change(tr("Noise view"),
                                     [scene](Project& project) { project.noise.scene = scene; });
               });
    action(QStringLiteral("noise.lighting"),
           tr("&Lighting"),
           tr("Shade the mesh, or not."),
           QStringLiteral("L"),
           [this] {
               m_document.change(tr("Lighting"), [](Project& project) {
                   project.noise.lighting = !project.noise.lighting;
               });
           });
}

void MainWindow::newSeed() {
    const quint32 seed = QRandomGenerator::global()->generate();
    const Picture picture = m_views->pictureUnderMouse().value_or(Picture::Noise);
    if (picture == Picture::Texton && m_document.project().texton.seedLocked) {
        m_messages->show(MessageBar::Kind::Note, tr("The texton's seed is locked."));
        return;
    }
    m_document.change(tr("New seed"), [&](Project& project) {
        if (picture == Picture::Gaussian)
            project.gaussian.seed = Seed{seed};
        else if (picture == Picture::Texton)
            project.texton.seed = Seed{seed};
        else
            project.noise.seed = Seed{seed};
    });
}

void MainWindow::createWindowActions() {
    m_actions->beginGroup(tr("Panel"));
    for (std::size_t i = 0; i < kDockOrder.size(); ++i) {
        QAction* toggle = m_docks.at(QLatin1String(kDockOrder[i]))->toggleViewAction();
        toggle->setToolTip(tr("Show or hide this panel."));
        toggle->setWhatsThis(toggle->toolTip());
        m_actions->adopt(QStringLiteral("window.") + QLatin1String(kDockOrder[i]),
                         toggle,
                         QStringLiteral("Alt+%1").arg(i + 1));
        addAction(toggle);
    }
    m_actions->beginGroup(tr("Window"));
    // In a view only: elsewhere, Tab goes to the next control.
    QAction* hide =
        m_actions->add(QStringLiteral("window.hideDocks"),
                       tr("&Hide panels"),
                       tr("Nothing but the pictures; the same key brings the panels back."),
                       QStringLiteral("Tab"));
    hide->setShortcutContext(Qt::WidgetShortcut);
    for (PictureView* view : m_views->views())
        view->addAction(hide);
    connect(hide, &QAction::triggered, this, &MainWindow::toggleDocks);
    action(QStringLiteral("window.next"),
           tr("&Next panel"),
           tr("Go on to the next panel with the keyboard."),
           QStringLiteral("F6"),
           [this] { focusNextPart(); });
    action(QStringLiteral("window.reset"),
           tr("&Reset layout"),
           tr("Put all panels back where they belong."),
           QStringLiteral("Ctrl+Shift+R"),
           [this] { resetLayout(); });
    QAction* full = action(QStringLiteral("window.fullScreen"),
                           tr("&Full screen"),
                           tr("Use the whole screen."),
                           QStringLiteral("F11"),
                           [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    full->setCheckable(true);
    const auto theme =
        [this](const char* id, const QString& text, const char* key, ThemeChoice choice) {
            action(QLatin1String(id),
                   text,
                   tr("The colors of the window."),
                   QLatin1String(key),
                   [this, choice] {
                       m_settings.setTheme(choice);
                       applyTheme(*qApp, choice);
                   });
        };
    m_actions->beginGroup(tr("Theme"));
    theme("window.themeDark", tr("&Dark"), "Ctrl+Alt+D", ThemeChoice::Dark);
    theme("window.themeLight", tr("&Light"), "Ctrl+Alt+L", ThemeChoice::Light);
    theme("window.themeSystem", tr("As the &system"), "Ctrl+Alt+S", ThemeChoice::System);
    m_actions->beginGroup(tr("Language"));
    int count = 0;
    for (const QString& code : availableLanguages())
        action(QStringLiteral("window.language.") + code,
               languageName(code),
               tr("The language of the window, from the next start on."),
               QStringLiteral("Ctrl+Alt+%1").arg(++count),
               [this, code] { chooseLanguage(code); });
}

void MainWindow::createHelpActions() {
    m_actions->beginGroup(tr("Help"));
    action(QStringLiteral("help.palette"),
           tr("&Command palette"),
           tr("Find any command by typing a part of its name."),
           QStringLiteral("Ctrl+Shift+P"),
           [this] { CommandPalette::open(*m_actions, *this); });
    action(QStringLiteral("help.keys"),
           tr("&Keys"),
           tr("All keys at a glance."),
           QStringLiteral("F1"),
           [this] { KeyMapOverlay::toggle(*m_actions, *this); });
    action(QStringLiteral("help.whatsThis"),
           tr("&What is this?"),
           tr("Then click on anything to read about it."),
           QStringLiteral("Shift+F1"),
           [] { QWhatsThis::enterWhatsThisMode(); });
    action(
        QStringLiteral("help.about"),
        tr("&About Texton Studio"),
        tr("Version, method and license."),
        QStringLiteral("Ctrl+F1"),
        [this] {
            auto* box =
                new QMessageBox(QMessageBox::NoIcon,
                                tr("About Texton Studio"),
                                tr("<b>Texton Studio %1</b>").arg(QLatin1String(kProgramVersion)),
                                QMessageBox::Close,
                                this);
            box->setInformativeText(tr(
                "Endless material from a photo, by the method of Galerne, Leclaire and Moisan "
                "(2014, "
                "2017). Free software under the GNU General Public License, version 3 or later."));
            QString details;
            for (const char* library : libraryVersions())
                details += QLatin1String(library) + QLatin1Char('\n');
            box->setDetailedText(details);
            box->setIconPixmap(QIcon(QStringLiteral(":/icons/texton-studio.svg")).pixmap(64, 64));
            box->setObjectName(QStringLiteral("aboutBox"));
            box->setAttribute(Qt::WA_DeleteOnClose);
            box->setModal(false);
            box->show();
        });
}

void MainWindow::chooseLanguage(const QString& language) {
    m_settings.setLanguage(language);
    m_messages->show(MessageBar::Kind::Note,
                     tr("The language changes when you start Texton Studio again."));
}

void MainWindow::saveScreenshot() {
    const QImage picture = m_views->screenshotOfNoise();
    if (picture.isNull()) {
        m_messages->show(
            MessageBar::Kind::Note,
            tr("There is no finished noise to save yet. Please wait a moment, or open a photo."));
        return;
    }
    auto* dialog = new QFileDialog(this,
                                   tr("Save the picture"),
                                   m_settings.folder(QStringLiteral("screenshots")),
                                   tr("PNG pictures (*.png)"));
    dialog->setObjectName(QStringLiteral("screenshotDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(QFileInfo(m_document.title()).completeBaseName() +
                       QStringLiteral("_noise.png"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, picture](const QString& path) {
        m_settings.setFolder(QStringLiteral("screenshots"), QFileInfo(path).absolutePath());
        m_runner.submit(
            JobKind::Picture,
            tr("Saving the picture"),
            [this, picture, path](JobContext&) -> Delivery {
                const auto saved = saveView(path, picture);
                return [this, saved, path] {
                    if (saved)
                        m_messages->show(MessageBar::Kind::Note,
                                         tr("Saved %1").arg(QFileInfo(path).fileName()));
                    else
                        m_messages->show(MessageBar::Kind::Problem, inWords(saved.error()));
                };
            });
    });
    dialog->open();
}

void MainWindow::openExport() {
    if (m_export == nullptr) {
        m_export = new ExportDialog(m_document, m_pipeline, m_runner, m_settings, this);
        m_export->setCurrentView([this] { return m_views->screenshotOfNoise(); });
    }
    m_export->show();
    m_export->raise();
    m_export->activateWindow();
}

} // namespace txn::app
