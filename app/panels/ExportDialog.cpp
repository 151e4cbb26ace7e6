// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/ExportDialog.h"

#include "app/export/ExportJob.h"
#include "app/look/Words.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "app/widgets/WhatsThis.h"
#include "core/noise/MixedProcess.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>
#include <array>
#include <cmath>

namespace txn::app {
namespace {

constexpr std::array kSizes{512, 1024, 2048, 4096, 8192, 16384};
constexpr int kFarthestOrigin = 40'000'000;
constexpr int kExportPollMs = 100;
constexpr qsizetype kMostLines = 5;
const QString kFolder = QStringLiteral("export");

} // namespace

ExportDialog::ExportDialog(ProjectDocument& document,
                           Pipeline& pipeline,
                           JobRunner& runner,
                           Settings& settings,
                           QWidget* parent)
    : QDialog(parent), m_document(document), m_pipeline(pipeline), m_runner(runner),
      m_settings(settings), m_presets(settings) {
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    m_plan.folder = m_settings.folder(kFolder);
    if (m_plan.folder.isEmpty())
        m_plan.folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    if (m_plan.folder.isEmpty())
        m_plan.folder = QDir::homePath();
    build();
    loadPresets({});
    showPlan();
    m_poll.setInterval(kExportPollMs);
    connect(&m_poll, &QTimer::timeout, this, &ExportDialog::showProgress);
    connect(&m_runner, &JobRunner::jobsChanged, this, &ExportDialog::showProgress);
    connect(&m_pipeline, &Pipeline::noiseTextonChanged, this, &ExportDialog::showFiles);
    connect(&m_pipeline, &Pipeline::mixtureChanged, this, &ExportDialog::showFiles);
    connect(&m_pipeline, &Pipeline::mixChanged, this, &ExportDialog::showFiles);
    connect(&m_document, &ProjectDocument::projectChanged, this, &ExportDialog::showFiles);
    showProgress();
}

QSpinBox* ExportDialog::sizeField(const QString& name, const QString& label) {
    auto* field = new QSpinBox;
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setRange(1, ExportPlan::kMaxSidePx);
    field->setSuffix(tr(" px"));
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    connect(field, &QSpinBox::valueChanged, this, &ExportDialog::readPlan);
    return field;
}

QWidget* ExportDialog::buildTextonPage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const QString& name, const QString& text, const QString& tip) {
        auto* box = new QCheckBox(text);
        box->setObjectName(name);
        box->setToolTip(tip);
        column->addWidget(box);
        connect(box, &QCheckBox::clicked, this, &ExportDialog::readPlan);
        return box;
    };
    m_exr = add(QStringLiteral("exportExr"),
                tr("EXR, exact"),
                tr("Every value as it is, with all parameters inside. The best choice."));
    m_png = add(QStringLiteral("exportPng"),
                tr("PNG, 16 bit"),
                tr("For programs that cannot read EXR. The JSON file tells how values are coded."));
    m_textonFile = add(QStringLiteral("exportTexton"),
                       tr(".texton, as text"),
                       tr("The format of the papers' authors, for their programs."));
    column->addStretch();
    return page;
}

