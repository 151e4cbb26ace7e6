// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"
#include "app/files/Autosave.h"
#include "app/files/RecoveryDialog.h"
#include "tests/app/Studio.h"
#include "tests/helpers/Verify.h"

#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <csignal>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

constexpr int kAtOnceMs = 20;

/// Hard to compute again: somebody painted it.
PaintedMap paintedMap() {
    Image map({64, 32}, 1);
    for (int x = 0; x < map.width(); ++x)
        map.at(x, x % map.height(), 0) = 1.0F;
    return PaintedMap::fromImage(map);
}

/// The program that will be killed: changes something, waits for the copy, says so, and goes on
/// until it dies.
int beKilled(const QString& home, double contrast) {
    Settings settings(home + "/settings.ini");
    ProjectDocument document;
    JobRunner runner;
    Autosave autosave(document, runner, home + "/recovery", kAtOnceMs);
    const auto source = sampleSource("sand");
    document.change("Open", [&](Project& p) { p.source = *source; });
    document.change("Contrast", [&](Project& p) {
        p.noise.contrast = contrast;
        p.edit.crop = Rect{10, 20, {300, 200}};
        p.mix.source = *sampleSource("cloth");
        p.mix.map = paintedMap();
    });
    if (!waitFor([&] { return QFileInfo::exists(autosave.file()); }))
        return 1;
    std::puts("copied");
    std::fflush(stdout);
    // Some more copies, so that some kills fall into the middle of one.
    for (int i = 0; i < 100000; ++i) {
        document.change("Seed",
                        [i](Project& p) { p.noise.seed = Seed{static_cast<std::uint32_t>(i)}; });
        QTest::qWait(1);
    }
    return 1;
}

constexpr int kSteps = 20;
constexpr int kSavedAfter = 8;

/// A step of a story: everything that a project holds is changed by one of them.
void takeStep(Project& project, int step) {
    project.noise.seed = Seed{static_cast<std::uint32_t>(step)};
    switch (step % 5) {
    case 0:
        project.texton.support = {8 + step, 8 + step};
        break;
    case 1:
        project.source = *sampleSource(step < kSteps / 2 ? "sand" : "stone");
        break;
    case 2:
        project.noise.contrast = 0.5 + 0.01 * step;
        break;
    case 3:
        project.mix.source = *sampleSource("cloth");
        project.mix.map = paintedMap();
        break;
    default:
        project.edit.crop = Rect{step, step, {64, 64}};
    }
}

/// Lives through the story up to a step, whose copy is made, and dies of a bug.
int abortAt(const QString& home, int last) {
    const QString original = home + "/story.txnproj";
    ProjectDocument document;
    JobRunner runner;
    Autosave autosave(document, runner, home + "/recovery", kAtOnceMs);
    for (int step = 1; step <= last; ++step) {
        document.change("Step", [step](Project& p) { takeStep(p, step); });
        if (step == kSavedAfter && last > step) {
            if (!saveProject(document.project(), document.view(), original))
                return 1;
            document.setSaved(original);
        }
    }
    const auto isCopied = [&] {
        const auto copy = readRecovered({autosave.file(), {}, {}, {}, {}});
        return copy && copy->project.noise.seed.value == static_cast<std::uint32_t>(last);
    };
    if (!waitFor(isCopied))
        return 1;
    std::puts("copied");
    std::fflush(stdout);
    std::abort();
}

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

void runAndKill(const QString& home, double contrast, int afterMs) {
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QCoreApplication::applicationFilePath(),
                  {"--be-killed", home, QString::number(contrast)});
    QVERIFY(program.waitForReadyRead(30000));
    QCOMPARE(program.readAllStandardOutput().trimmed(), "copied");
    QTest::qSleep(afterMs);
    ::kill(static_cast<pid_t>(program.processId()), SIGKILL);
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);
}

} // namespace

class TestRecovery : public QObject {
    Q_OBJECT

