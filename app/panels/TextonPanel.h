// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/jobs/JobRunner.h"

#include <QTimer>
#include <QWidget>
#include <vector>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace txn::app {

class ChoiceRow;
class ErrorPlot;
class Pipeline;
class SeedField;
class ValueSlider;

/// How the texton is computed, how far it is, and how good it has become.
class TextonPanel : public QWidget {
    Q_OBJECT

  public:
    TextonPanel(ProjectDocument& document,
                Pipeline& pipeline,
                JobRunner& runner,
                QWidget* parent = nullptr);

  private:
    void build();
    QWidget* buildResult();
    void buildMethod();
    std::vector<QWidget*> rows() const;
    void showSuggestion();
    void showSettings();
    void showResult();
    void showProgress();
    void change(const QString& text,
                const std::function<void(TextonSettings&)>& edit,
                Gesture gesture = {});

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    JobRunner& m_runner;
    QTimer m_poll; ///< the progress of a running job

    QLabel* m_verdict = nullptr;
    QLabel* m_numbers = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_remaining = nullptr;
    QPushButton* m_cancel = nullptr;
    QPushButton* m_suggest = nullptr;
    ChoiceRow* m_method = nullptr;
    ChoiceRow* m_kernels = nullptr;
    QLabel* m_trials = nullptr;
    ChoiceRow* m_shape = nullptr;
    ValueSlider* m_width = nullptr;
    ValueSlider* m_height = nullptr;
    ChoiceRow* m_order = nullptr;
    ValueSlider* m_iterations = nullptr;
    ValueSlider* m_momentum = nullptr;
    SeedField* m_seed = nullptr;
    QCheckBox* m_colors = nullptr;
    ErrorPlot* m_plot = nullptr;
};

} // namespace txn::app
