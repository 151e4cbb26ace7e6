// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"
#include "app/export/ExportJob.h"
#include "core/samples/Samples.h"
#include "tests/app/Studio.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Verify.h"

#include <QComboBox>
#include <QLabel>
#include <QMimeData>
#include <QUrl>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

/// Materials of several maps, as an artist meets them.
class TestStacks : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString write(const QString& name, const char* sample, Size size = {96, 80}) {
        const QString path = m_folder.filePath(name);
        const auto image = makeSample(sample, size, Seed{1});
        if (!image || !saveImage(*image, path.toStdString()))
            QTest::qFail("cannot write a map", __FILE__, __LINE__);
        return path;
    }
    static bool drop(Studio& studio, const QStringList& paths) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths)
            urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        return studio.window().files().openMime(data);
    }
    static QImage noiseOf(Studio& studio) {
        for (PictureView* view : studio.window().views().views()) {
            if (view->shows(Picture::Noise))
                return view->noiseFrame().image;
        }
        return {};
    }

  private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void severalMapsAreDroppedAtOnce() {
        Studio studio;
        studio.document().change("Small", [](Project& p) { p.texton.support = {16, 16}; });
        QVERIFY(drop(studio,
                     {write("wall_normal_gl.png", "cloth"), write("wall_albedo.png", "stone")}));
        QVERIFY(studio.settle());
        const auto& source = studio.project().source;
        QVERIFY(source && source->maps().size() == 2);
        QVERIFY(source->maps().front().kind == MapKind::Color); // wherever it was in the list
        const QString list = studio.find<QLabel>("exemplarMaps")->text();
        QVERIFY2(list.contains("wall_albedo.png") && list.contains("wall_normal_gl.png"),
                 qPrintable(list));
        QVERIFY(studio.find("exemplarMaps")->isVisible());
        QCOMPARE(studio->pipeline().texton()->texton.channels(), 5);
        QVERIFY(studio->pipeline().texton()->dial);
        QCOMPARE(studio.find("noiseMap")->findChild<QComboBox*>()->count(), 3);
        // A photo in its place, in one step and back.
        QVERIFY(drop(studio, {write("plain.png", "sand")}));
        QVERIFY(studio.settle());
        QVERIFY(studio.project().source->maps().empty());
        QVERIFY(!studio.find("exemplarMaps")->isVisible());
        QVERIFY(!studio.find("noiseMap")->isVisible());
    }

    void theLightMovesAndMapsAreShownAlone() {
        Studio studio;
        QVERIFY(studio.openSmallStack());
        const QImage shaded = noiseOf(studio);
        studio.document().change("Light", [](Project& p) { p.noise.light.azimuth = -1.0; });
        QVERIFY(studio.settle());
        const QImage otherLight = noiseOf(studio);
        QVERIFY(otherLight != shaded);
        studio.document().change("Map", [](Project& p) { p.noise.map = "normal"; });
        QVERIFY(studio.settle());
        const QImage normals = noiseOf(studio);
        // Normals look towards the eye: blue.
        const QColor middle = normals.pixelColor(normals.width() / 2, normals.height() / 2);
        QVERIFY(middle.blue() > 128);
        studio.document().change("Light", [](Project& p) { p.noise.light.azimuth = 1.0; });
        QVERIFY(studio.settle());
        QVERIFY(noiseOf(studio) == normals);
        QVERIFY(!studio.find("noiseLightAngle")->isVisible());
        // All scenes can do it.
        for (const NoiseScene scene :
             {NoiseScene::Perspective, NoiseScene::Mesh, NoiseScene::Surface}) {
            for (const char* map : {"", "extra"}) {
                studio.document().change("Scene", [&](Project& p) {
                    p.noise.scene = scene;
                    p.noise.map = map;
                });
                QVERIFY(studio.settle());
                QVERIFY(!noiseOf(studio).isNull());
            }
        }
    }

    void theRightButtonMovesTheLightAsOneStep() {
        Studio studio;
        QVERIFY(studio.openSmallStack());
        PictureView* view = nullptr;
        for (PictureView* each : studio.window().views().views()) {
            if (each->shows(Picture::Noise))
                view = each;
        }
        const Light before = studio.project().noise.light;
        const int steps = studio.document().undoStack().index();
        const QPoint middle = view->rect().center();
        QTest::mousePress(view, Qt::RightButton, {}, middle);
        for (int x = 5; x <= 60; x += 5)
            QTest::mouseMove(view, middle + QPoint(x, 0));
        QTest::mouseRelease(view, Qt::RightButton, {}, middle + QPoint(60, 0));
        QVERIFY(studio.project().noise.light != before);
        QVERIFY(studio.project().noise.light.direction().x > before.direction().x);
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
    }

    void mapsThatDoNotFitAreToldByName() {
        Studio studio;
        QVERIFY(studio.openSmall());
        const Project before = studio.project();
        QString message;
        connect(&studio.window().files(), &FileController::problem, [&](const QString& text) {
            message = text;
        });
        for (const QStringList& paths :
             {QStringList{write("a_color.png", "stone"), write("IMG_7.png", "sand")},
              QStringList{write("a_color.png", "stone"), write("a_normal.png", "sand", {64, 80})},
              QStringList{write("a_color.png", "stone"), write("a_height.png", "rust")},
              QStringList{write("a_color.png", "stone"), write("a_albedo.png", "rust")},
              QStringList{write("a_color.png", "stone"), m_folder.filePath("none_normal.png")}}) {
            message.clear();
            QVERIFY(drop(studio, paths));
            QVERIFY(studio.settle());
            QVERIFY2(message.contains(QFileInfo(paths.back()).fileName()), qPrintable(message));
            QVERIFY(studio.project() == before);
        }
    }

    void aStackIsSavedWithItsMaps() {
        Studio studio;
        QVERIFY(studio.openSmallStack());
        const QString path = m_folder.filePath("stack.txnproj");
        TXN_OK(saveProject(studio.project(), studio.document().view(), path));
        const auto opened = openProject(path);
        TXN_OK(opened);
        const auto& source = opened->project.source;
        QVERIFY(source && source->maps() == studio.project().source->maps());
        QVERIFY((*source->picture())->image == (*studio.project().source->picture())->image);
        // Files inside and linked ones, too.
        const auto files =
            openStack({write("s_color.png", "stone"), write("s_normal.png", "sand")});
        TXN_OK(files);
        for (const bool linked : {false, true}) {
            Project project;
            project.source = *files;
            project.linked = linked;
            TXN_OK(saveProject(project, {}, path));
            const auto again = openProject(path);
            TXN_OK(again);
            QVERIFY((*again->project.source->picture())->image == (*(*files)->picture())->image);
        }
    }

    void aStackIsExportedMapByMap() {
        Studio studio;
        QVERIFY(studio.openSmallStack());
        ExportSnapshot snapshot;
        snapshot.name = "wall";
        snapshot.asset.texton = *studio->pipeline().noiseTexton();
        snapshot.asset.maps = studio->pipeline().texton()->maps;
        ExportPlan plan;
        plan.folder = m_folder.path();
        plan.textonPng = true;
        plan.size = {64, 64};
        struct Context final : JobContext {
            CancelToken none;
            const CancelToken& token() const override { return none; }
            void setProgress(double) override {}
            void deliver(Delivery) override {}
        } context;
        for (const ExportKind kind : {ExportKind::Texton, ExportKind::Noise}) {
            for (const ImageFormat format : {ImageFormat::Png, ImageFormat::OpenExr}) {
                plan.kind = kind;
                plan.format = format;
                plan.depth = format == ImageFormat::Png ? SampleFormat::UInt8 : SampleFormat::Half;
                const auto report = runExport(plan, snapshot, context);
                TXN_OK(report);
                for (const QString& file : report->files)
                    QVERIFY2(QFileInfo(file).size() > 0, qPrintable(file));
                if (kind == ExportKind::Noise)
                    QCOMPARE(report->files.size(), format == ImageFormat::Png ? 3 : 1);
            }
        }
        plan.kind = ExportKind::Engine; // shaders take up to four channels
        TXN_FAILS_WITH(runExport(plan, snapshot, context), ErrorCode::Unsupported);
    }

    void twoTextonsStandSideBySide() {
        Studio studio;
        QVERIFY(studio.openSmall());
        const auto first = studio->pipeline().texton();
        studio.trigger("texton.keep");
        studio.document().change("Seed", [](Project& p) { p.texton.seed = Seed{9}; });
        QVERIFY(studio.settle());
        studio.trigger("texton.keptBeside");
        QVERIFY(studio.settle());
        const auto views = studio.window().views().views();
        QVERIFY(views[0]->isVisible() && views[1]->isVisible());
        QVERIFY(*views[0]->noiseFrame().request.texton == first->texton);
        QVERIFY(*views[1]->noiseFrame().request.texton == studio->pipeline().texton()->texton);
        studio.trigger("texton.keptBeside");
        QVERIFY(studio.settle());
        QVERIFY(*views[0]->noiseFrame().request.texton == studio->pipeline().texton()->texton);
        studio.trigger("texton.showKept");
        QVERIFY(studio.settle());
        QVERIFY(*views[0]->noiseFrame().request.texton == first->texton);
    }

    void aKeptTextonGoesWithItsMaterial() {
        Studio studio;
        QVERIFY(studio.openSmall());
        studio.trigger("texton.keep");
        studio.trigger("texton.showKept");
        QVERIFY(studio->pipeline().isShowingKept());
        // Exports are of the present one all the same.
        studio.document().change("Seed", [](Project& p) { p.texton.seed = Seed{5}; });
        QVERIFY(studio.settle());
        QVERIFY(*studio->pipeline().presentNoiseTexton() == studio->pipeline().texton()->texton);
        QVERIFY(studio.openSmallStack());
        QVERIFY(!studio->pipeline().keptTexton() && !studio->pipeline().isShowingKept());
        QCOMPARE(studio->pipeline().noiseTexton()->channels(), 8);
    }

    void croppingAndTurningWorkOnAllMaps() {
        Studio studio;
        QVERIFY(studio.openSmallStack());
        studio.document().change("Edit", [](Project& p) {
            p.edit.straightenDegrees = 10.0;
            p.edit.flattenRadiusPx = 20.0;
            p.edit.flipGreen = true;
        });
        QVERIFY(studio.settle());
        const auto exemplar = studio->pipeline().exemplar();
        QCOMPARE(exemplar->exemplar.image.channels(), 8);
        QVERIFY(exemplar->exemplar.maps[1].kind == MapKind::NormalYDown);
        QCOMPARE(exemplar->pictures.size(), std::size_t{3});
    }
};

QTEST_MAIN(TestStacks)
#include "TestStacks.moc"
