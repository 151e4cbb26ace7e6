// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory/Guarded.h"
#include "app/pipeline/Pipeline.h"
#include "app/views/NoiseService.h"
#include "tests/faults/Shim.h"
#include "tests/helpers/Tally.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QCoreApplication>
#include <QtTest>

#include <unistd.h>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

constexpr std::size_t kLarge = 32 << 10; ///< smaller ones are not where memory ends

std::shared_ptr<const Source> sample(const char* name) {
    const auto source = sampleSource(QLatin1String(name));
    return source ? *source : nullptr;
}

/// Whether an event could not be handled.
bool eventsEnded = false;

/// A document with its pipeline, and what an artist would be told.
struct Studio {
    ProjectDocument document;
    JobRunner runner;
    Pipeline pipeline{document, runner};
    QStringList messages;

    Studio() {
        const auto note = [this](const QString& message) { messages.append(message); };
        QObject::connect(&pipeline, &Pipeline::failed, note);
        QObject::connect(&runner, &JobRunner::jobFailed, [note](JobKind, const QString& reason) {
            note(reason);
        });
    }
    void open(bool mixed) {
        document.change(QStringLiteral("Open"), [&](Project& project) {
            static const auto first = sample("rust");
            static const auto second = sample("sand");
            project.source = first;
            project.edit.crop = Rect{0, 0, {128, 96}};
            project.texton.support = {16, 16};
            project.texton.iterations = 5;
            if (mixed) {
                project.mix.source = second;
                project.mix.edit.crop = Rect{0, 0, {128, 96}};
                project.mix.textons = 3;
            }
        });
    }
    /// No job runs, and none follows.
    bool rests() {
        int calm = 0;
        return QTest::qWaitFor(
            [&] {
                calm = runner.isIdle() ? calm + 1 : 0;
                return calm == 4;
            },
            kPatienceMs);
    }
    bool isDone() const {
        return pipeline.texton() && pipeline.texton()->finished &&
               !pipeline.isStale(Picture::Noise) && !pipeline.isStale(Picture::Gaussian) &&
               (!document.project().mix.source || (pipeline.mix() && pipeline.mix()->finished));
    }
};

} // namespace

/// From the n-th large allocation on there is no memory: the job says so, and the program lives on.
/// TXN_TORTURE=long: n = 1 to 100 instead of every seventh.
class TestMemoryFaults : public QObject {
    Q_OBJECT

    Tally m_tally;

  private slots:
    void theProgramLivesOn_data() {
        QTest::addColumn<bool>("mixed");
        QTest::newRow("one material") << false;
        QTest::newRow("a mixture") << true;
    }
    void theProgramLivesOn() {
        QFETCH(bool, mixed);
        Studio sound;
        sound.open(mixed);
        QVERIFY(sound.rests());
        QVERIFY(sound.isDone() && sound.messages.isEmpty());
        int refusals = 0;
        for (int n = 1; n <= 100; n += isLong() ? 1 : 7) {
            Studio studio;
            eventsEnded = false;
            failMemory(n - 1, kLarge);
            studio.open(mixed);
            const bool rests = studio.rests();
            const long refused = failMemory(-1, kLarge);
            refusals += refused > 0 ? 1 : 0;
            QString problem;
            if (!rests)
                problem = QStringLiteral("never rests");
            else if (refused > 0 && studio.messages.isEmpty() && !eventsEnded && !studio.isDone())
                problem = QStringLiteral("says nothing");
            // With memory again, computing again brings all of it, the same as ever.
            studio.messages.clear();
            studio.pipeline.recomputeTexton();
            if (!studio.rests() || !studio.isDone() || !studio.messages.isEmpty())
                problem += QStringLiteral(" does not recover %1").arg(studio.messages.join(' '));
            else if (!(studio.pipeline.texton()->texton == sound.pipeline.texton()->texton))
                problem += QStringLiteral(" computes something else");
            count(n, problem);
        }
        QVERIFY(refusals > 0);
        QCOMPARE(m_tally.bad(), 0);
    }

    void theNoiseIsDrawnAgain() {
        NoiseService service;
        NoiseFeed feed(service);
        int failures = 0;
        QObject::connect(&feed, &NoiseFeed::failed, [&](const QString&) { ++failures; });
        NoiseRequest request;
        request.texton = std::make_shared<const Texton>(makeTexton({}));
        request.size = {320, 200};
        const auto want = [&](std::uint32_t seed) {
            request.style.noise.seed = Seed{seed};
            failures = 0;
            feed.request(request);
            return QTest::qWaitFor([&] { return feed.isCurrent() || failures > 0; }, kPatienceMs);
        };
        // FFTW ends the program where there is no memory for the tables of its first plan.
        QVERIFY(want(1) && failures == 0);
        int refusals = 0;
        for (int n = 1; n <= (isLong() ? 20 : 6); ++n) {
            failMemory(n - 1, kLarge);
            QString problem = want(static_cast<std::uint32_t>(2 * n))
                                  ? QString()
                                  : QStringLiteral("neither noise nor a message");
            refusals += failMemory(-1, kLarge) > 0 ? 1 : 0;
            if (!want(static_cast<std::uint32_t>(2 * n + 1)) || failures > 0)
                problem += QStringLiteral(" no noise afterwards");
            count(n, problem);
        }
        QVERIFY(refusals > 0);
        QCOMPARE(m_tally.bad(), 0);
    }

  private:
    void count(int n, const QString& problem) {
        m_tally.count("memory ends at the n-th large allocation",
                      problem,
                      QStringLiteral("n = %1").arg(n));
    }
};

int main(int argc, char** argv) {
    if (!hasShim()) {
        ::setenv("LD_PRELOAD", TXN_FAULT_SHIM, 1);
        ::execv("/proc/self/exe", argv);
    }
    Guarded<QCoreApplication> application(argc, argv);
    application.outOfMemory = [] { eventsEnded = true; };
    TestMemoryFaults test;
    return QTest::qExec(&test, argc, argv);
}
#include "TestMemoryFaults.moc"
