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

#ifdef TXN_SANITIZED
constexpr int kTimeoutMs = 600'000;
#else
constexpr int kTimeoutMs = 60'000;
#endif

/// The image read from a place inside it and around its borders.
Image shifted(const Image& image, int left, int top) {
    Image result = image;
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                result.at(x, y, c) =
                    image.at((x + left) % image.width(), (y + top) % image.height(), c);
        }
    }
    return result;
}

Image part(const Image& image, int left, int top, Size size) {
    Image result(size, image.channels(), 0.0F, image.transfer());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x)
                result.at(x, y, c) = image.at(left + x, top + y, c);
        }
    }
    return result;
}

} // namespace

/// The main job, done with the real program as a user would: from a picture to a texton, from that
/// to noise, and all commands on the way.
class TestStory : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void reportsTexton();
    void fitsWithSeveralKernels();
    void makesMaterialsOfSeveralMaps();
    void mixesTwoMaterials();
    void mixesWhereTheMapSays();
    void suggestsASupport();
    void sameNoiseFromAllFormats();
    void tileWraps();
    void threadsDoNotMatter();
    void repeatsItself();
    void originIsAPlaceInOnePlane();
    void comparesItselfAsEqual();
    void comparesNoise();
    void describesFiles_data();
    void describesFiles();
    void makesGaussianVersion();
    void makesPeriodicComponent();
    void makesSheet();
    void drawsThumbnails();
    void projectsWithoutAPictureSaySo();

  private:
    /// Standard output; the run must end well and say nothing on standard error.
    QByteArray run(const QString& arguments) const;
    /// The same as one JSON object.
    QJsonObject json(const QString& arguments) const;
    QByteArray bytes(const QString& name) const;
    /// Whether the run ends with an error, and every file stays as it was.
    bool refuses(const QString& arguments) const;
    Image image(const QString& name) const;
    /// Runs `noise` with these options and reads the float EXR.
    Image noise(const QString& texton, const QString& options) const;

    QTemporaryDir m_folder;
    QJsonObject m_report;
};

QByteArray TestStory::run(const QString& arguments) const {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(TXN_TEXTON_PROGRAM, arguments.split(' '));
    const bool inTime = process.waitForFinished(kTimeoutMs);
    const QByteArray err = process.readAllStandardError();
    if (!inTime || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0 ||
        !err.isEmpty()) {
        QTest::qFail(qPrintable(arguments + ": " + process.errorString() + ": " + err),
                     __FILE__,
                     __LINE__);
        return {};
    }
    return process.readAllStandardOutput();
}

QJsonObject TestStory::json(const QString& arguments) const {
    QJsonParseError error;
    // Refuses anything after the object.
    const auto document = QJsonDocument::fromJson(run(arguments + " --json"), &error);
    if (!document.isObject())
        QTest::qFail(qPrintable(arguments + ": " + error.errorString()), __FILE__, __LINE__);
    return document.object();
}

