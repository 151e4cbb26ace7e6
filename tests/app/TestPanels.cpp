// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/CropCanvas.h"
#include "app/widgets/ChoiceRow.h"
#include "app/widgets/SeedField.h"
#include "app/widgets/ValueSlider.h"
#include "tests/app/Studio.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <random>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

/// Uses the control as somebody without a mouse would; forward: up or to the next choice.
void operate(QWidget* control, bool forward) {
    if (auto* slider = qobject_cast<ValueSlider*>(control)) {
        auto* track = slider->findChild<QWidget*>("track");
        QTest::keyClick(track, forward ? Qt::Key_PageUp : Qt::Key_PageDown);
    } else if (auto* choice = qobject_cast<ChoiceRow*>(control)) {
        QTest::keyClick(&choice->box(), forward ? Qt::Key_Down : Qt::Key_Up);
    } else if (auto* seed = qobject_cast<SeedField*>(control)) {
        auto* field = seed->findChild<QLineEdit*>("field");
        field->selectAll();
        QTest::keyClicks(field, QString::number(seed->seed() + (forward ? 1 : 7)));
        QTest::keyClick(field, Qt::Key_Return);
    } else {
        QTest::keyClick(control,
                        Qt::Key_F6); // whoever gets there by keys means the box, not the view
        QTest::keyClick(control, Qt::Key_Space);
    }
}

/// What the control shows.
QString shown(QWidget* control) {
    if (auto* slider = qobject_cast<ValueSlider*>(control))
        return slider->findChild<QLineEdit*>("field")->text();
    if (auto* choice = qobject_cast<ChoiceRow*>(control))
        return choice->box().currentText();
    if (auto* seed = qobject_cast<SeedField*>(control))
        return seed->findChild<QLineEdit*>("field")->text();
    return qobject_cast<QCheckBox*>(control)->isChecked() ? "on" : "off";
}

const std::array kControls{"exemplarAngle",    "exemplarSpace",  "exemplarEven", "exemplarRadius",
                           "exemplarPeriodic", "textonSupport",  "textonShape",  "textonOrder",
                           "textonIterations", "textonMomentum", "textonSeed",   "textonColors",
                           "noiseImpacts",     "noiseProcess",   "noiseSeed",    "noiseScene",
                           "noiseLighting",    "noiseFilter",    "noiseScale",   "noiseContrast",
                           "noiseBrightness",  "textonMethod",   "textonKernels"};

/// Those of stacks.
const std::array kStackControls{
    "exemplarFlipGreen", "noiseMap", "noiseLightAngle", "noiseLightHeight"};

} // namespace

class TestPanels : public QObject {
    Q_OBJECT

    /// With everything that hides some control switched on.
    static void openSmall(Studio& studio) {
        studio.document().change("All", [](Project& p) {
            p.edit.flattenRadiusPx = 20.0;
            p.noise.scene = NoiseScene::Surface;
        });
        QVERIFY(studio.openSmall());
    }

    std::unique_ptr<Studio> m_opened;
    bool m_openedStack = false;
    int m_openedStep = 0;

    /// One window for many rows, as it was after opening: to open one takes longer than a row.
    Studio& opened(bool stack) {
        if (!m_opened || m_openedStack != stack) {
            m_opened = std::make_unique<Studio>();
            m_openedStack = stack;
            if (stack)
                m_opened->openSmallStack();
            else
                openSmall(*m_opened);
            m_openedStep = m_opened->document().undoStack().index();
        }
        m_opened->document().undoStack().setIndex(m_openedStep);
        return *m_opened;
    }

  private slots:
    void cleanupTestCase() { m_opened.reset(); }

