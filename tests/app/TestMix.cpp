// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectFile.h"
#include "app/mixing/PaintTools.h"
#include "app/widgets/FilmStrip.h"
#include "app/widgets/MaterialSlot.h"
#include "app/widgets/ValueSlider.h"
#include "core/mixing/MapBrush.h"
#include "core/samples/Samples.h"
#include "tests/app/Studio.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPointingDevice>
#include <QPushButton>
#include <QSpinBox>
#include <QTabletEvent>
#include <QUrl>
#include <QtTest>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

bool settleMix(Studio& studio) {
    QTest::qWait(30);
    return waitFor([&] {
        const auto& pipeline = studio->pipeline();
        return studio.isSettled() && !pipeline.isMixStale() &&
               (!studio.project().mix.source || (pipeline.mix() && pipeline.mix()->finished));
    });
}

/// A is rust, B is sand, small, with three textons.
bool openSmallMix(Studio& studio) {
    if (!studio.openSmall())
        return false;
    static const auto second = sampleSource(QStringLiteral("sand"));
    studio.document().change(QStringLiteral("Mix"), [](Project& project) {
        project.mix.source = *second;
        project.mix.edit.crop = Rect{0, 0, {96, 96}};
        project.mix.textons = 3;
        project.mix.map = PaintedMap::fromImage(Image({256, 256}, 1));
        project.noise.filter = Filter::None;
    });
    studio.document().changeView([](ViewState& view) {
        view.layout = ViewLayout::Single;
        view.shown = {Picture::Noise, Picture::Exemplar, Picture::Gaussian, Picture::Texton};
    });
    studio.window().views().setZoom(1.0);
    return settleMix(studio);
}

PictureView& noiseView(Studio& studio) {
    return *studio.window().views().views().front();
}

QImage noiseOf(Studio& studio) {
    return noiseView(studio).noiseFrame().image;
}

/// Mean of the blue samples around a place of the noise, in pixels from the view's middle.
double blueAt(Studio& studio, int x, int y) {
    const auto& samples = noiseView(studio).noiseFrame().samples;
    double sum = 0.0;
    constexpr int kReach = 12;
    for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dx = -kReach; dx <= kReach; ++dx)
            sum += static_cast<double>(
                samples->at(samples->width() / 2 + x + dx, samples->height() / 2 + y + dy, 2));
    }
    return sum / (2 * kReach + 1) / (2 * kReach + 1);
}

QPoint inView(Studio& studio, int x, int y) {
    const PictureView& view = noiseView(studio);
    const QPoint middle(view.width() / 2, view.height() - view.screen().height() / 2);
    return middle + QPoint(x, y);
}

void drag(Studio& studio, QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
    PictureView& view = noiseView(studio);
    QTest::mousePress(&view, Qt::LeftButton, keys, from);
    for (int i = 1; i <= 8; ++i)
        QTest::mouseMove(&view, from + (to - from) * i / 8);
    QTest::mouseRelease(&view, Qt::LeftButton, keys, to);
}

/// What a pen sends before the event of the mouse that is made of it.
void pen(Studio& studio, QEvent::Type type, QPoint at, double pressure) {
    static const QPointingDevice device(QStringLiteral("pen"),
                                        1,
                                        QInputDevice::DeviceType::Stylus,
                                        QPointingDevice::PointerType::Pen,
                                        QInputDevice::Capability::Pressure,
                                        1,
                                        1);
    PictureView& view = noiseView(studio);
    const auto buttons = pressure > 0.0 ? Qt::LeftButton : Qt::NoButton;
    QTabletEvent event(type,
                       &device,
                       at,
                       view.mapToGlobal(QPointF(at)),
                       pressure,
                       0.0F,
                       0.0F,
                       0.0F,
                       0.0,
                       0.0F,
                       {},
                       type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       buttons);
    QApplication::sendEvent(&view, &event);
}

double rhoAt(Studio& studio, int x, int y) {
    const Image map = studio.project().mix.map.image();
    return static_cast<double>(map.at(map.width() / 2 + x, map.height() / 2 + y, 0));
}

} // namespace