QByteArray TestStory::bytes(const QString& name) const {
    QFile file(m_folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool TestStory::refuses(const QString& arguments) const {
    const auto all = [this] {
        QMap<QString, QByteArray> files;
        for (const QString& name : QDir(m_folder.path()).entryList(QDir::Files))
            files[name] = bytes(name);
        return files;
    };
    const auto before = all();
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(TXN_TEXTON_PROGRAM, arguments.split(' '));
    return process.waitForFinished(kTimeoutMs) && process.exitCode() == 1 && all() == before;
}

Image TestStory::image(const QString& name) const {
    auto loaded = loadImage(m_folder.filePath(name).toStdString());
    return loaded ? std::move(loaded->image) : Image();
}

Image TestStory::noise(const QString& texton, const QString& options) const {
    run("noise " + texton + " -o noise.exr --depth float " + options);
    return image("noise.exr");
}

void TestStory::initTestCase() {
    QVERIFY(m_folder.isValid());
    run("sample wood -o wood.png --size 96x64 --seed 3");
    QCOMPARE(image("wood.png").size(), (Size{96, 64}));
    m_report = json("compute wood.png -o t.exr -o t.png -o t.texton --support 24x16 "
                    "--method projections --iterations 20 --seed 7");
}

void TestStory::reportsTexton() {
    QCOMPARE(m_report["width"].toInt(), 96);
    QCOMPARE(m_report["height"].toInt(), 64);
    QCOMPARE(m_report["channels"].toInt(), 3);
    QCOMPARE(m_report["support"].toArray(), (QJsonArray{24, 16}));
    QCOMPARE(m_report["order"].toInt(-1), 1);
    QCOMPARE(m_report["iterations"].toInt(), 20);
    QCOMPARE(m_report["seed"].toInt(), 7);
    for (const char* key : {"rme", "rme_corrected"}) {
        const double error = m_report[key].toDouble(-1.0);
        QVERIFY2(error > 0.0 && error < 1.0, key);
    }
    const QJsonObject seconds = m_report["seconds"].toObject();
    for (const char* key : {"load", "solve", "write"})
        QVERIFY2(seconds[key].toDouble(-1.0) >= 0.0, key);
    const QJsonArray outputs = m_report["outputs"].toArray();
    QCOMPARE(outputs.size(), 6); // each with its sidecar
    for (const auto& output : outputs)
        QVERIFY2(!bytes(output.toString()).isEmpty(), qPrintable(output.toString()));
}

void TestStory::fitsWithSeveralKernels() {
    const QString command = "compute wood.png --method fit --support 16 --seed 7 ";
    const QJsonObject two = json(command + "--kernels 2 -o fit.exr -o fit.png");
    QCOMPARE(two["method"].toString(), "fit");
    QCOMPARE(two["kernels"].toInt(), 2);
    QVERIFY(two["rme"].isNull() && !two.contains("iterations"));
    QVERIFY(two["covariance_error_floor"].toDouble() > 0.0);
    const QJsonObject chosen = json(command + "-o auto.exr");
    QVERIFY(chosen["kernels"].toInt() == 1 || chosen["kernels"].toInt() == 2);
    // Closer than the papers' method where colours vary independently, by the dial made for it.
    run("sample stone -o stone.png --size 192x160 --seed 3");
    const QString stone = "compute stone.png --support 16 --seed 7 -o stone.exr --method ";
    const double fitted = json(stone + "fit --kernels 2")["covariance_error"].toDouble(1e9);
    const double papers = json(stone + "projections")["covariance_error"].toDouble(0.0);
    QVERIFY2(fitted < papers, QByteArray::number(fitted) + " and " + QByteArray::number(papers));
    // Where a file holds one kernel only, no more are tried.
    QCOMPARE(json(stone + "fit -o one.texton")["kernels"].toInt(), 1);
    // Both kernels are in the files, and in the noise.
    const Image fromExr = noise("fit.exr", "--size 128x96 --seed 5");
    QVERIFY(imageDistance(fromExr, noise("fit.png", "--size 128x96 --seed 5")) <= 4e-3);
    run(command + "--kernels 2 -o once.exr");
    QVERIFY(bytes("once.exr") == bytes("fit.exr"));
    run("sheet wood.png --method fit --support 16 -o fit_sheet.png");
}

void TestStory::makesMaterialsOfSeveralMaps() {
    run("sample stone -o albedo.png --size 96x80 --seed 1");
    run("sample sand -o rough.png --size 96x80 --seed 2");
    // Normals of any kind: what counts is that they come back as unit vectors.
    run("sample cloth -o bumps.png --size 96x80 --seed 3");
    const QJsonObject report = json("compute --stack color=albedo.png --stack normal=bumps.png "
                                    "--stack extra=rough.png --support 12 --kernels 2 "
                                    "-o rock.exr -o rock.png");
    QCOMPARE(report["channels"].toInt(), 8);
    QCOMPARE(report["kernels"].toInt(), 2);
    const QString options = " --size 64x48 --seed 5 --depth float";
    QCOMPARE(json("noise rock.exr -o layers.exr" + options)["outputs"].toArray().size(), 1);
    QCOMPARE(image("layers.exr").channels(), 9);
    QCOMPARE(json("noise rock.exr -o made.png --size 64x48 --seed 5")["outputs"].toArray().size(),
             3);
    QCOMPARE(image("made_color.png").size(), (Size{64, 48}));
    const Image normals = image("made_normal.png");
    for (int y = 0; y < normals.height(); ++y) {
        for (int x = 0; x < normals.width(); ++x) {
            double length = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double n = 2.0 * static_cast<double>(normals.at(x, y, c)) - 1.0;
                length += n * n;
            }
            QVERIFY(std::abs(std::sqrt(length) - 1.0) < 0.01);
        }
    }
    // The set of PNGs makes the noise of the EXR, whichever of its names it is called by.
    for (const char* name : {"rock.png", "rock.png.json"}) {
        run(QString("noise %1 -o set.exr").arg(name) + options);
        QVERIFY(imageDistance(image("set.exr"), image("layers.exr")) <= 0.02);
    }
    QCOMPARE(json("info rock.png")["maps"].toArray().size(), 3);
    // Nothing that is read is written over, under none of its names.
    for (const char* command :
         {"noise rock.png -o rock.png --size 8x8",
          "noise rock.png.json -o rock.png --size 8x8",
          "render rock.png -o rock_color.png --size 8x8",
          "compute --stack color=rock_color.png --stack normal=rock_normal.png -o rock.png"})
        QVERIFY2(refuses(command), command);
    run("sheet --stack color=albedo.png --stack normal=bumps.png --support 12 -o maps.png");
}

void TestStory::mixesTwoMaterials() {
    run("sample sand -o sand.png --size 80x72 --seed 4");
    const QString command =
        "mix wood.png sand.png --size 300x80 --depth float --support 16 --strips 5 ";
    for (const char* method : {"fit", "projections"}) {
        const QJsonObject report = json(
            command + "--save-textons parts -o mixed.exr --seed 7 --method " + QString(method));
        QCOMPARE(report["method"].toString(), method);
        const QJsonArray textons = report["textons"].toArray();
        QCOMPARE(textons.size(), 5);
        const double distance = report["distance"].toDouble();
        QVERIFY(distance > 0.01);
        for (int r = 0; r < 5; ++r) {
            const QJsonObject one = textons[r].toObject();
            QCOMPARE(one["rho"].toDouble(), r / 4.0);
            QVERIFY(std::abs(one["distance"].toDouble(-1.0) - distance * r / 4.0) < 1e-4);
        }
        // The picture, the array, the description, the map, and five textons of two files each.
        const QJsonArray outputs = report["outputs"].toArray();
        QCOMPARE(outputs.size(), 14);
        for (const auto& output : outputs)
            QVERIFY2(!bytes(output.toString()).isEmpty(), qPrintable(output.toString()));
    }
    // Left and right are as bright as the materials.
    const Image mixed = image("mixed.exr");
    QCOMPARE(mixed.size(), (Size{300, 80}));
    const auto brightness = [](const Image& picture, int left, int width) {
        double sum = 0.0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = left; x < left + width; ++x)
                sum += static_cast<double>(picture.at(x, y, 2));
        }
        return sum / width / picture.height();
    };
    const double a = brightness(image("wood.png"), 0, 96);
    const double b = brightness(image("sand.png"), 0, 80);
    QVERIFY(std::abs(a - b) > 0.1);
    QVERIFY(std::abs(brightness(mixed, 0, 30) - std::lerp(a, b, 0.05)) < 0.04);
    QVERIFY(std::abs(brightness(mixed, 270, 30) - std::lerp(a, b, 0.95)) < 0.04);

    // Every texton is a file of its own, and a layer of the one with all of them.
    const auto description = QJsonDocument::fromJson(bytes("parts/mixture.json")).object();
    QCOMPARE(description["format"].toString(), "texton-mixture");
    const auto all = loadImage(m_folder.filePath("parts/textons.exr").toStdString());
    QVERIFY(bool(all));
    for (const auto& entry : description["textons"].toArray()) {
        const QJsonObject one = entry.toObject();
        const QString file = "parts/" + one["file"].toString();
        QVERIFY(!json("info " + file)["kernels"].isNull());
        const auto own = loadImage(m_folder.filePath(file).toStdString());
        for (std::size_t c = 0; c < own->channelNames.size(); ++c) {
            const auto name = one["layer"].toString().toStdString() + "." + own->channelNames[c];
            const auto at = std::ranges::find(all->channelNames, name);
            QVERIFY2(at != all->channelNames.end(), name.c_str());
            QVERIFY(std::ranges::equal(
                all->image.plane(static_cast<int>(at - all->channelNames.begin())),
                own->image.plane(static_cast<int>(c))));
        }
    }
    run("noise parts/texton_02.exr -o middle.png --size 32x32");
    // The same again, and other noise with another seed.
    run(command + "-o again.exr --seed 7 --method projections");
    QVERIFY(bytes("again.exr") == bytes("mixed.exr"));
    run(command + "-o other.exr --seed 7 --method projections --noise-seed 2");
    QVERIFY(bytes("other.exr") != bytes("mixed.exr"));
    run(command + "-o turned.exr --angle 90 --ease smooth");

    // Stacks: one picture for each map.
    run("sample stone -o other.png --size 96x64 --seed 9");
    const QJsonObject stacks =
        json("mix --stack-a color=wood.png --stack-a extra=wood.png --stack-b color=other.png "
             "--stack-b extra=other.png -o set.png --size 64x48 --support 12 --strips 3");
    QCOMPARE(stacks["channels"].toInt(), 6);
    QCOMPARE(image("set_color.png").size(), (Size{64, 48}));
    QVERIFY(refuses("mix --stack-a color=wood.png --stack-b extra=other.png -o bad.png "
                    "--size 64x48 --support 12"));
}

