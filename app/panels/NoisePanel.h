// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/views/NoiseFrame.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace txn::app {

class ChoiceRow;
class SeedField;
class Settings;
class ValueSlider;

/// What the noise is like and on what it is seen. Nothing here computes the texton anew.
class NoisePanel : public QWidget {
    Q_OBJECT

  public:
    NoisePanel(ProjectDocument& document, Settings& settings, QWidget* parent = nullptr);

    /// The newest frame, for what is told about it.
    void showFrame(const NoiseFrame& frame);

  signals:
    void screenshotRequested();

  private:
    void build();
    void buildMaterial();
    void showMaterial();
    void showSettings();
    void chooseMesh(int index);
    void change(const QString& text,
                const std::function<void(NoiseSettings&)>& edit,
                Gesture gesture = {});

    ProjectDocument& m_document;
    Settings& m_settings;

    ValueSlider* m_impacts = nullptr;
    ChoiceRow* m_process = nullptr;
    SeedField* m_seed = nullptr;
    ChoiceRow* m_scene = nullptr;
    ChoiceRow* m_mesh = nullptr;
    QCheckBox* m_lighting = nullptr;
    ChoiceRow* m_map = nullptr;
    ValueSlider* m_lightAngle = nullptr;
    ValueSlider* m_lightHeight = nullptr;
    ChoiceRow* m_filter = nullptr;
    ValueSlider* m_scale = nullptr;
    ValueSlider* m_contrast = nullptr;
    ValueSlider* m_brightness = nullptr;
    QLabel* m_speed = nullptr;
    QLabel* m_clipped = nullptr;
    QPushButton* m_screenshot = nullptr;
};

} // namespace txn::app