QWidget* ExportDialog::buildNoisePage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    m_noiseForm = form;
    form->setContentsMargins(0, 0, 0, 0);
    m_sizes = new QComboBox;
    m_sizes->setObjectName(QStringLiteral("exportSizes"));
    m_sizes->setAccessibleName(tr("Size"));
    m_sizes->setToolTip(tr("Common sizes; any other can be typed below."));
    for (const int side : kSizes)
        m_sizes->addItem(tr("%1 x %1").arg(side), side);
    m_sizes->addItem(tr("Other"), 0);
    connect(m_sizes, &QComboBox::activated, this, [this](int index) {
        const int side = m_sizes->itemData(index).toInt();
        if (side > 0) {
            m_plan.size = {side, side};
            showPlan();
        }
    });
    m_width = sizeField(QStringLiteral("exportWidth"), tr("Width"));
    m_height = sizeField(QStringLiteral("exportHeight"), tr("Height"));
    for (QSpinBox* field : {m_width, m_height})
        field->setToolTip(tr("Pixels of the picture. Large ones are written piece by piece."));
    m_tileable = new QCheckBox(tr("Tiles without a seam"));
    m_tileable->setObjectName(QStringLiteral("exportTileable"));
    m_tileable->setToolTip(
        tr("The picture repeats without a seam. Off, it is a piece of the endless plane."));
    connect(m_tileable, &QCheckBox::clicked, this, &ExportDialog::readPlan);
    m_originX = sizeField(QStringLiteral("exportX"), tr("From the left"));
    m_originY = sizeField(QStringLiteral("exportY"), tr("From the top"));
    for (QSpinBox* field : {m_originX, m_originY}) {
        field->setRange(-kFarthestOrigin, kFarthestOrigin);
        field->setToolTip(tr("Where on the endless plane the piece is cut out."));
    }
    m_format = new QComboBox;
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_format->setAccessibleName(tr("Format"));
    m_format->setToolTip(
        tr("EXR keeps values beyond black and white; PNG and TIFF with 8 or 16 bits clip them."));
    for (const ExportFormat& each : kExportFormats)
        m_format->addItem(tr(each.name));
    connect(m_format, &QComboBox::activated, this, &ExportDialog::readPlan);
    form->addRow(tr("Size"), m_sizes);
    form->addRow(tr("Width"), m_width);
    form->addRow(tr("Height"), m_height);
    form->addRow(QString(), m_tileable);
    form->addRow(tr("From the left"), m_originX);
    form->addRow(tr("From the top"), m_originY);
    form->addRow(tr("Format"), m_format);
    return page;
}

QWidget* ExportDialog::buildNotePage(const QString& text) {
    auto* note = new QLabel(text);
    note->setWordWrap(true);
    note->setAlignment(Qt::AlignTop);
    note->setProperty("role", QStringLiteral("secondary"));
    return note;
}

