// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/JobRunner.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace txn::app {

/// One line of the status bar: what is being opened, prepared, computed or written, and how far it
/// is. Work that ends at once does not flicker there.
class JobsStatus : public QWidget {
    Q_OBJECT

  public:
    explicit JobsStatus(JobRunner& runner, QWidget* parent = nullptr);

  private:
    void showJobs();

    JobRunner& m_runner;
    QTimer m_poll;
    QLabel* m_title;
    QProgressBar* m_bar;
};

} // namespace txn::app
