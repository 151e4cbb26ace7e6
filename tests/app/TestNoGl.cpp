// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoiseService.h"
#include "gl/HeadlessContext.h"
#include "tests/app/NoiseRequests.h"
#include "tests/app/Studio.h"

#include <QLabel>
#include <QSignalSpy>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

/// On a machine whose OpenGL is too old; a program of its own, since drivers look only once.
class TestNoGl : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        qputenv("MESA_GL_VERSION_OVERRIDE", "2.1");
        if (HeadlessContext::create())
            QSKIP("this driver cannot be made to look old");
    }

    void theProcessorDrawsAndTheProblemIsTold() {
        NoiseService service;
        QSignalSpy ready(&service, &NoiseService::ready);
        NoiseFeed feed(service);
        for (const View& view : {View(PlaneView{}), View(GroundView{}), View(MeshView{})}) {
            feed.request(smallRequest(view));
            TXN_COMES_TRUE(feed.frame().complete && feed.frame().request.view == view);
            QVERIFY(feed.frame().onProcessor);
            QCOMPARE(feed.frame().image.size(), QSize(90, 60));
            QVERIFY(feed.frame().image.pixel(10, 10) != feed.frame().image.pixel(50, 40));
        }
        QCOMPARE(ready.count(), 1);
        QVERIFY(service.renderer().isEmpty());
        QVERIFY(service.problem().contains("OpenGL"));
    }

    void theWindowSaysSoAndShowsAPreview() {
        Studio studio;
        QVERIFY(studio.openSmall());
        QVERIFY(studio.find<QLabel>("messageText")->text().contains("graphics card"));
        PictureView* noise = studio.window().views().views()[3];
        QVERIFY(noise->noiseFrame().onProcessor);
        const QImage picture = noise->grabPicture();
        QVERIFY(picture.pixel(20, 20) != picture.pixel(200, 150));
        for (const NoiseScene scene : {NoiseScene::Perspective, NoiseScene::Surface}) {
            studio.document().change("View", [scene](Project& p) { p.noise.scene = scene; });
            QVERIFY(studio.settle());
            QVERIFY(!noise->noiseFrame().image.isNull());
        }
    }
};

QTEST_MAIN(TestNoGl)
#include "TestNoGl.moc"
