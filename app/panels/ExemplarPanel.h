// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QToolButton;

namespace txn::app {

class BeforeAfter;
class ChoiceRow;
class CropCanvas;
class Pipeline;
class ValueSlider;

/// What was opened, how it becomes the exemplar, and what can be expected of it.
class ExemplarPanel : public QWidget {
    Q_OBJECT

  public:
    ExemplarPanel(ProjectDocument& document, Pipeline& pipeline, QWidget* parent = nullptr);

  private:
    QWidget* buildTools();
    void build();
    void showSettings();
    void showExemplar();
    void showVerdict();
    void change(const QString& text,
                const std::function<void(ExemplarEdit&)>& edit,
                Gesture gesture = {});

    ProjectDocument& m_document;
    Pipeline& m_pipeline;

    CropCanvas* m_canvas = nullptr;
    QToolButton* m_cropTool = nullptr;
    QToolButton* m_straightenTool = nullptr;
    QToolButton* m_reset = nullptr;
    QLabel* m_facts = nullptr;
    QLabel* m_verdictIcon = nullptr;
    QLabel* m_verdict = nullptr;
    QLabel* m_reason = nullptr;
    ValueSlider* m_angle = nullptr;
    ChoiceRow* m_space = nullptr;
    QCheckBox* m_even = nullptr;
    ValueSlider* m_radius = nullptr;
    BeforeAfter* m_evenPreview = nullptr;
    QLabel* m_maps = nullptr;
    QCheckBox* m_flipGreen = nullptr;
    QCheckBox* m_periodic = nullptr;
    BeforeAfter* m_seamPreview = nullptr;
};

} // namespace txn::app
