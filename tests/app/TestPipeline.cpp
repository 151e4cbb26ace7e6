// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pipeline/Pipeline.h"
#include "tests/helpers/Verify.h"

#include <QSignalSpy>
#include <QtTest>

using namespace txn;
using namespace txn::app;

namespace {

std::shared_ptr<const Source> sample(const QString& name = QStringLiteral("rust")) {
    auto source = sampleSource(name);
    return source ? *source : nullptr;
}

/// A document with its pipeline, small enough to compute at once.
struct Studio {
    ProjectDocument document;
    JobRunner runner;
    Pipeline pipeline{document, runner};

    void open(const std::shared_ptr<const Source>& source) {
        document.change("Open", [&](Project& project) {
            project.source = source;
            project.edit.crop = Rect{0, 0, {128, 96}};
            project.texton.support = {16, 16};
            project.texton.method = TextonMethod::Projections;
            project.texton.iterations = 20;
        });
    }
    bool isDone() const {
        return runner.isIdle() && pipeline.texton() && pipeline.texton()->finished &&
               !pipeline.isStale(Picture::Noise) && !pipeline.isStale(Picture::Gaussian);
    }
};

} // namespace

class TestPipeline : public QObject {
    Q_OBJECT

    std::shared_ptr<const Source> m_rust;

  private slots:
    void initTestCase() {
        m_rust = sample();
        QVERIFY(m_rust);
    }

    void aPictureGoesThroughAllStages() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto exemplar = studio.pipeline.exemplar();
        QCOMPARE(exemplar->exemplar.image.size(), (Size{128, 96}));
        QCOMPARE(studio.pipeline.gaussian()->pictures.front().image().size(), (Size{128, 96}));
        TXN_COMES_TRUE(studio.pipeline.verdict() != nullptr);

