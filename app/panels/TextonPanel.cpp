// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/TextonPanel.h"

#include "app/panels/ErrorPlot.h"
#include "app/pipeline/Pipeline.h"
#include "app/widgets/ChoiceRow.h"
#include "app/widgets/SeedField.h"
#include "app/widgets/ValueSlider.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace txn::app {
namespace {

constexpr std::array kOrders{0, 1, 3, 5};
constexpr std::array kKernels{TextonSettings::kAutomatic, 1, 2, 3, 4, 8, 16};
constexpr int kProgressPollMs = 100;
constexpr int kProgressSteps = 1000;

ValueSlider::Range sideRange() {
    return {8.0,
            256.0,
            64.0,
            0,
            ValueSlider::Scale::Logarithmic,
            {8.0, 16.0, 32.0, 64.0, 128.0, 256.0},
            TextonPanel::tr("px"),
            TextonSettings::kMinSidePx,
            TextonSettings::kMaxSidePx};
}

/// What an artist makes of the error: how many times the floor it is, and whether the support holds
/// the grain.
QString inWords(const TextonResult& result,
                const std::optional<SupportSuggestion>& suggestion,
                bool suits) {
    constexpr double kClose = 1.25;
    constexpr double kFair = 2.5;
    if (!result.finished)
        return result.choosingKernels ? TextonPanel::tr("Choosing the number of kernels")
                                      : TextonPanel::tr("Getting closer");
    const Size side = result.texton.support.size();
    if (suggestion && 2 * std::max(side.width, side.height) <= suggestion->side)
        return TextonPanel::tr("Long grain is lost. Try a larger support");
    if (!result.dial || !(result.dial->floor > 0.0))
        return TextonPanel::tr("Done");
    const double ratio = result.dial->error / result.dial->floor;
    if (ratio <= kClose)
        return suits ? TextonPanel::tr("As close as two photos of this material")
                     : TextonPanel::tr("As close as this method gets");
    if (ratio <= kFair)
        return TextonPanel::tr("Close. A larger support or another seed may help");
    return TextonPanel::tr("Fair. The material has more order than noise can keep");
}

QString inNumbers(const TextonResult& result) {
    const QLocale locale;
    QStringList parts;
    if (result.dial && result.dial->floor > 0.0)
        parts << TextonPanel::tr("Covariance error %1 \u00d7 the floor (%2)")
                     .arg(locale.toString(result.dial->error / result.dial->floor, 'f', 2),
                          locale.toString(result.dial->error, 'f', 3));
    if (result.relativeModelError)
        parts << TextonPanel::tr("Relative model error %1")
                     .arg(locale.toString(*result.relativeModelError, 'f', 3));
    if (!result.finished)
        parts << TextonPanel::tr("Error %1 after %2 iterations")
                     .arg(locale.toString(result.error, 'f', 3), locale.toString(result.iteration));
    return parts.join(QLatin1Char('\n'));
}

/// What each number of kernels brings, and what it takes on a graphics card.
QString trialText(const TextonResult& result) {
    const QLocale locale;
    const Size footprint = result.texton.footprint();
    const int groups = (result.texton.channels() + 3) / 4;
    const double kernelKb = static_cast<double>(footprint.area()) * groups * 4 * 4 / 1024.0;
    QStringList lines;
    for (std::size_t q = 1; q <= result.trialErrors.size(); ++q) {
        const QString line = TextonPanel::tr("Kernels: %1, error %2, %3 KB")
                                 .arg(q)
                                 .arg(locale.toString(result.trialErrors[q - 1], 'f', 3),
                                      locale.toString(kernelKb * static_cast<double>(q), 'f', 0));
        lines << (static_cast<int>(q) == result.texton.kernelCount()
                      ? line + QStringLiteral(" \u2713")
                      : line);
    }
    return lines.join(QLatin1Char('\n'));
}

QString inSeconds(qint64 milliseconds) {
    const qint64 seconds = (milliseconds + 999) / 1000;
    if (seconds < 60)
        return TextonPanel::tr("%n s left", nullptr, static_cast<int>(seconds));
    return TextonPanel::tr("%n min left", nullptr, static_cast<int>((seconds + 59) / 60));
}

} // namespace

TextonPanel::TextonPanel(ProjectDocument& document,
                         Pipeline& pipeline,
                         JobRunner& runner,
                         QWidget* parent)
    : QWidget(parent), m_document(document), m_pipeline(pipeline), m_runner(runner) {
    setObjectName(QStringLiteral("textonPanel"));
    build();
    m_poll.setInterval(kProgressPollMs);
    connect(&m_poll, &QTimer::timeout, this, &TextonPanel::showProgress);
    connect(&m_document, &ProjectDocument::projectChanged, this, &TextonPanel::showSettings);
    connect(&m_pipeline, &Pipeline::textonChanged, this, &TextonPanel::showResult);
    connect(&m_pipeline, &Pipeline::verdictChanged, this, &TextonPanel::showResult);
    connect(&m_pipeline, &Pipeline::stateChanged, this, &TextonPanel::showProgress);
    showSettings();
    showResult();
    showProgress();
}

