// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/ExportPlan.h"
#include "app/export/ExportPresets.h"
#include "app/jobs/JobRunner.h"

#include <QDialog>
#include <QTimer>
#include <functional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace txn::app {

class Pipeline;
class ProjectDocument;
class Settings;

/// What to write, where, under which names; shows every file before it writes any.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    ExportDialog(ProjectDocument& document,
                 Pipeline& pipeline,
                 JobRunner& runner,
                 Settings& settings,
                 QWidget* parent = nullptr);

    /// Where the picture on screen comes from.
    void setCurrentView(std::function<QImage()> currentView) {
        m_currentView = std::move(currentView);
    }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildTextonPage();
    QWidget* buildNoisePage();
    QWidget* buildNotePage(const QString& text);
    void build();
    QSpinBox* sizeField(const QString& name, const QString& label);
    void showPlan();
    void readPlan();
    void showFiles();
    void showProgress();
    void loadPresets(const QString& current);
    void savePreset();
    void choosePreset(int index);
    void deletePreset();
    QString obstacle(const ExportSnapshot& shot) const;
    void chooseFolder();
    void start();
    void run(const ExportPlan& plan, const ExportSnapshot& snapshot);
    ExportSnapshot snapshot() const;
    /// Null where there are not two materials, or not yet.
    std::shared_ptr<const MixtureAsset> mixture(Seed seed) const;

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    JobRunner& m_runner;
    Settings& m_settings;
    ExportPresets m_presets;
    std::function<QImage()> m_currentView;
    ExportPlan m_plan;
    QTimer m_poll;
    bool m_reading = false;

    QListWidget* m_kinds = nullptr;
    QStackedWidget* m_pages = nullptr;
    QComboBox* m_presetChoice = nullptr;
    QPushButton* m_deletePreset = nullptr;
    QCheckBox* m_exr = nullptr;
    QCheckBox* m_png = nullptr;
    QCheckBox* m_textonFile = nullptr;
    bool m_hasFiles = false; ///< that would be written
    QFormLayout* m_noiseForm = nullptr;
    QComboBox* m_sizes = nullptr;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QCheckBox* m_tileable = nullptr;
    QSpinBox* m_originX = nullptr;
    QSpinBox* m_originY = nullptr;
    QComboBox* m_format = nullptr;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_folder = nullptr;
    QLabel* m_files = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_result = nullptr;
    QPushButton* m_openFolder = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_cancel = nullptr;
};

} // namespace txn::app
