// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoiseService.h"
#include "gl/HeadlessContext.h"
#include "tests/app/NoiseRequests.h"
#include "tests/app/RefusedShaders.h"
#include "tests/app/Studio.h"
#include "tests/helpers/Gl.h"

#include <QLabel>
#include <QSignalSpy>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

/// What is in all shaders, and in that of the ground only.
constexpr const char* kInAll = "void main()";
constexpr const char* kInGround = "rayMiddle";

} // namespace

/// On a driver that refuses shaders: what it can draw it draws, and the processor the rest.
class TestBadDriver : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        std::optional<HeadlessContext> context;
        TXN_NEEDS_GL(context);
    }

    void theProcessorDrawsWhatTheDriverRefuses() {
        const RefusedShaders refused(kInAll);
        NoiseService service;
        NoiseFeed feed(service);
        QSignalSpy failed(&feed, &NoiseFeed::failed);
        for (const View& view : {View(PlaneView{}), View(GroundView{}), View(MeshView{})}) {
            feed.request(smallRequest(view));
            TXN_COMES_TRUE(feed.frame().complete && feed.frame().request.view == view);
            QVERIFY(feed.frame().onProcessor);
            QVERIFY(feed.frame().image.pixel(10, 10) != feed.frame().image.pixel(50, 40));
            TXN_COMES_TRUE(service.problem().contains("refuses the shader"));
            QVERIFY(service.problem().contains("injected"));
        }
        QCOMPARE(failed.count(), 0);
        // Refused once, a kind of view is not tried again.
        const int tried = refused.count();
        feed.request(smallRequest(PlaneView{5.0, 5.0, 1.0, 0.0}));
        TXN_COMES_TRUE(feed.isCurrent());
        QVERIFY(feed.frame().onProcessor);
        QCOMPARE(refused.count(), tried);
    }

    void theWindowSaysSoAndDrawsTheRest() {
        const RefusedShaders refused(kInGround);
        Studio studio;
        QVERIFY(studio.openSmall());
        PictureView* noise = studio.window().views().views()[3];
        QVERIFY(!noise->noiseFrame().onProcessor);
        // Shaders are compiled before they are asked for: nobody hears of what fails there.
        TXN_COMES_TRUE(refused.count() > 0);
        const auto* message = studio.find<QLabel>("messageText");
        QVERIFY(message == nullptr || !message->text().contains("graphics card"));

        const auto show = [&](NoiseScene scene) {
            studio.document().change("View", [scene](Project& p) { p.noise.scene = scene; });
            return studio.settle() && !noise->noiseFrame().image.isNull();
        };
        QVERIFY(show(NoiseScene::Perspective));
        QVERIFY(noise->noiseFrame().onProcessor);
        const QImage picture = noise->grabPicture();
        QVERIFY(picture.pixel(20, 20) != picture.pixel(200, 150));
        message = studio.find<QLabel>("messageText");
        QVERIFY(message->text().contains("graphics card"));
        QVERIFY(message->text().contains("refuses the shader"));
        QVERIFY(!message->text().contains('\n'));
        QVERIFY(show(NoiseScene::Surface));
        QVERIFY(!noise->noiseFrame().onProcessor);
        QVERIFY(show(NoiseScene::Plane));
        QVERIFY(!noise->noiseFrame().onProcessor);
    }
};

QTEST_MAIN(TestBadDriver)
#include "TestBadDriver.moc"
