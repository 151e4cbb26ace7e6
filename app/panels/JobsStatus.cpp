// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/JobsStatus.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <algorithm>

namespace txn::app {
namespace {

constexpr int kStatusPollMs = 100;
constexpr qint64 kNoticeableMs = 250;
constexpr int kBarWidth = 96;
constexpr int kStatusBarHeight = 4;

} // namespace

JobsStatus::JobsStatus(JobRunner& runner, QWidget* parent)
    : QWidget(parent), m_runner(runner), m_title(new QLabel), m_bar(new QProgressBar) {
    setObjectName(QStringLiteral("jobsStatus"));
    m_title->setObjectName(QStringLiteral("jobsStatusTitle"));
    m_bar->setObjectName(QStringLiteral("jobsStatusBar"));
    m_bar->setAccessibleName(tr("Progress"));
    m_bar->setToolTip(tr("How far the work is. The Jobs panel lists all of it."));
    m_bar->setRange(0, 100);
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(kBarWidth, kStatusBarHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_title);
    row->addWidget(m_bar);
    m_poll.setInterval(kStatusPollMs);
    connect(&m_poll, &QTimer::timeout, this, &JobsStatus::showJobs);
    connect(&m_runner, &JobRunner::jobsChanged, this, &JobsStatus::showJobs);
    showJobs();
}

void JobsStatus::showJobs() {
    const auto jobs = m_runner.infos();
    if (jobs.empty())
        m_poll.stop();
    else if (!m_poll.isActive())
        m_poll.start();
    // The kinds are in the order in which they are waited for.
    const auto job = std::find_if(jobs.begin(), jobs.end(), [](const JobRunner::Info& each) {
        return each.kind != JobKind::Autosave && each.elapsedMs >= kNoticeableMs;
    });
    m_title->setVisible(job != jobs.end());
    m_bar->setVisible(job != jobs.end());
    if (job == jobs.end())
        return;
    m_title->setText(job->title);
    m_bar->setValue(static_cast<int>(job->progress * 100.0));
}

} // namespace txn::app