void TestStory::mixesWhereTheMapSays() {
    run("sample sand -o sand.png --size 80x72 --seed 4");
    // All of A, then all of B: as bright, and not the same picture.
    Image map({8, 4}, 1);
    const auto save = [&](const char* name) {
        QVERIFY(bool(saveImage(map, m_folder.filePath(name).toStdString())));
    };
    save("black.png");
    std::ranges::fill(map.samples(), 1.0F);
    save("white.png");
    const QString command =
        "mix wood.png sand.png --size 90x64 --depth float --support 16 --strips 3 ";
    run(command + "-o a.exr --map black.png --save-textons few");
    run(command + "-o b.exr --map white.png");
    // A map of one value is the noise of that texton alone, bit by bit.
    run("noise few/texton_00.exr -o alone.exr --size 90x64 --depth float");
    QVERIFY(imageDistance(image("alone.exr"), image("a.exr")) <= 0.0);
    run("noise few/texton_02.exr -o alone.exr --size 90x64 --depth float");
    QVERIFY(imageDistance(image("alone.exr"), image("b.exr")) <= 0.0);
    // With --tile, the map repeats and so does the noise.
    for (int x = 4; x < 8; ++x) {
        for (int y = 0; y < 4; ++y)
            map.at(x, y, 0) = 0.0F;
    }
    save("half.png");
    const QJsonObject tile = json(command + "-o tile.exr --map half.png --tile");
    QCOMPARE(tile["tile"].toBool(), true);
    const Image picture = image("tile.exr");
    const auto step = [&](int left) {
        double sum = 0.0;
        for (int y = 0; y < picture.height(); ++y)
            sum += std::pow(
                static_cast<double>(picture.at((left + 1) % 90, y, 0) - picture.at(left, y, 0)),
                2);
        return sum / picture.height();
    };
    double inside = 0.0;
    for (int x = 0; x < 89; ++x)
        inside = std::max(inside, step(x));
    QVERIFY(step(89) <= inside);
}

