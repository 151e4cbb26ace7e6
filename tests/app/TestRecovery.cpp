// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"
#include "app/files/RecoveryDialog.h"
#include "tests/app/Studio.h"

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
        QTRY_VERIFY(next.dialog() != nullptr);
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
        QTRY_COMPARE(next.studio.document().project().noise.contrast, 0.75);
        QCOMPARE(*next.studio.document().project().edit.crop, (Rect{10, 20, {300, 200}}));
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
            QTRY_VERIFY(next.dialog() != nullptr);
            next.dialog()->findChild<QPushButton*>("recoveryLater")->click();
            QTRY_VERIFY(next.studio.document().project().source != nullptr);
            QCOMPARE(next.studio.document().project().source->sample(), "rust");
        }
        Next next(home.path());
        QTRY_VERIFY(next.dialog() != nullptr);
        next.dialog()->findChild<QPushButton*>("recoveryDiscard")->click();
        QTRY_VERIFY(next.dialog() == nullptr || !next.dialog()->isVisible());
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

    void aDamagedCopyIsToldAndKept() {
        QTemporaryDir home;
        runAndKill(home.path(), 0.5, 0);
        const QDir folder(home.filePath("recovery"));
        const QString name = folder.entryList({"*.recovery"}, QDir::Files).value(0);
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        file.close();
        const auto at = bytes.indexOf("texton-studio-project");
        QVERIFY(at > 0);
        bytes[at] = 'X';
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        Next next(home.path());
        QTRY_VERIFY(next.dialog() != nullptr);
        next.dialog()->findChild<QPushButton*>("recoveryRecover")->click();
        QTRY_VERIFY(next.studio.window().findChild<QLabel*>("messageText")->text().contains(name));
        QVERIFY(file.exists());
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == "--be-killed")
        return beKilled(arguments.value(2), arguments.value(3).toDouble());
    TestRecovery test;
    return QTest::qExec(&test, argc, argv);
}
#include "TestRecovery.moc"
