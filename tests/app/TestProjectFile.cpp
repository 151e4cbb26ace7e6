// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"
#include "app/files/Autosave.h"
#include "app/files/Thumbnail.h"
#include "core/image/ImageIo.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QCborMap>
#include <QCborValue>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <random>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

class Dice {
  public:
    explicit Dice(unsigned seed) : m_random(seed) {}
    int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }

  private:
    std::mt19937 m_random;
};

void roll(Project& p, ViewState& v, Dice& dice) {
    if (dice.pick(0, 1) == 1)
        p.edit.crop = Rect{dice.pick(0, 9), dice.pick(0, 9), {dice.pick(1, 30), dice.pick(1, 30)}};
    p.linked = dice.pick(0, 1) == 1;
    p.edit.straightenDegrees = dice.number(-45.0, 45.0);
    if (dice.pick(0, 1) == 1)
        p.edit.flattenRadiusPx = dice.number(1.0, 500.0);
    p.edit.linear = dice.pick(0, 1) == 1;
    p.edit.periodic = dice.pick(0, 1) == 1;
    p.edit.flipGreen = dice.pick(0, 1) == 1;
    p.gaussian = {static_cast<GaussianMethod>(dice.pick(0, 1)),
                  Seed{static_cast<std::uint32_t>(dice.pick(0, 1 << 30)) * 3U}};
    p.texton.shape = static_cast<TextonSettings::Shape>(dice.pick(0, 2));
    p.texton.support = {dice.pick(4, 200), dice.pick(4, 200)};
    p.texton.interpolationOrder = std::array{0, 1, 3, 5}[static_cast<std::size_t>(dice.pick(0, 3))];
    p.texton.method = static_cast<TextonMethod>(dice.pick(0, 1));
    p.texton.kernels = dice.pick(0, 16);
    p.texton.iterations = dice.pick(1, 1000);
    p.texton.momentum = dice.number(0.0, 0.99);
    p.texton.seed = Seed{static_cast<std::uint32_t>(dice.pick(0, 1 << 30))};
    p.texton.seedLocked = dice.pick(0, 1) == 1;
    p.texton.colorCorrection = dice.pick(0, 1) == 1;
    p.noise.process = static_cast<NoiseProcess>(dice.pick(0, 2));
    p.noise.meanImpacts = dice.number(0.1, 1000.0);
    p.noise.seed = Seed{0xffffffffU};
    p.noise.filter = static_cast<Filter>(dice.pick(0, 3));
    p.noise.scale = dice.number(0.1, 10.0);
    p.noise.contrast = dice.number(0.0, 10.0);
    p.noise.brightness = dice.number(-1.0, 1.0);
    p.noise.scene = static_cast<NoiseScene>(dice.pick(0, 3));
    p.noise.mesh = QStringLiteral("torus");
    p.noise.map = dice.pick(0, 1) == 1 ? QStringLiteral("height") : QString();
    p.noise.light = {dice.number(-3.0, 3.0), dice.number(0.0, 1.5)};
    p.noise.lighting = dice.pick(0, 1) == 1;
    v.layout = static_cast<ViewLayout>(dice.pick(0, 3));
    std::swap(v.shown[static_cast<std::size_t>(dice.pick(0, 3))], v.shown[0]);
    v.wipe = dice.number(0.0, 1.0);
    v.centerX = dice.number(-1e6, 1e6);
    v.centerY = dice.number(-1e6, 1e6);
    v.zoom = dice.number(0.1, 60.0);
    v.exposure = dice.number(-5.0, 5.0);
    if (dice.pick(0, 1) == 1)
        v.channel = dice.pick(0, 2);
    v.tiled = dice.pick(0, 1) == 1;
    v.yaw = dice.number(-3.0, 3.0);
    v.pitch = dice.number(-1.5, 1.5);
    v.distance = dice.number(0.2, 20.0);
}

QString writePicture(const QTemporaryDir& folder, const QString& name) {
    Image image({32, 24}, 3);
    for (std::size_t i = 0; i < image.samples().size(); ++i)
        image.samples()[i] = static_cast<float>(i % 256) / 255.0F;
    const QString path = folder.filePath(name);
    return saveImage(image, path.toStdString()) ? path : QString();
}

/// A second material, with a map of some texels.
void rollMix(MixSettings& mix, const std::shared_ptr<const Source>& source, Dice& dice) {
    mix.source = source;
    mix.edit.straightenDegrees = dice.number(-45.0, 45.0);
    mix.edit.periodic = dice.pick(0, 1) == 1;
    mix.textons = dice.pick(2, 64);
    mix.mapScale = dice.number(0.1, 10.0);
    mix.repeats = dice.pick(0, 1) == 1;
    Image map({dice.pick(1, 150), dice.pick(1, 150)}, 1);
    for (float& v : map.samples())
        v = static_cast<float>(dice.number(0.0, 1.0));
    mix.map = PaintedMap::fromImage(map);
}