void TextonPanel::change(const QString& text,
                         const std::function<void(TextonSettings&)>& edit,
                         Gesture gesture) {
    m_document.change(
        text,
        [&](Project& project) { edit(project.texton); },
        gesture);
}

QWidget* TextonPanel::buildResult() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_verdict = new QLabel;
    m_verdict->setObjectName(QStringLiteral("textonVerdict"));
    m_verdict->setWordWrap(true);
    m_numbers = new QLabel;
    m_numbers->setObjectName(QStringLiteral("textonNumbers"));
    m_numbers->setProperty("role", QStringLiteral("secondary"));
    m_numbers->setWordWrap(true);
    m_numbers->setToolTip(tr(
        "How far the noise's correlations are from the photo's. At 1 \u00d7 the floor they are as "
        "close as one half of the photo is to all of it. The relative model error stays near 0.46 "
        "even for a perfect texton, because it compares with one photo, in which every wave's "
        "strength is random."));
    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("textonProgress"));
    m_progress->setRange(0, kProgressSteps);
    m_progress->setTextVisible(false);
    QSizePolicy kept = m_progress->sizePolicy(); // nothing jumps when work begins or ends
    kept.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(kept);
    m_progress->setFixedHeight(4);
    m_progress->setAccessibleName(tr("Progress of the texton"));
    m_remaining = new QLabel;
    m_remaining->setProperty("role", QStringLiteral("secondary"));
    m_cancel = new QPushButton(tr("Cancel"));
    m_cancel->setObjectName(QStringLiteral("textonCancel"));
    m_cancel->setToolTip(
        tr("Stop computing and go back to the last finished texton. Change anything to "
           "start again."));
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_pipeline.isComputingTexton())
            m_pipeline.cancelTexton();
        else
            m_pipeline.recomputeTexton();
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_progress, 1);
    row->addWidget(m_remaining);
    row->addWidget(m_cancel);
    column->addWidget(m_verdict);
    column->addWidget(m_numbers);
    column->addLayout(row);
    return box;
}

void TextonPanel::buildMethod() {
    m_suggest = new QPushButton;
    m_suggest->setObjectName(QStringLiteral("textonSuggest"));
    m_suggest->setAccessibleName(tr("Use the suggested support"));
    connect(m_suggest, &QPushButton::clicked, this, [this] {
        const auto suggestion = m_pipeline.suggestedSupport();
        if (!suggestion)
            return;
        change(tr("Suggested support"), [&](TextonSettings& texton) {
            texton.support = {suggestion->side, suggestion->side};
        });
    });
    m_method = new ChoiceRow(tr("Method"), {tr("Best fit"), tr("Papers' projections")});
    m_method->setObjectName(QStringLiteral("textonMethod"));
    m_method->setToolTip(
        tr("How the texton is found. Best fit comes closest for the same cost; the projections are "
           "the papers' own way, to compare with."));
    connect(m_method, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Method"),
               [&](TextonSettings& texton) { texton.method = static_cast<TextonMethod>(index); });
    });
    QStringList counts{tr("Automatic")};
    for (std::size_t i = 1; i < kKernels.size(); ++i)
        counts << QLocale().toString(kKernels[i]);
    m_kernels = new ChoiceRow(tr("Kernels"), counts);
    m_kernels->setObjectName(QStringLiteral("textonKernels"));
    m_kernels->setToolTip(
        tr("Each impact picks one of so many small pictures. More follow colors and maps that vary "
           "independently, at the same speed. Automatic tries them on one half of the photo."));
    connect(m_kernels, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Kernels"), [&](TextonSettings& texton) {
            texton.kernels = kKernels[static_cast<std::size_t>(index)];
        });
    });
    m_trials = new QLabel;
    m_trials->setObjectName(QStringLiteral("textonTrials"));
    m_trials->setProperty("role", QStringLiteral("secondary"));
    m_trials->setWordWrap(true);
    m_trials->setToolTip(
        tr("What was tried on one half of the photo: the error on the other half, and the memory "
           "on a graphics card. The fewest within 5 % of the best are taken."));
}

std::vector<QWidget*> TextonPanel::rows() const {
    return {m_width,
            m_suggest,
            m_shape,
            m_height,
            m_method,
            m_kernels,
            m_order,
            m_iterations,
            m_momentum,
            m_seed,
            m_colors};
}

