// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"
#include "tests/faults/Victim.h"
#include "tests/helpers/Tally.h"
#include "tests/helpers/Verify.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QtTest>

#include <chrono>
#include <csignal>
#include <cstring>
#include <random>
#include <sys/mount.h>
#include <sys/resource.h>
#include <thread>

using namespace txn::app;
using namespace txn::test;

namespace {

constexpr int kMostCalls = 50;

using Content = std::map<QString, QByteArray>;
using Variables = std::map<QString, QString>;

struct End {
    int code = 0;
    bool killed = false;
    bool reached = false; ///< the call that was to fail
    QString message;
};

/// Kinds of the command line, beside those of runVictim.
const QStringList kPrograms{QStringLiteral("texton noise"), QStringLiteral("texton compute")};

QStringList allKinds() {
    if (isLong())
        return kVictimKinds + kPrograms;
    return {QStringLiteral("project"),
            QStringLiteral("autosave"),
            QStringLiteral("mixture"),
            kPrograms.back()};
}

QByteArray readFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
}

bool isLeftover(const QString& name) {
    return QFileInfo(name).fileName().startsWith(QLatin1String(".texton-"));
}

/// Copies of unsaved work have names by chance: they count for what comes back of them.
Content contentOfCopies(const QString& folder) {
    Content content;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden)) {
        if (name.endsWith(QLatin1String(".recovery"))) {
            RecoveredProject copy;
            copy.file = folder + QLatin1Char('/') + name;
            const auto saved = readRecovered(copy);
            content[QStringLiteral("copy")] =
                saved ? QByteArray::number(saved->project.noise.contrast)
                      : QByteArray("damaged: ") + saved.error().message.c_str();
        } else if (!name.endsWith(QLatin1String(".lock"))) {
            content[name] = {};
        }
    }
    return content;
}

Content contentOf(const QString& kind, const QString& folder) {
    if (kind == QLatin1String("autosave"))
        return contentOfCopies(folder);
    Content content;
    QDirIterator files(folder,
                       QDir::Files | QDir::Hidden | QDir::System,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString file = files.next();
        content[QDir(folder).relativeFilePath(file)] = readFile(file);
    }
    return content;
}

/// What is not as it has to be, or empty. Files of a killed program may be of either kind; other
/// than that, all are old or all are new.
QString judged(const End& end, const Content& now, const Content& old, const Content& wanted) {
    if (end.killed) {
        for (const auto& [name, bytes] : now) {
            const auto before = old.find(name);
            const auto after = wanted.find(name);
            const bool isOld = before != old.end() && before->second == bytes;
            const bool isNew = after != wanted.end() && after->second == bytes;
            if (!isOld && !isNew && !isLeftover(name))
                return name + QStringLiteral(" is neither the old nor the new one");
        }
        for (const auto& [name, bytes] : old) {
            if (now.count(name) == 0)
                return name + QStringLiteral(" is gone");
        }
        return {};
    }
    const QString said = QStringLiteral(" (%1)").arg(end.message);
    if (end.code != kDone && end.code != kRefused)
        return QStringLiteral("ended with %1").arg(end.code) + said;
    if (end.code == kRefused && end.message.isEmpty())
        return QStringLiteral("no message");
    const Content& right = end.code == kDone ? wanted : old;
    if (now == right)
        return {};
    for (const auto& [name, bytes] : now) {
        const auto other = right.find(name);
        if (other == right.end())
            return QStringLiteral("left ") + name + said;
        if (other->second != bytes)
            return name + QStringLiteral(" is not the right one") + said;
    }
    return QStringLiteral("a file is gone") + said;
}

} // namespace

/// Saving, copying unsaved work and exporting, in programs of their own that things happen to.
/// TXN_TORTURE=long: all of it.
class TestFileFaults : public QObject {
    Q_OBJECT

    Tally m_tally;
    QTemporaryDir m_home;
    std::map<QString, Content> m_old; ///< variant 1 of each kind
    std::map<QString, Content> m_new;

    QString path(const QString& name) const { return m_home.filePath(name); }