    void everyControlIsOneUndoableStep_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : kControls)
            QTest::newRow(name) << name;
        for (const char* name : kStackControls)
            QTest::newRow(name) << name;
    }
    void everyControlIsOneUndoableStep() {
        QFETCH(QString, name);
        Studio& studio =
            opened(std::ranges::find(kStackControls, name.toStdString()) != kStackControls.end());
        QVERIFY(studio.settle());
        if (name == "textonIterations" || name == "textonMomentum") {
            studio.document().change("Method", [](Project& p) {
                p.texton.method = TextonMethod::Projections;
            });
            QVERIFY(studio.settle());
        }
        auto* control = studio.window().findChild<QWidget*>(name);
        QVERIFY(control != nullptr && control->isVisible());
        const Project before = studio.project();
        const QString text = shown(control);
        const int steps = studio.document().undoStack().index();
        // Whatever was at its first choice has a next one, and else the one before.
        operate(control, true);
        if (studio.project() == before)
            operate(control, false);
        QVERIFY(studio.project() != before);
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
        QVERIFY(!studio.document().undoStack().undoText().isEmpty());
        const QString after = shown(control);
        QVERIFY(after != text);
        QVERIFY(studio.settle());
        studio.trigger("edit.undo");
        QVERIFY(studio.project() == before);
        QCOMPARE(shown(control), text);
        studio.trigger("edit.redo");
        QCOMPARE(shown(control), after);
        QVERIFY(studio.settle());
    }

    void aDragOfASliderIsOneStep() {
        Studio studio;
        openSmall(studio);
        QWidget* track = studio.part("noiseContrast", "track");
        const int steps = studio.document().undoStack().index();
        QTest::mousePress(track, Qt::LeftButton, Qt::NoModifier, track->rect().center());
        for (int x = track->width() / 2; x < track->width(); ++x) {
            QMouseEvent move(QEvent::MouseMove,
                             QPointF(x, 8),
                             track->mapToGlobal(QPointF(x, 8)),
                             Qt::NoButton,
                             Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(track, &move);
        }
        QTest::mouseRelease(track, Qt::LeftButton);
        QCOMPARE(studio.project().noise.contrast, 2.0);
        QCOMPARE(studio.document().undoStack().index(), steps + 1);
        QTest::mouseDClick(track, Qt::LeftButton);
        QCOMPARE(studio.project().noise.contrast, 1.0);
    }

    void theVerdictHasAReason() {
        Studio studio;
        QVERIFY(studio.openSample("rust"));
        auto* verdict = studio.find<QLabel>("verdict");
        TXN_BECOMES(verdict->text(), "Suits texton noise");
        QVERIFY(studio.find<QLabel>("verdictReason")->text().size() > 20);
        QVERIFY(studio.find<QLabel>("exemplarFacts")->text().contains("512 x 512 px"));
        QVERIFY(studio.openSample("leather"));
        TXN_COMES_TRUE(verdict->text().contains("shapes"));
        QVERIFY(verdict->toolTip().contains("kurtosis"));
    }

    void aLineStraightens() {
        Studio studio;
        QVERIFY(studio.openSample("wood"));
        QTest::mouseClick(studio.find("straightenTool"), Qt::LeftButton);
        auto* canvas = studio.find<CropCanvas>("cropCanvas");
        QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, {40, 60});
        QMouseEvent move(QEvent::MouseMove,
                         QPointF(140, 70),
                         canvas->mapToGlobal(QPointF(140, 70)),
                         Qt::NoButton,
                         Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(canvas, &move);
        QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, {140, 70});
        QVERIFY(std::abs(studio.project().edit.straightenDegrees - 5.71) <= 0.01);
        QVERIFY(studio.settle());
        QTest::mouseClick(studio.find("resetExemplar"), Qt::LeftButton);
        QVERIFY(studio.project().edit == ExemplarEdit{});
    }

    void arrowsMoveTheCrop() {
        Studio studio;
        openSmall(studio);
        auto* canvas = studio.find<CropCanvas>("cropCanvas");
        QTest::keyClick(canvas, Qt::Key_Right);
        QTest::keyClick(canvas, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(*studio.project().edit.crop, (Rect{8, 0, {96, 104}}));
    }

    void aLockedSeedStays() {
        Studio studio;
        openSmall(studio);
        auto* lock = studio.part("textonSeed", "lock");
        QTest::mouseClick(lock, Qt::LeftButton);
        QVERIFY(studio.project().texton.seedLocked);
        QVERIFY(!studio.part("textonSeed", "dice")->isEnabled());
        QTest::mouseClick(lock, Qt::LeftButton);
        const Seed before = studio.project().texton.seed;
        QTest::mouseClick(studio.part("textonSeed", "dice"), Qt::LeftButton);
        QVERIFY(studio.project().texton.seed != before);
    }

    void theGaussianVersionIsRerolled() {
        Studio studio;
        openSmall(studio);
        const auto before = studio->pipeline().gaussian();
        QTest::mouseClick(studio.find("viewDice1"), Qt::LeftButton);
        QVERIFY(studio.settle());
        QVERIFY(studio->pipeline().gaussian() != before);
        QTest::keyClick(studio.find<QComboBox>("viewMethod1"), Qt::Key_Down);
        QCOMPARE(studio.project().gaussian.method, GaussianMethod::RandomPhase);
        studio.trigger("edit.undo");
        QCOMPARE(studio.find<QComboBox>("viewMethod1")->currentIndex(), 0);
    }

    void wipesBetweenAnyTwoPictures() {
        Studio studio;
        openSmall(studio);
        studio.trigger("view.wipe");
        auto* first = studio.find<QComboBox>("viewPicture0");
        auto* second = studio.find<QComboBox>("viewSecond0");
        QVERIFY(second->isVisible());
        PictureView* view = studio.window().views().views()[0];
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) {
                if (a == b)
                    continue;
                first->setCurrentIndex(a);
                emit first->activated(a);
                second->setCurrentIndex(b);
                emit second->activated(b);
                QCOMPARE(view->picture(), kPictures[static_cast<std::size_t>(a)]);
                QVERIFY(view->shows(kPictures[static_cast<std::size_t>(b)]));
                QVERIFY(studio.settle());
                QVERIFY(!view->grabPicture().isNull());
            }
        }
        // The border is dragged.
        const double wipe = studio.document().view().wipe;
        const QPoint border(view->width() / 2, view->height() / 2);
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, border);
        QTest::mouseMove(view, border + QPoint(60, 0));
        QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, border + QPoint(60, 0));
        QVERIFY(studio.document().view().wipe > wipe);
    }

    void spectraAndHistogramsAreDrawnWhenLookedAt() {
        Studio studio;
        studio.find<QDockWidget>("historyDock")->raise();
        QTest::qWait(10);
        openSmall(studio);
        QVERIFY(!studio->pipeline().analysis());
        for (const char* dock : {"spectrumDock", "histogramDock"}) {
            studio.find<QDockWidget>(dock)->raise();
            QVERIFY(waitFor([&] { return studio->pipeline().analysis() != nullptr; }));
            QVERIFY(studio.settle());
            const QImage panel = studio.find<QDockWidget>(dock)->widget()->grab().toImage();
            QSet<QRgb> colors;
            for (int y = 0; y < panel.height(); y += 3) {
                for (int x = 0; x < panel.width(); x += 3)
                    colors.insert(panel.pixel(x, y));
            }
            QVERIFY(colors.size() > 10);
        }
    }

    void meshesAreChosenAndMissingOnesTold() {
        Studio studio;
        openSmall(studio);
        QFile mesh(studio.path("roof.obj"));
        QVERIFY(mesh.open(QIODevice::WriteOnly));
        mesh.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        mesh.close();
        studio.document().change("Mesh", [&](Project& p) { p.noise.mesh = mesh.fileName(); });
        QVERIFY(studio.settle());
        QCOMPARE(studio->pipeline().mesh()->triangles.size(), std::size_t{1});
        studio.document().change("Mesh",
                                 [&](Project& p) { p.noise.mesh = studio.path("nowhere.obj"); });
        TXN_COMES_TRUE(studio.find<QLabel>("messageText")->text().contains("nowhere.obj"));
    }

    /// Hundreds of things that an artist may do, in any order, and all of them taken back.
    void threeHundredRandomActionsAreUndone() {
        Studio studio;
        openSmall(studio);
        studio.document().undoStack().clear();
        const Project start = studio.project();
        std::mt19937 random(20261125);
        const auto below = [&](std::size_t n) {
            return static_cast<std::size_t>(random() % static_cast<std::mt19937::result_type>(n));
        };
        const std::array samples{"sand", "stone", "cloth", "rust"};
        for (int i = 0; i < 300; ++i) {
            const std::size_t what = below(kControls.size() + 6);
            if (what < kControls.size()) {
                auto* control = studio.window().findChild<QWidget*>(QLatin1String(kControls[what]));
                if (control->isVisible() && control->isEnabled())
                    operate(control, below(2) == 0);
            } else if (what == kControls.size()) {
                auto* canvas = studio.find<CropCanvas>("cropCanvas");
                QTest::keyClick(canvas,
                                below(2) == 0 ? Qt::Key_Right : Qt::Key_Up,
                                below(2) == 0 ? Qt::NoModifier : Qt::ShiftModifier);
            } else if (what == kControls.size() + 1) {
                QTest::mouseClick(studio.find("viewDice1"), Qt::LeftButton);
            } else if (what == kControls.size() + 2) {
                studio.trigger("edit.undo");
            } else if (what == kControls.size() + 3) {
                studio.trigger("edit.redo");
            } else if (what == kControls.size() + 4) {
                studio.trigger("texton.newSeed");
            } else if (below(4) == 0) { // large pictures take their time
                studio.window().files().openSample(QLatin1String(samples[below(4)]));
                TXN_COMES_TRUE(!studio->runner().isBusy(JobKind::Open));
                studio.document().change("Small", [](Project& p) {
                    p.edit.crop = Rect{0, 0, {64, 64}};
                });
            }
            QTest::qWait(static_cast<int>(below(8)));
        }
        const Project end = studio.project();
        QVERIFY(studio.document().undoStack().count() > 100);
        while (studio.document().undoStack().canUndo())
            studio.trigger("edit.undo");
        QVERIFY(studio.project() == start);
        while (studio.document().undoStack().canRedo())
            studio.trigger("edit.redo");
        while (studio.document().undoStack().canUndo())
            studio.trigger("edit.undo");
        QVERIFY(studio.project() == start);
        QVERIFY(end != start);
        QVERIFY(studio.settle());
    }
};

QTEST_MAIN(TestPanels)
#include "TestPanels.moc"