/// All of the project but where its exemplar came from.
bool sameSettings(Project a, Project b) {
    a.source = b.source = nullptr;
    a.mix.source = b.mix.source = nullptr;
    a.importedTexton = b.importedTexton = nullptr;
    return a == b;
}

/// What a child process does: changes something, lets it be kept, and waits to be killed.
int beKilled(int argc, char** argv) {
    QGuiApplication application(argc, argv);
    ProjectDocument document;
    JobRunner runner;
    Autosave autosave(document, runner, QString::fromLocal8Bit(argv[2]), 10);
    const auto source = openSource(QString::fromLocal8Bit(argv[3]));
    document.change("Open", [&](Project& p) { p.source = *source; });
    document.change("Support", [](Project& p) { p.texton.support = {48, 48}; });
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, [&] {
        if (runner.isIdle() && QFileInfo(autosave.file()).size() > 0) {
            std::puts("kept");
            std::fflush(stdout);
        }
    });
    poll.start(50);
    return QGuiApplication::exec();
}

} // namespace

class TestProjectFile : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

  private slots:
    void everyFieldComesBack() {
        const auto source = openSource(writePicture(m_folder, "stone.png"));
        TXN_OK(source);
        const auto second = openSource(writePicture(m_folder, "moss.png"));
        TXN_OK(second);
        Dice dice(3);
        for (int i = 0; i < 40; ++i) {
            Project project;
            ViewState view;
            roll(project, view, dice);
            project.source = *source;
            if (i % 2 == 1)
                rollMix(project.mix, *second, dice);
            const QString path = m_folder.filePath("a.txnproj");
            TXN_OK(saveProject(project, view, path));
            const auto opened = openProject(path);
            TXN_OK(opened);
            QVERIFY(sameSettings(opened->project, project));
            QVERIFY(opened->view == view);
            QVERIFY(opened->warnings.isEmpty());
            QCOMPARE(opened->project.mix.source != nullptr, i % 2 == 1);
            if (i % 2 == 1)
                QCOMPARE(opened->project.mix.source->name(), "moss.png");
            QVERIFY((*opened->project.source->picture())->image == (*(*source)->picture())->image);
            QCOMPARE(opened->project.source->name(), "stone.png");
            QCOMPARE(opened->project.source->hash(), (*source)->hash());
        }
    }

    void fileManagersFindAPicture() {
        const auto source = openSource(writePicture(m_folder, "stone.png"));
        TXN_OK(source);
        Project project;
        project.source = *source;
        project.edit.crop = Rect{0, 0, {24, 12}};
        const QString path = m_folder.filePath("seen.txnproj");
        TXN_OK(saveProject(project, {}, path, thumbnail(project)));
        const QString small = m_folder.filePath("seen");
        QCOMPARE(
            QProcess::execute(TXN_TEXTON_PROGRAM, {"thumbnail", path, "-o", small, "--size", "16"}),
            0);
        const QImage picture(small, "PNG");
        QCOMPARE(picture.size(), QSize(16, 8));
        TXN_OK(openProject(path));
    }

    void linkedExemplarsMoveWithTheirFolder() {
        QTemporaryDir first;
        QTemporaryDir second;
        const auto source = openSource(writePicture(first, "wood.png"));
        TXN_OK(source);
        Project project;
        project.source = *source;
        project.linked = true;
        TXN_OK(saveProject(project, {}, first.filePath("w.txnproj")));
        QFile file(first.filePath("w.txnproj"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(!file.readAll().contains(first.path().toUtf8()));
        QVERIFY(QFile::copy(first.filePath("w.txnproj"), second.filePath("w.txnproj")));
        TXN_FAILS_WITH(openProject(second.filePath("w.txnproj")), ErrorCode::NotFound);
        QVERIFY(QFile::copy(first.filePath("wood.png"), second.filePath("wood.png")));
        const auto moved = openProject(second.filePath("w.txnproj"));
        TXN_OK(moved);
        QVERIFY(moved->warnings.isEmpty());
        QVERIFY(moved->project.linked);
        QFile picture(second.filePath("wood.png"));
        QVERIFY(picture.open(QIODevice::Append) && picture.write("x") == 1);
        picture.close();
        const auto changed = openProject(second.filePath("w.txnproj"));
        TXN_OK(changed);
        QCOMPARE(changed->warnings.size(), 1);
    }

    void filesOutsideAreOpenedOnlyWhenAllowed_data() {
        QTest::addColumn<bool>("throughLink");
        QTest::newRow("up and down again") << false;
        QTest::newRow("symbolic link") << true;
    }
    void filesOutsideAreOpenedOnlyWhenAllowed() {
        QFETCH(const bool, throughLink);
        QTemporaryDir whole;
        QVERIFY(QDir(whole.path()).mkdir("project"));
        const auto source = openSource(writePicture(whole, "secret.png"));
        TXN_OK(source);
        const QString path = whole.filePath("project/p.txnproj");
        Project project;
        project.source = *source;
        project.linked = true;
        TXN_OK(saveProject(project, {}, path));
        if (throughLink) {
            // As a project that was saved beside the picture has it.
            QVERIFY(
                QFile::copy(whole.filePath("secret.png"), whole.filePath("project/secret.png")));
            project.source = *openSource(whole.filePath("project/secret.png"));
            TXN_OK(saveProject(project, {}, path));
            QVERIFY(QFile::remove(whole.filePath("project/secret.png")));
            QVERIFY(
                QFile::link(whole.filePath("secret.png"), whole.filePath("project/secret.png")));
        }
        const auto asked = openProject(path);
        TXN_OK(asked);
        QCOMPARE(asked->outside.size(), 1);
        QVERIFY(asked->project.source == nullptr);
        const auto allowed = openProject(path, Trust{.outside = true, .pictures = {}});
        TXN_OK(allowed);
        QVERIFY(allowed->outside.isEmpty());
        QVERIFY(allowed->project.source != nullptr);
    }

    void allOfThemAreAskedForAtOnce() {
        QTemporaryDir whole;
        QVERIFY(QDir(whole.path()).mkdir("project"));
        QFile mesh(whole.filePath("m.obj"));
        QVERIFY(mesh.open(QIODevice::WriteOnly) && mesh.write("v 0 0 0\n") > 0);
        mesh.close();
        const auto source = openSource(writePicture(whole, "p.png"));
        TXN_OK(source);
        Project project;
        project.source = *source;
        project.linked = true;
        project.noise.mesh = whole.filePath("m.obj");
        const QString path = whole.filePath("project/p.txnproj");
        TXN_OK(saveProject(project, {}, path));
        const auto asked = openProject(path);
        TXN_OK(asked);
        QCOMPARE(asked->outside, (QStringList{whole.filePath("m.obj"), whole.filePath("p.png")}));
        const auto allowed = openProject(path, Trust{.outside = true, .pictures = {}});
        TXN_OK(allowed);
        QCOMPARE(allowed->project.noise.mesh, whole.filePath("m.obj"));
    }

    /// Whatever the file says: an absolute path is no link of ours.
    void absolutePathsAreNeverFollowed() {
        const QString picture = writePicture(m_folder, "absolute.png");
        QFile mesh(m_folder.filePath("absolute.obj"));
        QVERIFY(mesh.open(QIODevice::WriteOnly) && mesh.write("v 0 0 0\n") > 0);
        mesh.close();
        const QCborMap head{{QStringLiteral("format"), QStringLiteral("texton-studio-project")},
                            {QStringLiteral("version"), 1}};
        QCborMap linked = head;
        linked[QStringLiteral("exemplar")] = QCborMap{{QStringLiteral("link"), picture}};
        const QString path = m_folder.filePath("a.txnproj");
        TXN_FAILS_WITH(decodeProject(QCborValue(linked).toCbor(),
                                     path,
                                     Trust{.outside = true, .pictures = {}}),
                       ErrorCode::Unreadable);
        QCborMap meshed = head;
        meshed[QStringLiteral("noise")] = QCborMap{{QStringLiteral("mesh"), mesh.fileName()}};
        const auto opened = decodeProject(QCborValue(meshed).toCbor(),
                                          path,
                                          Trust{.outside = true, .pictures = {}});
        TXN_OK(opened);
        QCOMPARE(opened->project.noise.mesh, NoiseSettings{}.mesh);
        QCOMPARE(opened->warnings.size(), 1);
    }

    /// A way over the root would tell all of the path: then the bytes go into the file.
    void pathsOfTheMachineAreNotWritten() {
        const auto source = openSource(writePicture(m_folder, "private.png"));
        TXN_OK(source);
        Project project;
        project.source = *source;
        project.noise.mesh = m_folder.filePath("private.obj");
        const QByteArray bytes =
            encodeProject(project, {}, ExemplarStorage::Linked, "/somewhere/else");
        for (const QString& part : m_folder.path().split('/', Qt::SkipEmptyParts))
            QVERIFY(!bytes.contains(part.toUtf8()));
        QVERIFY(bytes.contains("private.obj"));
    }

    void samplesAreMadeAnew() {
        const auto source = sampleSource("sand");
        TXN_OK(source);
        Project project;
        project.source = *source;
        const QByteArray bytes = encodeProject(project, {}, ExemplarStorage::Embedded, "/");
        QVERIFY(bytes.size() < 4000);
        const auto opened = decodeProject(bytes, "/x.txnproj");
        TXN_OK(opened);
        QVERIFY((*opened->project.source->picture())->image == (*(*source)->picture())->image);
    }

    void importedTextonsAreExact() {
        for (const int channels : {1, 3, 7}) {
            TextonRecipe recipe;
            recipe.channels = channels;
            recipe.kernels = 2;
            recipe.order = 3;
            auto asset = std::make_shared<TextonAsset>();
            asset->texton = makeTexton(recipe);
            asset->exemplarName = "a \"name\"";
            asset->meanImpacts = 17.25;
            Project project;
            project.importedTexton = asset;
            const auto opened =
                decodeProject(encodeProject(project, {}, ExemplarStorage::Embedded, "/"), "/x");
            TXN_OK(opened);
            QVERIFY(*opened->project.importedTexton == *asset);
        }
    }

    void damageIsRefusedAndNeverWorse() {
        const auto source = openSource(writePicture(m_folder, "s.png"));
        TXN_OK(source);
        Dice dice(11);
        Project project;
        project.source = *source;
        rollMix(project.mix, *source, dice);
        const QByteArray whole = encodeProject(project, {}, ExemplarStorage::Embedded, "/");
        for (qsizetype n = 0; n < whole.size(); n += 1 + whole.size() / 100)
            QVERIFY(!decodeProject(whole.left(n), "/x.txnproj"));
        for (int i = 0; i < 300; ++i) {
            QByteArray bytes = whole;
            for (int k = 0; k < 3; ++k)
                bytes[dice.pick(0, static_cast<int>(bytes.size()) - 1)] =
                    static_cast<char>(dice.pick(0, 255));
            const auto opened = decodeProject(bytes, "/x.txnproj");
            if (!opened)
                QVERIFY(opened.error().message.find("x.txnproj") != std::string::npos);
        }
        for (const char* junk : {"", "hello", "{}", "\xd9\xd9\xf7\xa0"})
            TXN_FAILS_WITH(decodeProject(junk, "/x.txnproj"), ErrorCode::Unreadable);
    }

    void whatCannotBeSavedSaysSoAndHurtsNothing() {
        const auto saved = saveProject({}, {}, "/nowhere/a.txnproj");
        TXN_FAILS_WITH(saved, ErrorCode::Unwritable);
        QVERIFY(saved.error().message.find("a.txnproj") != std::string::npos);
    }

    void workComesBackAfterAKill() {
        QTemporaryDir recovery;
        const QString picture = writePicture(m_folder, "killed.png");
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(),
                    {"--be-killed", recovery.path(), picture});
        QVERIFY(child.waitForStarted());
        // What came between two looks counts, too.
        QTRY_VERIFY_WITH_TIMEOUT(child.bytesAvailable() > 0 || child.waitForReadyRead(50), 20000);
        QVERIFY(findRecoverable(recovery.path()).empty()); // it lives
        ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
        QVERIFY(child.waitForFinished());
        const auto copies = findRecoverable(recovery.path());
        QCOMPARE(copies.size(), std::size_t{1});
        QCOMPARE(copies.front().title, "killed.png");
        QVERIFY(!copies.front().thumbnail.isNull());
        const auto back = readRecovered(copies.front());
        TXN_OK(back);
        QCOMPARE(back->project.texton.support, (Size{48, 48}));
        QCOMPARE(back->project.source->size(), (Size{32, 24}));
        discard(copies.front());
        QVERIFY(findRecoverable(recovery.path()).empty());
    }

    void closingLeavesNoCopy() {
        QTemporaryDir recovery;
        JobRunner runner;
        ProjectDocument document;
        {
            Autosave autosave(document, runner, recovery.path(), 5);
            document.change("Support", [](Project& p) { p.texton.support = {48, 48}; });
            TXN_COMES_TRUE(QFileInfo(autosave.file()).size() > 0);
            document.undoStack().undo();
            TXN_COMES_TRUE(!QFileInfo::exists(autosave.file()));
            document.undoStack().redo();
            TXN_COMES_TRUE(QFileInfo(autosave.file()).size() > 0);
            document.setSaved("/somewhere/a.txnproj");
            TXN_COMES_TRUE(!QFileInfo::exists(autosave.file()));
        }
        QVERIFY(QDir(recovery.path()).entryList({"*.recovery"}).isEmpty());
    }
};

int main(int argc, char** argv) {
    if (argc > 3 && QByteArray(argv[1]) == "--be-killed")
        return beKilled(argc, argv);
    QGuiApplication application(argc, argv);
    TestProjectFile test;
    return QTest::qExec(&test, argc, argv);
}
#include "TestProjectFile.moc"
