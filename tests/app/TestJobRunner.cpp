// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/JobRunner.h"
#include "app/threads/Mailbox.h"
#include "tests/helpers/Verify.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>
#include <new>
#include <thread>

using namespace txn::app;
using namespace std::chrono_literals;

namespace {

/// Works until it is cancelled or released.
Work busyUntil(std::atomic<bool>& release, std::atomic<int>& running, Delivery delivery = {}) {
    return [&release, &running, delivery = std::move(delivery)](JobContext& context) -> Delivery {
        ++running;
        while (!context.cancelled() && !release)
            std::this_thread::sleep_for(1ms);
        --running;
        return delivery;
    };
}

} // namespace

class TestJobRunner : public QObject {
    Q_OBJECT

  private slots:
    void deliversOnTheInterfaceThread() {
        JobRunner runner;
        QThread* deliveredOn = nullptr;
        QThread* workedOn = nullptr;
        runner.submit(JobKind::Texton, "work", [&](JobContext&) -> Delivery {
            workedOn = QThread::currentThread();
            return [&] { deliveredOn = QThread::currentThread(); };
        });
        TXN_COMES_TRUE(deliveredOn != nullptr);
        QCOMPARE(deliveredOn, QThread::currentThread());
        QVERIFY(workedOn != deliveredOn);
        TXN_COMES_TRUE(runner.isIdle());
    }

    void theNewestRequestWins() {
        JobRunner runner;
        std::vector<int> delivered;
        std::atomic<int> started{0};
        for (int i = 0; i < 50; ++i) {
            runner.submit(JobKind::Texton, "work", [&, i](JobContext& context) -> Delivery {
                ++started;
                while (!context.cancelled() && i < 49)
                    std::this_thread::sleep_for(1ms);
                return [&delivered, i] { delivered.push_back(i); };
            });
        }
        TXN_COMES_TRUE(runner.isIdle());
        QCOMPARE(delivered, std::vector<int>{49});
        // The first one was at work, all others but the last never started.
        QVERIFY(started <= 2);
    }

    void oneRunsAndOneWaitsOfEachKind() {
        JobRunner runner;
        std::atomic<bool> release{false};
        std::atomic<int> running{0};
        int most = 0;
        for (int i = 0; i < 5; ++i) {
            runner.submit(JobKind::Gaussian, "work", busyUntil(release, running));
            QTest::qWait(5);
            most = std::max(most, running.load());
            QVERIFY(runner.infos().size() <= 1);
        }
        QCOMPARE(most, 1);
        release = true;
        TXN_COMES_TRUE(runner.isIdle());
    }

    void nothingIsDeliveredAfterCancel() {
        JobRunner runner;
        std::atomic<bool> release{false};
        std::atomic<int> running{0};
        bool delivered = false;
        runner.submit(JobKind::Export, "work", busyUntil(release, running, [&] {
                          delivered = true;
                      }));
        TXN_BECOMES(running.load(), 1);
        runner.cancel(JobKind::Export);
        QVERIFY(!runner.isBusy(JobKind::Export));
        QVERIFY(!runner.info(JobKind::Export));
        TXN_COMES_TRUE(runner.isIdle());
        QTest::qWait(20);
        QVERIFY(!delivered);
    }

    void intermediateResultsStopAtCancel() {
        JobRunner runner;
        int shown = 0;
        std::atomic<int> sent{0};
        runner.submit(JobKind::Texton, "work", [&](JobContext& context) -> Delivery {
            while (!context.cancelled()) {
                context.deliver([&] { ++shown; });
                ++sent;
                std::this_thread::sleep_for(1ms);
            }
            context.deliver([&] { shown += 1000; });
            return [&] { shown += 1000; };
        });
        TXN_COMES_TRUE(shown > 3);
        runner.cancel(JobKind::Texton);
        const int atCancel = shown;
        TXN_COMES_TRUE(runner.isIdle());
        QTest::qWait(20);
        QCOMPARE(shown, atCancel);
        QVERIFY(sent >= shown);
    }

    void aSlowInterfaceGetsTheLastIntermediateResultOnly() {
        JobRunner runner;
        std::vector<int> shown;
        std::atomic<bool> all{false};
        std::atomic<bool> release{false};
        runner.submit(JobKind::Texton, "work", [&](JobContext& context) -> Delivery {
            for (int i = 0; i < 100; ++i)
                context.deliver([&shown, i] { shown.push_back(i); });
            all = true;
            while (!release)
                std::this_thread::sleep_for(1ms);
            return {};
        });
        while (!all)
            std::this_thread::sleep_for(1ms); // the interface does not look meanwhile
        TXN_BECOMES(shown, std::vector<int>{99});
        release = true;
        TXN_COMES_TRUE(runner.isIdle());
    }

    void progressTellsTheRemainingTime() {
        JobRunner runner;
        std::atomic<bool> release{false};
        runner.submit(JobKind::Texton, "work", [&](JobContext& context) -> Delivery {
            context.setProgress(0.5);
            while (!release)
                std::this_thread::sleep_for(1ms);
            return {};
        });
        TXN_COMES_TRUE(runner.info(JobKind::Texton)->remainingMs.has_value());
        const auto info = *runner.info(JobKind::Texton);
        QCOMPARE(info.title, "work");
        QVERIFY(std::abs(info.progress - 0.5) <= 1e-9);
        // Half of it done: as long again.
        QVERIFY(std::abs(static_cast<double>(*info.remainingMs - info.elapsedMs)) <= 5.0);
        release = true;
        TXN_COMES_TRUE(runner.isIdle());
    }

    void whatIsThrownEndsTheJobOnly() {
        JobRunner runner;
        QSignalSpy failed(&runner, &JobRunner::jobFailed);
        runner.submit(JobKind::Mesh, "work", [](JobContext&) -> Delivery {
            throw std::bad_alloc();
        });
        TXN_BECOMES(failed.count(), 1);
        QVERIFY(failed.first().at(1).toString().contains("memory"));
        bool delivered = false;
        runner.submit(JobKind::Mesh, "work", [&](JobContext&) -> Delivery {
            return [&] { delivered = true; };
        });
        TXN_COMES_TRUE(delivered);
    }

    void endsWhileJobsRun() {
        std::atomic<bool> release{false};
        std::atomic<int> running{0};
        {
            JobRunner runner;
            for (const JobKind kind : {JobKind::Texton, JobKind::Gaussian, JobKind::Export})
                runner.submit(kind, "work", busyUntil(release, running));
            TXN_COMES_TRUE(running >= 1);
        }
        QCOMPARE(running.load(), 0);
    }

    void lettersComeInOrderAndNotToThoseWhoLeft() {
        auto mailbox = std::make_unique<Mailbox>();
        std::vector<int> taken;
        const auto post = [&](int from, int to) {
            std::thread([&, from, to] {
                for (int i = from; i < to; ++i)
                    mailbox->post([&taken, i] { taken.push_back(i); });
            }).join();
        };
        post(0, 100);
        QVERIFY(taken.empty()); // never on the thread that posts
        TXN_BECOMES(taken.size(), std::size_t{100});
        QVERIFY(std::is_sorted(taken.begin(), taken.end()));
        post(100, 200);
        mailbox.reset();
        QCoreApplication::processEvents();
        QCOMPARE(taken.size(), std::size_t{100});
    }
};

QTEST_MAIN(TestJobRunner)
#include "TestJobRunner.moc"
