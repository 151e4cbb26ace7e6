// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/ExemplarPanel.h"

#include "app/look/Theme.h"
#include "app/panels/CropCanvas.h"
#include "app/pipeline/Pipeline.h"
#include "app/widgets/BeforeAfter.h"
#include "app/widgets/ChoiceRow.h"
#include "app/widgets/ValueSlider.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace txn::app {
namespace {

constexpr double kStandardRadius = 80.0;
constexpr int kIconPx = 16;

QString depthText(SampleFormat format) {
    switch (format) {
    case SampleFormat::UInt8:
        return ExemplarPanel::tr("8 bit");
    case SampleFormat::UInt16:
        return ExemplarPanel::tr("16 bit");
    case SampleFormat::Half:
        return ExemplarPanel::tr("16 bit float");
    case SampleFormat::Float:
        break;
    }
    return ExemplarPanel::tr("32 bit float");
}

QString kindText(MapKind kind) {
    switch (kind) {
    case MapKind::Color:
        return ExemplarPanel::tr("Color");
    case MapKind::Normal:
        return ExemplarPanel::tr("Normals");
    case MapKind::NormalYDown:
        return ExemplarPanel::tr("Normals, green down");
    case MapKind::Height:
        return ExemplarPanel::tr("Height");
    case MapKind::Roughness:
        return ExemplarPanel::tr("Roughness");
    case MapKind::Occlusion:
        return ExemplarPanel::tr("Occlusion");
    case MapKind::Metalness:
        return ExemplarPanel::tr("Metalness");
    case MapKind::Packed:
        return ExemplarPanel::tr("Occlusion, roughness, metalness");
    case MapKind::Data:
        break;
    }
    return ExemplarPanel::tr("Data");
}

QString mapsText(const Source& source) {
    QStringList lines;
    for (const Source::File& file : source.files())
        lines << ExemplarPanel::tr("%1: %2").arg(kindText(file.kind), file.name);
    return lines.join(QLatin1Char('\n'));
}

bool hasNormals(const Source& source) {
    return std::ranges::any_of(source.maps(),
                               [](const MaterialMap& map) { return isNormal(map.kind); });
}

QString channelText(int channels) {
    if (channels == 1)
        return ExemplarPanel::tr("gray");
    return channels == 3 ? ExemplarPanel::tr("RGB")
                         : ExemplarPanel::tr("%1 channels").arg(channels);
}

struct Words {
    QString icon;
    QString verdict;
    QString reason;
};

Words inWords(const Suitability& s) {
    const QLocale locale;
    switch (s.verdict) {
    case Verdict::ColoursClip:
        return {QStringLiteral("warning"),
                ExemplarPanel::tr("Colors will clip"),
                ExemplarPanel::tr(
                    "%1 % of the noise's values are darker than black or lighter than white. Lower "
                    "the contrast of the noise, or export EXR.")
                    .arg(locale.toString(100.0 * s.clippedShare, 'f', 1))};
    case Verdict::ColoursDiffer:
        return {QStringLiteral("warning"),
                ExemplarPanel::tr("Suits, but highlights or shadows even out"),
                ExemplarPanel::tr(
                    "Its values lean to one side; those of the noise are spread evenly around the "
                    "mean.")};
    case Verdict::HasShapes:
        return {
            QStringLiteral("info"),
            ExemplarPanel::tr("Has shapes that a Gaussian texture cannot keep"),
            ExemplarPanel::tr(
                "Edges, patches and single features even out into grain. Compare with the Gaussian "
                "version, or crop a part that is all grain.")};
    case Verdict::Suits:
        break;
    }
    return {QStringLiteral("good"),
            ExemplarPanel::tr("Suits texton noise"),
            ExemplarPanel::tr("It is all grain and no shapes, and its colors fit.")};
}

} // namespace

ExemplarPanel::ExemplarPanel(ProjectDocument& document, Pipeline& pipeline, QWidget* parent)
    : QWidget(parent), m_document(document), m_pipeline(pipeline) {
    setObjectName(QStringLiteral("exemplarPanel"));
    build();
    connect(&m_document, &ProjectDocument::projectChanged, this, &ExemplarPanel::showSettings);
    connect(&m_pipeline, &Pipeline::exemplarChanged, this, &ExemplarPanel::showExemplar);
    connect(&m_pipeline, &Pipeline::verdictChanged, this, &ExemplarPanel::showVerdict);
    showSettings();
    showExemplar();
    showVerdict();
}

