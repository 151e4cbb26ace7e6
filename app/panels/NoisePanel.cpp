// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/NoisePanel.h"

#include "app/look/Theme.h"
#include "app/settings/Settings.h"
#include "app/widgets/ChoiceRow.h"
#include "app/widgets/SeedField.h"
#include "app/widgets/ValueSlider.h"
#include "core/noise/NoiseGrid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

namespace txn::app {
namespace {

const std::array kMeshes{
    QStringLiteral("sphere"), QStringLiteral("torus"), QStringLiteral("plane")};
constexpr int kMeshFile = 3; ///< the fourth choice

} // namespace

NoisePanel::NoisePanel(ProjectDocument& document, Settings& settings, QWidget* parent)
    : QWidget(parent), m_document(document), m_settings(settings) {
    setObjectName(QStringLiteral("noisePanel"));
    build();
    connect(&m_document, &ProjectDocument::projectChanged, this, &NoisePanel::showSettings);
    showSettings();
    showFrame({});
}

void NoisePanel::change(const QString& text,
                        const std::function<void(NoiseSettings&)>& edit,
                        Gesture gesture) {
    m_document.change(
        text,
        [&](Project& project) { edit(project.noise); },
        gesture);
}

void NoisePanel::build() {
    m_impacts = new ValueSlider(tr("Impacts per pixel"),
                                {1.0,
                                 100.0,
                                 defaultMeanImpacts(NoiseProcess::Stratified),
                                 1,
                                 ValueSlider::Scale::Logarithmic,
                                 {4.0, 12.0, 30.0},
                                 {},
                                 NoiseParams::kMinMeanImpacts,
                                 NoiseParams::kMaxMeanImpacts});
    m_impacts->setObjectName(QStringLiteral("noiseImpacts"));
    m_impacts->setToolTip(
        tr("How many textons overlap at a pixel, on average (the MNI). Fewer is faster; "
           "too few show single textons. Try 12."));
    connect(m_impacts, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Impacts per pixel"),
            [&](NoiseSettings& noise) { noise.meanImpacts = value; },
            gesture);
    });

    m_process = new ChoiceRow(tr("Placing"), {tr("Even"), tr("Random, both signs"), tr("Random")});
    m_process->setObjectName(QStringLiteral("noiseProcess"));
    m_process->setToolTip(
        tr("How textons are scattered. Even (stratified) needs the fewest; random "
           "(Poisson) is the papers' way and needs about 30 impacts."));
    connect(m_process, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Placing"), [&](NoiseSettings& noise) {
            // A number that was left at its default goes with the process.
            const bool standard = noise.meanImpacts == defaultMeanImpacts(noise.process);
            noise.process = static_cast<NoiseProcess>(index);
            if (standard)
                noise.meanImpacts = defaultMeanImpacts(noise.process);
        });
    });

    m_seed = new SeedField(tr("Seed"), SeedField::Lock::None);
    m_seed->setObjectName(QStringLiteral("noiseSeed"));
    m_seed->setToolTip(tr("Another number gives another piece of the same material."));
    connect(m_seed, &SeedField::seedEdited, this, [this](quint32 seed, Gesture gesture) {
        change(
            tr("Noise seed"),
            [&](NoiseSettings& noise) { noise.seed = Seed{seed}; },
            gesture);
    });

    m_scene =
        new ChoiceRow(tr("View"),
                      {tr("Flat"), tr("Ground"), tr("Mesh, by its UVs"), tr("Mesh, any surface")});
    m_scene->setObjectName(QStringLiteral("noiseScene"));
    m_scene->setToolTip(
        tr("What the noise is shown on. Drag in the view to look around. Any surface "
           "needs no texture coordinates."));
    connect(m_scene, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Noise view"),
               [&](NoiseSettings& noise) { noise.scene = static_cast<NoiseScene>(index); });
    });

    m_mesh =
        new ChoiceRow(tr("Mesh"), {tr("Sphere"), tr("Torus"), tr("Plane"), tr("From a file...")});
    m_mesh->setObjectName(QStringLiteral("noiseMesh"));
    m_mesh->setToolTip(tr("The object that wears the noise. OBJ and PLY files can be opened."));
    connect(m_mesh, &ChoiceRow::chosen, this, &NoisePanel::chooseMesh);

    m_lighting = new QCheckBox(tr("Lighting"));
    m_lighting->setObjectName(QStringLiteral("noiseLighting"));
    m_lighting->setToolTip(tr("Shades the mesh. Switch it off to judge colors."));
    connect(m_lighting, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Lighting"), [&](NoiseSettings& noise) { noise.lighting = on; });
    });

    m_filter =
        new ChoiceRow(tr("Filter"),
                      {tr("None"), tr("Isotropic"), tr("Anisotropic"), tr("Of the graphics card")});
    m_filter->setObjectName(QStringLiteral("noiseFilter"));
    m_filter->setToolTip(tr("Keeps distant noise from flickering. Anisotropic is the sharpest at a "
                            "slant."));
    connect(m_filter, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Filter"),
               [&](NoiseSettings& noise) { noise.filter = static_cast<Filter>(index); });
    });

    m_scale = new ValueSlider(tr("Scale"),
                              {0.25,
                               4.0,
                               1.0,
                               2,
                               ValueSlider::Scale::Logarithmic,
                               {0.25, 0.5, 1.0, 2.0, 4.0},
                               QStringLiteral("\u00d7"),
                               NoiseGrid::kMinScale,
                               NoiseGrid::kMaxScale});
    m_scale->setObjectName(QStringLiteral("noiseScale"));
    m_scale->setToolTip(tr("How large the grain is, next to that of the photo."));
    connect(m_scale, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Scale"),
            [&](NoiseSettings& noise) { noise.scale = value; },
            gesture);
    });

    m_contrast =
        new ValueSlider(tr("Contrast"),
                        {0.0, 2.0, 1.0, 2, ValueSlider::Scale::Linear, {1.0}, {}, 0.0, 10.0});
    m_contrast->setObjectName(QStringLiteral("noiseContrast"));
    m_contrast->setToolTip(tr("Strengthens or softens the grain. Less of it clips fewer colors."));
    connect(m_contrast, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Contrast"),
            [&](NoiseSettings& noise) { noise.contrast = value; },
            gesture);
    });

    m_brightness =
        new ValueSlider(tr("Brightness"),
                        {-0.5, 0.5, 0.0, 2, ValueSlider::Scale::Linear, {0.0}, {}, -10.0, 10.0});
    m_brightness->setObjectName(QStringLiteral("noiseBrightness"));
    m_brightness->setToolTip(tr("Makes the whole material lighter or darker."));
    connect(m_brightness, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Brightness"),
            [&](NoiseSettings& noise) { noise.brightness = value; },
            gesture);
    });

    m_speed = new QLabel;
    m_speed->setObjectName(QStringLiteral("noiseSpeed"));
    m_speed->setProperty("role", QStringLiteral("secondary"));
    m_speed->setToolTip(
        tr("What the picture costs: the time to draw one, and how often the texton is "
           "looked up for each pixel."));
    m_clipped = new QLabel;
    m_clipped->setObjectName(QStringLiteral("noiseClipped"));
    m_clipped->setToolTip(
        tr("Values that are darker than black or lighter than white. Lower the contrast, "
           "or export EXR, which keeps them."));
    m_screenshot = new QPushButton(themeIcon(QStringLiteral("camera")), tr("Save picture..."));
    m_screenshot->setObjectName(QStringLiteral("noiseScreenshot"));
    m_screenshot->setToolTip(tr("Saves what the noise view shows as a PNG file."));
    connect(m_screenshot, &QPushButton::clicked, this, &NoisePanel::screenshotRequested);

    buildMaterial();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    for (QWidget* row : std::initializer_list<QWidget*>{m_impacts, m_process, m_seed})
        column->addWidget(row);
    column->addSpacing(8);
    for (QWidget* row : std::initializer_list<QWidget*>{m_map,
                                                        m_lightAngle,
                                                        m_lightHeight,
                                                        m_scene,
                                                        m_mesh,
                                                        m_lighting,
                                                        m_filter,
                                                        m_scale})
        column->addWidget(row);
    column->addSpacing(8);
    for (QWidget* row : std::initializer_list<QWidget*>{m_contrast, m_brightness, m_clipped})
        column->addWidget(row);
    column->addSpacing(8);
    column->addWidget(m_speed);
    column->addWidget(m_screenshot);
    column->addStretch();
}

