// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoiseService.h"
#include "core/mesh/BuiltinMeshes.h"
#include "core/noise/SpotNoise.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QSignalSpy>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

NoiseRequest planeRequest(const std::shared_ptr<const Texton>& texton, QSize size = {96, 64}) {
    NoiseRequest request;
    request.texton = texton;
    request.style.filter = Filter::None;
    request.view = PlaneView{100.0, -40.0, 1.0, 0.0};
    request.size = size;
    return request;
}

bool isComplete(const NoiseFeed& feed, const NoiseRequest& request) {
    return feed.frame().complete && feed.frame().request == request;
}

} // namespace

class TestNoiseService : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;
    std::shared_ptr<const Texton> m_texton;

  private slots:
    void initTestCase() {
        TXN_NEEDS_GL(m_context);
        m_context.reset();
        TextonRecipe recipe;
        recipe.channels = 3;
        m_texton = shared(makeTexton(recipe));
    }

    void tellsWhatDraws() {
        NoiseService service;
        QSignalSpy ready(&service, &NoiseService::ready);
        TXN_BECOMES(ready.count(), 1);
        QVERIFY(!service.renderer().isEmpty());
        QVERIFY(service.problem().isEmpty());
    }

    void theCompleteFrameIsTheNoise() {
        NoiseService service;
        NoiseFeed feed(service);
        const NoiseRequest request = planeRequest(m_texton);
        feed.request(request);
        TXN_COMES_TRUE(isComplete(feed, request));
        const NoiseFrame& frame = feed.frame();
        QCOMPARE(frame.image.size(), request.size);
        QVERIFY(!frame.onProcessor);
        // The middle of the picture shows the view's centre.
        const SpotNoise noise(*m_texton, request.style.noise);
        std::array<double, 3> value{};
        double worst = 0.0;
        for (int y = 0; y < request.size.height(); y += 7) {
            for (int x = 0; x < request.size.width(); x += 7) {
                noise.evaluate(100.0 + x + 0.5 - 48.0, -40.0 + y + 0.5 - 32.0, value);
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst,
                                     std::abs(value[static_cast<std::size_t>(c)] -
                                              static_cast<double>(frame.samples->at(x, y, c))));
            }
        }
        TXN_AT_MOST(worst, 1e-3);
    }

    void onlyTheNewestRequestIsCompleted() {
        NoiseService service;
        NoiseFeed feed(service);
        NoiseRequest request = planeRequest(m_texton, {400, 300});
        int frames = 0;
        connect(&feed, &NoiseFeed::frameReady, this, [&] { ++frames; });
        for (int i = 0; i < 100; ++i) {
            auto view = std::get<PlaneView>(request.view);
            view.centerX += 3.0;
            request.view = view;
            feed.request(request);
        }
        TXN_COMES_TRUE(isComplete(feed, request));
        QVERIFY(frames < 10);
    }

    void twoViewsGetTheirOwn() {
        NoiseService service;
        NoiseFeed a(service);
        NoiseFeed b(service);
        const NoiseRequest first = planeRequest(m_texton, {64, 64});
        NoiseRequest second = planeRequest(m_texton, {80, 40});
        second.view = GroundView{};
        a.request(first);
        b.request(second);
        TXN_COMES_TRUE(isComplete(a, first) && isComplete(b, second));
        QCOMPARE(a.frame().image.size(), QSize(64, 64));
        QCOMPARE(b.frame().image.size(), QSize(80, 40));
    }

    void meshesAreDrawn() {
        NoiseService service;
        NoiseFeed feed(service);
        NoiseRequest request = planeRequest(m_texton, {128, 96});
        request.mesh = std::make_shared<const TriangleMesh>(sphereMesh());
        request.view = MeshView{};
        feed.request(request);
        TXN_COMES_TRUE(isComplete(feed, request));
        // The corner is background, the middle is not.
        const QImage& image = feed.frame().image;
        QVERIFY(image.pixel(2, 2) == image.pixel(125, 2));
        QVERIFY(image.pixel(64, 48) != image.pixel(2, 2));
    }

    void comesBackAfterTheContextIsLost() {
        NoiseService service;
        NoiseFeed feed(service);
        const NoiseRequest request = planeRequest(m_texton);
        feed.request(request);
        TXN_COMES_TRUE(isComplete(feed, request));
        const QImage before = feed.frame().image.copy();
        for (int i = 0; i < 5; ++i) {
            int frames = 0;
            const auto link = connect(&feed, &NoiseFeed::frameReady, this, [&] { ++frames; });
            service.loseContext();
            TXN_COMES_TRUE(frames > 0 && feed.frame().complete);
            QCOMPARE(feed.frame().image, before);
            disconnect(link);
        }
    }

    void endsWhileDrawing() {
        for (int i = 0; i < 5; ++i) {
            NoiseService service;
            NoiseFeed feed(service);
            NoiseRequest request = planeRequest(m_texton, {1500, 1000});
            request.view = GroundView{};
            feed.request(request);
            QTest::qWait(i * 15);
        }
    }

    void aFeedMayOutliveTheService() {
        auto service = std::make_unique<NoiseService>();
        NoiseFeed feed(*service);
        feed.request(planeRequest(m_texton));
        service.reset();
        feed.request(planeRequest(m_texton, {10, 10}));
    }

    void whatCannotBeDrawnSaysWhy() {
        NoiseService service;
        NoiseFeed feed(service);
        QSignalSpy failed(&feed, &NoiseFeed::failed);
        NoiseRequest request = planeRequest(m_texton);
        request.style.noise.meanImpacts = -1.0;
        feed.request(request);
        TXN_BECOMES(failed.count(), 1);
        QVERIFY(!failed.first().first().toString().isEmpty());
        feed.request(planeRequest(m_texton));
        TXN_COMES_TRUE(feed.frame().complete);
    }
};

QTEST_MAIN(TestNoiseService)
#include "TestNoiseService.moc"