void ExemplarPanel::change(const QString& text,
                           const std::function<void(ExemplarEdit&)>& edit,
                           Gesture gesture) {
    m_document.change(
        text,
        [&](Project& project) { edit(project.edit); },
        gesture);
}

QWidget* ExemplarPanel::buildTools() {
    auto* tools = new QWidget;
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    const auto add =
        [&](const QString& name, const QString& icon, const QString& text, const QString& tip) {
            auto* button = new QToolButton;
            button->setObjectName(name);
            button->setIcon(themeIcon(icon));
            button->setText(text);
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
            button->setToolTip(tip);
            button->setAccessibleName(text);
            button->setFocusPolicy(Qt::StrongFocus);
            row->addWidget(button);
            return button;
        };
    m_cropTool = add(QStringLiteral("cropTool"),
                     QStringLiteral("crop"),
                     tr("Crop"),
                     tr("Drag over the part of the photo that looks the same all over."));
    m_straightenTool = add(QStringLiteral("straightenTool"),
                           QStringLiteral("straighten"),
                           tr("Straighten"),
                           tr("Draw a line along the grain; it becomes level or upright."));
    row->addStretch();
    m_reset = add(QStringLiteral("resetExemplar"),
                  QStringLiteral("reset"),
                  tr("Reset"),
                  tr("Back to the photo as it was opened."));
    m_cropTool->setCheckable(true);
    m_straightenTool->setCheckable(true);
    m_cropTool->setChecked(true);
    const auto use = [this](CropCanvas::Tool tool) {
        m_canvas->setTool(tool);
        m_cropTool->setChecked(tool == CropCanvas::Tool::Crop);
        m_straightenTool->setChecked(tool == CropCanvas::Tool::Straighten);
    };
    connect(m_cropTool, &QToolButton::clicked, this, [use] { use(CropCanvas::Tool::Crop); });
    connect(m_straightenTool, &QToolButton::clicked, this, [use] {
        use(CropCanvas::Tool::Straighten);
    });
    connect(m_canvas, &CropCanvas::lineDrawn, this, [this, use](double degrees) {
        change(tr("Straighten"),
               [degrees](ExemplarEdit& edit) { edit.straightenDegrees = degrees; });
        use(CropCanvas::Tool::Crop);
    });
    connect(m_reset, &QToolButton::clicked, this, [this] {
        change(tr("Reset the exemplar"), [](ExemplarEdit& edit) { edit = ExemplarEdit{}; });
    });
    return tools;
}

