// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/JobRunner.h"

#include "app/threads/PoolWork.h"
#include "app/threads/ThreadPriority.h"
#include "app/threads/WorkArena.h"

#include <QThread>
#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>

namespace txn::app {
namespace {

/// So many cores may work at once; one stays with the interface.
int workingCores() {
    return std::max(1, QThread::idealThreadCount() - 1);
}

} // namespace

class JobRunner::Job final : public JobContext, public std::enable_shared_from_this<Job> {
  public:
    Job(JobRunner& runner, JobKind kind, QString title, Work work)
        : m_runner(runner), m_kind(kind), m_title(std::move(title)), m_work(std::move(work)),
          m_token(m_source.token()) {}

    const CancelToken& token() const override { return m_token; }
    void setProgress(double share) override { m_progress = std::clamp(share, 0.0, 1.0); }
    void deliver(Delivery delivery) override {
        {
            const std::lock_guard lock(m_mutex);
            const bool onTheWay = static_cast<bool>(m_delivery);
            m_delivery = std::move(delivery);
            if (onTheWay)
                return;
        }
        m_runner.m_mailbox.post([self = shared_from_this()] { self->takeDelivery(); });
    }

    JobKind kind() const { return m_kind; }
    void cancel() { m_source.cancel(); }
    void started() {
        m_clock.start();
        m_running = true;
    }
    Info info() const {
        Info info{m_kind, m_title, !m_running, m_progress, {}, 0};
        if (m_running) {
            info.elapsedMs = m_clock.elapsed();
            if (info.progress > 0.0 && info.elapsedMs > 300)
                info.remainingMs = static_cast<qint64>(static_cast<double>(info.elapsedMs) *
                                                       (1.0 / info.progress - 1.0));
        }
        return info;
    }
    Delivery run() { return cancelled() ? Delivery() : m_work(*this); }

  private:
    void takeDelivery() {
        Delivery delivery;
        {
            const std::lock_guard lock(m_mutex);
            delivery = std::exchange(m_delivery, nullptr);
        }
        if (delivery && !cancelled())
            delivery();
    }

    JobRunner& m_runner;
    JobKind m_kind;
    QString m_title;
    Work m_work;
    CancelSource m_source;
    CancelToken m_token;
    std::atomic<double> m_progress{0.0};
    bool m_running = false;
    QElapsedTimer m_clock;
    std::mutex m_mutex;
    Delivery m_delivery;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent), m_slots(kJobKinds) {
    // One of each kind: no long export keeps opening, saving or the live work waiting.
    m_pool.setMaxThreadCount(kJobKinds);
    m_pool.setExpiryTimeout(-1);
}

JobRunner::~JobRunner() {
    for (Slot& each : m_slots) {
        each.waiting.reset();
        if (each.running)
            each.running->cancel();
    }
    waitFor(m_pool);
}

void JobRunner::submit(JobKind kind, const QString& title, Work work) {
    auto job = std::make_shared<Job>(*this, kind, title, std::move(work));
    Slot& place = slot(kind);
    if (place.running) {
        place.running->cancel();
        place.waiting = std::move(job);
    } else {
        start(job);
    }
    emit jobsChanged();
}

void JobRunner::start(const std::shared_ptr<Job>& job) {
    slot(job->kind()).running = job;
    job->started();
    const auto work = [this, job] {
        thread_local bool yielded = false;
        if (!std::exchange(yielded, true))
            lowerThreadPriority(ThreadPriority::Computing);
        Delivery delivery;
        runOnCores(workingCores(), [&] { delivery = guarded(*job); });
        m_mailbox.post([this, job, delivery = std::move(delivery)] { finished(job, delivery); });
    };
    startOn(m_pool, work, kJobKinds - static_cast<int>(job->kind()));
}

QString JobRunner::outOfMemory() {
    return tr("there is not enough memory; try a smaller picture or size");
}

/// What a library throws ends the job, not the program.
Delivery JobRunner::guarded(Job& job) {
    try {
        return job.run();
    } catch (const std::bad_alloc&) {
        return [this, kind = job.kind()] { emit jobFailed(kind, outOfMemory()); };
    } catch (const std::exception& error) {
        return [this, kind = job.kind(), reason = QString::fromUtf8(error.what())] {
            emit jobFailed(kind, reason);
        };
    }
}

void JobRunner::finished(const std::shared_ptr<Job>& job, const Delivery& delivery) {
    Slot& place = slot(job->kind());
    place.running.reset();
    if (place.waiting)
        start(std::exchange(place.waiting, nullptr));
    if (delivery && !job->cancelled())
        delivery();
    job->cancel(); // whatever intermediate result is still on its way comes too late
    emit jobsChanged();
}

void JobRunner::cancel(JobKind kind) {
    Slot& place = slot(kind);
    if (!place.running)
        return;
    place.waiting.reset();
    place.running->cancel();
    emit jobsChanged();
}

void JobRunner::cancelAll() {
    for (int kind = 0; kind < kJobKinds; ++kind)
        cancel(static_cast<JobKind>(kind));
}

bool JobRunner::isBusy(JobKind kind) const {
    const Slot& place = slot(kind);
    return place.waiting || (place.running && !place.running->cancelled());
}

bool JobRunner::isRunning(JobKind kind) const {
    return slot(kind).running != nullptr;
}

bool JobRunner::isIdle() const {
    return std::none_of(m_slots.begin(), m_slots.end(), [](const Slot& each) {
        return each.running != nullptr;
    });
}

int JobRunner::activeThreads() const {
    return static_cast<int>(std::count_if(m_slots.begin(), m_slots.end(), [](const Slot& each) {
        return each.running != nullptr;
    }));
}

std::optional<JobRunner::Info> JobRunner::info(JobKind kind) const {
    const Slot& place = slot(kind);
    if (place.waiting)
        return place.waiting->info();
    if (place.running && !place.running->cancelled())
        return place.running->info();
    return std::nullopt;
}

std::vector<JobRunner::Info> JobRunner::infos() const {
    std::vector<Info> all;
    for (int kind = 0; kind < kJobKinds; ++kind) {
        if (const auto each = info(static_cast<JobKind>(kind)))
            all.push_back(*each);
    }
    return all;
}

} // namespace txn::app