void NoisePanel::buildMaterial() {
    m_map = new ChoiceRow(tr("Show"), {tr("Material")});
    m_map->setObjectName(QStringLiteral("noiseMap"));
    m_map->setToolTip(tr("All maps of the material together under a light, or one of them."));
    connect(m_map, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Shown map"), [&](NoiseSettings& noise) {
            noise.map = index == 0 ? QString() : m_map->box().itemText(index);
        });
    });
    constexpr double kDegree = std::numbers::pi / 180.0;
    m_lightAngle = new ValueSlider(tr("Light from"),
                                   {0.0,
                                    360.0,
                                    135.0,
                                    0,
                                    ValueSlider::Scale::Linear,
                                    {0.0, 90.0, 180.0, 270.0, 360.0},
                                    QStringLiteral("\u00b0"),
                                    0.0,
                                    360.0});
    m_lightAngle->setObjectName(QStringLiteral("noiseLightAngle"));
    m_lightAngle->setToolTip(tr("Where the light comes from: 0 is the right, 90 the top. Or drag "
                                "with the right button in the view."));
    connect(m_lightAngle, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Light"),
            [&](NoiseSettings& noise) { noise.light.azimuth = kDegree * value; },
            gesture);
    });
    m_lightHeight = new ValueSlider(tr("Light height"),
                                    {0.0,
                                     90.0,
                                     45.0,
                                     0,
                                     ValueSlider::Scale::Linear,
                                     {45.0},
                                     QStringLiteral("\u00b0"),
                                     0.0,
                                     90.0});
    m_lightHeight->setObjectName(QStringLiteral("noiseLightHeight"));
    m_lightHeight->setToolTip(
        tr("How high the light stands. Low light shows the relief, high light the colors."));
    connect(m_lightHeight, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Light height"),
            [&](NoiseSettings& noise) { noise.light.elevation = kDegree * value; },
            gesture);
    });
}