void TestStory::suggestsASupport() {
    const QJsonObject report = json("compute wood.png -o suggested.exr --support auto");
    const int side = report["support"].toArray().at(0).toInt();
    QVERIFY(side >= 16 && side <= 32);
    QVERIFY(report["support_error"].toDouble(-1.0) >= 0.0);
}

void TestStory::sameNoiseFromAllFormats() {
    const QString options = "--size 128x96 --seed 5";
    const Image fromExr = noise("t.exr", options);
    QCOMPARE(fromExr.size(), (Size{128, 96}));
    // Both keep every float; the mean may be rounded differently on the way.
    QVERIFY(imageDistance(fromExr, noise("t.texton", options)) <= 1e-4);
    // 16 bits for each of the coefficients, of which some hundred add up.
    QVERIFY(imageDistance(fromExr, noise("t.png", options)) <= 2e-3);
}

void TestStory::tileWraps() {
    const QString options = "--size 80x64 --tile";
    const Image tile = noise("t.exr", options);
    QVERIFY(!tile.empty());
    // Rounding of the transforms, whose tiles lie elsewhere.
    QVERIFY(imageDistance(tile, noise("t.exr", options + " --origin 80,-64")) <= 1e-4);
    QVERIFY(imageDistance(shifted(tile, 33, 17), noise("t.exr", options + " --origin 33,17")) <=
            1e-4);
    // Without --tile it would not.
    QVERIFY(imageDistance(tile, noise("t.exr", "--size 80x64 --origin 80,0")) > 0.01);
}

