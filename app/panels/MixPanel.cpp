// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/MixPanel.h"

#include "app/look/Theme.h"
#include "app/mixing/PaintTools.h"
#include "app/pipeline/Pipeline.h"
#include "app/widgets/ChoiceRow.h"
#include "app/widgets/FilmStrip.h"
#include "app/widgets/MaterialSlot.h"
#include "app/widgets/ValueSlider.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

constexpr int kToolWidth = 272;
constexpr int kMaterialWidth = 232;

QImage thumbnail(const std::shared_ptr<const ExemplarResult>& exemplar) {
    return exemplar ? exemplar->overview : QImage();
}

} // namespace

MixPanel::MixPanel(ProjectDocument& document,
                   Pipeline& pipeline,
                   PaintTools& tools,
                   QWidget* parent)
    : QWidget(parent), m_document(document), m_pipeline(pipeline), m_tools(tools) {
    setObjectName(QStringLiteral("mixPanel"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 8, 8, 8);
    row->setSpacing(16);
    row->addWidget(buildMaterials());
    row->addWidget(buildStrip(), 1);
    row->addWidget(buildTools());
    connect(&m_document, &ProjectDocument::projectChanged, this, &MixPanel::showMaterials);
    connect(&m_document, &ProjectDocument::viewChanged, this, [this] {
        m_strip->setChosen(chosenFrame()); // views move often, and nothing else depends on them
    });
    connect(&m_pipeline, &Pipeline::exemplarChanged, this, &MixPanel::showMaterials);
    connect(&m_pipeline, &Pipeline::secondExemplarChanged, this, &MixPanel::showMaterials);
    connect(&m_pipeline, &Pipeline::mixChanged, this, &MixPanel::showFrames);
    connect(&m_pipeline, &Pipeline::stateChanged, this, &MixPanel::showFrames);
    connect(&m_tools, &PaintTools::changed, this, &MixPanel::showTools);
    showMaterials();
    showFrames();
    showTools();
}

void MixPanel::setAccepts(const std::function<bool(const QMimeData&)>& accepts) {
    m_first->setAccepts(accepts);
    m_second->setAccepts(accepts);
}

QWidget* MixPanel::buildMaterials() {
    m_first = new MaterialSlot(QStringLiteral("A"), tr("Drop a photo"));
    m_first->setObjectName(QStringLiteral("mixFirst"));
    m_first->setToolTip(tr("The first material. Click to open another one, or drop a photo here."));
    m_second = new MaterialSlot(QStringLiteral("B"), tr("Drop a second photo"));
    m_second->setObjectName(QStringLiteral("mixSecond"));
    m_second->setToolTip(
        tr("The second material, to be mixed with the first. Click to open one, or drop a photo "
           "here."));
    connect(m_first, &MaterialSlot::clicked, this, &MixPanel::firstWanted);
    connect(m_first, &MaterialSlot::dropped, this, &MixPanel::firstDropped);
    connect(m_second, &MaterialSlot::clicked, this, &MixPanel::secondWanted);
    connect(m_second, &MaterialSlot::dropped, this, &MixPanel::secondDropped);
    const auto button = [](const char* name, const QString& icon, const QString& toolTip) {
        auto* made = new QToolButton;
        made->setObjectName(QLatin1String(name));
        made->setIcon(themeIcon(icon));
        made->setToolTip(toolTip);
        made->setAccessibleName(toolTip);
        made->setAutoRaise(true);
        return made;
    };
    m_swap = button("mixSwap", QStringLiteral("swap"), tr("Let A and B change places."));
    m_remove = button("mixRemove",
                      QStringLiteral("close"),
                      tr("Take the second material away and show the first one alone."));
    connect(m_swap, &QToolButton::clicked, this, &MixPanel::swapWanted);
    connect(m_remove, &QToolButton::clicked, this, &MixPanel::removeWanted);
    m_count = new ValueSlider(tr("Textons"),
                              {2.0,
                               41.0,
                               MixSettings::kStandardTextons,
                               0,
                               ValueSlider::Scale::Linear,
                               {5.0, 11.0, 21.0, 41.0},
                               {},
                               MixSolver::kMinTextons,
                               MixSolver::kMaxTextons});
    m_count->setObjectName(QStringLiteral("mixCount"));
    m_count->setToolTip(
        tr("How many textons lie between A and B. More make the passage finer. Try 21."));
    connect(m_count, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        m_document.change(
            tr("Textons from A to B"),
            [value](Project& project) { project.mix.textons = static_cast<int>(value); },
            gesture);
    });
    m_words = new QLabel;
    m_words->setObjectName(QStringLiteral("mixWords"));
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* widget = new QWidget;
    widget->setMinimumWidth(kMaterialWidth);
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(m_first, 0, 0, 2, 1);
    grid->addWidget(m_swap, 0, 1);
    grid->addWidget(m_remove, 1, 1);
    grid->addWidget(m_second, 0, 2, 2, 1);
    grid->addWidget(m_words, 2, 0, 1, 3);
    grid->addWidget(m_count, 3, 0, 1, 3);
    grid->setRowStretch(2, 1);
    return widget;
}