void ExemplarPanel::build() {
    m_canvas = new CropCanvas;
    m_canvas->setObjectName(QStringLiteral("cropCanvas"));
    m_canvas->setAccessibleName(tr("The photo and its crop"));
    m_canvas->setToolTip(
        tr("Drag to use only a part of the photo. Arrow keys move it, with Shift they resize it."));
    connect(m_canvas, &CropCanvas::cropEdited, this, [this](const Rect& crop, Gesture gesture) {
        change(
            tr("Crop"),
            [&](ExemplarEdit& edit) {
                edit.crop = crop;
                const auto& source = m_document.project().source;
                if (source && crop == Rect{0, 0, source->size()})
                    edit.crop.reset();
            },
            gesture);
    });
    QWidget* tools = buildTools();

    m_facts = new QLabel;
    m_facts->setObjectName(QStringLiteral("exemplarFacts"));
    m_facts->setProperty("role", QStringLiteral("secondary"));
    m_facts->setWordWrap(true);

    m_maps = new QLabel;
    m_maps->setObjectName(QStringLiteral("exemplarMaps"));
    m_maps->setWordWrap(true);
    m_maps->setToolTip(
        tr("The maps of this material, told by the words in their names. Their noise "
           "comes from the same impacts, so that they stay in register."));
    m_flipGreen = new QCheckBox(tr("Green points the other way"));
    m_flipGreen->setObjectName(QStringLiteral("exemplarFlipGreen"));
    m_flipGreen->setToolTip(tr("For normal maps made for another program: switch it on if bumps "
                               "look like dents."));
    connect(m_flipGreen, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Green of the normals"), [&](ExemplarEdit& edit) { edit.flipGreen = on; });
    });

    m_verdictIcon = new QLabel;
    m_verdictIcon->setFixedSize(kIconPx, kIconPx);
    m_verdict = new QLabel;
    m_verdict->setObjectName(QStringLiteral("verdict"));
    m_verdict->setWordWrap(true);
    m_reason = new QLabel;
    m_reason->setObjectName(QStringLiteral("verdictReason"));
    m_reason->setWordWrap(true);
    m_reason->setProperty("role", QStringLiteral("secondary"));
    auto* verdict = new QHBoxLayout;
    verdict->setSpacing(8);
    verdict->addWidget(m_verdictIcon, 0, Qt::AlignTop);
    verdict->addWidget(m_verdict, 1);

    m_angle = new ValueSlider(tr("Angle"),
                              {-45.0,
                               45.0,
                               0.0,
                               1,
                               ValueSlider::Scale::Linear,
                               {0.0},
                               QStringLiteral("\u00b0"),
                               -180.0,
                               180.0});
    m_angle->setObjectName(QStringLiteral("exemplarAngle"));
    m_angle->setToolTip(tr("Turns the photo, counterclockwise. Or draw a line with Straighten."));
    connect(m_angle, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Straighten"),
            [&](ExemplarEdit& edit) { edit.straightenDegrees = value; },
            gesture);
    });

    m_space = new ChoiceRow(tr("Work in"), {tr("sRGB values"), tr("Linear light")});
    m_space->setObjectName(QStringLiteral("exemplarSpace"));
    m_space->setToolTip(
        tr("sRGB values keep dark grain; linear light suits renderers. Try sRGB first."));
    connect(m_space, &ChoiceRow::chosen, this, [this](int index) {
        m_document.change(tr("Work in"), [index](Project& project) {
            // A second exemplar can be mixed with the first one in one kind of light only.
            project.edit.linear = index == 1;
            project.mix.edit.linear = project.edit.linear;
        });
    });

    m_even = new QCheckBox(tr("Even out the lighting"));
    m_even->setObjectName(QStringLiteral("exemplarEven"));
    m_even->setToolTip(
        tr("Takes away shade that is smoother than the radius, such as a dark corner."));
    connect(m_even, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Even out the lighting"), [&](ExemplarEdit& edit) {
            edit.flattenRadiusPx = on ? std::optional(m_radius->value()) : std::nullopt;
        });
    });
    m_radius = new ValueSlider(tr("Radius"),
                               {5.0,
                                500.0,
                                kStandardRadius,
                                0,
                                ValueSlider::Scale::Logarithmic,
                                {},
                                tr("px"),
                                1.0,
                                10000.0});
    m_radius->setObjectName(QStringLiteral("exemplarRadius"));
    m_radius->setToolTip(
        tr("Only what is smoother than this goes away. Small values also take large grain."));
    connect(m_radius, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Lighting radius"),
            [&](ExemplarEdit& edit) { edit.flattenRadiusPx = value; },
            gesture);
    });
    m_evenPreview = new BeforeAfter;
    m_evenPreview->setObjectName(QStringLiteral("evenPreview"));
    m_evenPreview->setAccessibleName(tr("Lighting before and after"));

    m_periodic = new QCheckBox(tr("Remove the seam"));
    m_periodic->setObjectName(QStringLiteral("exemplarPeriodic"));
    m_periodic->setToolTip(
        tr("Takes away the jump from one border of the photo to the other (the periodic "
           "component). Switch it off for pictures that tile already."));
    connect(m_periodic, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Remove the seam"), [&](ExemplarEdit& edit) { edit.periodic = on; });
    });
    m_seamPreview = new BeforeAfter;
    m_seamPreview->setObjectName(QStringLiteral("seamPreview"));
    m_seamPreview->setAccessibleName(tr("Seam before and after"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addWidget(m_canvas);
    column->addWidget(tools);
    column->addWidget(m_facts);
    column->addWidget(m_maps);
    column->addWidget(m_flipGreen);
    column->addSpacing(12);
    column->addLayout(verdict);
    column->addWidget(m_reason);
    column->addSpacing(12);
    for (QWidget* each : std::initializer_list<QWidget*>{m_angle, m_space})
        column->addWidget(each);
    column->addSpacing(12);
    for (QWidget* each : std::initializer_list<QWidget*>{m_even, m_radius, m_evenPreview})
        column->addWidget(each);
    column->addSpacing(12);
    for (QWidget* each : std::initializer_list<QWidget*>{m_periodic, m_seamPreview})
        column->addWidget(each);
    column->addStretch();
}

void ExemplarPanel::showSettings() {
    const Project& project = m_document.project();
    const ExemplarEdit& edit = project.edit;
    const bool open = project.source != nullptr;
    for (QWidget* each : std::initializer_list<QWidget*>{m_canvas,
                                                         m_cropTool,
                                                         m_straightenTool,
                                                         m_reset,
                                                         m_angle,
                                                         m_space,
                                                         m_even,
                                                         m_periodic,
                                                         m_seamPreview})
        each->setEnabled(open);
    m_reset->setEnabled(open && edit != ExemplarEdit{});
    m_canvas->setCrop(edit.crop);
    m_angle->setValue(edit.straightenDegrees);
    const bool linearFile = open && project.source->facts().transfer == Transfer::Linear;
    m_space->setCurrent(edit.linear || linearFile ? 1 : 0);
    const bool stack = open && !project.source->maps().empty();
    // Such a file has no other values; and the colors of a stack stay encoded.
    m_space->setEnabled(open && !linearFile && !stack);
    m_maps->setVisible(stack);
    m_maps->setText(stack ? mapsText(*project.source) : QString());
    m_flipGreen->setVisible(stack && hasNormals(*project.source));
    m_flipGreen->setChecked(edit.flipGreen);
    m_even->setChecked(edit.flattenRadiusPx.has_value());
    m_radius->setEnabled(open && edit.flattenRadiusPx.has_value());
    m_radius->setVisible(edit.flattenRadiusPx.has_value());
    m_evenPreview->setVisible(edit.flattenRadiusPx.has_value());
    if (edit.flattenRadiusPx)
        m_radius->setValue(*edit.flattenRadiusPx);
    m_periodic->setChecked(edit.periodic);
    const auto exemplar = m_pipeline.exemplar();
    m_canvas->setEnabled(exemplar && exemplar->source == project.source);
    if (!open) {
        m_facts->setText(project.importedTexton
                             ? tr("A texton from a file needs no exemplar.")
                             : tr("Open a photo of a material, or drop one here."));
        return;
    }
    const Source::Facts& known = project.source->facts();
    QStringList facts{tr("%1 x %2 px").arg(known.size.width).arg(known.size.height),
                      channelText(known.channels),
                      depthText(known.sampleFormat),
                      known.transfer == Transfer::Linear ? tr("linear") : tr("sRGB")};
    if (known.iccConverted)
        facts.append(tr("color profile converted"));
    if (known.hasAlpha)
        facts.append(tr("transparency left out"));
    m_facts->setText(project.source->name() + QLatin1Char('\n') + facts.join(QStringLiteral(", ")));
}

void ExemplarPanel::showExemplar() {
    const auto exemplar = m_pipeline.exemplar();
    const auto& source = m_document.project().source;
    if (!exemplar || !source) {
        m_canvas->setPicture({}, {});
        m_evenPreview->setImages({}, {});
        m_seamPreview->setImages({}, {});
        return;
    }
    // Until the new photo is prepared, the old one is seen, and must not be cropped.
    const bool present = exemplar->source == source;
    m_canvas->setEnabled(present);
    if (!present)
        return;
    m_canvas->setPicture(exemplar->overview, source->size());
    m_evenPreview->setImages(exemplar->evenBefore, exemplar->evenAfter);
    const bool periodic = m_document.project().edit.periodic;
    m_seamPreview->setImages(exemplar->seamBefore,
                             periodic ? exemplar->seamAfter : exemplar->seamBefore);
}

void ExemplarPanel::showVerdict() {
    const auto verdict = m_pipeline.verdict();
    if (!verdict) {
        m_verdictIcon->clear();
        m_verdict->setText(QStringLiteral(" "));
        m_reason->setText(QStringLiteral(" "));
        return;
    }
    const Words words = inWords(*verdict);
    const QLocale locale;
    m_verdictIcon->setPixmap(
        themeIcon(words.icon).pixmap(QSize(kIconPx, kIconPx), devicePixelRatioF()));
    m_verdict->setText(words.verdict);
    m_reason->setText(words.reason);
    const QString numbers = tr("Skewness %1, excess kurtosis %2, clipped values %3 %, sub-bands %4 "
                               "standard deviations from those of "
                               "its Gaussian versions.")
                                .arg(locale.toString(verdict->skewness, 'f', 2),
                                     locale.toString(verdict->excessKurtosis, 'f', 2),
                                     locale.toString(100.0 * verdict->clippedShare, 'f', 1),
                                     locale.toString(verdict->subbandDeviation, 'f', 1));
    m_verdict->setToolTip(numbers);
    m_reason->setToolTip(numbers);
}

} // namespace txn::app