void TestStory::threadsDoNotMatter() {
    for (const char* ending : {"png", "exr"}) {
        QByteArray first;
        for (const char* threads : {"", " --threads 1", " --threads 2"}) {
            const QString name = QString("threads.%1").arg(ending);
            run("noise t.exr --size 200x150 -o " + name + threads);
            const QByteArray file = bytes(name);
            QVERIFY(!file.isEmpty());
            QVERIFY2(first.isEmpty() || file == first, threads);
            first = file;
        }
    }
}

void TestStory::repeatsItself() {
    run("compute wood.png -o again.exr -o again.png -o again.texton --support 24x16 "
        "--method projections --iterations 20 --seed 7");
    for (const char* ending : {"exr", "exr.json", "png", "png.json", "texton", "texton.json"})
        QVERIFY2(bytes(QString("again.%1").arg(ending)) == bytes(QString("t.%1").arg(ending)),
                 ending);
    for (const char* name : {"first.jpg", "second.jpg"})
        run(QString("gaussian wood.png --seed 4 -o ") + name);
    QVERIFY(bytes("first.jpg") == bytes("second.jpg"));
}

void TestStory::originIsAPlaceInOnePlane() {
    const Image plane = noise("t.exr", "--size 260x140");
    const Image window = noise("t.exr", "--size 200x100 --origin 37,11");
    QCOMPARE(window.size(), (Size{200, 100}));
    QVERIFY(imageDistance(part(plane, 37, 11, {200, 100}), window) <= 1e-5);
    const Image before = noise("t.exr", "--size 150x110 --origin -50,-60");
    QVERIFY(imageDistance(part(before, 50, 60, {100, 50}), part(plane, 0, 0, {100, 50})) <= 1e-5);
}

void TestStory::comparesItselfAsEqual() {
    for (const char* name : {"wood.png", "t.exr", "t.png"}) {
        const QJsonObject result = json(QString("compare %1 %1").arg(name));
        for (const char* key : {"mean_difference",
                                "covariance_error",
                                "color_covariance_error",
                                "spectrum_difference_db"}) {
            QVERIFY2(result[key].isDouble() && std::abs(result[key].toDouble()) <= 1e-9, key);
        }
    }
}

void TestStory::comparesNoise() {
    run("noise t.exr -o large.png --size 256x256");
    const QJsonObject result = json("compare t.exr large.png");
    // A sample of 65536 pixels with features of some ten strays by that many percent.
    QVERIFY(result["mean_difference"].toDouble(1.0) < 0.05);
    QVERIFY(result["covariance_error"].toDouble(1.0) < 0.5);
    QVERIFY(run("compare wood.png large.png").contains("covariance error"));
}

