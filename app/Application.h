// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/jobs/JobRunner.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "app/views/NoiseService.h"

#include <QStringList>
#include <memory>

namespace txn::app {

class Autosave;
class MainWindow;
struct RecoveredProject;

/// Owns everything that lives as long as the program, in the order in which it may be destroyed.
class Application {
  public:
    /// recoveryFolder: where copies of unsaved work go.
    Application(Settings& settings, const QString& recoveryFolder);
    ~Application();

    /// Opens the files, or else offers what a crash left behind, or else shows a sample.
    void start(const QStringList& files);

    MainWindow& window() { return *m_window; }
    ProjectDocument& document() { return m_document; }
    Pipeline& pipeline() { return m_pipeline; }
    JobRunner& runner() { return m_runner; }
    NoiseService& noise() { return m_noise; }

    /// Where copies of unsaved work go by default.
    static QString standardRecoveryFolder();

  private:
    void offerRecovery(std::vector<RecoveredProject> copies);
    void recover(const RecoveredProject& copy);

    Settings& m_settings;
    QString m_recoveryFolder;
    ProjectDocument m_document;
    JobRunner m_runner;
    Pipeline m_pipeline;
    NoiseService m_noise;
    std::unique_ptr<Autosave> m_autosave;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace txn::app
