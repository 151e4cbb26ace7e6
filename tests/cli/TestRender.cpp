// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageIo.h"
#include "tests/helpers/Images.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace txn;
using txn::test::imageDistance;

namespace {

constexpr int kTimeoutMs = 300'000;

struct Outcome {
    int code = -1; ///< -1: it crashed or hung
    QByteArray out;
    QByteArray err;
};

} // namespace

/// `texton render` as users run it, headless. Skipped where there is no OpenGL, unless
/// TXN_REQUIRE_GL is 1.
class TestRender : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void flatViewIsTheNoiseOfTheOtherCommand();
    void everyViewAndFilter_data();
    void everyViewAndFilter();
    void sameEveryTime();
    void readsMeshes();
    void refusesOneLine_data();
    void refusesOneLine();
    void saysSoWithoutOpenGl_data();
    void saysSoWithoutOpenGl();

  private:
    Outcome run(const QString& arguments, const QStringList& environment = {}) const;
    Image image(const QString& name) const;
    QString path(const QString& name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

Outcome TestRender::run(const QString& arguments, const QStringList& environment) const {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.setEnvironment(QProcess::systemEnvironment() + environment);
    process.start(TXN_TEXTON_PROGRAM, arguments.split(' '));
    if (!process.waitForFinished(kTimeoutMs)) {
        process.kill();
        process.waitForFinished();
        return {-1, {}, "it ran too long"};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(),
            process.readAllStandardError()};
}

Image TestRender::image(const QString& name) const {
    auto loaded = loadImage(path(name).toStdString());
    return loaded ? std::move(loaded->image) : Image();
}

void TestRender::initTestCase() {
    QVERIFY(m_folder.isValid());
    for (const char* command : {"sample wood -o wood.png --size 96x64 --seed 3",
                                "compute wood.png -o t.exr --support 24 --iterations 20"})
        QCOMPARE(run(command).code, 0);
    const Outcome first = run("render t.exr -o first.png --size 16x16");
    if (first.code == 1 && first.err.contains("cannot draw with OpenGL") &&
        qgetenv("TXN_REQUIRE_GL") != "1")
        QSKIP("there is no OpenGL here");
    QVERIFY2(first.code == 0, first.err.constData());
}

void TestRender::flatViewIsTheNoiseOfTheOtherCommand() {
    for (const QString& noise : {QString(), QString(" --process poisson --mni 30 --seed 9")}) {
        QCOMPARE(run("render t.exr -o gpu.exr --depth float --filter none --size 128x96 "
                     "--center 1000064,-52" +
                     (noise.isEmpty() ? " --seed 1" : noise))
                     .code,
                 0);
        QCOMPARE(
            run("noise t.exr -o cpu.exr --depth float --size 128x96 --origin 1000000,-100" + noise)
                .code,
            0);
        QVERIFY(imageDistance(image("gpu.exr"), image("cpu.exr")) <= 1e-4);
    }
}

void TestRender::everyViewAndFilter_data() {
    QTest::addColumn<QString>("options");
    for (const char* options : {"--view plane --zoom 3 --rotate 30",
                                "--view plane --filter mipmap --zoom 0.2",
                                "--view plane --filter supersample:3 --zoom 0.5",
                                "--view perspective",
                                "--view perspective --filter mipmap --camera 30,10",
                                "--view perspective --filter hardware --camera 30,10,2,60",
                                "--view mesh",
                                "--view mesh --mesh torus --filter none",
                                "--view surface --unlit",
                                "--view surface --mesh plane --camera 0,90 --filter supersample:2"})
        QTest::newRow(options) << options;
}

void TestRender::everyViewAndFilter() {
    QFETCH(QString, options);
    const Outcome outcome = run("render t.exr -o view.png --size 60x40 --json " + options);
    QVERIFY2(outcome.code == 0 && outcome.err.isEmpty(), outcome.err.constData());
    const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
    QCOMPARE(json["width"].toInt(), 60);
    QCOMPARE(json["height"].toInt(), 40);
    QCOMPARE(json["channels"].toInt(), 3);
    QVERIFY(!json["renderer"].toString().isEmpty());
    QVERIFY(json["milliseconds"].toDouble(-1.0) > 0.0);
    const Image picture = image("view.png");
    QCOMPARE(picture.size(), (Size{60, 40}));
    // There is something to see.
    const auto [low, high] =
        std::minmax_element(picture.samples().begin(), picture.samples().end());
    QVERIFY(*high - *low > 0.1F);
}

void TestRender::sameEveryTime() {
    for (const char* view : {"plane", "perspective", "surface"}) {
        for (const char* name : {"one.exr", "two.exr"})
            QCOMPARE(run(QString("render t.exr -o %1 --size 64x48 --view %2").arg(name, view)).code,
                     0);
        QVERIFY2(imageDistance(image("one.exr"), image("two.exr")) <= 0.0, view);
    }
}

void TestRender::readsMeshes() {
    QFile file(path("roof.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("mtllib none.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1 0\n"
               "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n");
    file.close();
    const Outcome drawn =
        run("render t.exr -o roof.png --size 64x48 --view surface --mesh roof.obj");
    QVERIFY2(drawn.code == 0, drawn.err.constData());
    const Outcome refused = run("render t.exr -o roof2.png --view mesh --mesh roof.obj");
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("roof.obj") && refused.err.contains("surface"),
             refused.err.constData());
}

void TestRender::refusesOneLine_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("says");
    QTest::newRow("no such mesh") << "--view mesh --mesh cube"
                                  << "cube";
    QTest::newRow("not a mesh") << "--view mesh --mesh wood.png"
                                << "wood.png";
    QTest::newRow("camera in the ground") << "--view perspective --camera 0,0"
                                          << "pitch";
    QTest::newRow("camera beyond the top") << "--view surface --camera 0,91"
                                           << "pitch";
    QTest::newRow("distance") << "--view surface --camera 0,10,0"
                              << "distance";
    QTest::newRow("angle of view") << "--view surface --camera 0,10,1,179"
                                   << "field of view";
    QTest::newRow("far away") << "--center 1e9,0"
                              << "centre";
    QTest::newRow("wide") << "--size 1048576x2"
                          << "1048576";
}

void TestRender::refusesOneLine() {
    QFETCH(QString, options);
    QFETCH(QString, says);
    const Outcome outcome = run("render t.exr -o refused.png " + options);
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.count('\n') == 1 && outcome.err.contains(says.toUtf8()),
             outcome.err.constData());
    QVERIFY(!QFileInfo::exists(path("refused.png")));
}

void TestRender::saysSoWithoutOpenGl_data() {
    QTest::addColumn<QString>("setting");
    QTest::newRow("no driver") << "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent";
    QTest::newRow("too old") << "MESA_GL_VERSION_OVERRIDE=2.1";
}

void TestRender::saysSoWithoutOpenGl() {
    QFETCH(QString, setting);
    const Outcome outcome = run("render t.exr -o none.png --size 16x16", {setting});
    if (outcome.code == 0 && setting.startsWith("MESA"))
        QSKIP("this driver is not Mesa's");
    QCOMPARE(outcome.code, 1);
    QVERIFY2(outcome.err.startsWith("texton: cannot draw with OpenGL") &&
                 outcome.err.count('\n') == 1,
             outcome.err.constData());
    QVERIFY(!QFileInfo::exists(path("none.png")));
}

QTEST_GUILESS_MAIN(TestRender)
#include "TestRender.moc"
