// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/threads/Mailbox.h"
#include "core/base/CancelToken.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace txn::app {

/// One job of each kind runs at a time; earlier kinds go first where threads are short.
enum class JobKind {
    Open,
    Exemplar,
    SecondExemplar,
    Texton,
    Mix,
    Gaussian,
    Mesh,
    Verdict,
    Analysis,
    Save,
    Picture,
    Export,
    Autosave
};
inline constexpr int kJobKinds = 13;

/// What a finished job leaves to be done on the interface thread.
using Delivery = std::function<void()>;

/// What a job sees of the world, on its worker thread.
class JobContext {
  public:
    virtual ~JobContext() = default;
    virtual const CancelToken& token() const = 0;
    bool cancelled() const { return token().cancelled(); }
    /// 0 to 1.
    virtual void setProgress(double share) = 0;
    /// Runs on the interface thread, unless the job has been cancelled or replaced by then. A
    /// delivery that has not run yet when the next one comes is dropped.
    virtual void deliver(Delivery delivery) = 0;
};

/// Runs on a worker thread on values it has copied; touches no QObject and no OpenGL.
using Work = std::function<Delivery(JobContext&)>;

/// Runs jobs on threads of its own, at low priority and on all cores but one. Of each kind at most
/// one runs and one waits: a newer one takes the place of the waiting one and asks the running one
/// to end, whose results are dropped from that moment on. Lives on the interface thread.
class JobRunner : public QObject {
    Q_OBJECT

  public:
    struct Info {
        JobKind kind = JobKind::Open;
        QString title;
        bool waiting = false;
        double progress = 0.0;
        std::optional<qint64> remainingMs; ///< once it can be told
        qint64 elapsedMs = 0;
    };

    explicit JobRunner(QObject* parent = nullptr);
    /// Cancels everything and waits for the threads.
    ~JobRunner() override;

    void submit(JobKind kind, const QString& title, Work work);
    /// The running and the waiting one: nothing of theirs is delivered any more.
    void cancel(JobKind kind);
    void cancelAll();

    /// Whether one runs or waits that has not been cancelled.
    bool isBusy(JobKind kind) const;
    /// Whether a thread is at work for it, cancelled or not.
    bool isRunning(JobKind kind) const;
    bool isIdle() const;
    /// Threads that are still at work, cancelled jobs included.
    int activeThreads() const;
    std::optional<Info> info(JobKind kind) const;
    std::vector<Info> infos() const;

    /// The reason, for messages.
    static QString outOfMemory();

  signals:
    /// Some job started, ended, waits, or was cancelled.
    void jobsChanged();
    /// The job ran out of memory or met another error that nobody expected; it leaves no result.
    void jobFailed(JobKind kind, const QString& reason);

  private:
    class Job;
    struct Slot {
        std::shared_ptr<Job> running;
        std::shared_ptr<Job> waiting;
    };

    void start(const std::shared_ptr<Job>& job);
    void finished(const std::shared_ptr<Job>& job, const Delivery& delivery);
    Delivery guarded(Job& job);
    Slot& slot(JobKind kind) { return m_slots[static_cast<std::size_t>(kind)]; }
    const Slot& slot(JobKind kind) const { return m_slots[static_cast<std::size_t>(kind)]; }

    std::vector<Slot> m_slots;
    Mailbox m_mailbox;
    QThreadPool m_pool;
};

} // namespace txn::app