void NoisePanel::showMaterial() {
    const Project& project = m_document.project();
    const MaterialMaps maps = mapsOf(project);
    while (m_map->box().count() > 1)
        m_map->box().removeItem(1);
    int current = 0;
    for (const MaterialMap& map : maps) {
        const QString name = QString::fromStdString(map.name);
        m_map->box().addItem(name);
        if (name == project.noise.map)
            current = m_map->box().count() - 1;
    }
    m_map->setCurrent(current);
    m_map->setVisible(!maps.empty());
    const bool lit = !maps.empty() && current == 0;
    m_lightAngle->setVisible(lit);
    m_lightHeight->setVisible(lit);
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const double angle = std::fmod(kDegrees * project.noise.light.azimuth + 720.0, 360.0);
    m_lightAngle->setValue(angle);
    m_lightHeight->setValue(kDegrees * project.noise.light.elevation);
}

void NoisePanel::chooseMesh(int index) {
    if (index < kMeshFile) {
        change(tr("Mesh"), [&](NoiseSettings& noise) {
            noise.mesh = kMeshes[static_cast<std::size_t>(index)];
        });
        return;
    }
    const QString folder = m_settings.folder(QStringLiteral("meshes"));
    auto* dialog =
        new QFileDialog(this, tr("Open a mesh"), folder, tr("Meshes (*.obj *.ply);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_settings.setFolder(QStringLiteral("meshes"), QFileInfo(path).absolutePath());
        change(tr("Mesh"),
               [&](NoiseSettings& noise) { noise.mesh = QFileInfo(path).absoluteFilePath(); });
    });
    connect(dialog, &QFileDialog::rejected, this, &NoisePanel::showSettings);
    dialog->open();
}

void NoisePanel::showSettings() {
    const NoiseSettings& noise = m_document.project().noise;
    m_impacts->setValue(noise.meanImpacts);
    m_process->setCurrent(static_cast<int>(noise.process));
    m_seed->setSeed(noise.seed.value);
    m_scene->setCurrent(static_cast<int>(noise.scene));
    const auto known = std::find(kMeshes.begin(), kMeshes.end(), noise.mesh);
    m_mesh->box().setItemText(kMeshFile,
                              known == kMeshes.end() ? QFileInfo(noise.mesh).fileName()
                                                     : tr("From a file..."));
    m_mesh->setCurrent(static_cast<int>(known - kMeshes.begin()));
    const bool onMesh = noise.scene == NoiseScene::Mesh || noise.scene == NoiseScene::Surface;
    m_mesh->setVisible(onMesh);
    const bool material = !mapsOf(m_document.project()).empty() && noise.map.isEmpty();
    m_lighting->setVisible(onMesh && !material);
    m_lighting->setChecked(noise.lighting);
    showMaterial();
    m_filter->setCurrent(static_cast<int>(noise.filter));
    m_scale->setValue(noise.scale);
    m_contrast->setValue(noise.contrast);
    m_brightness->setValue(noise.brightness);
}

void NoisePanel::showFrame(const NoiseFrame& frame) {
    const QLocale locale;
    if (frame.image.isNull()) {
        m_speed->setText(QStringLiteral(" "));
        m_clipped->setText(QStringLiteral(" "));
        m_screenshot->setEnabled(false);
        return;
    }
    m_screenshot->setEnabled(true);
    m_speed->setText(tr("%1 frames per second, %2 fetches per pixel")
                         .arg(locale.toString(1000.0 / std::max(frame.milliseconds, 0.1), 'f', 0),
                              locale.toString(frame.fetchesPerPixel, 'g', 3)));
    m_clipped->setText(tr("%1 % of the values are clipped")
                           .arg(locale.toString(100.0 * frame.clippedShare, 'f', 1)));
}

} // namespace txn::app
