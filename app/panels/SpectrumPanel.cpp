// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/SpectrumPanel.h"

#include "app/display/ColorMap.h"
#include "app/pipeline/Pipeline.h"
#include "app/widgets/PlotPicture.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace txn::app {

SpectrumPanel::SpectrumPanel(Pipeline& pipeline, QWidget* parent)
    : QWidget(parent), m_pipeline(pipeline) {
    setObjectName(QStringLiteral("spectrumPanel"));
    const std::array captions{tr("Exemplar"), tr("Gaussian version"), tr("Noise")};
    auto* groups = new QHBoxLayout(this);
    groups->setContentsMargins(8, 8, 8, 8);
    groups->setSpacing(16);
    const auto add =
        [&](auto& places, const QString& title, const QString& name, const QString& tip) {
            auto* column = new QVBoxLayout;
            column->setSpacing(4);
            auto* heading = new QLabel(title);
            heading->setProperty("role", QStringLiteral("heading"));
            column->addWidget(heading);
            auto* row = new QHBoxLayout;
            row->setSpacing(4);
            for (std::size_t i = 0; i < places.size(); ++i) {
                places[i] = new PlotPicture(captions[i]);
                places[i]->setObjectName(name + QString::number(i));
                places[i]->setToolTip(tip);
                row->addWidget(places[i], 1);
            }
            column->addLayout(row, 1);
            groups->addLayout(column, 1);
        };
    add(m_spectra,
        tr("Power spectrum"),
        QStringLiteral("spectrum"),
        tr("How strong waves of each direction and length are: long ones in the middle, fine grain "
           "outside. The three should look alike."));
    add(m_autocorrelations,
        tr("Autocorrelation"),
        QStringLiteral("autocorrelation"),
        tr("How alike two points are at each distance and direction. The size of the bright patch "
           "is that of the grain; it should fit into the support."));
    connect(&m_pipeline, &Pipeline::analysisChanged, this, &SpectrumPanel::showAnalysis);
    showAnalysis();
}

void SpectrumPanel::showAnalysis() {
    const auto analysis = m_pipeline.analysis();
    if (!analysis) {
        for (std::size_t i = 0; i < m_spectra.size(); ++i) {
            m_spectra[i]->setImage({});
            m_autocorrelations[i]->setImage({});
        }
        return;
    }
    const std::array all{&analysis->exemplar, &analysis->gaussian, &analysis->noise};
    for (std::size_t i = 0; i < all.size(); ++i) {
        // All on the exemplar's scale.
        const double ratio = all[i]->peakPower / std::max(analysis->exemplar.peakPower, 1e-30);
        const double shift = 10.0 * std::log10(std::max(ratio, 1e-30)) / TextureAnalysis::kDecibels;
        m_spectra[i]->setImage(falseColors(all[i]->logPower, -shift, 1.0 - shift));
        m_autocorrelations[i]->setImage(falseColors(all[i]->autocorrelation, -0.2, 0.6));
    }
}

} // namespace txn::app
