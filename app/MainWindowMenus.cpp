// SPDX-License-Identifier: GPL-3.0-or-later
// Where the actions of the main window are found.
#include "app/MainWindow.h"
#include "app/display/PicturePyramid.h"
#include "app/files/FileController.h"
#include "app/look/Language.h"
#include "app/settings/Settings.h"
#include "app/widgets/ActionRegistry.h"
#include "core/samples/Samples.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QProxyStyle>
#include <QToolBar>

namespace txn::app {
namespace {

/// Menus with pictures that are to be seen.
class ThumbnailStyle final : public QProxyStyle {
  public:
    static constexpr int kSide = 40;

    ThumbnailStyle() : QProxyStyle(QStringLiteral("Fusion")) {}
    int pixelMetric(PixelMetric metric,
                    const QStyleOption* option,
                    const QWidget* widget) const override {
        return metric == PM_SmallIconSize ? kSide
                                          : QProxyStyle::pixelMetric(metric, option, widget);
    }
};

QString sampleTitle(const QString& name) {
    const std::map<QString, QString> titles{
        {QStringLiteral("wood"), MainWindow::tr("Wood")},
        {QStringLiteral("stone"), MainWindow::tr("Stone")},
        {QStringLiteral("sand"), MainWindow::tr("Sand")},
        {QStringLiteral("rust"), MainWindow::tr("Rust")},
        {QStringLiteral("metal"), MainWindow::tr("Brushed metal")},
        {QStringLiteral("cloth"), MainWindow::tr("Cloth")},
        {QStringLiteral("leather"), MainWindow::tr("Leather")}};
    const auto found = titles.find(name);
    return found == titles.end() ? name : found->second;
}

} // namespace

void MainWindow::createMenus() {
    const auto fill = [this](QMenu* menu, std::initializer_list<const char*> ids) {
        for (const char* id : ids) {
            if (*id == '\0')
                menu->addSeparator();
            else
                menu->addAction(m_actions->find(QLatin1String(id)));
        }
        menu->setToolTipsVisible(true);
    };
    QMenu* file = menuBar()->addMenu(tr("&File"));
    fill(file, {"file.new", "file.open"});
    m_recentMenu = file->addMenu(tr("Open &recent"));
    m_sampleMenu = file->addMenu(tr("Open a sa&mple"));
    m_sampleMenu->setObjectName(QStringLiteral("sampleMenu"));
    auto* style = new ThumbnailStyle;
    style->setParent(m_sampleMenu);
    m_sampleMenu->setStyle(style);
    fill(file,
         {"",
          "file.save",
          "file.saveAs",
          "file.embed",
          "",
          "file.export",
          "file.screenshot",
          "",
          "file.quit"});
    fill(menuBar()->addMenu(tr("&Edit")),
         {"edit.undo", "edit.redo", "", "edit.paste", "edit.resetExemplar", "", "edit.shortcuts"});
    QMenu* view = menuBar()->addMenu(tr("&View"));
    fill(view,
         {"view.single",
          "view.sideBySide",
          "view.quad",
          "view.wipe",
          "",
          "view.fit",
          "view.zoomIn",
          "view.zoomOut",
          "view.zoom100",
          "view.zoom200",
          "",
          "view.gaussian",
          "view.tiled",
          "",
          "view.brighter",
          "view.darker",
          "view.exposureReset"});
    fill(view->addMenu(tr("&Channels")),
         {"view.channelAll", "view.channel1", "view.channel2", "view.channel3"});
    fill(view->addMenu(tr("S&urround")),
         {"view.surroundGrey", "view.surroundBlack", "view.surroundWhite"});
    fill(menuBar()->addMenu(tr("&Texton")),
         {"texton.compute",
          "texton.cancel",
          "texton.newSeed",
          "",
          "texton.keep",
          "texton.showKept",
          "texton.keptBeside",
          "",
          "texton.adsn",
          "texton.rpn"});
    fill(menuBar()->addMenu(tr("&Noise")),
         {"noise.flat", "noise.ground", "noise.mesh", "noise.surface", "", "noise.lighting"});
    QMenu* mix = menuBar()->addMenu(tr("&Mix"));
    mix->setObjectName(QStringLiteral("mixMenu"));
    fill(mix,
         {"mix.open",
          "mix.swap",
          "mix.remove",
          "",
          "mix.look",
          "mix.brush",
          "mix.smooth",
          "mix.erase",
          "mix.gradient",
          "mix.round",
          "",
          "mix.larger",
          "mix.smaller",
          "",
          "mix.fill",
          "mix.strips",
          "mix.stripsDown",
          "mix.passage",
          "mix.invert",
          "mix.repeat",
          "mix.show",
          "",
          "mix.import",
          "mix.export"});
    QMenu* window = menuBar()->addMenu(tr("&Window"));
    for (const char* id : kDockOrder)
        window->addAction(m_docks.at(QLatin1String(id))->toggleViewAction());
    fill(window, {"", "window.hideDocks", "window.next", "window.reset", "window.fullScreen", ""});
    fill(window->addMenu(tr("&Theme")),
         {"window.themeDark", "window.themeLight", "window.themeSystem"});
    QMenu* languages = window->addMenu(tr("&Language"));
    for (const QString& code : availableLanguages())
        languages->addAction(m_actions->find(QStringLiteral("window.language.") + code));
    fill(menuBar()->addMenu(tr("&Help")),
         {"help.palette", "help.keys", "help.whatsThis", "", "help.about"});

    auto* corner = new QToolBar;
    corner->setObjectName(QStringLiteral("layoutBar"));
    corner->setIconSize({16, 16});
    for (const char* id : {"view.single", "view.sideBySide", "view.quad", "view.wipe"})
        corner->addAction(m_actions->find(QLatin1String(id)));
    menuBar()->setCornerWidget(corner);
    fillRecentMenu();
    // Thumbnails take a moment to make; nobody needs them before the menu opens.
    connect(m_sampleMenu, &QMenu::aboutToShow, this, &MainWindow::fillSampleMenu);
}

void MainWindow::fillRecentMenu() {
    m_recentMenu->clear();
    for (const QString& path : m_settings.recentFiles()) {
        QAction* each = m_recentMenu->addAction(QFileInfo(path).fileName());
        each->setToolTip(path);
        connect(each, &QAction::triggered, this, [this, path] { m_files->open(path); });
    }
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
    m_recentMenu->setToolTipsVisible(true);
    if (m_recentMenu->isEmpty())
        return;
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("Clear this list")), &QAction::triggered, this, [this] {
        m_settings.clearRecentFiles();
        fillRecentMenu();
    });
}

void MainWindow::fillSampleMenu() {
    if (!m_sampleMenu->isEmpty())
        return;
    constexpr Size kThumbnail{2 * ThumbnailStyle::kSide, 2 * ThumbnailStyle::kSide};
    for (const SampleInfo& sample : sampleCatalog()) {
        const QString name =
            QString::fromUtf8(sample.name.data(), static_cast<qsizetype>(sample.name.size()));
        QAction* each = m_sampleMenu->addAction(sampleTitle(name));
        if (const auto image = makeSample(sample.name, kThumbnail, Seed{1}))
            each->setIcon(QPixmap::fromImage(toQImage(*image)));
        connect(each, &QAction::triggered, this, [this, name] { m_files->openSample(name); });
    }
}

} // namespace txn::app