void ExportDialog::build() {
    m_kinds = new QListWidget;
    m_kinds->setObjectName(QStringLiteral("exportKinds"));
    m_kinds->setAccessibleName(tr("What to export"));
    m_kinds->setFixedWidth(152);
    m_kinds->setToolTip(tr("What to write."));
    m_kinds->ensurePolished(); // the rows are measured by the style
    m_kinds->addItems(
        {tr("Texton"), tr("Noise texture"), tr("Current view"), tr("For engines"), tr("Mixture")});
    m_pages = new QStackedWidget;
    m_pages->addWidget(buildTextonPage());
    m_pages->addWidget(buildNoisePage());
    m_pages->addWidget(buildNotePage(tr("The noise as it is on screen, as a PNG picture.")));
    m_pages->addWidget(buildNotePage(
        tr("Everything to draw endless material in your own program: the texton, one "
           "self-contained shader "
           "(GLSL 330, free to use under CC0), its parameters, and a small example program.")));
    m_pages->addWidget(buildNotePage(
        tr("All textons from A to B in a folder of their own: one EXR with a layer for each, the "
           "same as single files, a description, and the map as a gray picture. A noise texture of "
           "the mixture begins at the corner of the map; to tile, the map has to repeat.")));
    connect(m_kinds, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row < 0 || m_reading)
            return;
        m_plan.kind = static_cast<ExportKind>(row);
        showPlan();
    });

    m_presetChoice = new QComboBox;
    m_presetChoice->setObjectName(QStringLiteral("exportPresets"));
    m_presetChoice->setAccessibleName(tr("Preset"));
    m_presetChoice->setToolTip(tr("Choices that you saved under a name."));
    auto* save = new QPushButton(tr("Save as preset..."));
    save->setObjectName(QStringLiteral("exportSavePreset"));
    connect(m_presetChoice, &QComboBox::activated, this, &ExportDialog::choosePreset);
    connect(save, &QPushButton::clicked, this, &ExportDialog::savePreset);
    m_deletePreset = new QPushButton(tr("Delete"));
    m_deletePreset->setObjectName(QStringLiteral("exportDeletePreset"));
    m_deletePreset->setToolTip(tr("Forgets the chosen preset."));
    save->setToolTip(tr("Remembers these choices under a name."));
    connect(m_deletePreset, &QPushButton::clicked, this, &ExportDialog::deletePreset);
    auto* presets = new QHBoxLayout;
    presets->addWidget(m_presetChoice, 1);
    presets->addWidget(save);
    presets->addWidget(m_deletePreset);

    m_name = new QLineEdit;
    m_name->setObjectName(QStringLiteral("exportName"));
    m_name->setAccessibleName(tr("Name"));
    m_name->setToolTip(tr("Words in braces are filled in: {name} {support} {mni} {seed} {size}."));
    connect(m_name, &QLineEdit::textEdited, this, &ExportDialog::readPlan);
    m_folder = new QLineEdit;
    m_folder->setObjectName(QStringLiteral("exportFolder"));
    m_folder->setAccessibleName(tr("Folder"));
    m_folder->setToolTip(tr("Where the files go."));
    connect(m_folder, &QLineEdit::textEdited, this, &ExportDialog::readPlan);
    auto* browse = new QPushButton(tr("Choose..."));
    browse->setToolTip(tr("Choose another folder."));
    browse->setObjectName(QStringLiteral("exportBrowse"));
    connect(browse, &QPushButton::clicked, this, &ExportDialog::chooseFolder);
    auto* folder = new QHBoxLayout;
    folder->addWidget(m_folder, 1);
    folder->addWidget(browse);
    m_files = new QLabel;
    m_files->setObjectName(QStringLiteral("exportFiles"));
    m_files->setTextFormat(Qt::PlainText);
    m_files->setProperty("role", QStringLiteral("secondary"));
    m_files->setMinimumHeight(5 * fontMetrics().lineSpacing());
    m_files->setAlignment(Qt::AlignTop);
    auto* where = new QFormLayout;
    where->addRow(tr("Preset"), presets);
    where->addRow(tr("Name"), m_name);
    where->addRow(tr("Folder"), folder);
    where->addRow(tr("Files"), m_files);

    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("exportProgress"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(4);
    m_progress->setAccessibleName(tr("Progress"));
    QSizePolicy kept = m_progress->sizePolicy(); // nothing jumps when the work begins
    kept.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(kept);
    m_result = new QLabel;
    m_result->setObjectName(QStringLiteral("exportResult"));
    m_result->setWordWrap(true);
    m_openFolder = new QPushButton(tr("Open folder"));
    m_openFolder->setObjectName(QStringLiteral("exportOpenFolder"));
    m_openFolder->setToolTip(tr("Shows where the files are."));
    m_openFolder->hide();
    connect(m_openFolder, &QPushButton::clicked, this, [this] {
        QDesktopServices::openUrl(QUrl::fromLocalFile(m_plan.folder));
    });
    m_export = new QPushButton(tr("Export"));
    m_export->setObjectName(QStringLiteral("exportStart"));
    m_export->setDefault(true);
    m_export->setToolTip(tr("Writes the files that are listed."));
    m_cancel = new QPushButton;
    m_cancel->setObjectName(QStringLiteral("exportCancel"));
    m_cancel->setToolTip(tr("Stops the work, or else closes this window."));
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (!m_runner.isBusy(JobKind::Export)) {
            close();
            return;
        }
        m_runner.cancel(JobKind::Export);
        m_result->setText(tr("Cancelled."));
    });
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_result, 1);
    buttons->addWidget(m_openFolder);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_export);

    auto* top = new QHBoxLayout;
    top->setSpacing(16);
    top->addWidget(m_kinds);
    top->addWidget(m_pages, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addLayout(top, 1);
    column->addLayout(where);
    column->addWidget(m_progress);
    column->addLayout(buttons);
    explainByToolTips(*this);
    resize(640, 580);
}

