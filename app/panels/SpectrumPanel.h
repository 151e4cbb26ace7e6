// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

namespace txn::app {

class Pipeline;
class PlotPicture;

/// Log power spectra and autocorrelations of exemplar, Gaussian version and noise, side by side.
class SpectrumPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SpectrumPanel(Pipeline& pipeline, QWidget* parent = nullptr);

  private:
    void showAnalysis();

    Pipeline& m_pipeline;
    std::array<PlotPicture*, 3> m_spectra{};
    std::array<PlotPicture*, 3> m_autocorrelations{};
};

} // namespace txn::app
