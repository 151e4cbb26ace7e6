// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/EngineExport.h"
#include "app/export/ExportJob.h"
#include "app/export/ExportPresets.h"
#include "app/panels/ExportDialog.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "core/export/Exporter.h"
#include "core/noise/SpotNoise.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

class Context final : public JobContext {
  public:
    const CancelToken& token() const override { return m_token; }
    void setProgress(double share) override { progress = share; }
    void deliver(Delivery) override {}

    double progress = 0.0;
    CancelSource source;

  private:
    CancelToken m_token = source.token();
};

/// A texton of colours within [0, 1].
Texton quietTexton() {
    TextonRecipe recipe;
    recipe.size = {12, 10};
    Texton texton = makeTexton(recipe);
    for (Image& kernel : texton.kernels) {
        for (float& v : kernel.samples())
            v *= 0.08F;
    }
    texton.mean = {0.4, 0.5, 0.6};
    return texton;
}

ExportSnapshot snapshotOf(const Texton& texton) {
    ExportSnapshot snapshot;
    snapshot.name = "stone";
    snapshot.asset.texton = texton;
    snapshot.noise.meanImpacts = 8.0;
    snapshot.view = QImage(30, 20, QImage::Format_ARGB32_Premultiplied);
    snapshot.view.fill(Qt::red);
    return snapshot;
}

} // namespace

