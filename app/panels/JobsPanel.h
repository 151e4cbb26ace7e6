// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/JobRunner.h"

#include <QTimer>
#include <QWidget>
#include <functional>

class QTreeWidget;
class QTreeWidgetItem;

namespace txn::app {

/// What is being computed, how far it is, and a way to stop it.
class JobsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit JobsPanel(JobRunner& runner, QWidget* parent = nullptr);

  signals:
    /// By the user.
    void cancelWanted(JobKind kind);

  private:
    void showJobs();
    QTreeWidgetItem* addRow();

    JobRunner& m_runner;
    QTreeWidget* m_list;
    QTimer m_poll;
};

} // namespace txn::app