QWidget* MixPanel::buildStrip() {
    m_strip = new FilmStrip;
    m_strip->setObjectName(QStringLiteral("mixStrip"));
    m_strip->setAccessibleName(tr("Textons from A to B"));
    m_strip->setToolTip(
        tr("The textons from A to B, each with a piece of its noise. Click one to see it alone "
           "and to paint with it; click it again to see the mixture."));
    connect(m_strip, &FilmStrip::chosen, this, [this](std::optional<int> frame) {
        const auto mix = m_pipeline.mix();
        std::optional<double> rho;
        if (frame && mix && *frame < static_cast<int>(mix->frames.size()))
            rho = mix->frames[static_cast<std::size_t>(*frame)].rho;
        m_document.changeView([rho](ViewState& view) { view.mixRho = rho; });
        if (!rho)
            return;
        auto state = m_tools.state();
        state.target = *rho;
        m_tools.set(state);
    });
    m_scroll = new QScrollArea;
    m_scroll->setWidget(m_strip);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setMinimumWidth(184);
    m_scroll->setFixedHeight(m_strip->sizeHint().height() +
                             m_scroll->horizontalScrollBar()->sizeHint().height());
    connect(m_strip, &FilmStrip::reached, this, [this](const QRect& place) {
        m_scroll->ensureVisible(place.center().x(), place.center().y(), place.width(), 0);
    });
    auto* widget = new QWidget;
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_scroll);
    column->addStretch(1);
    return widget;
}

QWidget* MixPanel::buildTools() {
    const auto slider = [this](const char* name,
                               const QString& label,
                               ValueSlider::Range range,
                               const QString& toolTip,
                               double PaintTools::State::*member) {
        auto* made = new ValueSlider(label, std::move(range));
        made->setObjectName(QLatin1String(name));
        made->setToolTip(toolTip);
        connect(made, &ValueSlider::valueEdited, this, [this, member](double value) {
            auto state = m_tools.state();
            state.*member = value;
            m_tools.set(state);
        });
        return made;
    };
    m_tool = new ChoiceRow(tr("Tool"),
                           {tr("Look"),
                            tr("Brush"),
                            tr("Smooth"),
                            tr("Eraser"),
                            tr("Gradient"),
                            tr("Round gradient")});
    m_tool->setObjectName(QStringLiteral("mixTool"));
    m_tool->setToolTip(
        tr("What the mouse does in the noise seen from above. Brush paints B, or any "
           "mixture; the eraser brings A back. Shift draws straight lines."));
    connect(m_tool, &ChoiceRow::chosen, this, [this](int index) {
        auto state = m_tools.state();
        state.tool = static_cast<PaintTool>(index);
        m_tools.set(state);
    });
    m_target = slider("mixTarget",
                      tr("Paint with"),
                      {0.0, 1.0, 1.0, 2, ValueSlider::Scale::Linear, {0.0, 0.5, 1.0}, {}, 0, 0},
                      tr("What the brush paints: 0 is A, 1 is B, anything else lies between."),
                      &PaintTools::State::target);
    m_radius = slider("mixRadius",
                      tr("Radius"),
                      {PaintTools::kMinRadiusPx,
                       512.0,
                       64.0,
                       0,
                       ValueSlider::Scale::Logarithmic,
                       {16.0, 64.0, 256.0},
                       QStringLiteral("px"),
                       PaintTools::kMinRadiusPx,
                       PaintTools::kMaxRadiusPx},
                      tr("How large the brush is. The keys [ and ] change it, too."),
                      &PaintTools::State::radiusPx);
    m_hardness = slider("mixHardness",
                        tr("Hardness"),
                        {0.0, 1.0, 0.5, 2, ValueSlider::Scale::Linear, {0.5}, {}, 0, 0},
                        tr("How sharp the rim of the brush is. Low passes softly from A to B."),
                        &PaintTools::State::hardness);
    m_strength = slider("mixStrength",
                        tr("Strength"),
                        {0.0, 1.0, 1.0, 2, ValueSlider::Scale::Linear, {0.5}, {}, 0, 0},
                        tr("How far one stroke goes towards what it paints."),
                        &PaintTools::State::strength);
    m_symmetry = new ChoiceRow(tr("Symmetry"),
                               {tr("None"), tr("Left and right"), tr("Up and down"), tr("Both")});
    m_symmetry->setObjectName(QStringLiteral("mixSymmetry"));
    m_symmetry->setToolTip(tr("Strokes are mirrored about the middle of the map."));
    connect(m_symmetry, &ChoiceRow::chosen, this, [this](int index) {
        auto state = m_tools.state();
        state.symmetry = {index == 1 || index == 3, index == 2 || index == 3};
        m_tools.set(state);
    });
    m_toolColumn = new QWidget;
    m_toolColumn->setMinimumWidth(kToolWidth);
    auto* column = new QVBoxLayout(m_toolColumn);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    for (QWidget* each : std::initializer_list<QWidget*>{m_tool,
                                                         m_target,
                                                         m_radius,
                                                         m_hardness,
                                                         m_strength,
                                                         m_symmetry})
        column->addWidget(each);
    column->addStretch(1);
    return m_toolColumn;
}

