// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/BadFiles.h"

#include <QtTest>
#include <algorithm>
#include <csignal>
#include <functional>
#include <limits>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace txn::test;

namespace {

#ifdef TXN_SANITIZED
constexpr int kSlowdown = 10;
#else
constexpr int kSlowdown = 1;
#endif
constexpr int kTimeoutMs = 20'000 * kSlowdown;
/// Exit code of a child that could not be prepared as the row asks.
constexpr int kCannotPrepare = 77;
constexpr qint64 kNoLimit = -1;

/// What the program did.
struct Outcome {
    bool inTime = false;
    bool normal = false;
    int code = -1;
    QByteArray out;
    QByteArray err;
};

/// The surroundings of a run, beyond its arguments.
struct Conditions {
    qint64 largestFile = kNoLimit; ///< bytes: stands for a full disk
    bool plainUser = false;        ///< file permissions hold, also for root
    QString standardOutput = {};   ///< a path; empty: captured
};

/// One line of the tables.
struct Row {
    const char* arguments; ///< split at spaces; "_" stands for an empty one
    int code;
    const char* says; ///< must be in the message
};

QStringList split(const QString& line) {
    QStringList words = line.split(' ');
    words.replaceInStrings(QRegularExpression("^_$"), QString());
    return words;
}

void addColumns() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    QTest::addColumn<qint64>("largestFile");
    QTest::addColumn<bool>("plainUser");
}

void addRow(const QByteArray& name,
            const QStringList& arguments,
            int code,
            const QString& says,
            const Conditions& conditions = {}) {
    QTest::newRow(name.constData())
        << arguments << code << says << conditions.largestFile << conditions.plainUser;
}

template <std::size_t N>
void addRows(const Row (&rows)[N], const Conditions& conditions = {}) {
    for (const Row& row : rows)
        addRow(row.arguments, split(row.arguments), row.code, row.says, conditions);
}

/// The commands one after the other: all of them for each file would take minutes.
class Turns {
  public:
    template <std::size_t N>
    explicit Turns(const char* const (&commands)[N]) : m_commands(commands, commands + N) {}
    QString next() { return m_commands[m_next++ % m_commands.size()]; }

  private:
    QStringList m_commands;
    qsizetype m_next = 0;
};

/// Everything below a folder, hidden things too, by the facts that any change alters.
using Listing = QMap<QString, QString>;

Listing listing(const QString& folder) {
    Listing result;
    QDirIterator it(folder,
                    QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QString path = it.next();
        struct stat info {};
        if (::lstat(QFile::encodeName(path).constData(), &info) != 0)
            continue;
        const bool isFolder = S_ISDIR(info.st_mode);
        result[path.mid(folder.size() + 1)] = QString("mode %1 inode %2 size %3 changed %4.%5")
                                                  .arg(info.st_mode, 0, 8)
                                                  .arg(info.st_ino)
                                                  .arg(isFolder ? 0 : info.st_size)
                                                  .arg(isFolder ? 0 : info.st_ctim.tv_sec)
                                                  .arg(isFolder ? 0 : info.st_ctim.tv_nsec);
    }
    return result;
}

/// Names of what came, went or changed.
QStringList differences(const Listing& before, const Listing& after) {
    QStringList names;
    for (auto it = after.begin(); it != after.end(); ++it) {
        if (before.value(it.key()) != it.value())
            names.append(it.key());
    }
    for (auto it = before.begin(); it != before.end(); ++it) {
        if (!after.contains(it.key()))
            names.append(it.key());
    }
    return names;
}

/// Runs between fork and exec.
void prepareChild(const Conditions& conditions) {
    if (conditions.largestFile != kNoLimit) {
        const auto bytes = static_cast<rlim_t>(conditions.largestFile);
        const rlimit limit{bytes, bytes};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0)
            ::_exit(kCannotPrepare);
    }
    // Root reads and writes anything by these two rights.
    if (conditions.plainUser && ::geteuid() == 0) {
        for (const int right : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) {
            if (::prctl(PR_CAPBSET_DROP, right, 0, 0, 0) != 0)
                ::_exit(kCannotPrepare);
        }
    }
}

} // namespace

/// Runs the real program on what users and their files can do wrong: one line says what, the exit
/// code is 1 or 2, nothing is printed to standard output, and no file appears or changes.
class TestBadInput : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void cleanupTestCase();

    void wrongUsage_data();
    void wrongUsage() { checkRefused(); }
    void valuesOutOfRange_data();
    void valuesOutOfRange() { checkRefused(); }
    void notFiles_data();
    void notFiles() { checkRefused(); }
    void brokenPictures_data();
    void brokenPictures() { checkRefused(); }
    void uselessExemplars_data();
    void uselessExemplars() { checkRefused(); }
    void brokenTextons_data();
    void brokenTextons() { checkRefused(); }
    void brokenSidecars_data();
    void brokenSidecars() { checkRefused(); }
    void impossibleOutputs_data();
    void impossibleOutputs() { checkRefused(); }
    void permissions_data();
    void permissions() { checkRefused(); }
    void fullDisk_data();
    void fullDisk() { checkRefused(); }
    void fullStandardOutput();

    void oddButRight_data();
    void oddButRight();
    void outputBehindLink();
    void nameThatIsNotUnicode();

    void stopsOnSignal_data();
    void stopsOnSignal();

  private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QByteArray bytes(const QString& name) const;
    qint64 size(const QString& name) const { return QFileInfo(path(name)).size(); }
    void write(const QByteArray& name, const QByteArray& bytes) const;
    void makeGood(const QString& arguments) const;
    void makeGoodFiles();
    void makeBadFiles();
    void makeSpecialFiles() const;

    Outcome run(const QStringList& arguments,
                const Conditions& conditions = {},
                const std::function<void(QProcess&, Outcome&)>& wait = {}) const;
    /// The columns of a row against the program.
    void checkRefused() const;
    void checkOneLine(const Outcome& outcome, const QString& says) const;

    QTemporaryDir m_folder;
    QList<NamedBytes> m_pictures;
    QList<NamedBytes> m_textons;
    QList<NamedBytes> m_sidecars;
};

