// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QChartView;
class QLabel;

namespace txn::app {

class Pipeline;

/// How often each value occurs, channel by channel, in exemplar, Gaussian version and noise.
class HistogramPanel : public QWidget {
    Q_OBJECT

  public:
    explicit HistogramPanel(Pipeline& pipeline, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void showAnalysis();
    void showLegend();

    Pipeline& m_pipeline;
    QLabel* m_legend;                  ///< one for all channels
    std::vector<QChartView*> m_charts; ///< one per channel, up to four
};

} // namespace txn::app