void MixPanel::showMaterials() {
    const Project& project = m_document.project();
    const auto second = m_pipeline.secondExemplar();
    m_first->setPicture(thumbnail(m_pipeline.exemplar()),
                        project.source ? project.source->name() : QString());
    m_second->setPicture(project.mix.source ? thumbnail(second) : QImage(),
                         project.mix.source ? project.mix.source->name() : QString());
    const bool mixes = project.mix.source != nullptr;
    if (!mixes && m_document.view().mixRho) // of a mixture that is no more
        m_document.changeView([](ViewState& view) { view.mixRho.reset(); });
    m_second->setEnabled(project.source != nullptr);
    m_swap->setEnabled(mixes);
    m_remove->setEnabled(mixes);
    m_count->setValue(project.mix.textons);
    m_count->setEnabled(mixes);
    m_toolColumn->setEnabled(mixes);
    showFrames();
}

void MixPanel::showFrames() {
    const auto mix = m_pipeline.mix();
    const Project& project = m_document.project();
    if (!project.source)
        m_words->setText(project.importedTexton
                             ? tr("A texton from a file cannot be mixed. Open a photo instead.")
                             : tr("Open a photo, then a second one to mix it with."));
    else if (!project.mix.source)
        m_words->setText(tr("Drop a second material onto B, then paint where it is."));
    else if (m_pipeline.isMixStale() && !m_pipeline.isComputingMix())
        m_words->setText(tr("The textons from A to B are not up to date. Compute again with F5."));
    else if (!mix)
        m_words->setText(tr("Computing the textons from A to B..."));
    else if (!mix->finished)
        m_words->setText(tr("Textons so far: %1").arg(mix->frames.size()));
    else
        m_words->setText(
            tr("Distance from A to B: %1").arg(QLocale().toString(mix->distance, 'g', 3)));
    std::vector<FilmStrip::Frame> frames;
    for (const MixFrame& frame : mix ? mix->frames : std::vector<MixFrame>())
        frames.push_back({frame.texton, frame.noise, QLocale().toString(frame.rho, 'f', 2)});
    m_strip->setFrames(std::move(frames));
    m_strip->adjustSize();
    m_strip->setChosen(chosenFrame());
}

/// The frame of the texton that is shown alone, as soon as it is there.
std::optional<int> MixPanel::chosenFrame() const {
    const auto rho = m_document.view().mixRho;
    const auto mix = m_pipeline.mix();
    if (!rho || !mix || mix->frames.empty())
        return std::nullopt;
    const auto nearest = std::ranges::min_element(mix->frames, {}, [&](const MixFrame& frame) {
        return std::abs(frame.rho - *rho);
    });
    if (!mix->finished && std::abs(nearest->rho - *rho) > 1e-9)
        return std::nullopt;
    return static_cast<int>(nearest - mix->frames.begin());
}

void MixPanel::showTools() {
    const PaintTools::State& state = m_tools.state();
    m_tool->setCurrent(static_cast<int>(state.tool));
    m_target->setValue(state.target);
    m_radius->setValue(state.radiusPx);
    m_hardness->setValue(state.hardness);
    m_strength->setValue(state.strength);
    m_symmetry->setCurrent((state.symmetry.acrossVertical ? 1 : 0) +
                           (state.symmetry.acrossHorizontal ? 2 : 0));
    const bool brush = state.tool == PaintTool::Paint || state.tool == PaintTool::Smooth ||
                       state.tool == PaintTool::Erase;
    m_target->setEnabled(state.tool != PaintTool::Look && state.tool != PaintTool::Smooth &&
                         state.tool != PaintTool::Erase);
    for (QWidget* each : {m_radius, m_hardness, m_strength})
        each->setEnabled(brush);
    m_symmetry->setEnabled(brush);
}

} // namespace txn::app