    /// A program started in the home of one that was killed.
    struct Next {
        explicit Next(const QString& home)
            : settings(home + "/settings.ini"), studio(settings, home + "/recovery") {
            studio.window().show();
            studio.start({});
        }
        RecoveryDialog* dialog() { return studio.window().findChild<RecoveryDialog*>(); }
        Settings settings;
        Application studio;
    };

  private slots:
    void workComesBackAfterAKill_data() {
        QTest::addColumn<int>("afterMs");
        for (const int ms : {0, 3, 10, 27, 60})
            QTest::addRow("%d ms", ms) << ms;
    }
    void workComesBackAfterAKill() {
        QFETCH(int, afterMs);
        QTemporaryDir home;
        runAndKill(home.path(), 0.75, afterMs);
        Next next(home.path());
        TXN_COMES_TRUE(next.dialog() != nullptr);
        // What would come back is seen before it is chosen.
        QVERIFY(next.dialog()
                    ->findChild<QListWidget*>("recoveryList")
                    ->item(0)
                    ->text()
                    .contains("sand.png"));
        bool picture = false;
        for (const QLabel* label : next.dialog()->findChildren<QLabel*>())
            picture = picture || label->pixmap().width() >= 150;
        QVERIFY(picture);
        next.dialog()->findChild<QPushButton*>("recoveryRecover")->click();
        TXN_BECOMES(next.studio.document().project().noise.contrast, 0.75);
        QCOMPARE(*next.studio.document().project().edit.crop, (Rect{10, 20, {300, 200}}));
        const MixSettings& mix = next.studio.document().project().mix;
        QVERIFY(mix.source && mix.source->sample() == "cloth");
        QVERIFY(mix.map == paintedMap());
        // It is still to be saved, and a second crash would not lose it.
        QVERIFY(next.studio.document().isModified());
        const QDir folder(home.filePath("recovery"));
        QCOMPARE(folder.entryList({"*.recovery"}, QDir::Files).size(), 1);
        // Nothing else of the program that died is left.
        for (const QString& file : folder.entryList(QDir::Files))
            QVERIFY2(file.endsWith(".recovery") || file.endsWith(".recovery.lock"),
                     qPrintable(file));
        QVERIFY(folder.entryList({"*.lock"}, QDir::Files).size() == 1);
    }

    void laterMeansLater() {
        QTemporaryDir home;
        runAndKill(home.path(), 0.5, 0);
        for (int i = 0; i < 2; ++i) {
            Next next(home.path());
            TXN_COMES_TRUE(next.dialog() != nullptr);
            next.dialog()->findChild<QPushButton*>("recoveryLater")->click();
            TXN_COMES_TRUE(next.studio.document().project().source != nullptr);
            QCOMPARE(next.studio.document().project().source->sample(), "rust");
        }
        Next next(home.path());
        TXN_COMES_TRUE(next.dialog() != nullptr);
        next.dialog()->findChild<QPushButton*>("recoveryDiscard")->click();
        TXN_COMES_TRUE(next.dialog() == nullptr || !next.dialog()->isVisible());
        QVERIFY(!mayBeRecoverable(home.filePath("recovery")));
    }

    void theNewestOfSeveralIsFirst() {
        QTemporaryDir home;
        runAndKill(home.path(), 0.5, 0);
        QTest::qSleep(20);
        runAndKill(home.path(), 0.6, 0);
        const auto copies = findRecoverable(home.filePath("recovery"));
        QCOMPARE(copies.size(), std::size_t{2});
        const auto newest = readRecovered(copies.front());
        QVERIFY(newest && newest->project.noise.contrast == 0.6);
    }