void TextonPanel::showSuggestion() {
    const auto suggestion = m_pipeline.suggestedSupport();
    m_suggest->setText(suggestion ? tr("Suggested: %1 px").arg(suggestion->side)
                                  : tr("Suggested: none"));
    m_suggest->setToolTip(
        suggestion
            ? tr("As large as the grain of this material needs. A texton of that size leaves "
                 "out %1 % of the correlation.")
                  .arg(QLocale().toString(100.0 * suggestion->error, 'f', 0))
            : tr("The photo is too small to tell how large its grain is."));
    const TextonSettings& texton = m_document.project().texton;
    m_suggest->setEnabled(suggestion && m_document.project().source &&
                          texton.support != Size{suggestion->side, suggestion->side});
}

void TextonPanel::build() {
    buildMethod();
    m_shape = new ChoiceRow(tr("Shape"), {tr("Square"), tr("Rectangle"), tr("Disc")});
    m_shape->setObjectName(QStringLiteral("textonShape"));
    m_shape->setToolTip(
        tr("The outline of the texton. A square suits almost everything; a rectangle "
           "follows long grain."));
    connect(m_shape, &ChoiceRow::chosen, this, [this](int shape) {
        change(tr("Texton shape"), [&](TextonSettings& texton) {
            texton.shape = static_cast<TextonSettings::Shape>(shape);
            if (texton.shape == TextonSettings::Shape::Rectangle)
                texton.support.height =
                    std::max(TextonSettings::kMinSidePx, texton.support.width / 2);
        });
    });

    m_width = new ValueSlider(tr("Support"), sideRange());
    m_width->setObjectName(QStringLiteral("textonSupport"));
    m_width->setToolTip(tr("How large the texton is. Features longer than this get lost; larger "
                           "takes longer to compute. Try 64 first, 128 for long grain."));
    connect(m_width, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Support"),
            [&](TextonSettings& texton) {
                texton.support.width = static_cast<int>(std::lround(value));
                if (texton.shape != TextonSettings::Shape::Rectangle)
                    texton.support.height = texton.support.width;
            },
            gesture);
    });
    m_height = new ValueSlider(tr("Height"), sideRange());
    m_height->setObjectName(QStringLiteral("textonSupportHeight"));
    m_height->setToolTip(
        tr("The height of a rectangular texton. Make it small where the grain runs "
           "from left to right."));
    connect(m_height, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Support height"),
            [&](TextonSettings& texton) {
                texton.support.height = static_cast<int>(std::lround(value));
            },
            gesture);
    });

    m_order = new ChoiceRow(tr("Interpolation"),
                            {tr("Nearest"), tr("Linear"), tr("Cubic"), tr("Quintic")});
    m_order->setObjectName(QStringLiteral("textonOrder"));
    m_order->setToolTip(
        tr("How values between the texton's pixels are found. Linear is what graphics "
           "cards do for free; cubic is smoother when magnified."));
    connect(m_order, &ChoiceRow::chosen, this, [this](int index) {
        change(tr("Interpolation"), [&](TextonSettings& texton) {
            texton.interpolationOrder = kOrders[static_cast<std::size_t>(index)];
        });
    });

    m_iterations = new ValueSlider(tr("Iterations"),
                                   {5.0,
                                    500.0,
                                    50.0,
                                    0,
                                    ValueSlider::Scale::Logarithmic,
                                    {10.0, 50.0, 100.0, 200.0},
                                    {},
                                    1.0,
                                    100000.0});
    m_iterations->setObjectName(QStringLiteral("textonIterations"));
    m_iterations->setToolTip(
        tr("How long the texton is refined. Watch the curve: where it runs flat, "
           "more brings nothing."));
    connect(m_iterations, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Iterations"),
            [&](TextonSettings& texton) {
                texton.iterations = static_cast<int>(std::lround(value));
            },
            gesture);
    });

    m_momentum =
        new ValueSlider(tr("Momentum"),
                        {0.0, 0.99, 0.9, 2, ValueSlider::Scale::Linear, {}, {}, 0.0, 0.999});
    m_momentum->setObjectName(QStringLiteral("textonMomentum"));
    m_momentum->setToolTip(
        tr("Gets there in fewer iterations. 0.9 is good; 0 is the plain method of the "
           "papers."));
    connect(m_momentum, &ValueSlider::valueEdited, this, [this](double value, Gesture gesture) {
        change(
            tr("Momentum"),
            [&](TextonSettings& texton) { texton.momentum = value; },
            gesture);
    });

    m_seed = new SeedField(tr("Seed"));
    m_seed->setObjectName(QStringLiteral("textonSeed"));
    m_seed->setToolTip(
        tr("Another number gives another, equally good texton. Roll the dice, or lock "
           "the one you like."));
    connect(m_seed, &SeedField::seedEdited, this, [this](quint32 seed, Gesture gesture) {
        change(
            tr("Texton seed"),
            [&](TextonSettings& texton) { texton.seed = Seed{seed}; },
            gesture);
    });
    connect(m_seed, &SeedField::lockEdited, this, [this](bool locked) {
        change(locked ? tr("Lock the texton seed") : tr("Unlock the texton seed"),
               [&](TextonSettings& texton) { texton.seedLocked = locked; });
    });

    m_colors = new QCheckBox(tr("Exact colors"));
    m_colors->setObjectName(QStringLiteral("textonColors"));
    m_colors->setToolTip(
        tr("Corrects the texton so that the noise has exactly the colors of the photo. "
           "Leave it on unless you compare with the papers."));
    connect(m_colors, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Exact colors"), [&](TextonSettings& texton) { texton.colorCorrection = on; });
    });

    m_plot = new ErrorPlot;
    m_plot->setObjectName(QStringLiteral("textonPlot"));
    m_plot->setAccessibleName(tr("Error against iterations"));
    m_plot->setToolTip(tr("The error while the texton is refined. Lower is closer."));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addWidget(buildResult());
    column->addSpacing(8);
    for (QWidget* row : rows()) {
        column->addWidget(row);
        if (row == m_kernels)
            column->addWidget(m_trials);
    }
    column->addSpacing(8);
    column->addWidget(m_plot);
    column->addStretch();
}

