// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/JobsPanel.h"

#include "app/look/Theme.h"

#include <QHeaderView>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace txn::app {
namespace {

constexpr int kListPollMs = 200;
constexpr int kRowHeight = 26;
constexpr int kRowBarHeight = 6;
constexpr int kStopWidth = 36;
enum Column { What, Progress, Time, Stop };

} // namespace

JobsPanel::JobsPanel(JobRunner& runner, QWidget* parent)
    : QWidget(parent), m_runner(runner), m_list(new QTreeWidget) {
    setObjectName(QStringLiteral("jobsPanel"));
    m_list->setObjectName(QStringLiteral("jobsList"));
    m_list->setAccessibleName(tr("Work in progress"));
    m_list->setToolTip(tr("What is being computed right now."));
    m_list->setHeaderLabels({tr("Work"), tr("Progress"), tr("Time"), QString()});
    m_list->setRootIsDecorated(false);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(What, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(Stop, QHeaderView::Fixed);
    m_list->header()->resizeSection(Stop, kStopWidth);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_list);
    m_poll.setInterval(kListPollMs);
    connect(&m_poll, &QTimer::timeout, this, &JobsPanel::showJobs);
    connect(&m_runner, &JobRunner::jobsChanged, this, &JobsPanel::showJobs);
    showJobs();
}

void JobsPanel::showJobs() {
    const auto jobs = m_runner.infos();
    if (jobs.empty())
        m_poll.stop();
    else if (!m_poll.isActive())
        m_poll.start();
    while (m_list->topLevelItemCount() > static_cast<int>(jobs.size()))
        delete m_list->takeTopLevelItem(m_list->topLevelItemCount() - 1);
    const QLocale locale;
    for (int i = 0; i < static_cast<int>(jobs.size()); ++i) {
        QTreeWidgetItem* item = m_list->topLevelItem(i);
        if (item == nullptr)
            item = addRow();
        const JobRunner::Info& job = jobs[static_cast<std::size_t>(i)];
        item->setText(What, job.title);
        item->setData(What, Qt::UserRole, static_cast<int>(job.kind));
        auto* bar = m_list->itemWidget(item, Progress)->findChild<QProgressBar*>();
        bar->setRange(0, job.progress > 0.0 ? 100 : 0); // 0: it moves without telling how far
        bar->setValue(static_cast<int>(job.progress * 100.0));
        item->setText(
            Time,
            job.waiting
                ? tr("waiting")
                : tr("%1 s").arg(
                      locale.toString(static_cast<double>(job.elapsedMs) / 1000.0, 'f', 1)));
    }
}

QTreeWidgetItem* JobsPanel::addRow() {
    auto* item = new QTreeWidgetItem(m_list);
    item->setSizeHint(What, {0, kRowHeight});
    auto* bar = new QProgressBar;
    bar->setTextVisible(false);
    bar->setFixedHeight(kRowBarHeight);
    auto* middle = new QWidget; // of the row's height
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 8, 0);
    column->addWidget(bar);
    m_list->setItemWidget(item, Progress, middle);
    auto* stop = new QToolButton;
    stop->setObjectName(QStringLiteral("jobStop"));
    stop->setIcon(themeIcon(QStringLiteral("close")));
    stop->setIconSize({14, 14});
    stop->setAccessibleName(tr("Cancel"));
    stop->setToolTip(tr("Stops this work."));
    stop->setFocusPolicy(Qt::StrongFocus);
    m_list->setItemWidget(item, Stop, stop);
    connect(stop, &QToolButton::clicked, this, [this, item] {
        emit cancelWanted(static_cast<JobKind>(item->data(What, Qt::UserRole).toInt()));
    });
    return item;
}

} // namespace txn::app
