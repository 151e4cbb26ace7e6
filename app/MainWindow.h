// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <array>
#include <functional>
#include <map>

class QDockWidget;
class QLabel;

namespace txn::app {

class ActionRegistry;
class ExportDialog;
class FileController;
class JobRunner;
class MapPainter;
class MessageBar;
class MixEditor;
class MixPanel;
class NoisePanel;
class NoiseService;
class PaintTools;
class Pipeline;
class ProjectDocument;
class Settings;
class ViewArea;
struct ProbeInfo;

/// Docks, menus and the status bar; what they do is done elsewhere.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    struct Parts {
        Settings& settings;
        ProjectDocument& document;
        JobRunner& runner;
        Pipeline& pipeline;
        NoiseService& noise;
    };
    explicit MainWindow(const Parts& parts);
    ~MainWindow() override;

    FileController& files() { return *m_files; }
    ActionRegistry& actions() { return *m_actions; }
    MessageBar& messages() { return *m_messages; }
    ViewArea& views() { return *m_views; }
    /// For whoever notices it outside of a job.
    void sayOutOfMemory();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// As in the window: what goes in, what can be tuned, what is looked at.
    static constexpr std::array kDockOrder{"exemplarDock",
                                           "textonDock",
                                           "noiseDock",
                                           "spectrumDock",
                                           "histogramDock",
                                           "mixDock",
                                           "historyDock",
                                           "jobsDock"};

    void createDocks();
    void createStatusBar();
    void createActions();
    void createFileActions();
    void createEditActions();
    void createViewActions();
    void createTextonActions();
    void createNoiseActions();
    void createMixActions();
    void createMapActions();
    void chooseMapToImport();
    void chooseMapToExport();
    void createWindowActions();
    void createHelpActions();
    void createMenus();
    void fillRecentMenu();
    void fillSampleMenu();
    QDockWidget* addDock(const QString& id,
                         const QString& title,
                         QWidget* content,
                         Qt::DockWidgetArea area,
                         bool scrolls);
    void arrangeDocks();
    void resetLayout();
    void toggleDocks();
    void newSeed();
    void chooseTheme(int theme);
    void chooseLanguage(const QString& language);
    void saveScreenshot();
    void openExport();
    void showProbe(const ProbeInfo& probe);
    void showTitle();
    void focusNextPart();
    void askAboutExport();
    QAction* action(const QString& id,
                    const QString& text,
                    const QString& toolTip,
                    const QString& shortcut,
                    const std::function<void()>& run);

    Settings& m_settings;
    ProjectDocument& m_document;
    JobRunner& m_runner;
    Pipeline& m_pipeline;
    NoiseService& m_noise;

    FileController* m_files;
    ActionRegistry* m_actions;
    MessageBar* m_messages;
    PaintTools* m_tools;
    MapPainter* m_painter;
    MixEditor* m_mix;
    ViewArea* m_views;
    MixPanel* m_mixPanel = nullptr;
    NoisePanel* m_noisePanel = nullptr;
    ExportDialog* m_export = nullptr;
    std::map<QString, QDockWidget*> m_docks;
    std::map<QDockWidget*, bool> m_hiddenDocks; ///< by toggleDocks(), and whether they were visible
    QMenu* m_recentMenu = nullptr;
    QMenu* m_sampleMenu = nullptr;
    QLabel* m_probe = nullptr;
    QLabel* m_zoom = nullptr;
    QLabel* m_error = nullptr;
    QLabel* m_renderer = nullptr;
    /// What has been asked about already on the way out.
    enum class Closing { No, NothingToSave, NothingToExport } m_closing = Closing::No;
};

} // namespace txn::app