void ExportDialog::showPlan() {
    m_reading = true;
    m_kinds->setCurrentRow(static_cast<int>(m_plan.kind));
    m_pages->setCurrentIndex(static_cast<int>(m_plan.kind));
    m_exr->setChecked(m_plan.textonExr);
    m_png->setChecked(m_plan.textonPng);
    m_textonFile->setChecked(m_plan.textonFile);
    m_width->setValue(m_plan.size.width);
    m_height->setValue(m_plan.size.height);
    const int preset =
        m_plan.size.width == m_plan.size.height ? m_sizes->findData(m_plan.size.width) : -1;
    m_sizes->setCurrentIndex(preset >= 0 ? preset : m_sizes->count() - 1);
    m_tileable->setChecked(m_plan.tileable);
    m_originX->setValue(static_cast<int>(m_plan.originX));
    m_originY->setValue(static_cast<int>(m_plan.originY));
    for (QSpinBox* field : {m_originX, m_originY})
        m_noiseForm->setRowVisible(field, !m_plan.tileable);
    for (std::size_t i = 0; i < kExportFormats.size(); ++i) {
        if (kExportFormats[i].format == m_plan.format && kExportFormats[i].depth == m_plan.depth)
            m_format->setCurrentIndex(static_cast<int>(i));
    }
    if (m_name->text() != m_plan.nameTemplate)
        m_name->setText(m_plan.nameTemplate);
    m_name->setPlaceholderText(standardTemplate(m_plan));
    if (m_folder->text() != m_plan.folder)
        m_folder->setText(m_plan.folder);
    m_reading = false;
    showFiles();
}

void ExportDialog::readPlan() {
    if (m_reading)
        return;
    m_plan.textonExr = m_exr->isChecked();
    m_plan.textonPng = m_png->isChecked();
    m_plan.textonFile = m_textonFile->isChecked();
    m_plan.size = {m_width->value(), m_height->value()};
    m_plan.tileable = m_tileable->isChecked();
    m_plan.originX = m_originX->value();
    m_plan.originY = m_originY->value();
    const auto format = static_cast<std::size_t>(std::max(0, m_format->currentIndex()));
    m_plan.format = kExportFormats[format].format;
    m_plan.depth = kExportFormats[format].depth;
    m_plan.nameTemplate = m_name->text();
    m_plan.folder = m_folder->text();
    showPlan();
}

ExportSnapshot ExportDialog::snapshot() const {
    const Project& project = m_document.project();
    ExportSnapshot shot;
    shot.noise = project.noise;
    if (project.importedTexton) {
        shot.asset = *project.importedTexton;
        shot.name = QFileInfo(QString::fromStdString(shot.asset.exemplarName)).completeBaseName();
    } else if (project.source) {
        shot.asset.exemplarName = project.source->name().toStdString();
        shot.asset.seed = project.texton.seed;
        shot.name = QFileInfo(project.source->name()).completeBaseName();
    }
    if (shot.name.isEmpty())
        shot.name = tr("material");
    shot.asset.process = project.noise.process;
    shot.asset.meanImpacts = project.noise.meanImpacts;
    if (const auto texton = m_pipeline.presentNoiseTexton(); texton && m_pipeline.texton()) {
        shot.asset.texton = *texton;
        shot.asset.maps = m_pipeline.texton()->maps;
    }
    shot.mixture = mixture(shot.asset.seed);
    return shot;
}