void TestStory::describesFiles_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("kind");
    QTest::newRow("picture") << "wood.png"
                             << "picture";
    QTest::newRow("EXR texton") << "t.exr"
                                << "texton";
    QTest::newRow("PNG texton") << "t.png"
                                << "texton";
    QTest::newRow("text texton") << "t.texton"
                                 << "texton";
}

void TestStory::describesFiles() {
    QFETCH(QString, name);
    QFETCH(QString, kind);
    const QJsonObject result = json("info " + name);
    QCOMPARE(result["kind"].toString(), kind);
    QCOMPARE(result["channels"].toInt(), 3);
    QVERIFY(run("info " + name).contains("channels"));
}

void TestStory::makesGaussianVersion() {
    run("gaussian wood.png -o gaussian.png");
    QCOMPARE(image("gaussian.png").size(), (Size{96, 64}));
    run("gaussian wood.png -o enlarged.tif --model rpn --size 150x100");
    QCOMPARE(image("enlarged.tif").size(), (Size{150, 100}));
}

void TestStory::makesPeriodicComponent() {
    run("periodic wood.png -o periodic.exr");
    QCOMPARE(image("periodic.exr").size(), (Size{96, 64}));
}

void TestStory::makesSheet() {
    run("sheet wood.png -o sheet.png --support 16 --iterations 5");
    const Image sheet = image("sheet.png");
    QVERIFY(sheet.width() > 2 * 96 && sheet.height() > 2 * 64);
}

void TestStory::drawsThumbnails() {
    run("thumbnail t.texton -o noname --size 40");
    QCOMPARE(image("noname").size(), (Size{40, 40}));
    run("thumbnail wood.png -o small.png --size 48");
    const Image small = image("small.png");
    QCOMPARE(small.size(), (Size{48, 32}));
    // The same material on the average, and no larger than it was.
    const auto mean = [](const Image& picture, int c) {
        double sum = 0.0;
        for (const float sample : picture.plane(c))
            sum += static_cast<double>(sample);
        return sum / static_cast<double>(picture.plane(c).size());
    };
    for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(mean(small, c) - mean(image("wood.png"), c)) <= 0.01);
    run("thumbnail wood.png -o same.png --size 1024");
    QVERIFY(image("same.png") == image("wood.png"));
}

void TestStory::projectsWithoutAPictureSaySo() {
    const QByteArray signature("\xd9\xd9\xf7");
    const auto refused = [&](const QByteArray& content) {
        QFile file(m_folder.filePath("a.txnproj"));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() &&
               file.flush() && refuses("thumbnail a.txnproj -o never.png");
    };
    QVERIFY(refused(signature));
    QVERIFY(refused(signature + QCborValue(QCborMap{{"format", "x"}}).toCbor()));
    QVERIFY(refused(signature + QCborValue(QCborMap{{"thumbnail", 1}}).toCbor()));
    QVERIFY(refused(signature +
                    QCborValue(QCborMap{{"thumbnail", QByteArray("no picture")}}).toCbor()));
    QCborMap inner{{"thumbnail", bytes("wood.png")}};
    QVERIFY(refused(signature + QCborValue(QCborMap{{"view", inner}}).toCbor()));
    QVERIFY(refused(signature + QByteArray(1'000'000, '\x81'))); // as deep as that
    QVERIFY(
        refused(signature + QByteArray("\xbf\x69thumbnail\x5b\x7f\xff\xff\xff\xff\xff\xff", 19)));
    inner.insert(QStringLiteral("format"), QStringLiteral("x"));
    QFile file(m_folder.filePath("b.txnproj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(signature + QCborValue(inner).toCbor());
    file.close();
    run("thumbnail b.txnproj -o project.png --size 24");
    QCOMPARE(image("project.png").size(), (Size{24, 16}));
}

QTEST_GUILESS_MAIN(TestStory)
#include "TestStory.moc"
