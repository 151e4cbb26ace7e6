// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"

#include <QImage>
#include <QWidget>
#include <functional>
#include <optional>

class QCheckBox;
class QLabel;
class QMimeData;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace txn::app {

class ChoiceRow;
class FilmStrip;
class MaterialSlot;
class PaintTools;
class Pipeline;
class ValueSlider;

/// The two materials of a mixture, the textons between them, and the brush that mixes them.
class MixPanel : public QWidget {
    Q_OBJECT

  public:
    MixPanel(ProjectDocument& document,
             Pipeline& pipeline,
             PaintTools& tools,
             QWidget* parent = nullptr);
    /// What may be dropped onto A and B.
    void setAccepts(const std::function<bool(const QMimeData&)>& accepts);

  signals:
    void firstWanted();
    void secondWanted();
    void firstDropped(const QMimeData& data);
    void secondDropped(const QMimeData& data);
    void swapWanted();
    void removeWanted();

  private:
    QWidget* buildMaterials();
    QWidget* buildStrip();
    QWidget* buildTools();
    void showMaterials();
    void showFrames();
    std::optional<int> chosenFrame() const;
    void showTools();

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    PaintTools& m_tools;

    MaterialSlot* m_first = nullptr;
    MaterialSlot* m_second = nullptr;
    QToolButton* m_swap = nullptr;
    QToolButton* m_remove = nullptr;
    QLabel* m_words = nullptr;
    QScrollArea* m_scroll = nullptr;
    FilmStrip* m_strip = nullptr;
    ValueSlider* m_count = nullptr;
    QWidget* m_toolColumn = nullptr;
    ChoiceRow* m_tool = nullptr;
    ChoiceRow* m_symmetry = nullptr;
    ValueSlider* m_radius = nullptr;
    ValueSlider* m_hardness = nullptr;
    ValueSlider* m_strength = nullptr;
    ValueSlider* m_target = nullptr;
};

} // namespace txn::app