QByteArray TestBadInput::bytes(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestBadInput::write(const QByteArray& name, const QByteArray& bytes) const {
    QFile file(path(QString::fromUtf8(name)));
    QVERIFY2(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(),
             name.constData());
}

Outcome TestBadInput::run(const QStringList& arguments,
                          const Conditions& conditions,
                          const std::function<void(QProcess&, Outcome&)>& wait) const {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.setStandardInputFile(QProcess::nullDevice());
    if (!conditions.standardOutput.isEmpty())
        process.setStandardOutputFile(conditions.standardOutput);
    process.setChildProcessModifier([conditions] { prepareChild(conditions); });
    process.start(TXN_TEXTON_PROGRAM, arguments);
    Outcome outcome;
    if (wait)
        wait(process, outcome);
    outcome.inTime = process.waitForFinished(kTimeoutMs);
    if (!outcome.inTime) {
        process.kill();
        process.waitForFinished();
        return outcome;
    }
    outcome.normal = process.exitStatus() == QProcess::NormalExit;
    outcome.code = process.exitCode();
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

void TestBadInput::makeGood(const QString& arguments) const {
    const Outcome outcome = run(split(arguments));
    QVERIFY2(outcome.normal && outcome.code == 0, outcome.err.constData());
}

void TestBadInput::makeGoodFiles() {
    for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"})
        makeGood(QString("sample wood --size 48x32 -o good.%1").arg(ending));
    makeGood("compute good.png --support 8 --iterations 2 -o t.png -o t.exr -o t.texton");
    // Those that must stay as they are.
    for (const char* name : {"old.png", "old.exr", "old.jpg", "old.texton", "old.png.json"})
        write(name, "the output of an earlier day");
}

void TestBadInput::makeBadFiles() {
    GoodPictures good;
    for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"})
        good[ending] = bytes(QString("good.%1").arg(ending));
    m_pictures = txn::test::brokenPictures(good);
    for (const NamedBytes& file : m_pictures)
        write(file.name, file.bytes);

    m_textons = brokenTextonTexts() + brokenExrTextons();
    for (const NamedBytes& file : m_textons)
        write(file.name, file.bytes);
    m_sidecars = txn::test::brokenSidecars(bytes("t.png.json"));
    for (const NamedBytes& file : m_sidecars) {
        write(file.name, bytes("t.png"));
        write(file.name + ".json", file.bytes);
    }

    ExrLayout layout;
    layout.firstSample = std::numeric_limits<float>::quiet_NaN();
    write("nan.exr", exrBytes(layout));
    write("nan\n\x1b[2Jname.exr", exrBytes(layout));
    layout.firstSample = std::numeric_limits<float>::infinity();
    write("infinite.exr", exrBytes(layout));
    layout.firstSample = 1e30F;
    write("huge.exr", exrBytes(layout));
    layout = {};
    layout.channels = {{"X", 0.1F}, {"Y", 0.2F}};
    write("two.exr", exrBytes(layout));
    for (int i = 0; i < 17; ++i)
        layout.channels["c" + QByteArray::number(i + 10)] = 0.5F;
    write("nineteen.exr", exrBytes(layout));
    write("flat.png", pngBytes(16, 16));
    write("pixel.png", pngBytes(1, 1));
    const QByteArray line = bytes("good.bmp").right(48 * 3);
    write("row.png", pngBytes(48, 1, line));
    write("column.png", pngBytes(1, 48, line));
    write("lost.png", bytes("t.png")); // its sidecar is not there
}

void TestBadInput::makeSpecialFiles() const {
    const auto native = [&](const char* name) { return QFile::encodeName(path(name)); };
    QDir folder(m_folder.path());
    for (const char* name : {"folder", "folder.png", "closed", "locked", "blocked.png.json"})
        QVERIFY(folder.mkdir(name));
    write("closed/good.png", bytes("good.png"));
    write("secret.png", bytes("good.png"));
    write("secret.texton", bytes("t.texton"));
    write("locked.png", "may not be written");
    write("folder-sidecar.png", bytes("t.png"));
    QVERIFY(folder.mkdir("folder-sidecar.png.json"));
    QVERIFY(::mkfifo(native("pipe.png").constData(), 0600) == 0);
    QVERIFY(::mkfifo(native("pipe.texton").constData(), 0600) == 0);
    QVERIFY(::mknod(native("socket.png").constData(), S_IFSOCK | 0600, 0) == 0);
    QVERIFY(::symlink("loop.png", native("loop.png").constData()) == 0);
    QVERIFY(::symlink("nowhere/x.png", native("dangling.png").constData()) == 0);
    QVERIFY(::symlink("folder", native("to-folder.png").constData()) == 0);
    QVERIFY(::symlink("/dev/full", native("to-full.png").constData()) == 0);
    QVERIFY(::chmod(native("secret.png").constData(), 0) == 0);
    QVERIFY(::chmod(native("secret.texton").constData(), 0) == 0);
    QVERIFY(::chmod(native("locked.png").constData(), 0444) == 0);
    QVERIFY(::chmod(native("locked").constData(), 0555) == 0);
    QVERIFY(::chmod(native("closed").constData(), 0) == 0);
}

void TestBadInput::initTestCase() {
    QVERIFY(m_folder.isValid());
    QVERIFY2(QFileInfo(TXN_TEXTON_PROGRAM).isExecutable(), TXN_TEXTON_PROGRAM);
    makeGoodFiles();
    makeBadFiles();
    makeSpecialFiles();
}

void TestBadInput::cleanupTestCase() {
    for (const char* name : {"locked", "closed"})
        ::chmod(QFile::encodeName(path(name)).constData(), 0755);
}

void TestBadInput::checkOneLine(const Outcome& outcome, const QString& says) const {
    const QByteArray& err = outcome.err;
    QVERIFY2(err.size() > 1 && err.endsWith('\n'), err.constData());
    const bool printable = std::all_of(err.begin(), err.end() - 1, [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    });
    QVERIFY2(printable, err.constData());
    QVERIFY2(QString::fromUtf8(err).contains(says), err.constData());
    QVERIFY2(!err.contains("internal error"), err.constData());
    QVERIFY2(!err.contains(".texton-"), err.constData()); // the name of a temporary file
}

void TestBadInput::checkRefused() const {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, says);
    QFETCH(qint64, largestFile);
    QFETCH(bool, plainUser);
    const Listing before = listing(m_folder.path());
    const Outcome outcome = run(arguments, {largestFile, plainUser, {}});
    if (outcome.normal && outcome.code == kCannotPrepare)
        QSKIP("this system does not let the test give up its rights");
    QVERIFY2(outcome.inTime, "it ran too long");
    QVERIFY2(outcome.normal, outcome.err.constData());
    QVERIFY2(outcome.code == code,
             "exit code " + QByteArray::number(outcome.code) + ": " + outcome.err + outcome.out);
    checkOneLine(outcome, says);
    QCOMPARE(outcome.out, QByteArray());
    QCOMPARE(differences(before, listing(m_folder.path())), QStringList());
}

void TestBadInput::wrongUsage_data() {
    addColumns();
    addRow("output over the exemplar", {"periodic", "good.png", "-o", "./good.png"}, 1, "good.png");
    addRow("no arguments", {}, 2, "subcommand");
    const Row rows[] = {
        {"frobnicate", 2, "frobnicate"},
        {"_", 2, "texton"},
        {"--frobnicate", 2, "--frobnicate"},
        {"compute good.png", 2, "--output"},
        {"compute good.png --max-samples 100 -o new.exr", 1, "allow more with --max-samples"},
        {"compute good.png --max-samples -1 -o new.exr", 2, "--max-samples"},
        {"compute good.png -o old.exr --frobnicate", 2, "--frobnicate"},
        {"compute good.png -o old.exr --support", 2, "--support"},
        {"gaussian good.png -o old.png -o new.png", 2, "--output"},
        {"noise", 2, "required"},
        {"noise t.exr -o old.png", 2, "--size"},
        {"compare good.png", 2, "B"},
        {"sheet good.png", 2, "--output"},
        {"info", 2, "FILE"},
        {"mix good.png good.png -o new.png", 2, "--size"},
        {"mix good.png good.png --size 8x8", 2, "--output"},
        {"mix good.png -o new.png --size 8x8", 1, "--stack-b"},
        {"mix -o new.png --size 8x8", 1, "--stack-a"},
        {"mix good.png good.png -o new.png --size 8x8 --stack-a height=good.png", 1, "--stack-a"},
        {"mix good.png good.png -o new.png --size 8x8 --strips 1", 2, "--strips"},
        {"mix good.png good.png -o new.png --size 8x8 --strips 65", 2, "--strips"},
        {"mix good.png good.png -o new.png --size 8x8 --angle nan", 2, "--angle"},
        {"mix good.png good.png -o new.png --size 8x8 --ease jump", 2, "--ease"},
        {"mix good.png good.png -o new.png --size 8x8 --map flat.png --angle 3", 1, "--angle"},
        {"mix good.png good.png -o new.png --size 8x8 --process poisson --support 8",
         1,
         "both signs"},
        {"sample wood", 2, "--output"},
        {"info good.png compare good.png good.png", 2, "compare"},
    };
    addRows(rows);
    addRow("control characters", {"two\nlines\x1b[2J\r\t"}, 2, "two");
}

void TestBadInput::valuesOutOfRange_data() {
    addColumns();
    const Row rows[] = {
        {"compute good.png -o old.exr --support 0", 2, "--support"},
        {"compute good.png -o old.exr --support -1", 2, "--support"},
        {"compute good.png -o old.exr --support axb", 2, "--support"},
        {"compute good.png -o old.exr --support 99999999999", 2, "--support"},
        {"compute good.png -o old.exr", 1, "good.png"}, // 64 x 64 by default
        {"compute good.png -o old.exr --support 16777216", 2, "--support"},
        {"compute good.png -o old.exr --support 8x9 --shape disc", 1, "--support"},
        {"compute good.png -o old.exr --support 100000 --shape disc", 1, "good.png"},
        {"compute good.png -o old.exr --support 8 --shape star", 2, "--shape"},
        {"compute good.png -o old.exr --support 8 --order 2", 2, "--order"},
        {"compute good.png -o old.exr --support 8 --iterations 0", 2, "--iterations"},
        {"compute good.png -o old.exr --support 8 --momentum 1", 2, "--momentum"},
        {"compute good.png -o old.exr --support 8 --momentum nan", 2, "--momentum"},
        {"compute good.png -o old.exr --method fit --kernels 0", 2, "--kernels"},
        {"compute good.png -o old.exr --method fit --kernels 17", 2, "--kernels"},
        {"compute good.png -o old.exr --method fit --kernels some", 2, "--kernels"},
        {"compute good.png -o old.exr --method best", 2, "--method"},
        {"compute -o old.exr --stack height", 2, "--stack"},
        {"compute -o old.exr --stack height=", 2, "--stack"},
        {"compute -o old.exr --stack alpha=good.png", 2, "--stack"},
        {"compute -o old.exr --stack ../x=good.png", 2, "--stack"},
        {"compute -o old.exr", 1, "--stack"},
        {"compute good.png -o old.exr --stack color=good.png", 1, "--stack"},
        {"compute -o old.exr --support 8 --linear --stack color=good.png", 1, "--linear"},
        {"compute -o old.exr --support 8 --stack color=good.png --stack color=good.png",
         1,
         "color"},
        {"compute -o old.exr --support 8 --stack height=good.png", 1, "good.png"},
        {"compute -o old.exr --support 8 --stack color=good.png --stack data=pixel.png",
         1,
         "pixel.png"},
        {"compute -o old.texton --support 8 --stack color=good.png --stack normal=good.png",
         1,
         "old.texton"},
        {"compute good.png -o old.texton --support 8 --kernels 2", 1, "old.texton"},
        {"render t.exr -o old.png --map color", 1, "--map"},
        {"render t.exr -o old.png --light 0,99", 2, "--light"},
        {"compute good.png -o old.exr --support 8 --seed 4294967296", 2, "--seed"},
        {"compute good.png -o old.exr --support 8 --crop 0,0,0,5", 2, "--crop"},
        {"compute good.png -o old.exr --support 8 --crop 9223372036854775807,0,9,9", 1, "good.png"},
        {"compute good.png -o old.exr --support 8 --rotate nan", 1, "good.png"},
        {"compute pixel.png -o old.exr --support 1 --rotate 45", 1, "pixel.png"},
        {"compute good.png -o old.exr --support 8 --flatten nan", 2, "--flatten"},
        {"gaussian good.png -o old.png --size -5x5", 2, "--size"},
        {"gaussian good.png -o old.png --size 16777216x16777216", 2, "16777216"},
        {"gaussian good.png -o old.png --depth 12", 2, "--depth"},
        {"gaussian good.png -o old.jpg --depth 16", 1, "old.jpg"},
        {"periodic good.png -o old.exr --depth 8", 1, "old.exr"},
        {"noise t.exr -o old.png --size 0x0", 2, "--size"},
        {"noise t.exr -o old.png --size -5x5", 2, "--size"},
        {"noise t.exr -o old.png --size 99999999999x1", 2, "--size"},
        {"noise t.exr -o old.png --size 8x8 --mni 0", 2, "--mni"},
        {"noise t.exr -o old.png --size 8x8 --mni -3", 2, "--mni"},
        {"noise t.exr -o old.png --size 8x8 --mni 1e9", 2, "--mni"},
        {"noise t.exr -o old.png --size 8x8 --mni nan", 2, "--mni"},
        {"noise t.exr -o old.png --size 8x8 --scale 0", 2, "--scale"},
        {"noise t.exr -o old.png --size 8x8 --scale 1e9", 2, "--scale"},
        {"noise t.exr -o old.png --size 8x8 --scale nan", 2, "--scale"},
        {"noise t.exr -o old.png --size 8x8 --threads 0", 2, "--threads"},
        {"noise t.exr -o old.png --size 8x8 --origin 99999999999999999999,0", 2, "--origin"},
        {"noise t.exr -o old.png --size 8x8 --origin 1000000000,0", 1, "plane"},
        {"noise t.exr -o old.png --size 8x8 --origin 0,9223372036854775807", 1, "plane"},
        {"noise t.exr -o old.png --size 8x8 --origin=0,-9223372036854775808", 1, "plane"},
        {"render t.exr -o old.png --size 0x5", 2, "--size"},
        {"render t.exr -o old.png --view cube", 2, "--view"},
        {"render t.exr -o old.png --zoom 0", 2, "--zoom"},
        {"render t.exr -o old.png --zoom nan", 2, "--zoom"},
        {"render t.exr -o old.png --center 1", 2, "--center"},
        {"render t.exr -o old.png --center nan,0", 2, "--center"},
        {"render t.exr -o old.png --rotate inf", 2, "--rotate"},
        {"render t.exr -o old.png --filter sharp", 2, "--filter"},
        {"render t.exr -o old.png --filter supersample:0", 2, "--filter"},
        {"render t.exr -o old.png --filter supersample:65", 2, "--filter"},
        {"render t.exr -o old.png --filter supersample:2.5", 2, "--filter"},
        {"render t.exr -o old.png --view mesh --camera 1", 2, "--camera"},
        {"render t.exr -o old.png --camera 1,2", 1, "--camera"},
        {"render t.exr -o old.png --mesh sphere", 1, "--mesh"},
        {"render t.exr -o old.png --unlit", 1, "--unlit"},
        {"render t.exr -o old.png --view surface --center 1,2", 1, "--center"},
        {"render t.exr -o old.png --view perspective --rotate 3", 1, "--rotate"},
        {"render t.exr -o t.exr", 1, "t.exr"},
        {"render good.png -o old.png", 1, "good.png"},
        {"compare good.png good.jpg --lag -1", 2, "--lag"},
        {"compare good.png good.jpg --lag 32", 1, "lag"},
        {"sheet good.png -o old.png --support 8 --mni nan", 2, "--mni"},
        {"sample granite -o old.png", 2, "granite"},
        {"sample wood -o old.png --size 15x16", 1, "15 x 16"},
    };
    addRows(rows);
    addRow("sample with control characters", {"sample", "a\n\x1b[2J", "-o", "old.png"}, 2, "a");
}

void TestBadInput::notFiles_data() {
    addColumns();
    const char* commands[] = {"compute %1 --support 8 -o old.exr",
                              "gaussian %1 -o old.png",
                              "periodic %1 -o old.png",
                              "noise %1 -o old.png --size 8x8",
                              "compare good.png %1",
                              "compare %1 good.png",
                              "sheet %1 -o old.png --support 8",
                              "info %1 --json"};
    const char* names[] = {"missing.png",
                           "missing.texton",
                           "nowhere/missing.png",
                           "good.png/missing.png",
                           "folder",
                           "folder.png",
                           "to-folder.png",
                           "pipe.png",
                           "pipe.texton",
                           "socket.png",
                           "loop.png",
                           "dangling.png",
                           "/dev/null",
                           "/dev/zero",
                           "/dev/full"};
    Turns turns(commands);
    for (const char* name : names) {
        const QString line = turns.next().arg(name);
        addRow(line.toUtf8(), split(line), 1, name);
    }
    const QString longName = QString(300, 'n') + ".png";
    addRow("info TOO-LONG", {"info", longName}, 1, "nnnn");
    addRow("noise TOO-LONG", {"noise", longName, "-o", "old.png", "--size", "8x8"}, 1, "nnnn");
    const Row rows[] = {
        {"noise _ -o old.png --size 8x8", 1, "''"},
        {"noise pipe.png -o old.png --size 8x8", 1, "pipe.png"},
        {"noise pipe.texton -o old.png --size 8x8", 1, "pipe.texton"},
        {"noise missing.texton -o old.png --size 8x8", 1, "missing.texton"},
    };
    addRows(rows);
}

void TestBadInput::brokenPictures_data() {
    addColumns();
    const char* commands[] = {"info %1",
                              "compute %1 --support 2 --iterations 1 -o old.exr",
                              "gaussian %1 -o old.png",
                              "compare good.png %1",
                              "periodic %1 -o new.png",
                              "info %1 --json",
                              "sheet %1 -o new.png --support 2 --iterations 1",
                              "compute %1 --support 2 --json -o new.texton -o old.png",
                              "compare %1 good.png --json",
                              "noise %1 -o new.png --size 8x8"};
    Turns turns(commands);
    for (const NamedBytes& file : m_pictures) {
        const QString name = QString::fromUtf8(file.name);
        // This one is no picture, and yet a texton.
        const QString line =
            (name == "texton.png" ? "periodic %1 -o old.png" : turns.next()).arg(name);
        addRow(line.toUtf8(), split(line), 1, name);
    }
}

void TestBadInput::uselessExemplars_data() {
    addColumns();
    const Row rows[] = {
        {"compute nan.exr --support 2 -o old.exr", 1, "nan.exr"},
        {"compare good.png nan.exr", 1, "nan.exr"},
        {"compute nan.exr --support 2 --rotate 7 --flatten 2 -o old.exr", 1, "nan.exr"},
        {"compute huge.exr --support 2 -o old.exr", 1, "huge.exr"},
        {"compute nineteen.exr --support 2 -o old.exr", 1, "nineteen.exr"},
        {"compute flat.png --support 8 -o old.exr", 1, "flat.png"},
        {"mix good.png flat.png --support 8 -o old.png --size 8x8", 1, "exemplar B"},
        {"mix flat.png good.png --support 8 -o old.png --size 8x8", 1, "exemplar A"},
        {"mix good.png two.exr --support 8 -o old.png --size 8x8", 1, "2 channels"},
        {"mix good.png nan.exr --support 8 -o old.png --size 8x8", 1, "nan.exr"},
        {"mix good.png missing.png --support 8 -o old.png --size 8x8", 1, "missing.png"},
        {"mix good.png good.png --support 80 -o old.png --size 8x8", 1, "good.png"},
        {"mix good.png good.png -o old.png --size 8x8 --map good.png", 1, "good.png"},
        {"mix good.png good.png -o old.png --size 8x8 --map nan.exr", 1, "nan.exr"},
        {"mix good.png good.png -o old.png --size 8x8 --map two.exr", 1, "two.exr"},
        {"mix good.png good.png -o old.png --size 8x8 --map nineteen.exr", 1, "nineteen.exr"},
        {"mix good.png good.png -o old.png --size 8x8 --map missing.png", 1, "missing.png"},
        {"mix good.png row.png --support 8 -o ./row.png --size 8x8", 1, "row.png"},
        {"mix good.png good.png --map pixel.png -o ./pixel.png --size 8x8", 1, "pixel.png"},
        {"compare flat.png good.png", 1, "flat.png"},
        {"compute pixel.png --support 1 -o old.exr", 1, "pixel.png"},
        {"compute row.png --support 49x1 -o old.exr", 1, "row.png"},
        {"compare good.png two.exr", 1, "two.exr"},
        {"compute t.texton --support 2 -o old.exr", 1, "t.texton"},
    };
    addRows(rows);
    addRow("NaN and a name with control characters",
           {"compute", "nan\n\x1b[2Jname.exr", "--support", "2", "-o", "old.exr"},
           1,
           "name.exr");
    addRow("missing, with control characters", {"info", "a\nb\x1b[2J.png"}, 1, ".png");
}

void TestBadInput::brokenTextons_data() {
    addColumns();
    for (const NamedBytes& file : m_textons) {
        const QString name = QString::fromUtf8(file.name);
        addRow("noise " + file.name, {"noise", name, "-o", "old.png", "--size", "8x8"}, 1, name);
    }
    const Row rows[] = {
        {"noise good.png -o new.png --size 8x8", 1, "good.png"},
        {"noise good.exr -o new.exr --size 8x8", 1, "good.exr"},
        {"noise lost.png -o new.png --size 8x8", 1, "lost.png"},
        {"compare good.png texton-nan.exr", 1, "texton-nan.exr"},
    };
    addRows(rows);
}

void TestBadInput::brokenSidecars_data() {
    addColumns();
    for (const NamedBytes& file : m_sidecars) {
        const QString name = QString::fromUtf8(file.name);
        addRow("noise " + file.name, {"noise", name, "-o", "old.png", "--size", "8x8"}, 1, name);
    }
    addRow("noise folder-sidecar.png",
           split("noise folder-sidecar.png -o old.png --size 8x8"),
           1,
           "folder-sidecar.png");
    addRow("info sidecar-without-mean.png",
           split("info sidecar-without-mean.png"),
           1,
           "sidecar-without-mean.png");
}

void TestBadInput::impossibleOutputs_data() {
    addColumns();
    const char* commands[] = {"compute good.png --support 8 --iterations 1 -o %1",
                              "gaussian good.png -o %1",
                              "periodic good.png -o %1",
                              "noise t.exr --size 8x8 -o %1",
                              "sheet good.png --support 8 --iterations 1 -o %1",
                              "sample wood --size 16x16 -o %1"};
    const char* names[] = {"new.xyz",
                           "new",
                           "new.json",
                           ".png",
                           "nowhere/new.png",
                           "good.png/new.png",
                           "folder",
                           "folder/",
                           "folder.png",
                           "to-folder.png",
                           "dangling.png",
                           "loop.png",
                           "pipe.png",
                           "socket.png",
                           "to-full.png",
                           "/dev/full",
                           "/dev/null"};
    Turns turns(commands);
    for (const char* name : names) {
        const QString line = turns.next().arg(name);
        addRow(line.toUtf8(), split(line), 1, name);
    }
    addRow("name that is too long",
           split("sample wood --size 16x16 -o " + QString(300, 'n') + ".png"),
           1,
           "nnnn");
    const Row rows[] = {
        {"compute good.png --support 8 --iterations 1 -o new.jpg", 1, "new.jpg"},
        {"compute good.png --support 8 --iterations 1 -o _", 1, "''"},
        {"compute good.png --support 8 --iterations 1 -o pipe.texton", 1, "pipe.texton"},
        {"compute two.exr --support 2 --iterations 1 -o new.exr -o new.texton", 1, "new.texton"},
        {"compute two.exr --support 2 --iterations 1 -o new.exr -o new.png", 1, "new.png"},
        {"compute good.png --support 8 --iterations 1 -o old.exr -o ./old.exr", 1, "old.exr"},
        {"compute good.png --support 8 --iterations 1 -o new.exr -o nowhere/new.exr", 1, "nowhere"},
        {"compute good.png --support 8 --iterations 1 -o new.exr -o blocked.png", 1, "blocked.png"},
        {"noise t.exr --size 8x8 -o new.texton", 1, "new.texton"},
        {"mix good.png row.png --size 8x8 -o new.xyz", 1, "new.xyz"},
        {"mix good.png row.png --size 8x8 -o nowhere/new.png", 1, "nowhere/new.png"},
        {"mix good.png row.png --size 8x8 -o new.png --save-textons nowhere/new", 1, "nowhere/new"},
        {"mix good.png row.png --size 8x8 -o new.png --save-textons good.png", 1, "good.png"},
        {"mix good.png row.png --size 8x8 -o new.png --save-textons dangling.png", 1, "dangling"},
        {"noise t.exr --size 1000001x8 -o new.png", 1, "new.png"},
        {"gaussian two.exr -o new.png", 1, "new.png"},
    };
    addRows(rows);
    // The output fits into a name, its sidecar does not.
    const QString longest = QString(251, 'n') + ".png";
    addRow("sidecar with too long a name",
           split("compute good.png --support 8 --iterations 1 -o " + longest),
           1,
           "nnnn");
}

void TestBadInput::permissions_data() {
    addColumns();
    const Row rows[] = {
        {"info secret.png", 1, "secret.png"},
        {"noise secret.texton -o old.png --size 8x8", 1, "secret.texton"},
        {"info closed/good.png", 1, "closed/good.png"},
        {"sample wood --size 16x16 -o locked/new.png", 1, "locked/new.png"},
        {"sample wood --size 16x16 -o locked.png", 1, "locked.png"},
        {"compute good.png --support 8 --iterations 1 -o locked/new.texton", 1, "locked/new"},
        {"compute good.png --support 8 --iterations 1 -o new.exr -o locked/new.exr", 1, "locked/"},
        {"compute good.png --support 8 --iterations 1 -o old.exr -o locked.png", 1, "locked.png"},
    };
    addRows(rows, {.plainUser = true});
}

void TestBadInput::fullDisk_data() {
    addColumns();
    const auto add = [](const QString& line, const QString& says, qint64 bytes) {
        addRow(line.toUtf8() + " in " + QByteArray::number(bytes), split(line), 1, says, {bytes});
    };
    // All but the last byte fits.
    for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"}) {
        const qint64 whole = size(QString("good.%1").arg(ending));
        add(QString("sample wood --size 48x32 -o new.%1").arg(ending),
            QString("new.%1").arg(ending),
            whole - 1);
    }
    add("sample wood --size 48x32 -o old.png", "old.png", 0);
    add("noise t.exr --size 1024x1024 -o old.exr", "old.exr", 20'000);
    add("noise t.exr --size 1024x1024 -o new.exr --depth float", "new.exr", 1'000'000);
    add("noise t.exr --size 512x512 -o old.png", "old.png", 20'000);
    add("gaussian good.png -o old.png", "old.png", 1000);
    add("sheet good.png --support 8 --iterations 1 -o old.png", "old.png", 10'000);
    const QString compute = "compute good.png --support 8 --iterations 2 -o ";
    for (const char* ending : {"png", "exr", "texton"}) {
        const QString name = QString("new.%1").arg(ending);
        add(compute + name, name, size(QString("t.%1").arg(ending)) - 1);
    }
    // The second does not fit, and the first must not appear either.
    const qint64 text = size("t.texton");
    const qint64 picture = size("t.exr") + 100;
    if (text > picture)
        add(compute + "new.exr -o new.texton", "new.texton", picture);
    // The texton fits and its sidecar does not.
    add("compute good.png --support 1 --iterations 1 -o new.png", "new.png.json", 400);
    add("compute good.png --support 1 --iterations 1 -o old.texton", "old.texton.json", 350);
}

void TestBadInput::fullStandardOutput() {
    if (!QFileInfo::exists("/dev/full"))
        QSKIP("there is no /dev/full");
    const Outcome outcome = run({"info", "good.png", "--json"}, {.standardOutput = "/dev/full"});
    QVERIFY(outcome.inTime && outcome.normal);
    QCOMPARE(outcome.code, 1);
    checkOneLine(outcome, "output");
}

void TestBadInput::oddButRight_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QStringList>("changed");
    const auto add =
        [](const char* name, const QStringList& arguments, const QStringList& changed) {
            QTest::newRow(name) << arguments << changed;
        };
    const QStringList solve{"--support", "4", "--iterations", "1"};
    write("jpeg.png", bytes("good.jpg"));
    write("exr.bmp", bytes("good.exr"));
    write("noise", bytes("good.png"));
    write("text.dat", bytes("t.texton"));
    write("trailing.jpg", bytes("good.jpg") + "appended by a phone");
    write("trailing.png", bytes("good.png") + "appended by a program");
    write("-x.png", bytes("good.png"));
    const QString unicode = QString::fromUtf8("\xe6\x9c\xa8 \xc3\xa9\xcc\x81 \xf0\x9f\xaa\xb5.png");
    write(unicode.toUtf8(), bytes("good.png"));
    write("two\nlines.png", bytes("good.png"));
    write("[a,b].png", bytes("good.png"));

    add("a JPEG called .png",
        QStringList{"compute", "jpeg.png", "-o", "1.exr"} + solve,
        {"1.exr", "1.exr.json"});
    add("an EXR called .bmp", {"periodic", "exr.bmp", "-o", "2.png"}, {"2.png"});
    add("a texton called .dat", {"noise", "text.dat", "-o", "3.png", "--size", "8x8"}, {"3.png"});
    add("a file called like a subcommand", {"info", "noise"}, {});
    add("more after the end of a JPEG", {"info", "trailing.jpg"}, {});
    add("more after the end of a PNG", {"info", "trailing.png"}, {});
    add("leading dash", {"periodic", "./-x.png", "-o", "./-y.png"}, {"-y.png"});
    add("spaces", {"periodic", "good.png", "-o", " a  b .png"}, {" a  b .png"});
    add("Unicode",
        QStringList{"compute", unicode, "-o", unicode + ".png", "--json"} + solve,
        {unicode + ".png", unicode + ".png.json"});
    add("newline",
        {"periodic", "two\nlines.png", "-o", "three\n\nlines.png"},
        {"three\n\nlines.png"});
    add("brackets and commas",
        QStringList{"compute", "[a,b].png", "-o", "[c,d].exr"} + solve,
        {"[c,d].exr", "[c,d].exr.json"});
    add("output over an old one",
        {"noise", "t.png", "-o", "old.jpg", "--size", "8x8"},
        {"old.jpg"});
    const QString longest = QString(251, 'n') + ".png";
    add("longest name", {"sample", "wood", "-o", longest, "--size", "16x16"}, {longest});
    add("one row",
        {"compute", "row.png", "-o", "6.exr", "--support", "8x1"},
        {"6.exr", "6.exr.json"});
    add("one column",
        {"compute", "column.png", "-o", "7.exr", "--support", "1x48"},
        {"7.exr", "7.exr.json"});
    add("support as large as the exemplar",
        {"compute", "good.png", "-o", "8.exr", "--support", "48x32", "--iterations", "1"},
        {"8.exr", "8.exr.json"});
    add("negative origin",
        {"noise", "t.exr", "-o", "9.png", "--size", "8x8", "--origin", "-37,-11"},
        {"9.png"});
    add("one pixel of noise", {"noise", "t.exr", "-o", "10.png", "--size", "1x1"}, {"10.png"});
    add("tile smaller than the texton",
        {"noise", "t.exr", "-o", "11.png", "--size", "3x2", "--tile"},
        {"11.png"});
    add("flat picture", {"gaussian", "flat.png", "-o", "13.png"}, {"13.png"});
    add("one pixel", {"gaussian", "pixel.png", "-o", "14.png", "--size", "4x4"}, {"14.png"});
    add("--help", {"--help"}, {});
    add("--version", {"--version"}, {});
}

void TestBadInput::oddButRight() {
    QFETCH(QStringList, arguments);
    QFETCH(QStringList, changed);
    const Listing before = listing(m_folder.path());
    const Outcome outcome = run(arguments);
    QVERIFY(outcome.inTime && outcome.normal);
    QVERIFY2(outcome.code == 0, outcome.err.constData());
    QCOMPARE(outcome.err, QByteArray());
    QStringList found = differences(before, listing(m_folder.path()));
    found.sort();
    changed.sort();
    QCOMPARE(found, changed);
    for (const QString& name : changed)
        QVERIFY2(size(name) > 0, qPrintable(name));
}

void TestBadInput::outputBehindLink() {
    write("target.png", "the old picture");
    QVERIFY(::symlink("target.png", QFile::encodeName(path("link.png")).constData()) == 0);
    QVERIFY(::symlink("not-yet.png", QFile::encodeName(path("early.png")).constData()) == 0);
    for (const char* name : {"link.png", "early.png"}) {
        const Outcome outcome = run({"sample", "wood", "-o", name, "--size", "16x16"});
        QVERIFY2(outcome.code == 0, outcome.err.constData());
        QVERIFY(QFileInfo(path(name)).isSymLink());
    }
    QVERIFY(bytes("target.png").startsWith("\x89PNG"));
    QVERIFY(bytes("not-yet.png").startsWith("\x89PNG"));
}

void TestBadInput::nameThatIsNotUnicode() {
    // QProcess passes text only and Qt cannot remove such files: the shell does both. What is
    // written names the exemplar.
    const QString script =
        QString("trap 'rm -f wood*' EXIT; name=$(printf 'wood\\377.png'); cp good.png \"$name\" && "
                "'%1' compute \"$name\" -o \"$name.exr\" --support 4 --json && "
                "'%1' noise \"$name.exr\" -o \"$name\" --size 8x8 && "
                "'%1' info \"$name\" --json")
            .arg(TXN_TEXTON_PROGRAM);
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start("/bin/sh", {"-c", script});
    QVERIFY(process.waitForFinished(kTimeoutMs));
    QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
}

void TestBadInput::stopsOnSignal_data() {
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("number");
    const auto add = [](const char* arguments, int number) {
        QTest::newRow(arguments) << arguments << number;
    };
    add("noise t.exr -o new.exr --size 20000x20000", SIGINT);
    add("noise t.exr -o old.exr --size 20000x20000", SIGTERM);
    add("noise t.png -o old.png --size 20000x20000 --scale 3", SIGHUP);
    add("compute good.png -o new.exr --support 16 --method projections --iterations 100000",
        SIGTERM);
    add("sheet good.png -o old.png --support 16 --method projections --iterations 100000", SIGINT);
    add("sample wood -o new.exr --size 6000x6000", SIGINT);
    add("gaussian good.png -o old.png --size 6000x6000", SIGTERM);
}

void TestBadInput::stopsOnSignal() {
    QFETCH(QString, arguments);
    QFETCH(int, number);
    constexpr int kStopMs = 10'000 * kSlowdown;
    const Listing before = listing(m_folder.path());
    QElapsedTimer timer;
    const Outcome outcome = run(split(arguments), {}, [&](QProcess& process, Outcome&) {
        process.waitForStarted();
        // Nothing shows from outside that the work has begun: files have no names until the end.
        QTest::qWait(kSlowdown > 1 ? 2500 : 1000);
        timer.start();
        // No process has the number 0, but kill() would take it for everybody.
        QVERIFY2(process.processId() > 0, "it has finished already");
        ::kill(static_cast<pid_t>(process.processId()), number);
    });
    QVERIFY(outcome.inTime);
    QVERIFY2(timer.elapsed() < kStopMs, qPrintable(QString::number(timer.elapsed()) + " ms"));
    QVERIFY2(outcome.normal, "the signal killed it");
    QCOMPARE(outcome.code, 1);
    checkOneLine(outcome, "stopped");
    QCOMPARE(outcome.out, QByteArray());
    QCOMPARE(differences(before, listing(m_folder.path())), QStringList());
}

QTEST_GUILESS_MAIN(TestBadInput)
#include "TestBadInput.moc"
