// SPDX-License-Identifier: GPL-3.0-or-later
// What the main window can do with two materials.
#include "app/MainWindow.h"
#include "app/document/ProjectDocument.h"
#include "app/files/FileController.h"
#include "app/mixing/MixEditor.h"
#include "app/mixing/PaintTools.h"
#include "app/panels/MixPanel.h"
#include "app/settings/Settings.h"
#include "app/widgets/ActionRegistry.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <array>

namespace txn::app {
namespace {

constexpr double kRadiusStep = 1.25;

} // namespace

void MainWindow::createMixActions() {
    m_actions->beginGroup(tr("Mix"));
    QAction* open = action(QStringLiteral("mix.open"),
                           tr("&Open a second material..."),
                           tr("Open another photo, to mix it with the first one."),
                           QStringLiteral("Ctrl+Shift+O"),
                           [this] { m_files->openSecondDialog(); });
    QAction* swap = action(QStringLiteral("mix.swap"),
                           tr("S&wap A and B"),
                           tr("Let the two materials change places. The noise stays as it is."),
                           QStringLiteral("Shift+X"),
                           [this] { m_mix->swapMaterials(); });
    QAction* remove = action(QStringLiteral("mix.remove"),
                             tr("&Remove the second material"),
                             tr("Show the first material alone again."),
                             QStringLiteral("Ctrl+Shift+B"),
                             [this] { m_mix->removeSecond(); });
    struct Tool {
        const char* id;
        QString text;
        QString tip;
        const char* key;
        PaintTool tool;
    };
    const std::array tools{
        Tool{"mix.look", tr("&Look"), tr("The mouse paints nothing."), "V", PaintTool::Look},
        Tool{"mix.brush",
             tr("&Brush"),
             tr("Paint where the second material is, in the noise seen from above."),
             "N",
             PaintTool::Paint},
        Tool{"mix.smooth", tr("&Smooth"), tr("Soften borders in the map."), "S", PaintTool::Smooth},
        Tool{"mix.erase",
             tr("&Eraser"),
             tr("Bring the first material back."),
             "E",
             PaintTool::Erase},
        Tool{"mix.gradient",
             tr("&Gradient"),
             tr("Drag a line: one material at its start, the other at its end."),
             "D",
             PaintTool::Line},
        Tool{"mix.round",
             tr("Ro&und gradient"),
             tr("Drag from the middle: one material inside, the other around it."),
             "C",
             PaintTool::Circle}};
    std::vector<QAction*> needMixture{swap, remove};
    for (const Tool& each : tools) {
        QAction* made = action(QLatin1String(each.id),
                               each.text,
                               each.tip,
                               QLatin1String(each.key),
                               [this, tool = each.tool] {
                                   auto state = m_tools->state();
                                   state.tool = tool;
                                   m_tools->set(state);
                               });
        made->setCheckable(true);
        const auto show = [this, made, tool = each.tool] {
            made->setChecked(m_tools->state().tool == tool);
        };
        connect(m_tools, &PaintTools::changed, made, show);
        connect(made, &QAction::triggered, made, show);
        show();
        needMixture.push_back(made);
    }
    const auto resize = [this](double factor) {
        auto state = m_tools->state();
        state.radiusPx =
            std::clamp(state.radiusPx * factor, PaintTools::kMinRadiusPx, PaintTools::kMaxRadiusPx);
        m_tools->set(state);
    };
    needMixture.push_back(action(QStringLiteral("mix.larger"),
                                 tr("L&arger brush"),
                                 tr("Make the brush a quarter larger."),
                                 QStringLiteral("]"),
                                 [resize] { resize(kRadiusStep); }));
    needMixture.push_back(action(QStringLiteral("mix.smaller"),
                                 tr("S&maller brush"),
                                 tr("Make the brush a quarter smaller."),
                                 QStringLiteral("["),
                                 [resize] { resize(1.0 / kRadiusStep); }));
    createMapActions();
    for (const char* id : {"mix.fill",
                           "mix.strips",
                           "mix.stripsDown",
                           "mix.passage",
                           "mix.invert",
                           "mix.repeat",
                           "mix.show",
                           "mix.import",
                           "mix.export"})
        needMixture.push_back(m_actions->find(QLatin1String(id)));
    const auto enable = [this, open, needMixture] {
        const Project& project = m_document.project();
        open->setEnabled(project.source != nullptr);
        for (QAction* each : needMixture)
            each->setEnabled(project.mix.source != nullptr);
    };
    connect(&m_document, &ProjectDocument::projectChanged, this, enable);
    enable();

    m_mixPanel->setAccepts(&FileController::canOpen);
    connect(m_mixPanel, &MixPanel::firstWanted, m_files, &FileController::openDialog);
    connect(m_mixPanel, &MixPanel::secondWanted, m_files, &FileController::openSecondDialog);
    connect(m_mixPanel, &MixPanel::firstDropped, m_files, [this](const QMimeData& dragged) {
        m_files->openMime(dragged);
    });
    connect(m_mixPanel, &MixPanel::secondDropped, m_files, [this](const QMimeData& dragged) {
        m_files->openSecondMime(dragged);
    });
    connect(m_mixPanel, &MixPanel::swapWanted, m_mix, &MixEditor::swapMaterials);
    connect(m_mixPanel, &MixPanel::removeWanted, m_mix, &MixEditor::removeSecond);
}

void MainWindow::createMapActions() {
    action(QStringLiteral("mix.fill"),
           tr("&Fill the map"),
           tr("All of it becomes what the brush paints."),
           QStringLiteral("Shift+F"),
           [this] { m_mix->fill(m_tools->state().target); });
    action(QStringLiteral("mix.strips"),
           tr("S&trips, left to right"),
           tr("One strip for each texton, from the first material on the left to the second one on "
              "the right."),
           QStringLiteral("Shift+T"),
           [this] { m_mix->makeStrips(0.0); });
    action(QStringLiteral("mix.stripsDown"),
           tr("Strips, top to bottom"),
           tr("One strip for each texton, from the first material at the top to the second one at "
              "the bottom."),
           QStringLiteral("Ctrl+Shift+T"),
           [this] { m_mix->makeStrips(90.0); });
    action(QStringLiteral("mix.passage"),
           tr("Smooth passage"),
           tr("From the first material on the left to the second one on the right, slowly at both "
              "ends."),
           QStringLiteral("Shift+D"),
           [this] { m_mix->makePassage(); });
    action(QStringLiteral("mix.invert"),
           tr("&Invert the map"),
           tr("The second material where the first one was."),
           QStringLiteral("Ctrl+I"),
           [this] { m_mix->invertMap(); });
    QAction* repeat = action(QStringLiteral("mix.repeat"),
                             tr("Re&peat the map"),
                             tr("Beyond its border the map comes again, instead of going on as it "
                                "ends."),
                             QStringLiteral("Shift+R"),
                             [this] { m_mix->setRepeats(!m_document.project().mix.repeats); });
    repeat->setCheckable(true);
    const auto showRepeat = [this, repeat] {
        repeat->setChecked(m_document.project().mix.repeats);
    };
    connect(&m_document, &ProjectDocument::projectChanged, repeat, showRepeat);
    QAction* show = action(
        QStringLiteral("mix.show"),
        tr("S&how the map"),
        tr("Lay the map over the noise: blue is the first material, amber the second one."),
        QStringLiteral("M"),
        [this] { m_document.changeView([](ViewState& view) { view.mapShown = !view.mapShown; }); });
    show->setCheckable(true);
    connect(&m_document, &ProjectDocument::viewChanged, show, [this, show] {
        show->setChecked(m_document.view().mapShown);
    });
    action(QStringLiteral("mix.import"),
           tr("Import a map..."),
           tr("Take a gray picture as the map: black is the first material, white the second."),
           QStringLiteral("Ctrl+Shift+M"),
           [this] { chooseMapToImport(); });
    action(QStringLiteral("mix.export"),
           tr("E&xport the map..."),
           tr("Save the map as a gray picture."),
           QStringLiteral("Ctrl+Alt+M"),
           [this] { chooseMapToExport(); });
}

void MainWindow::chooseMapToImport() {
    auto* dialog = new QFileDialog(
        this,
        tr("Import a map"),
        m_settings.folder(QStringLiteral("maps")),
        tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;All files (*)"));
    dialog->setObjectName(QStringLiteral("importMapDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_settings.setFolder(QStringLiteral("maps"), QFileInfo(path).absolutePath());
        m_mix->importMap(path);
    });
    dialog->open();
}

void MainWindow::chooseMapToExport() {
    auto* dialog = new QFileDialog(this,
                                   tr("Export the map"),
                                   m_settings.folder(QStringLiteral("maps")),
                                   tr("Pictures (*.png *.tif *.exr)"));
    dialog->setObjectName(QStringLiteral("exportMapDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(QFileInfo(m_document.title()).completeBaseName() +
                       QStringLiteral("_map.png"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_settings.setFolder(QStringLiteral("maps"), QFileInfo(path).absolutePath());
        m_mix->exportMap(path);
    });
    dialog->open();
}

} // namespace txn::app