    QProcess* prepared(const QString& kind,
                       const QString& folder,
                       int variant,
                       const Variables& variables,
                       const std::function<void()>& limits = {}) {
        auto* program = new QProcess(this);
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_PRELOAD", TXN_FAULT_SHIM);
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("TXN_FAULT_UNDER", folder);
        environment.insert("TXN_FAULT_MARK", path("mark"));
        for (const auto& [name, value] : variables)
            environment.insert(name, value);
        program->setProcessEnvironment(environment);
        if (limits)
            program->setChildProcessModifier(limits);
        const QString seed = QString::number(variant);
        if (kind == kPrograms[0]) {
            program->setProgram(TXN_TEXTON_PROGRAM);
            program->setArguments({"noise",
                                   path("input.exr"),
                                   "--size",
                                   "512x384",
                                   "--seed",
                                   seed,
                                   "-o",
                                   folder + "/noise.png"});
        } else if (kind == kPrograms[1]) {
            program->setProgram(TXN_TEXTON_PROGRAM);
            program->setArguments({"compute",
                                   path("input.png"),
                                   "--support",
                                   "16",
                                   "--method",
                                   "projections",
                                   "--iterations",
                                   "2",
                                   "--seed",
                                   seed,
                                   "-o",
                                   folder + "/texton.exr",
                                   "-o",
                                   folder + "/other.png"});
        } else {
            program->setProgram(QCoreApplication::applicationFilePath());
            program->setArguments({"--victim", kind, folder, seed});
        }
        return program;
    }

    End run(const QString& kind,
            const QString& folder,
            int variant,
            const Variables& variables = {},
            const std::function<void()>& limits = {}) {
        QFile::remove(path("mark"));
        const std::unique_ptr<QProcess> program(prepared(kind, folder, variant, variables, limits));
        program->start();
        End end;
        if (!program->waitForFinished(kPatienceMs)) {
            program->kill();
            program->waitForFinished();
            end.code = -1;
        } else if (program->exitStatus() == QProcess::CrashExit) {
            end.killed = variables.count("TXN_FAULT") != 0 &&
                         variables.at("TXN_FAULT").endsWith("kill") &&
                         program->exitCode() == SIGKILL;
            end.code = 1000 + program->exitCode();
        } else {
            end.code = program->exitCode();
        }
        end.message = QString::fromLocal8Bit(program->readAllStandardError()).trimmed();
        end.reached = QFile::exists(path("mark"));
        return end;
    }

    /// A folder with the old files, or an empty one.
    QString folderWith(const Content& content) {
        const QString folder = path("work");
        QDir(folder).removeRecursively();
        QDir().mkpath(folder);
        fill(folder, content);
        return folder;
    }
    static void fill(const QString& folder, const Content& content) {
        for (const auto& [name, bytes] : content) {
            const QString file = folder + QLatin1Char('/') + name;
            QDir().mkpath(QFileInfo(file).path());
            QFile out(file);
            QVERIFY(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size());
        }
    }
    /// The old files of a kind. Copies of unsaved work are made by the victim itself.
    Content oldFiles(const QString& kind) {
        return kind == QLatin1String("autosave") ? Content() : m_old[kind];
    }

    /// Whether all is well again after one more save: nothing is left of what was killed.
    void sweeps(const QString& kind, const QString& folder) {
        const End end = run(kind, folder, 2);
        QString problem = end.code == kDone ? QString() : QStringLiteral("fails afterwards");
        for (const auto& [name, bytes] : contentOf(kind, folder)) {
            if (isLeftover(name))
                problem = QStringLiteral("still has ") + name;
        }
        m_tally.count(QStringLiteral("leftovers are swept by the next save"), problem, kind);
    }

    static QString triedAt(const QString& kind, int n, bool nameless) {
        return QStringLiteral("%1, n = %2%3")
            .arg(kind)
            .arg(n)
            .arg(nameless ? QString() : QStringLiteral(", named"));
    }

    void kindRows() {
        QTest::addColumn<QString>("kind");
        for (const QString& kind : allKinds())
            QTest::newRow(qPrintable(kind)) << kind;
    }

