// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QProcess>
#include <QtTest>

namespace {

QStringList targets() {
    return QStringLiteral(TXN_FUZZ_TARGETS).split(' ');
}

} // namespace

/// Files that once broke a reader, each kept in data/fuzz/TARGET, are shown to it again.
class TestFuzzCorpus : public QObject {
    Q_OBJECT

    /// What the program says at the end, or "ok".
    static QString outcome(const QString& target, const QStringList& arguments) {
        QProcess program;
        program.start(QStringLiteral(TXN_FUZZ_PROGRAMS "/replay_") + target, arguments);
        if (!program.waitForStarted())
            return QStringLiteral("does not start: ") + program.errorString();
        // What is slow to refuse is a way to hang the program.
        if (!program.waitForFinished(30000)) {
            program.kill();
            program.waitForFinished();
            return QStringLiteral("takes too long");
        }
        if (program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0)
            return QStringLiteral("ok");
        return QString::fromLocal8Bit(program.readAllStandardError()).right(2000) +
               QStringLiteral(" exit code %1").arg(program.exitCode());
    }

  private slots:
    void readersStand_data() {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("argument");
        for (const QString& target : targets()) {
            // All seeds are read, and accepted.
            QTest::addRow("%s seeds", qPrintable(target)) << target << QStringLiteral("--check");
            const QDir folder(QStringLiteral(TXN_TEST_DATA "/fuzz/") + target);
            for (const QString& name : folder.entryList(QDir::Files))
                QTest::addRow("%s/%s", qPrintable(target), qPrintable(name))
                    << target << folder.filePath(name);
        }
    }
    void readersStand() {
        QFETCH(const QString, target);
        QFETCH(const QString, argument);
        QCOMPARE(outcome(target, {argument}), QStringLiteral("ok"));
    }
};

QTEST_GUILESS_MAIN(TestFuzzCorpus)
#include "TestFuzzCorpus.moc"