class TestExport : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    ExportPlan planFor(ExportKind kind) const {
        ExportPlan plan;
        plan.kind = kind;
        plan.folder = m_folder.path();
        plan.size = {96, 64};
        return plan;
    }

  private slots:
    void init() {
        for (const QFileInfo& file : QDir(m_folder.path()).entryInfoList(QDir::Files))
            QFile::remove(file.filePath());
    }

    void namesTellWhatIsInside() {
        const ExportSnapshot snapshot = snapshotOf(quietTexton());
        ExportPlan plan = planFor(ExportKind::Noise);
        plan.size = {4096, 4096};
        QCOMPARE(exportName(plan, snapshot), "stone_noise_4096_tile");
        plan.size = {4096, 2048};
        plan.tileable = false;
        QCOMPARE(exportName(plan, snapshot), "stone_noise_4096x2048");
        plan.kind = ExportKind::Texton;
        QCOMPARE(exportName(plan, snapshot), "stone_texton12x10");
        plan.nameTemplate = "{name}-{mni}-{seed}";
        QCOMPARE(exportName(plan, snapshot), "stone-8-1");
    }

    void hostileNamesAreMadeHarmless() {
        ExportSnapshot snapshot = snapshotOf(quietTexton());
        const ExportPlan plan = planFor(ExportKind::View);
        for (const char* name : {"../../etc/passwd",
                                 "a/b\\c:d",
                                 ".hidden",
                                 "",
                                 "...",
                                 "a\nb",
                                 "{size}{name}",
                                 "con*?\"<>|",
                                 "gpj\u202e.exe",
                                 "a\u2028b\u0085c\u2067d"}) {
            snapshot.name = QString::fromUtf8(name);
            const QString made = exportName(plan, snapshot);
            QVERIFY(!made.isEmpty() && !made.startsWith('.') && !made.contains('/') &&
                    !made.contains('\\'));
            QVERIFY(!made.contains('\n') && !made.contains('*') && made.size() <= 120);
            for (const char16_t control : {u'\u202e', u'\u2028', u'\u0085', u'\u2067'})
                QVERIFY(!made.contains(QChar(control)));
        }
        snapshot.name = QString(5000, 'x');
        QVERIFY(exportName(plan, snapshot).size() <= 120);
    }

    /// The name stands in a comment, in a command to copy and in strings: it ends none of them.
    void theExampleIsHarmlessUnderAnyName() {
        const std::string hostile = "a\nint evil;\r*/ \"\\'; $(touch x) `x` \u202e\u2028 end";
        const auto text = engineExample(quietTexton(), hostile);
        TXN_OK(text);
        const auto plain = engineExample(quietTexton(), "plain");
        TXN_OK(plain);
        QCOMPARE(std::count(text->begin(), text->end(), '\n'),
                 std::count(plain->begin(), plain->end(), '\n'));
        QVERIFY(text->find('\r') == std::string::npos);
        QVERIFY(text->find("\u202e") == std::string::npos);
        QVERIFY(text->find("\u2028") == std::string::npos);
        // For the shell the name is one word, and the words before and after are as they were.
        const auto command = [](const std::string& example) {
            const auto start = example.find("c++ ");
            return example.substr(start, example.find(" -o example", start) - start);
        };
        QProcess shell;
        shell.start("sh", {"-c", QString::fromStdString("printf '[%s]' " + command(*text))});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(
            QString::fromUtf8(shell.readAllStandardOutput()),
            QStringLiteral("[c++][./a int evil; */ \"\\'; $(touch x) `x`    end_example.cpp]"));
        // And a compiler takes all of it.
        QFile file(m_folder.filePath("hostile.cpp"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text->c_str()) > 0);
        file.close();
        QProcess compiler;
        compiler.start("c++", {"-fsyntax-only", file.fileName()});
        QVERIFY(compiler.waitForFinished(60000));
        QCOMPARE(compiler.readAllStandardError(), QByteArray());
        QCOMPARE(compiler.exitCode(), 0);
    }

    void theFilesAreThoseOfThePreview_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("texton") << 0;
        QTest::newRow("noise") << 1;
        QTest::newRow("view") << 2;
        QTest::newRow("engine") << 3;
    }
    void theFilesAreThoseOfThePreview() {
        QFETCH(int, kind);
        ExportPlan plan = planFor(static_cast<ExportKind>(kind));
        plan.textonPng = plan.textonFile = true;
        const ExportSnapshot snapshot = snapshotOf(quietTexton());
        Context context;
        const auto report = runExport(plan, snapshot, context);
        TXN_OK(report);
        QStringList expected = exportFiles(plan, snapshot);
        QStringList found;
        for (const QFileInfo& file :
             QDir(m_folder.path()).entryInfoList(QDir::Files | QDir::Hidden))
            found << file.filePath();
        expected.sort();
        found.sort();
        QCOMPARE(found, expected);
    }

    void everyFormatIsReadable_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<int>("depth");
        const auto row = [](const char* name, ImageFormat format, SampleFormat depth) {
            QTest::newRow(name) << static_cast<int>(format) << static_cast<int>(depth);
        };
        row("PNG 8", ImageFormat::Png, SampleFormat::UInt8);
        row("PNG 16", ImageFormat::Png, SampleFormat::UInt16);
        row("EXR half", ImageFormat::OpenExr, SampleFormat::Half);
        row("EXR float", ImageFormat::OpenExr, SampleFormat::Float);
        row("TIFF 8", ImageFormat::Tiff, SampleFormat::UInt8);
        row("TIFF 16", ImageFormat::Tiff, SampleFormat::UInt16);
        row("TIFF float", ImageFormat::Tiff, SampleFormat::Float);
    }
    void everyFormatIsReadable() {
        QFETCH(int, format);
        QFETCH(int, depth);
        ExportPlan plan = planFor(ExportKind::Noise);
        plan.format = static_cast<ImageFormat>(format);
        plan.depth = static_cast<SampleFormat>(depth);
        Context context;
        const auto report = runExport(plan, snapshotOf(quietTexton()), context);
        TXN_OK(report);
        TXN_AT_MOST(std::abs(context.progress - 1.0), 1e-9);
        const auto loaded = loadImage(report->files.front().toStdString());
        TXN_OK(loaded);
        QCOMPARE(loaded->image.size(), (Size{96, 64}));
        QCOMPARE(static_cast<int>(loaded->sampleFormat), depth);
        QCOMPARE(static_cast<int>(loaded->format), format);
    }

    void aCancelledExportLeavesNothing() {
        Context context;
        context.source.cancel();
        const auto report =
            runExport(planFor(ExportKind::Noise), snapshotOf(quietTexton()), context);
        TXN_FAILS_WITH(report, ErrorCode::Cancelled);
        QVERIFY(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }

    void whatCannotBeWrittenNamesTheFile() {
        ExportPlan plan = planFor(ExportKind::Noise);
        plan.folder = "/nowhere/at/all";
        Context context;
        const auto report = runExport(plan, snapshotOf(quietTexton()), context);
        TXN_FAILS_WITH(report, ErrorCode::Unwritable);
        QVERIFY(report.error().message.find("stone_noise") != std::string::npos);
        ExportSnapshot noView = snapshotOf(quietTexton());
        noView.view = {};
        TXN_FAILS_WITH(runExport(planFor(ExportKind::View), noView, context),
                       ErrorCode::InvalidArgument);
    }

    /// The exported files alone, with the system's compiler: the picture is that of the core.
    void theExampleDrawsTheNoise() {
        const QString compiler = QStandardPaths::findExecutable("c++");
        if (compiler.isEmpty())
            QSKIP("there is no compiler");
        const ExportSnapshot snapshot = snapshotOf(quietTexton());
        Context context;
        TXN_OK(runExport(planFor(ExportKind::Engine), snapshot, context));
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(compiler, {"stone_shader_example.cpp", "-o", "example", "-lepoxy"});
        QVERIFY(process.waitForFinished(120000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError());
        process.start(m_folder.filePath("example"), {});
        QVERIFY(process.waitForFinished(60000));
        const QByteArray messages = process.readAllStandardError();
        if (process.exitCode() != 0 && messages.contains("no OpenGL") &&
            qEnvironmentVariableIntValue("TXN_REQUIRE_GL") != 1)
            QSKIP("there is no OpenGL");
        QVERIFY2(process.exitCode() == 0, messages);
        const QImage picture(m_folder.filePath("stone_shader_example.ppm"));
        QCOMPARE(picture.size(), QSize(512, 512));
        NoiseParams params;
        params.meanImpacts = snapshot.noise.meanImpacts;
        const SpotNoise noise(snapshot.asset.texton, params);
        std::array<double, 3> value{};
        double worst = 0.0;
        for (int y = 0; y < 512; y += 13) {
            for (int x = 0; x < 512; x += 13) {
                noise.evaluate(x, y, value);
                const QColor color = picture.pixelColor(x, y);
                const std::array shown{color.redF(), color.greenF(), color.blueF()};
                for (std::size_t c = 0; c < 3; ++c)
                    worst = std::max(
                        worst,
                        std::abs(std::clamp(value[c], 0.0, 1.0) - static_cast<double>(shown[c])));
            }
        }
        TXN_AT_MOST(worst, 0.51 / 255.0 + 1e-3);
    }

    void presetsAreRemembered() {
        Settings settings(m_folder.filePath("settings.ini"));
        ExportPresets presets(settings);
        QVERIFY(presets.names().isEmpty() && !presets.find("game"));
        ExportPlan plan;
        plan.kind = ExportKind::Noise;
        plan.nameTemplate = "{name}_{size}";
        plan.size = {640, 320};
        plan.tileable = false;
        plan.format = ImageFormat::OpenExr;
        plan.depth = SampleFormat::Half;
        presets.save("game", plan);
        presets.save("film", {});
        QCOMPARE(presets.names(), QStringList({"film", "game"}));
        QVERIFY(presets.find("game") == plan);
        presets.remove("film");
        QCOMPARE(ExportPresets(settings).names(), QStringList("game"));
        settings.setJson("export-presets", "{\"bad\": {\"width\": -5, \"kind\": 99}}");
        const auto bad = presets.find("bad");
        QVERIFY(bad && bad->size.width == 1 && bad->kind == ExportKind::Mixture);
        settings.setJson("export-presets", "not JSON");
        QVERIFY(presets.names().isEmpty());
    }

    void theDialogWritesWhatItShows() {
        Settings settings(m_folder.filePath("settings.ini"));
        ProjectDocument document;
        JobRunner runner;
        Pipeline pipeline(document, runner);
        auto asset = std::make_shared<TextonAsset>();
        asset->texton = quietTexton();
        asset->exemplarName = "stone.jpg";
        document.change("Open", [&](Project& project) { project.importedTexton = asset; });
        TXN_COMES_TRUE(pipeline.noiseTexton() != nullptr);

        ExportDialog dialog(document, pipeline, runner, settings);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto child = [&](const char* name) { return dialog.findChild<QWidget*>(name); };
        auto* folder = dialog.findChild<QLineEdit*>("exportFolder");
        folder->selectAll();
        QTest::keyClicks(folder, m_folder.path());
        dialog.findChild<QListWidget*>("exportKinds")->setCurrentRow(1);
        auto* width = dialog.findChild<QSpinBox*>("exportWidth");
        auto* height = dialog.findChild<QSpinBox*>("exportHeight");
        for (QSpinBox* field : {width, height}) {
            field->selectAll();
            QTest::keyClicks(field, "64");
            QTest::keyClick(field, Qt::Key_Return);
        }
        // Return in a field starts nothing twice: wait for whatever it started.
        TXN_COMES_TRUE(runner.isIdle());
        auto* files = dialog.findChild<QLabel*>("exportFiles");
        QVERIFY2(files->text().startsWith("stone_noise_64_tile.png"), qPrintable(files->text()));
        QFile::remove(m_folder.filePath("stone_noise_64_tile.png"));
        QTest::mouseClick(child("exportStart"), Qt::LeftButton);
        auto* result = dialog.findChild<QLabel*>("exportResult");
        QTRY_VERIFY2(result->text().contains('1'), qPrintable(result->text()));
        QVERIFY(QFileInfo::exists(m_folder.filePath("stone_noise_64_tile.png")));
        QVERIFY(child("exportOpenFolder")->isVisible());

        // A second time there is a question, and no is no.
        const QDateTime before =
            QFileInfo(m_folder.filePath("stone_noise_64_tile.png")).lastModified();
        QTest::qWait(20);
        QTest::mouseClick(child("exportStart"), Qt::LeftButton);
        TXN_COMES_TRUE(dialog.findChild<QMessageBox*>("replaceQuestion") != nullptr);
        dialog.findChild<QMessageBox*>("replaceQuestion")->button(QMessageBox::Cancel)->click();
        TXN_COMES_TRUE(dialog.findChild<QMessageBox*>("replaceQuestion") == nullptr);
        QVERIFY(runner.isIdle());
        QCOMPARE(QFileInfo(m_folder.filePath("stone_noise_64_tile.png")).lastModified(), before);
        QTest::mouseClick(child("exportStart"), Qt::LeftButton);
        TXN_COMES_TRUE(dialog.findChild<QMessageBox*>("replaceQuestion") != nullptr);
        for (QAbstractButton* button :
             dialog.findChild<QMessageBox*>("replaceQuestion")->buttons()) {
            if (button->text() == "Replace")
                button->click();
        }
        TXN_COMES_TRUE(QFileInfo(m_folder.filePath("stone_noise_64_tile.png")).lastModified() !=
                       before);
    }
};

QTEST_MAIN(TestExport)
#include "TestExport.moc"