  private slots:
    void initTestCase() {
        QVERIFY(m_home.isValid());
        // An input for the command line.
        QDir().mkpath(path("input"));
        QCOMPARE(run("texton", path("input"), 1).code, int(kDone));
        QCOMPARE(run("noise", path("input"), 1).code, int(kDone));
        const auto inputs = contentOf("texton", path("input"));
        for (const auto& [name, bytes] : inputs) {
            if (name.endsWith(".exr"))
                QVERIFY(QFile::copy(path("input/" + name), path("input.exr")));
            if (name.endsWith(".exr.json"))
                QVERIFY(QFile::copy(path("input/" + name), path("input.exr.json")));
        }
        QVERIFY(QFile::copy(path("input/stone.png"), path("input.png")));
        for (const QString& kind : allKinds()) {
            for (const int variant : {1, 2}) {
                const QString folder = path(QStringLiteral("whole"));
                QDir(folder).removeRecursively();
                QDir().mkpath(folder);
                const End end = run(kind, folder, variant);
                QVERIFY2(end.code == kDone, qPrintable(kind + ": " + end.message));
                (variant == 1 ? m_old : m_new)[kind] = contentOf(kind, folder);
            }
            QVERIFY(!m_old[kind].empty());
            QVERIFY(m_old[kind] != m_new[kind]);
        }
    }

    void failingCalls_data() { kindRows(); }
    void failingCalls() {
        QFETCH(QString, kind);
        const std::map<QString, QStringList> calls{{"write", {"ENOSPC", "EDQUOT"}},
                                                   {"sync", {"EIO"}},
                                                   {"rename", {"EACCES"}},
                                                   {"link", {"EIO"}}};
        for (const bool nameless : {true, false}) {
            for (const auto& [call, errors] : calls) {
                for (int n = 1; n <= kMostCalls; ++n) {
                    Variables variables{{"TXN_FAULT",
                                         QStringLiteral("%1:%2:%3")
                                             .arg(call)
                                             .arg(n)
                                             .arg(errors[(n - 1) % errors.size()])}};
                    if (!nameless)
                        variables["TXN_NAMELESS"] = QStringLiteral("0");
                    const Content old = n % 3 == 0 ? Content() : oldFiles(kind);
                    const QString folder = folderWith(old);
                    const End end = run(kind, folder, 2, variables);
                    const QString problem =
                        judged(end,
                               contentOf(kind, folder),
                               kind == QLatin1String("autosave") ? m_old[kind] : old,
                               m_new[kind]);
                    m_tally.count(QStringLiteral("the n-th %1 fails").arg(call),
                                  problem,
                                  triedAt(kind, n, nameless));
                    if (!end.reached)
                        break;
                }
            }
        }
    }

    void killsAtCalls_data() { kindRows(); }
    void killsAtCalls() {
        QFETCH(QString, kind);
        for (const bool nameless : {true, false}) {
            for (const QString call : {"write", "sync", "rename", "link"}) {
                for (int n = 1; n <= (isLong() ? kMostCalls : 3); ++n) {
                    Variables variables{
                        {"TXN_FAULT", QStringLiteral("%1:%2:kill").arg(call).arg(n)}};
                    if (!nameless)
                        variables["TXN_NAMELESS"] = QStringLiteral("0");
                    const QString folder = folderWith(oldFiles(kind));
                    const End end = run(kind, folder, 2, variables);
                    const QString problem =
                        judged(end, contentOf(kind, folder), m_old[kind], m_new[kind]);
                    m_tally.count(QStringLiteral("killed at the n-th %1").arg(call),
                                  problem,
                                  triedAt(kind, n, nameless));
                    if (!end.reached)
                        break;
                    if (kind != QLatin1String("autosave"))
                        sweeps(kind, folder);
                }
            }
        }
    }