void TextonPanel::showSettings() {
    const Project& project = m_document.project();
    const TextonSettings& texton = project.texton;
    m_shape->setCurrent(static_cast<int>(texton.shape));
    m_width->setValue(texton.support.width);
    m_height->setValue(texton.support.height);
    m_height->setVisible(texton.shape == TextonSettings::Shape::Rectangle);
    for (std::size_t i = 0; i < kOrders.size(); ++i) {
        if (kOrders[i] == texton.interpolationOrder)
            m_order->setCurrent(static_cast<int>(i));
    }
    m_iterations->setValue(texton.iterations);
    m_momentum->setValue(texton.momentum);
    m_seed->setSeed(texton.seed.value);
    m_seed->setLocked(texton.seedLocked);
    m_colors->setChecked(texton.colorCorrection);
    const bool fit = texton.method == TextonMethod::Fit;
    m_method->setCurrent(static_cast<int>(texton.method));
    const auto* known = std::find(kKernels.begin(), kKernels.end(), texton.kernels);
    m_kernels->setCurrent(known == kKernels.end() ? 0 : static_cast<int>(known - kKernels.begin()));
    m_kernels->setVisible(fit);
    m_trials->setVisible(fit);
    m_iterations->setVisible(!fit);
    m_momentum->setVisible(!fit);
    for (QWidget* row : rows())
        row->setEnabled(project.source != nullptr);
    showSuggestion();
}

void TextonPanel::showResult() {
    const auto result = m_pipeline.texton();
    if (!result) {
        m_verdict->setText(tr("Open a photo to compute its texton"));
        m_numbers->setText(QStringLiteral(" "));
        m_trials->clear();
        m_plot->showCurve({}, m_document.project().texton.iterations);
        return;
    }
    const Size side = result->texton.support.size();
    if (result->imported) {
        m_verdict->setText(tr("A texton from a file"));
        m_numbers->setText(tr("%1 x %2 px").arg(side.width).arg(side.height));
        m_trials->clear();
        m_plot->showCurve({}, 1);
        return;
    }
    const auto verdict = m_pipeline.verdict();
    m_verdict->setText(inWords(*result,
                               m_pipeline.suggestedSupport(),
                               verdict && verdict->verdict == Verdict::Suits));
    m_numbers->setText(inNumbers(*result));
    if (result->finished)
        m_trials->setText(trialText(*result));
    showSuggestion();
    m_plot->showCurve(result->curve, result->iterations);
}

void TextonPanel::showProgress() {
    const auto info = m_runner.info(JobKind::Texton);
    const bool busy = info.has_value();
    if (busy && !m_poll.isActive())
        m_poll.start();
    else if (!busy)
        m_poll.stop();
    m_progress->setVisible(busy);
    m_progress->setValue(busy ? static_cast<int>(info->progress * kProgressSteps) : 0);
    m_remaining->setText(busy && info->remainingMs ? inSeconds(*info->remainingMs)
                         : busy                    ? tr("Computing")
                                                   : QString());
    m_cancel->setText(busy ? tr("Cancel") : tr("Compute again"));
    m_cancel->setEnabled(m_document.project().source != nullptr);
}

} // namespace txn::app