std::shared_ptr<const MixtureAsset> ExportDialog::mixture(Seed seed) const {
    const Project& project = m_document.project();
    const auto textons = m_pipeline.mixTextons();
    const auto mix = m_pipeline.mix();
    const auto map = m_pipeline.mixingMap();
    if (!project.mix.source || !textons || !map || !mix || m_pipeline.isMixStale())
        return nullptr;
    auto asset = std::make_shared<MixtureAsset>();
    asset->mixture = {*textons, *map};
    for (const MixedTexton& one : mix->mixed.textons) {
        asset->rhos.push_back(one.rho);
        asset->distances.push_back(one.distance);
    }
    asset->process = mixedProcess(project.noise.process);
    asset->meanImpacts = project.noise.meanImpacts;
    asset->seed = seed;
    asset->exemplarA = project.source->name().toStdString();
    asset->exemplarB = project.mix.source->name().toStdString();
    asset->maps = mix->maps;
    return asset;
}

/// Why what is planned cannot be written (yet); empty where it can.
QString ExportDialog::obstacle(const ExportSnapshot& shot) const {
    if (!m_pipeline.noiseTexton() || !m_pipeline.texton() || !m_pipeline.texton()->finished)
        return tr("There is no texton yet.");
    const bool ofMixture = m_document.project().mix.source != nullptr;
    if (m_plan.kind == ExportKind::Mixture && !ofMixture)
        return tr("There is no mixture yet. Open a second material first.");
    const bool needsMixture =
        m_plan.kind == ExportKind::Mixture || (m_plan.kind == ExportKind::Noise && ofMixture);
    if (!needsMixture)
        return {};
    if (!shot.mixture)
        return tr("The mixture is not ready. The Mix panel tells why.");
    const MixingMap& map = shot.mixture->mixture.map;
    if (m_plan.kind != ExportKind::Noise || !m_plan.tileable)
        return {};
    const double scale = shot.noise.scale;
    NoiseParams params;
    params.period = Period{m_plan.size.width / scale, m_plan.size.height / scale};
    if (checkMixing(shot.mixture->mixture.textons.size(), map.placement, map.boundary, params))
        return {};
    return tr("To tile, switch on Mix > Repeat the map, and choose a multiple of %1 x %2 px.")
        .arg(std::llround(map.placement.width * scale))
        .arg(std::llround(map.placement.height * scale));
}

void ExportDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    showPlan();
    showProgress();
}

void ExportDialog::showFiles() {
    if (!isVisible())
        return; // showEvent() asks again
    const ExportSnapshot shot = snapshot();
    const QString problem = obstacle(shot);
    QStringList lines;
    if (problem.isEmpty()) {
        for (const QString& file : exportFiles(m_plan, shot))
            lines << (QFileInfo::exists(file)
                          ? tr("%1  (replaces a file)").arg(QFileInfo(file).fileName())
                          : QFileInfo(file).fileName());
        if (lines.size() > kMostLines) {
            const auto more = lines.size() - (kMostLines - 1);
            lines = lines.first(kMostLines - 1);
            lines << tr("and %1 more").arg(more);
        }
    }
    m_files->setText(problem.isEmpty() ? lines.join(QLatin1Char('\n')) : problem);
    m_hasFiles = !lines.isEmpty();
    m_export->setEnabled(m_hasFiles && !m_runner.isBusy(JobKind::Export));
}

void ExportDialog::showProgress() {
    const auto info = m_runner.info(JobKind::Export);
    m_progress->setVisible(info.has_value());
    m_progress->setValue(info ? static_cast<int>(info->progress * 1000.0) : 0);
    m_cancel->setText(info ? tr("Cancel") : tr("Close"));
    if (info && !m_poll.isActive())
        m_poll.start();
    else if (!info)
        m_poll.stop();
    if (info && info->remainingMs)
        m_result->setText(
            tr("%n s left", nullptr, static_cast<int>((*info->remainingMs + 999) / 1000)));
    m_export->setEnabled(!info && m_hasFiles);
}

void ExportDialog::loadPresets(const QString& current) {
    m_presetChoice->clear();
    m_presetChoice->addItem(tr("None"));
    m_presetChoice->addItems(m_presets.names());
    m_presetChoice->setCurrentIndex(std::max(0, m_presetChoice->findText(current)));
    m_deletePreset->setEnabled(m_presetChoice->currentIndex() > 0);
}