    void killsAtRandom_data() { kindRows(); }
    void killsAtRandom() {
        QFETCH(QString, kind);
        if (kPrograms.contains(kind))
            return; // they write once and end
        std::mt19937 random(7);
        std::uniform_int_distribution<int> microseconds(0, 60000);
        const QString folder = folderWith(oldFiles(kind));
        Content both = m_new[kind];
        for (int i = 0; i < (isLong() ? 40 : 4); ++i) {
            const std::unique_ptr<QProcess> program(prepared(kind, folder, 0, {}));
            program->start();
            QVERIFY(program->waitForReadyRead(kPatienceMs));
            QTest::qSleep(0);
            std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
            program->kill();
            QVERIFY(program->waitForFinished());
            End end;
            end.killed = true;
            Content now = contentOf(kind, folder);
            if (kind == QLatin1String("autosave"))
                QDir(folder).removeRecursively(), QDir().mkpath(folder);
            const Content old =
                kind == QLatin1String("autosave") && now.empty() ? now : m_old[kind];
            m_tally.count(QStringLiteral("killed at a random instant"),
                          judged(end, now, old, m_new[kind]),
                          kind);
        }
        if (kind != QLatin1String("autosave"))
            sweeps(kind, folder);
    }

    void fullAndReadOnlyDisks_data() { kindRows(); }
    void fullAndReadOnlyDisks() {
        QFETCH(QString, kind);
        const QString disk = path("disk");
        QDir().mkpath(disk);
        qint64 size = 0;
        for (const auto& [name, bytes] : m_new[kind])
            size += bytes.size() + 4096;
        if (kind == QLatin1String("autosave"))
            size = 1 << 19;
        if (::mount("none", disk.toLocal8Bit(), "tmpfs", 0, "size=16m") != 0)
            QSKIP("no disks may be mounted here");
        const int levels = isLong() ? 12 : 3;
        for (int level = 0; level <= levels; ++level) {
            const QString folder = disk + "/work";
            QDir(folder).removeRecursively();
            QFile::remove(disk + "/filler");
            QDir().mkpath(folder);
            fill(folder, oldFiles(kind));
            const bool readOnly = level == levels;
            if (readOnly) {
                QCOMPARE(
                    ::mount("none", disk.toLocal8Bit(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr),
                    0);
            } else {
                // What is left of the disk: a growing part of what is needed.
                QFile filler(disk + "/filler");
                QVERIFY(filler.open(QIODevice::WriteOnly));
                const qint64 room = size * level / levels;
                const qint64 free = QStorageInfo(disk).bytesAvailable() - room;
                const QByteArray block(4096, 'x');
                for (qint64 at = 0; at + block.size() <= free; at += block.size())
                    filler.write(block);
            }
            // A program that starts on a full disk has no old copy of unsaved work.
            const bool isAutosave = kind == QLatin1String("autosave");
            const End end = run(kind, folder, 2);
            Content old = isAutosave ? m_old[kind] : oldFiles(kind);
            const Content now = contentOf(kind, folder);
            if (isAutosave && now.empty())
                old = {};
            const QString problem = judged(end, now, old, m_new[kind]);
            m_tally.count(readOnly ? QStringLiteral("read-only disk") : QStringLiteral("full disk"),
                          problem,
                          QStringLiteral("%1, level %2").arg(kind).arg(level));
        }
        QCOMPARE(::umount2(disk.toLocal8Bit(), MNT_DETACH), 0);
    }

    void quotas_data() { kindRows(); }
    void quotas() {
        QFETCH(QString, kind);
        qint64 largest = 1 << 18;
        for (const auto& [name, bytes] : m_new[kind])
            largest = std::max<qint64>(largest, bytes.size());
        const int levels = isLong() ? 12 : 3;
        for (int level = 0; level < levels; ++level) {
            const auto limit = static_cast<rlim_t>(largest * level / levels);
            const QString folder = folderWith(oldFiles(kind));
            const End end = run(kind, folder, 2, {}, [limit] {
                const rlimit both{limit, limit};
                ::setrlimit(RLIMIT_FSIZE, &both);
            });
            const Content now = contentOf(kind, folder);
            Content old = kind == QLatin1String("autosave") && now.empty() ? now : m_old[kind];
            const QString problem = judged(end, now, old, m_new[kind]);
            m_tally.count(QStringLiteral("quota"),
                          problem,
                          QStringLiteral("%1, level %2").arg(kind).arg(level));
        }
    }

    void cleanupTestCase() { QCOMPARE(m_tally.bad(), 0); }
};

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "--victim") == 0)
        runVictim(argc, argv);
    QCoreApplication application(argc, argv);
    TestFileFaults test;
    return QTest::qExec(&test, argc, argv);
}
#include "TestFileFaults.moc"