    void theNewestWholeCopyIsOffered() {
        QTemporaryDir home;
        runAndKill(home.path(), 0.5, 0);
        const QDir folder(home.filePath("recovery"));
        const QString older = folder.entryList({"*.recovery"}, QDir::Files).value(0);
        runAndKill(home.path(), 0.6, 0);
        QString newer;
        for (const QString& name : folder.entryList({"*.recovery"}, QDir::Files))
            newer = name == older ? newer : name;
        // Dates of files say nothing.
        QFile old(folder.filePath(older));
        QVERIFY(old.open(QIODevice::ReadWrite));
        QVERIFY(old.setFileTime(QDateTime::currentDateTime().addDays(1),
                                QFileDevice::FileModificationTime));
        old.close();
        auto copies = findRecoverable(folder.path());
        QCOMPARE(copies.size(), std::size_t{2});
        QCOMPARE(QFileInfo(copies.front().file).fileName(), newer);
        // A bit is lost somewhere in it.
        QByteArray bytes = read(folder.filePath(newer));
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        QVERIFY(write(folder.filePath(newer), bytes));
        copies = findRecoverable(folder.path());
        QCOMPARE(copies.size(), std::size_t{1});
        QCOMPARE(QFileInfo(copies.front().file).fileName(), older);
        QVERIFY(folder.exists(newer)); // perhaps somebody can make something of it
        Next next(home.path());
        TXN_COMES_TRUE(next.dialog() != nullptr);
        next.dialog()->findChild<QPushButton*>("recoveryRecover")->click();
        TXN_BECOMES(next.studio.document().project().noise.contrast, 0.5);
    }

    void copiesThatAreCutOffArePassedOver() {
        QTemporaryDir home;
        runAndKill(home.path(), 0.5, 0);
        const QDir folder(home.filePath("recovery"));
        const QString file = folder.filePath(folder.entryList({"*.recovery"}, QDir::Files).first());
        const QByteArray whole = read(file);
        QCOMPARE(findRecoverable(folder.path()).size(), std::size_t{1});
        const qsizetype step = std::max<qsizetype>(1, whole.size() / 200);
        for (qsizetype length = 0; length < whole.size();
             length += length < 300 ? qsizetype{1} : step) {
            QVERIFY(write(file, whole.left(length)));
            QVERIFY2(findRecoverable(folder.path()).empty(), qPrintable(QString::number(length)));
        }
    }

    void abortedAnywhereTheLastCopyComesBack_data() {
        QTest::addColumn<int>("step");
        for (int step = 1; step <= kSteps; ++step)
            QTest::addRow("step %d", step) << step;
    }
    void abortedAnywhereTheLastCopyComesBack() {
        QFETCH(int, step);
        QTemporaryDir home;
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(),
                      {"--abort-at", home.path(), QString::number(step)});
        QVERIFY(program.waitForFinished(30000));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);
        QVERIFY2(program.readAllStandardOutput().contains("copied"), "no copy was made");
        // The file that was saved on the way is as it was saved.
        const QString original = home.filePath("story.txnproj");
        QCOMPARE(QFileInfo::exists(original), step > kSavedAfter);
        if (step > kSavedAfter) {
            const auto saved = openProject(original);
            TXN_OK(saved);
            QCOMPARE(saved->project.noise.seed.value, std::uint32_t{kSavedAfter});
        }
        const auto copies = findRecoverable(home.filePath("recovery"));
        QCOMPARE(copies.size(), std::size_t{1});
        QCOMPARE(copies.front().originalPath, step > kSavedAfter ? original : QString());
        const auto copy = readRecovered(copies.front());
        TXN_OK(copy);
        Project wanted;
        for (int i = 1; i <= step; ++i)
            takeStep(wanted, i);
        QVERIFY(copy->project.noise == wanted.noise);
        QVERIFY(copy->project.texton == wanted.texton);
        QVERIFY(copy->project.mix.map == wanted.mix.map);
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == "--abort-at")
        return abortAt(arguments.value(2), arguments.value(3).toInt());
    if (arguments.value(1) == "--be-killed")
        return beKilled(arguments.value(2), arguments.value(3).toDouble());
    TestRecovery test;
    return QTest::qExec(&test, argc, argv);
}
#include "TestRecovery.moc"