void ExportDialog::savePreset() {
    auto* question = new QInputDialog(this);
    question->setObjectName(QStringLiteral("presetName"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(tr("Save as preset"));
    question->setLabelText(tr("Name of the preset"));
    connect(question, &QInputDialog::textValueSelected, this, [this](const QString& text) {
        const QString name = text.trimmed();
        if (name.isEmpty())
            return;
        m_presets.save(name, m_plan);
        loadPresets(name);
    });
    question->open();
}

void ExportDialog::deletePreset() {
    const QString name = m_presetChoice->currentText();
    auto* question = new QMessageBox(QMessageBox::Question,
                                     tr("Delete the preset?"),
                                     tr("The preset %1 will be gone.").arg(name),
                                     QMessageBox::Cancel,
                                     this);
    question->setObjectName(QStringLiteral("deletePresetQuestion"));
    question->addButton(tr("Delete"), QMessageBox::AcceptRole);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, question, name](int) {
        if (question->buttonRole(question->clickedButton()) != QMessageBox::AcceptRole)
            return;
        m_presets.remove(name);
        loadPresets({});
    });
    question->open();
}

void ExportDialog::choosePreset(int index) {
    m_deletePreset->setEnabled(index > 0);
    if (const auto plan = m_presets.find(m_presetChoice->itemText(index)); index > 0 && plan) {
        const QString folder = m_plan.folder; // remembered apart
        m_plan = *plan;
        m_plan.folder = folder;
        showPlan();
    }
}

void ExportDialog::chooseFolder() {
    auto* dialog = new QFileDialog(this, tr("Choose a folder"), m_plan.folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        m_plan.folder = folder;
        showPlan();
    });
    dialog->open();
}

void ExportDialog::start() {
    readPlan();
    m_openFolder->hide();
    ExportSnapshot shot = snapshot();
    if (!obstacle(shot).isEmpty())
        return; // it has come meanwhile, and is told
    if (m_plan.kind == ExportKind::View && m_currentView)
        shot.view = m_currentView();
    QStringList present;
    for (const QString& file : exportFiles(m_plan, shot)) {
        if (QFileInfo::exists(file))
            present << QFileInfo(file).fileName();
    }
    if (present.isEmpty()) {
        run(m_plan, shot);
        return;
    }
    auto* question = new QMessageBox(
        QMessageBox::Question,
        tr("Replace files?"),
        tr("%n file(s) of these names exist already.", nullptr, static_cast<int>(present.size())),
        QMessageBox::Cancel,
        this);
    question->setObjectName(QStringLiteral("replaceQuestion"));
    question->setInformativeText(present.join(QLatin1Char('\n')));
    question->addButton(tr("Replace"), QMessageBox::AcceptRole);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, question, plan = m_plan, shot](int) {
        if (question->buttonRole(question->clickedButton()) == QMessageBox::AcceptRole)
            run(plan, shot);
    });
    question->open();
}

void ExportDialog::run(const ExportPlan& plan, const ExportSnapshot& snapshot) {
    m_settings.setFolder(kFolder, plan.folder);
    m_result->setText(tr("Writing"));
    m_runner.submit(
        JobKind::Export,
        tr("Exporting"),
        [this, plan, snapshot](JobContext& context) -> Delivery {
            auto report = runExport(plan, snapshot, context);
            return [this, report = std::move(report)] {
                if (!report) {
                    m_result->setText(inWords(report.error()));
                    return;
                }
                QString text =
                    tr("Wrote %n file(s).", nullptr, static_cast<int>(report->files.size()));
                if (report->clippedShare >= 0.001)
                    text += QLatin1Char(' ') +
                            tr("%1 % of the values were clipped; EXR keeps them.")
                                .arg(QLocale().toString(100.0 * report->clippedShare, 'f', 1));
                m_result->setText(text);
                m_openFolder->show();
                showFiles();
            };
        });
    showProgress();
}

} // namespace txn::app