/// Two materials and the map between them, as an artist meets them.
class TestMix : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

  private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void aSecondMaterialMixesAtOnce() {
        Studio studio;
        QVERIFY(studio.openSmall());
        studio.document().change("Few", [](Project& p) { p.mix.textons = 5; });
        QVERIFY(!studio.find("mixTool")->isEnabled());
        // Dropped onto B.
        QMimeData data;
        const QString path = m_folder.filePath("sand.png");
        QVERIFY(bool(saveImage(*makeSample("sand", {96, 80}, Seed{1}), path.toStdString())));
        data.setUrls({QUrl::fromLocalFile(path)});
        auto* slot = studio.find<MaterialSlot>("mixSecond");
        QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(slot, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(slot, &drop);
        QVERIFY(waitFor([&] { return studio.project().mix.source != nullptr; }));
        QVERIFY(settleMix(studio));
        const auto mix = studio->pipeline().mix();
        QVERIFY(mix && mix->finished);
        QCOMPARE(mix->frames.size(), std::size_t{5});
        QVERIFY(mix->distance > 0.0);
        QVERIFY(slot->accessibleName().contains("sand.png"));
        QVERIFY(studio.find("mixTool")->isEnabled());
        QVERIFY(studio.find<QLabel>("mixWords")->text().contains("Distance"));
        // The first map goes from A to B, and the first material is as it was after undo.
        const Image map = studio.project().mix.map.image();
        QVERIFY(map.at(0, 0, 0) < 0.01F);
        QVERIFY(map.at(map.width() - 1, 0, 0) > 0.99F);
        QVERIFY(studio->pipeline().mixTextons());
        studio.document().undoStack().undo();
        QVERIFY(settleMix(studio));
        QVERIFY(!studio.project().mix.source);
        QVERIFY(!studio->pipeline().mix());
        QVERIFY(!studio.find("mixTool")->isEnabled());
    }

    void whatCannotBeMixedSaysSo() {
        Studio studio;
        QVERIFY(studio.openSmall());
        const QString path = m_folder.filePath("grey.png");
        QVERIFY(bool(saveImage(Image({64, 64}, 1, 0.5F), path.toStdString())));
        studio.window().files().openSecond({path});
        auto* bar = studio.find<QLabel>("messageText");
        QVERIFY(bar != nullptr);
        QVERIFY(waitFor([&] { return bar->text().contains("channel"); }));
        QVERIFY(!studio->pipeline().mixTextons());
        // The noise of A stays on show, and another B is welcome.
        QVERIFY(!noiseOf(studio).isNull() || studio->pipeline().noiseTexton());
        studio.window().files().openSecondSample("sand");
        QVERIFY(settleMix(studio));
        QVERIFY(studio->pipeline().mixTextons());
        studio.window().files().openSecond({m_folder.filePath("missing.png")});
        QVERIFY(waitFor([&] { return bar->text().contains("missing.png"); }));
        QVERIFY(studio->pipeline().mixTextons());
    }

    void paintingIsSeenAndUndone() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        const QImage before = noiseOf(studio);
        const double a = blueAt(studio, 0, 0);
        const int steps = studio.document().undoStack().index();
        // Without a tool nothing is painted.
        drag(studio, inView(studio, -30, 0), inView(studio, 30, 0));
        QCOMPARE(studio.document().undoStack().index(), steps);
        studio.trigger("mix.brush");
        auto* radius = studio.find<ValueSlider>("mixRadius");
        QVERIFY(radius->isEnabled());
        emit radius->valueEdited(40.0, Gesture::next());
        drag(studio, inView(studio, -30, 0), inView(studio, 30, 0));
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
        QVERIFY(rhoAt(studio, 0, 0) > 0.99);
        QVERIFY(rhoAt(studio, 30, 0) > 0.99);
        QVERIFY(rhoAt(studio, 0, 60) < 0.01);
        QVERIFY(settleMix(studio));
        // Sand is much lighter than rust.
        QVERIFY(blueAt(studio, 0, 0) > a + 0.1);
        QVERIFY(std::abs(blueAt(studio, 0, 115) - blueAt(studio, 60, 115)) < 0.2);
        QVERIFY(noiseOf(studio) != before);
        studio.document().undoStack().undo();
        QVERIFY(settleMix(studio));
        QVERIFY(rhoAt(studio, 0, 0) < 0.01);
        QVERIFY(noiseOf(studio) == before);
    }

    void toolsDoWhatTheySay() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.trigger("mix.fill"); // with what the brush paints: B
        QVERIFY(rhoAt(studio, -100, 100) > 0.99);
        studio.trigger("mix.erase");
        emit studio.find<ValueSlider>("mixRadius")->valueEdited(20.0, Gesture::next());
        drag(studio, inView(studio, -60, -60), inView(studio, -60, -60));
        QVERIFY(rhoAt(studio, -60, -60) < 0.01);
        // On from there in a straight line, with Shift.
        drag(studio, inView(studio, 60, -60), inView(studio, 60, -60), Qt::ShiftModifier);
        QVERIFY(rhoAt(studio, 0, -60) < 0.01);
        QVERIFY(rhoAt(studio, 0, 0) > 0.99);
        const auto roughness = [&] {
            return varianceOf(studio.project().mix.map.image().samples());
        };
        const double rough = roughness();
        studio.trigger("mix.smooth");
        drag(studio, inView(studio, -60, -60), inView(studio, 60, -60));
        QVERIFY(roughness() < rough);
        studio.trigger("mix.gradient");
        drag(studio, inView(studio, -80, 0), inView(studio, 80, 0));
        QVERIFY(rhoAt(studio, -90, 30) > 0.99); // from what the brush paints
        QVERIFY(rhoAt(studio, 90, 30) < 0.01);
        TXN_AT_MOST(std::abs(rhoAt(studio, 0, 30) - 0.5), 0.02);
        studio.trigger("mix.round");
        drag(studio, inView(studio, 0, 0), inView(studio, 60, 0));
        QVERIFY(rhoAt(studio, 0, 0) > 0.99);
        QVERIFY(rhoAt(studio, 0, 70) < 0.01);
        studio.trigger("mix.invert");
        QVERIFY(rhoAt(studio, 0, 0) < 0.01);
        studio.trigger("mix.strips");
        QVERIFY(rhoAt(studio, -120, 0) < 0.01);
        TXN_AT_MOST(std::abs(rhoAt(studio, 0, 0) - 0.5), 1e-4);
        QVERIFY(rhoAt(studio, 120, 0) > 0.99);
        studio.trigger("mix.stripsDown");
        QVERIFY(rhoAt(studio, 0, -120) < 0.01);
        QVERIFY(rhoAt(studio, 0, 120) > 0.99);
        studio.trigger("mix.passage");
        TXN_AT_MOST(std::abs(rhoAt(studio, 0, 0) - 0.5), 0.01);
        QVERIFY(rhoAt(studio, -120, 0) < 0.01);
        // Mirrored strokes.
        studio.trigger("mix.fill");
        studio.trigger("mix.erase");
        emit studio.find("mixSymmetry")->findChild<QComboBox*>()->activated(1);
        drag(studio, inView(studio, -70, 20), inView(studio, -70, 20));
        QVERIFY(rhoAt(studio, -70, 20) < 0.01);
        QVERIFY(rhoAt(studio, 69, 20) < 0.01);
        QVERIFY(rhoAt(studio, -70, -60) > 0.99);
        studio.trigger("mix.repeat");
        QVERIFY(studio.project().mix.repeats);
        studio.trigger("mix.show");
        QVERIFY(studio.document().view().mapShown);
        QVERIFY(settleMix(studio));
        const double size = studio.find<ValueSlider>("mixRadius")->value();
        studio.trigger("mix.larger");
        QVERIFY(studio.find<ValueSlider>("mixRadius")->value() > size);
    }

    void theFilmStripShowsOneTexton() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        const QImage mixture = noiseOf(studio);
        auto* strip = studio.find<FilmStrip>("mixStrip");
        strip->setFocus();
        QTest::keyClick(strip, Qt::Key_Right);
        QTest::keyClick(strip, Qt::Key_Right);
        QTest::keyClick(strip, Qt::Key_Right);
        QVERIFY(studio.document().view().mixRho == 1.0);
        QCOMPARE(studio.find<ValueSlider>("mixTarget")->value(), 1.0);
        QVERIFY(settleMix(studio));
        QVERIFY(noiseOf(studio) != mixture);
        QVERIFY(blueAt(studio, 0, 0) > 0.2);
        // Its texton is what the texton view shows.
        studio.document().changeView([](ViewState& view) { view.shown[0] = Picture::Texton; });
        const QImage texton = noiseView(studio).grabPicture();
        QTest::keyClick(strip, Qt::Key_Escape);
        QVERIFY(noiseView(studio).grabPicture() != texton);
        QTest::keyClick(strip, Qt::Key_Left); // the last one again
        QVERIFY(noiseView(studio).grabPicture() == texton);
        studio.document().changeView([](ViewState& view) { view.shown[0] = Picture::Noise; });
        QTest::keyClick(strip, Qt::Key_Escape);
        QVERIFY(!studio.document().view().mixRho);
        QVERIFY(settleMix(studio));
        QVERIFY(noiseOf(studio) == mixture);
    }

    void swappingKeepsTheLook() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        const double left = blueAt(studio, 0, 0);
        const auto a = studio.project().source;
        const auto b = studio.project().mix.source;
        studio.trigger("mix.swap");
        QVERIFY(studio.project().source == b && studio.project().mix.source == a);
        QVERIFY(rhoAt(studio, 0, 0) > 0.99);
        QVERIFY(settleMix(studio));
        TXN_AT_MOST(std::abs(blueAt(studio, 0, 0) - left), 1e-4); // nothing was computed anew
        TXN_AT_MOST(std::abs(studio->pipeline().mix()->frames.front().rho), 0.0);
        TXN_AT_MOST(std::abs(studio->pipeline().mix()->mixed.textons.back().rho - 1.0), 0.0);
        studio.trigger("edit.undo");
        QVERIFY(studio.project().source == a && studio.project().mix.source == b);
        QVERIFY(settleMix(studio));
        studio.trigger("mix.remove");
        QVERIFY(settleMix(studio));
        QVERIFY(!studio->pipeline().mix() && !studio->pipeline().secondExemplar());
    }

    void mixturesComeBackFromProjects() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.trigger("mix.brush");
        drag(studio, inView(studio, -30, 0), inView(studio, 30, 20));
        studio.document().change("More", [](Project& p) {
            p.mix.repeats = true;
            p.mix.mapScale = 2.0;
        });
        QVERIFY(settleMix(studio));
        const QImage noise = noiseOf(studio);
        const QString path = studio.path("mix.txnproj");
        TXN_OK(saveProject(studio.project(), studio.document().view(), path));
        const auto saved = openProject(path);
        TXN_OK(saved);
        const MixSettings& mix = saved->project.mix;
        QVERIFY(mix.source && mix.source->name() == studio.project().mix.source->name());
        QVERIFY(mix.edit == studio.project().mix.edit);
        QVERIFY(mix.map == studio.project().mix.map);
        QCOMPARE(mix.textons, 3);
        QVERIFY(mix.repeats);
        QCOMPARE(mix.mapScale, 2.0);
        // And makes the same noise, computed anew.
        studio.document().reset(saved->project, saved->view, path);
        QVERIFY(settleMix(studio));
        QVERIFY(noiseOf(studio) == noise);
    }

    void mapsComeAndGoAsPictures() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        Image map({64, 32}, 1);
        for (int x = 0; x < 64; ++x) {
            for (int y = 0; y < 32; ++y)
                map.at(x, y, 0) = static_cast<float>(x) / 63.0F;
        }
        const QString path = m_folder.filePath("map.png");
        SaveOptions options;
        options.sampleFormat = SampleFormat::UInt16;
        QVERIFY(bool(saveImage(map, path.toStdString(), options)));
        const auto choose = [&](const char* action, const char* dialog, const QString& file) {
            studio.trigger(action);
            auto* box = studio.find<QFileDialog>(dialog);
            emit box->fileSelected(file);
            box->close();
        };
        choose("mix.import", "importMapDialog", path);
        QVERIFY(waitFor([&] { return studio.project().mix.map.size() == Size{64, 32}; }));
        TXN_AT_MOST(imageDistance(studio.project().mix.map.image(), map), 1e-4);
        const QString out = m_folder.filePath("out.png");
        choose("mix.export", "exportMapDialog", out);
        QVERIFY(waitFor([&] { return QFile::exists(out); }));
        QVERIFY(settleMix(studio));
        TXN_AT_MOST(imageDistance(loadImage(out.toStdString())->image, map), 1e-4);
        // Colors are no map.
        const QString color = m_folder.filePath("color.png");
        QVERIFY(bool(saveImage(*makeSample("rust", {32, 32}, Seed{1}), color.toStdString())));
        choose("mix.import", "importMapDialog", color);
        auto* bar = studio.find<QLabel>("messageText");
        QVERIFY(waitFor([&] { return bar->text().contains("color.png"); }));
        QVERIFY(studio.project().mix.map.size() == (Size{64, 32}));
    }

    void anotherButtonDoesNotLoseTheStroke() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.trigger("mix.brush");
        PictureView& view = noiseView(studio);
        const int steps = studio.document().undoStack().index();
        QTest::mousePress(&view, Qt::LeftButton, {}, inView(studio, 0, 0));
        QTest::mousePress(&view, Qt::MiddleButton, {}, inView(studio, 0, 0));
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, inView(studio, 0, 0));
        QCOMPARE(studio.document().undoStack().index(), steps);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, inView(studio, 0, 0));
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
        QVERIFY(rhoAt(studio, 0, 0) > 0.99);
        // Under the exemplar that is held up, nothing is painted.
        view.setFlipped(true);
        drag(studio, inView(studio, 60, 60), inView(studio, 60, 60));
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
    }

    void aPenPaintsWithItsPressure() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.trigger("mix.brush");
        const QPoint light = inView(studio, -70, 0);
        pen(studio, QEvent::TabletPress, light, 0.3);
        QTest::mousePress(&noiseView(studio), Qt::LeftButton, {}, light);
        pen(studio, QEvent::TabletRelease, light, 0.0);
        QTest::mouseRelease(&noiseView(studio), Qt::LeftButton, {}, light);
        QVERIFY2(std::abs(rhoAt(studio, -70, 0) - 0.3) < 0.05,
                 qPrintable(QString::number(rhoAt(studio, -70, 0))));
        // A pen that hovers or has gone leaves the mouse its strength.
        const QPoint full = inView(studio, 70, 0);
        pen(studio, QEvent::TabletMove, full, 0.0);
        drag(studio, full, full);
        QVERIFY(rhoAt(studio, 70, 0) > 0.99);
    }

    void theChosenTextonSurvivesAnotherNumber() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        auto* strip = studio.find<FilmStrip>("mixStrip");
        strip->setFocus();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(strip, Qt::Key_Right); // the last one: B
        QVERIFY(settleMix(studio));
        const QImage b = noiseOf(studio);
        for (const int count : {2, 5}) {
            studio.document().change("Count", [count](Project& p) { p.mix.textons = count; });
            QVERIFY(settleMix(studio));
            QVERIFY(studio.document().view().mixRho == 1.0);
            QVERIFY(noiseOf(studio) == b);
        }
        studio.trigger("mix.remove");
        QVERIFY(!studio.document().view().mixRho);
    }

    void whatIsStoppedSaysSo() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        const auto before = studio->pipeline().mix();
        studio.document().change("Long", [](Project& p) {
            p.mix.textons = 64;
            p.texton.method = TextonMethod::Projections;
            p.texton.iterations = 50000;
        });
        QVERIFY(waitFor([&] { return studio->runner().isBusy(JobKind::Mix); }));
        studio->pipeline().cancelMix();
        studio->pipeline().cancelTexton();
        QVERIFY(studio->pipeline().mix() == before);
        TXN_COMES_TRUE(studio.find<QLabel>("mixWords")->text().contains("not up to date"));
        // The old mixture is seen, and not exported as if it were the new one.
        studio.trigger("file.export");
        QVERIFY(QTest::qWaitForWindowExposed(studio.find<QDialog>("exportDialog")));
        studio.find<QListWidget>("exportKinds")->setCurrentRow(4);
        QVERIFY(!studio.find<QPushButton>("exportStart")->isEnabled());
        studio.find<QDialog>("exportDialog")->close();
        studio.document().undoStack().undo();
        QVERIFY(settleMix(studio));
        QVERIFY(studio.find<QLabel>("mixWords")->text().contains("Distance"));
    }

    void lightIsOfOneKind() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        emit studio.find("exemplarSpace")->findChild<QComboBox*>()->activated(1);
        QVERIFY(studio.project().edit.linear && studio.project().mix.edit.linear);
        QVERIFY(settleMix(studio));
        QVERIFY(studio->pipeline().mixTextons()->front().transfer == Transfer::Linear);
    }

    void exportsAreOfTheMixture() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.document().change("Map", [](Project& p) {
            Image half({64, 64}, 1);
            for (int y = 0; y < 64; ++y) {
                for (int x = 32; x < 64; ++x)
                    half.at(x, y, 0) = 1.0F;
            }
            p.mix.map = PaintedMap::fromImage(half);
            p.mix.mapScale = 4.0;
            p.noise.process = NoiseProcess::Poisson; // a mixture takes both signs all the same
        });
        QVERIFY(settleMix(studio));
        studio.trigger("file.export");
        QVERIFY(QTest::qWaitForWindowExposed(studio.find<QDialog>("exportDialog")));
        auto* folder = studio.find<QLineEdit>("exportFolder");
        folder->setText(m_folder.path());
        emit folder->textEdited(m_folder.path());
        const auto write = [&](int kind, const QString& name, const QString& file) {
            studio.find<QListWidget>("exportKinds")->setCurrentRow(kind);
            studio.find<QLineEdit>("exportName")->setText(name);
            studio.find<QPushButton>("exportStart")->click();
            return waitFor([&] { return QFile::exists(m_folder.filePath(file)); }, 20000) &&
                   waitFor([&] { return studio->runner().isIdle(); });
        };
        studio.find<QListWidget>("exportKinds")->setCurrentRow(1);
        studio.find<QCheckBox>("exportTileable")->setChecked(false);
        studio.find<QSpinBox>("exportWidth")->setValue(256);
        studio.find<QSpinBox>("exportHeight")->setValue(256);
        // From the corner of the map on: rust on the left, sand on the right.
        QVERIFY2(write(1, "baked", "baked.png"),
                 qPrintable(studio.find<QLabel>("exportResult")->text()));
        const Image baked = loadImage(m_folder.filePath("baked.png").toStdString())->image;
        double left = 0.0;
        double right = 0.0;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 96; ++x) {
                left += static_cast<double>(baked.at(x, y, 2)) / (256.0 * 96.0);
                right += static_cast<double>(baked.at(255 - x, y, 2)) / (256.0 * 96.0);
            }
        }
        QVERIFY(right > left + 0.1);
        // All textons, their description and the map.
        QVERIFY(write(4, "all", "all/mixture.json"));
        for (const char* file : {"textons.exr", "map.png", "texton_00.exr", "texton_02.exr.json"})
            QVERIFY2(QFile::exists(m_folder.filePath("all/" + QString(file))), file);
        QVERIFY(studio.find<QLabel>("exportFiles")->text().contains("more"));
        // A tile of a map that does not repeat would have a seam.
        studio.find<QListWidget>("exportKinds")->setCurrentRow(1);
        studio.find<QCheckBox>("exportTileable")->click();
        QVERIFY(!studio.find<QPushButton>("exportStart")->isEnabled());
        QVERIFY(studio.find<QLabel>("exportFiles")->text().contains("256 x 256"));
        studio.trigger("mix.repeat");
        QVERIFY(settleMix(studio));
        QVERIFY(studio.find<QPushButton>("exportStart")->isEnabled());
        QVERIFY(write(1, "tile", "tile.png"));
    }

    void aStrokeEndsWithWhatItWasFor() {
        Studio studio;
        QVERIFY(openSmallMix(studio));
        studio.trigger("mix.brush");
        PictureView& view = noiseView(studio);
        const int steps = studio.document().undoStack().index();
        QTest::mousePress(&view, Qt::LeftButton, {}, inView(studio, 0, 0));
        QTest::mouseMove(&view, inView(studio, 20, 0));
        studio.trigger("mix.remove"); // in the middle of a stroke
        QTest::mouseMove(&view, inView(studio, 40, 0));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, inView(studio, 40, 0));
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
        QVERIFY(!studio.project().mix.source);
        QVERIFY(settleMix(studio));
    }
};

QTEST_MAIN(TestMix)
#include "TestMix.moc"