        // The texton is the one of the core, by the same settings.
        const auto expected = computeTexton(exemplar->exemplar,
                                            exemplar->model,
                                            computeParams(studio.document.project().texton));
        TXN_OK(expected);
        const auto texton = studio.pipeline.texton();
        QVERIFY(texton->texton == expected->texton);
        QCOMPARE(texton->iteration, 20);
        QCOMPARE(texton->curve.back().iteration, 20);
        QCOMPARE(*texton->relativeModelError, *expected->relativeModelError);
        QVERIFY(texton->dial && texton->dial->floor > 0.0);
        QVERIFY(*studio.pipeline.noiseTexton() == expected->texton);
    }

    void theFitIsTheDefault() {
        Studio studio;
        studio.open(m_rust);
        QVERIFY(TextonSettings{}.method == TextonMethod::Fit);
        studio.document.change("Fit", [](Project& p) { p.texton.method = TextonMethod::Fit; });
        TXN_COMES_TRUE(studio.isDone());
        const auto texton = studio.pipeline.texton();
        QCOMPARE(texton->trialErrors.size(), std::size_t{2});
        QVERIFY(texton->texton.kernelCount() <= 2 && !texton->relativeModelError);
        studio.document.change("Kernels", [](Project& p) { p.texton.kernels = 3; });
        TXN_BECOMES(studio.pipeline.texton()->texton.kernelCount(), 3);
        TXN_COMES_TRUE(studio.pipeline.suggestedSupport().has_value());
    }

    void twoTextonsAreComparedByTurns() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto first = studio.pipeline.texton();
        studio.pipeline.showKept(true); // nothing is kept yet
        QVERIFY(!studio.pipeline.isShowingKept());
        studio.pipeline.keepTexton();
        studio.document.change("Seed", [](Project& p) { p.texton.seed = Seed{77}; });
        TXN_COMES_TRUE(studio.isDone());
        const auto second = studio.pipeline.texton();
        QVERIFY(*studio.pipeline.noiseTexton() == second->texton);
        studio.pipeline.showKept(true);
        QCOMPARE(studio.pipeline.shownTexton(), first);
        QVERIFY(*studio.pipeline.noiseTexton() == first->texton);
        studio.pipeline.showKept(false);
        QVERIFY(*studio.pipeline.noiseTexton() == second->texton);
    }

    void onlyWhatIsStaleIsComputed() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto exemplar = studio.pipeline.exemplar();
        const auto gaussian = studio.pipeline.gaussian();
        const auto texton = studio.pipeline.texton();

        studio.document.change("Impacts", [](Project& p) { p.noise.meanImpacts = 5.0; });
        QTest::qWait(20);
        QVERIFY(studio.runner.isIdle());
        QCOMPARE(studio.pipeline.texton(), texton);

        studio.document.change("Seed", [](Project& p) { p.gaussian.seed = Seed{9}; });
        TXN_COMES_TRUE(studio.isDone() && studio.pipeline.gaussian() != gaussian);
        QCOMPARE(studio.pipeline.exemplar(), exemplar);
        QCOMPARE(studio.pipeline.texton(), texton);

        studio.document.change("Support", [](Project& p) { p.texton.support = {12, 12}; });
        TXN_COMES_TRUE(studio.isDone() && studio.pipeline.texton() != texton);
        QCOMPARE(studio.pipeline.exemplar(), exemplar);
        QCOMPARE(studio.pipeline.texton()->texton.support.size(), (Size{12, 12}));

        studio.document.change("Crop", [](Project& p) { p.edit.crop = Rect{10, 10, {64, 64}}; });
        TXN_COMES_TRUE(studio.isDone() && studio.pipeline.exemplar() != exemplar);
        QCOMPARE(studio.pipeline.gaussian()->pictures.front().image().size(), (Size{64, 64}));
    }

    void theLastValueOfADragWins() {
        Studio studio;
        studio.open(m_rust);
        const Gesture drag = Gesture::next();
        for (int side = 8; side <= 40; ++side) {
            studio.document.change(
                "Support",
                [&](Project& p) {
                    p.texton.support = {side, side};
                },
                drag);
            QTest::qWait(3);
            QVERIFY(studio.pipeline.isStale(Picture::Texton));
        }
        TXN_COMES_TRUE(studio.isDone());
        QCOMPARE(studio.pipeline.texton()->texton.support.size(), (Size{40, 40}));
    }

    void undoBringsTheOldResultsBack() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const Texton before = studio.pipeline.texton()->texton;
        studio.document.change("Iterations", [](Project& p) { p.texton.iterations = 3000; });
        TXN_COMES_TRUE(studio.pipeline.isComputingTexton());
        studio.document.undoStack().undo();
        TXN_COMES_TRUE(studio.isDone());
        QVERIFY(studio.pipeline.texton()->texton == before);
    }

    void cancelGoesBackToTheLastFinishedTexton() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto before = studio.pipeline.texton();
        studio.document.change("Iterations", [](Project& p) { p.texton.iterations = 100000; });
        TXN_COMES_TRUE(studio.pipeline.texton() != before); // an intermediate one
        studio.pipeline.cancelTexton();
        QCOMPARE(studio.pipeline.texton(), before);
        QVERIFY(studio.pipeline.isStale(Picture::Texton));
        QTRY_VERIFY_WITH_TIMEOUT(studio.runner.isIdle(), 1000);
        QTest::qWait(50);
        QCOMPARE(studio.pipeline.texton(), before);
        // And on again, from the start.
        studio.document.change("Iterations", [](Project& p) { p.texton.iterations = 10; });
        TXN_COMES_TRUE(studio.isDone());
        QCOMPARE(studio.pipeline.texton()->iteration, 10);
        const auto first = studio.pipeline.texton();
        studio.pipeline.recomputeTexton();
        TXN_COMES_TRUE(studio.isDone() && studio.pipeline.texton() != first);
        QVERIFY(studio.pipeline.texton()->texton == first->texton);
    }

    void contrastAndBrightnessNeedNoSolver() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto texton = studio.pipeline.texton();
        studio.document.change("Contrast", [](Project& p) {
            p.noise.contrast = 0.5;
            p.noise.brightness = 0.1;
        });
        TXN_COMES_TRUE(*studio.pipeline.noiseTexton() != texton->texton);
        QCOMPARE(studio.pipeline.texton(), texton);
        const Texton& noise = *studio.pipeline.noiseTexton();
        TXN_AT_MOST(std::abs(noise.mean[0] - texton->texton.mean[0] - 0.1), 1e-12);
        TXN_AT_MOST(
            std::abs(noise.kernels[0].at(3, 4, 1) - 0.5F * texton->texton.kernels[0].at(3, 4, 1)),
            1e-7);
    }

    void whatFailsIsToldAndTheOldResultStays() {
        Studio studio;
        QSignalSpy failed(&studio.pipeline, &Pipeline::failed);
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        const auto before = studio.pipeline.texton();
        studio.document.change("Support", [](Project& p) { p.texton.support = {500, 500}; });
        TXN_BECOMES(failed.count(), 1);
        QVERIFY(failed.first().first().toString().contains("support"));
        QVERIFY(failed.first().first().toString().contains("rust.png"));
        QCOMPARE(studio.pipeline.texton(), before);
        QVERIFY(studio.pipeline.isStale(Picture::Texton));
        studio.document.undoStack().undo();
        TXN_COMES_TRUE(studio.isDone());
        QCOMPARE(studio.pipeline.texton(), before);
    }

    void spectraAreMeasuredOnlyWhenSomebodyLooks() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        QVERIFY(!studio.pipeline.analysis());
        studio.pipeline.setAnalysisWanted(true);
        TXN_COMES_TRUE(studio.pipeline.analysis() != nullptr);
        QCOMPARE(studio.pipeline.analysis()->exemplar.histograms.size(), std::size_t{3});
    }

    void meshesAreLoadedWhenShown() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        QVERIFY(!studio.pipeline.mesh());
        studio.document.change("View", [](Project& p) { p.noise.scene = NoiseScene::Surface; });
        TXN_COMES_TRUE(studio.pipeline.mesh() != nullptr);
        const auto sphere = studio.pipeline.mesh();
        QSignalSpy failed(&studio.pipeline, &Pipeline::failed);
        studio.document.change("Mesh", [](Project& p) { p.noise.mesh = "/nowhere/pot.obj"; });
        TXN_BECOMES(failed.count(), 1);
        QVERIFY(failed.first().first().toString().contains("pot.obj"));
        QCOMPARE(studio.pipeline.mesh(), sphere);
    }

    void closingEmptiesEverything() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        studio.document.reset({}, {}, {});
        TXN_COMES_TRUE(!studio.pipeline.texton());
        QVERIFY(!studio.pipeline.exemplar() && !studio.pipeline.gaussian() &&
                !studio.pipeline.noiseTexton() && !studio.pipeline.verdict());
        QVERIFY(!studio.pipeline.isStale(Picture::Noise));
    }

    void aTextonFromAFileTakesThePlaceOfThePicture() {
        Studio studio;
        studio.open(m_rust);
        TXN_COMES_TRUE(studio.isDone());
        auto asset = std::make_shared<TextonAsset>();
        asset->texton = studio.pipeline.texton()->texton;
        studio.document.change("Open", [&](Project& p) {
            p.source.reset();
            p.importedTexton = asset;
        });
        TXN_COMES_TRUE(studio.pipeline.texton() && studio.pipeline.texton()->imported);
        QVERIFY(!studio.pipeline.exemplar());
        QVERIFY(*studio.pipeline.noiseTexton() == asset->texton);
        studio.document.undoStack().undo();
        TXN_COMES_TRUE(studio.isDone() && !studio.pipeline.texton()->imported);
        QVERIFY(studio.pipeline.exemplar() != nullptr);
    }
};

QTEST_GUILESS_MAIN(TestPipeline)
#include "TestPipeline.moc"
