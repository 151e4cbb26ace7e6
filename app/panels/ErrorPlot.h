// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/Results.h"

#include <QChartView>

class QLineSeries;
class QValueAxis;

namespace txn::app {

/// The error of the method against iterations.
class ErrorPlot : public QChartView {
    Q_OBJECT

  public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    /// iterations: where the axis ends, so that the curve grows and nothing jumps.
    void showCurve(const std::vector<ErrorPoint>& curve, int iterations);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void applyColors();

    QLineSeries* m_series;
    QValueAxis* m_iterations;
    QValueAxis* m_error;
};

} // namespace txn::app
