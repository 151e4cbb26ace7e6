// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/CropCanvas.h"
#include "core/export/Exporter.h"
#include "core/samples/Samples.h"
#include "tests/app/Studio.h"

#include <QAbstractButton>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

/// A photo that somebody might have: sand, not square.
QString writePhoto(const QString& path) {
    const auto image = makeSample("sand", {320, 240}, Seed{5});
    const bool written = image && toQImage(*image).save(path);
    return written ? path : QString();
}

void drop(QWidget& target, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint middle = target.rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &drop);
}

void drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseMove(widget, from);
    QTest::mousePress(widget, button, Qt::NoModifier, from);
    for (int i = 1; i <= 4; ++i) {
        // QTest::mouseMove tells no buttons.
        const QPoint at = from + (to - from) * i / 4;
        QMouseEvent move(QEvent::MouseMove,
                         at,
                         widget->mapToGlobal(at),
                         Qt::NoButton,
                         button,
                         Qt::NoModifier);
        QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, button, Qt::NoModifier, to);
}

/// What a file dialog asks for, typed.
void typeFileName(Studio& studio, const char* dialog, const QString& path) {
    TXN_COMES_TRUE(studio.find<QFileDialog>(dialog) != nullptr);
    auto* files = studio.find<QFileDialog>(dialog);
    QVERIFY(QTest::qWaitForWindowExposed(files));
    auto* name = files->findChild<QLineEdit*>("fileNameEdit");
    QVERIFY(name != nullptr);
    name->selectAll();
    QTest::keyClicks(name, path);
    files->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
    TXN_COMES_TRUE(studio.find<QFileDialog>(dialog) == nullptr);
}

} // namespace

/// What an artist does on the first day, by mouse and keyboard, on the real window.
class TestAppStory : public QObject {
    Q_OBJECT

  private slots:
    void fromAPhotoToAMaterial() {
        Studio studio;
        studio->start({});
        // The first thing to see is a finished result.
        QVERIFY(studio.settle());
        QCOMPARE(studio.project().source->sample(), "rust");
        QVERIFY(studio.find<QLabel>("textonVerdict")->text().contains("close"));
        QVERIFY(!studio.window().isWindowModified());

        // A photo is dropped.
        const QString photo = writePhoto(studio.path("beach.png"));
        QVERIFY(!photo.isEmpty());
        drop(studio.window(), photo);
        QVERIFY(studio.settle());
        QCOMPARE(studio.project().source->name(), "beach.png");
        QCOMPARE(studio->pipeline().exemplar()->exemplar.image.size(), (Size{320, 240}));
        QVERIFY(studio.window().windowTitle().startsWith("beach.png"));

        // Its right half is taken.
        auto* canvas = studio.find<CropCanvas>("cropCanvas");
        const QPoint middle = canvas->rect().center();
        drag(canvas, {middle.x(), 10}, {canvas->width() - 2, canvas->height() - 2});
        QVERIFY(studio.project().edit.crop.has_value());
        QVERIFY(studio.settle());
        const Size cropped = studio->pipeline().exemplar()->exemplar.image.size();
        QVERIFY(cropped.width > 140 && cropped.width < 180 && cropped.height > 210);

        // The support is dragged, then typed.
        QWidget* track = studio.part("textonSupport", "track");
        drag(track, track->rect().center(), {2, track->height() / 2});
        QCOMPARE(studio.project().texton.support, (Size{8, 8}));
        auto* field = static_cast<QLineEdit*>(studio.part("textonSupport", "field"));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "16+4*3");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(studio.project().texton.support, (Size{28, 28}));
        QVERIFY(studio.settle());
        QCOMPARE(studio->pipeline().texton()->texton.support.size(), (Size{28, 28}));

        lookAround(studio);
        exportTexton(studio);
        saveAndReopen(studio);
    }

    void aPastedPictureIsOpened() {
        Studio studio;
        QImage picture(64, 48, QImage::Format_RGB32);
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x)
                picture.setPixel(x, y, qRgb((x * 37 + y * 91) % 256, (x * y) % 256, 128));
        }
        QApplication::clipboard()->setImage(picture);
        QTest::keyClick(&studio.window(), Qt::Key_V, Qt::ControlModifier);
        TXN_COMES_TRUE(studio.project().source != nullptr);
        QCOMPARE(studio.project().source->size(), (Size{64, 48}));
        QApplication::clipboard()->clear();
        QTest::keyClick(&studio.window(), Qt::Key_V, Qt::ControlModifier);
        QVERIFY(studio.find<QLabel>("messageText")->text().contains("clipboard"));
    }

    void cancelGoesBackAtOnce() {
        Studio studio;
        QVERIFY(studio.openSample("sand"));
        const auto before = studio->pipeline().texton();
        auto* field = static_cast<QLineEdit*>(studio.part("textonIterations", "field"));
        field->selectAll();
        QTest::keyClicks(field, "100000");
        QTest::keyClick(field, Qt::Key_Return);
        TXN_COMES_TRUE(studio->pipeline().texton() != before); // it forms before the eyes
        TXN_COMES_TRUE(studio.find("viewStale2")->isVisible());
        QTest::mouseClick(studio.find("textonCancel"), Qt::LeftButton);
        QCOMPARE(studio->pipeline().texton(), before);
        QTRY_VERIFY_WITH_TIMEOUT(studio->runner().isIdle(), 1000);
        QCOMPARE(studio->pipeline().texton(), before);
        QVERIFY(studio.find("viewStale2")->isVisible()); // not what the settings say
        QTest::keyClick(&studio.window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(studio.settle());
        QVERIFY(!studio.find("viewStale2")->isVisible());
    }

    void closingDuringWorkEndsCleanly() {
        for (int round = 0; round < 3; ++round) {
            Studio studio;
            QVERIFY(studio.openSample("rust"));
            studio.document().change("Iterations", [](Project& p) {
                p.texton.method = TextonMethod::Projections;
                p.texton.iterations = 100000;
                p.texton.support = {256, 256};
            });
            QTest::qWait(round * 60);
            studio.window().close();
            auto* question = studio.find<QMessageBox>("saveQuestion");
            QVERIFY(question != nullptr);
            question->button(QMessageBox::Discard)->click();
            TXN_COMES_TRUE(!studio.window().isVisible());
        }
    }

    /// Pictures beyond the budget are opened when the user insists, and only then.
    void veryLargePicturesAreAskedAbout() {
        Studio studio;
        QVERIFY(studio.openSmall());
        limitPictures(studio);
        const QString photo = writePhoto(studio.path("beach.png"));
        studio.window().files().open(photo);
        answerLargePicture(studio, false);
        QCOMPARE(studio.project().source->sample(), "rust");
        studio.window().files().open(photo);
        answerLargePicture(studio, true);
        QCOMPARE(studio.project().source->name(), "beach.png");
        studio.window().files().openSecond({photo});
        answerLargePicture(studio, true);
        QCOMPARE(studio.project().mix.source->name(), "beach.png");
    }

    /// Also those inside of projects, first or second.
    void veryLargePicturesOfProjectsAreAskedAbout_data() {
        QTest::addColumn<bool>("second");
        QTest::newRow("the exemplar") << false;
        QTest::newRow("what it is mixed with") << true;
    }
    void veryLargePicturesOfProjectsAreAskedAbout() {
        QFETCH(bool, second);
        Studio studio;
        QVERIFY(studio.openSmall());
        const auto photo = openSource(writePhoto(studio.path("beach.png")));
        TXN_OK(photo);
        Project project = studio.project();
        (second ? project.mix.source : project.source) = *photo;
        const QString path = studio.path("beach.txnproj");
        TXN_OK(saveProject(project, {}, path));
        limitPictures(studio);
        studio.window().files().newProject();
        if (auto* unsaved = studio.find<QMessageBox>("saveQuestion"))
            unsaved->button(QMessageBox::Discard)->click();
        TXN_COMES_TRUE(studio.project().source == nullptr);
        studio.window().files().open(path);
        answerLargePicture(studio, false);
        QVERIFY(studio.project().source == nullptr);
        studio.window().files().open(path);
        answerLargePicture(studio, true);
        QVERIFY(studio.project().source != nullptr);
        QCOMPARE((second ? studio.project().mix.source : studio.project().source)->name(),
                 "beach.png");
        QCOMPARE(studio.document().filePath(), path);
    }

  private:
    /// To less than writePhoto() makes.
    void limitPictures(const Studio& studio) {
        QSettings(studio.path("settings.ini"), QSettings::IniFormat)
            .setValue("open/pictureBudget", 320 * 240 * 3 - 1);
    }

    void answerLargePicture(Studio& studio, bool openIt) {
        TXN_COMES_TRUE(studio.find<QMessageBox>("largePictureQuestion") != nullptr);
        auto* question = studio.find<QMessageBox>("largePictureQuestion");
        QVERIFY(question->text().contains("beach.png"));
        for (QAbstractButton* button : question->buttons()) {
            if ((question->buttonRole(button) == QMessageBox::AcceptRole) == openIt) {
                button->click();
                break;
            }
        }
        TXN_COMES_TRUE(studio.find<QMessageBox>("largePictureQuestion") == nullptr);
        QVERIFY(studio.settle());
    }

    void lookAround(Studio& studio) {
        PictureView* view = studio.window().views().views()[3];
        QCOMPARE(view->picture(), Picture::Noise);
        const double zoom = studio.document().view().zoom;
        const QPoint middle = view->rect().center();
        QWheelEvent wheel(middle,
                          view->mapToGlobal(QPointF(middle)),
                          {},
                          {0, 240},
                          Qt::NoButton,
                          Qt::NoModifier,
                          Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(view, &wheel);
        QVERIFY(studio.document().view().zoom > zoom);
        drag(view, middle, middle + QPoint(40, 10), Qt::MiddleButton);
        QVERIFY(studio.document().view().centerX < 0.0);
        QTest::keyClick(&studio.window(), Qt::Key_1);
        QCOMPARE(studio.document().view().zoom, 1.0);
        QTest::keyClick(&studio.window(), Qt::Key_F);
        QCOMPARE(studio.document().view().centerX, 0.0);

        // The probe tells what is under the mouse.
        QTest::mouseMove(view, middle + QPoint(3, 3));
        TXN_COMES_TRUE(studio.find<QLabel>("probe")->text().contains("sRGB"));

        // A new seed for what is under the mouse.
        const Seed seed = studio.project().noise.seed;
        QTest::keyClick(&studio.window(), Qt::Key_R);
        QVERIFY(studio.project().noise.seed != seed);
        QVERIFY(studio.settle());

        // Held keys act on the view under the mouse, until they are let go.
        const QImage noise = view->grabPicture();
        QTest::keyPress(&studio.window(), Qt::Key_QuoteLeft);
        QVERIFY(view->grabPicture() != noise);
        QTest::keyRelease(&studio.window(), Qt::Key_QuoteLeft);
        QCOMPARE(view->grabPicture(), noise);
        QTest::keyPress(&studio.window(), Qt::Key_Space);
        drag(view, middle, middle + QPoint(0, 30));
        QTest::keyRelease(&studio.window(), Qt::Key_Space);
        QVERIFY(studio.document().view().centerY < 0.0);
    }

    void exportTexton(Studio& studio) {
        QTest::keyClick(&studio.window(), Qt::Key_E, Qt::ControlModifier);
        TXN_COMES_TRUE(studio.find<QDialog>("exportDialog") != nullptr &&
                       studio.find<QDialog>("exportDialog")->isVisible());
        QVERIFY(QTest::qWaitForWindowExposed(studio.find<QDialog>("exportDialog")));
        auto* folder = studio.find<QLineEdit>("exportFolder");
        folder->selectAll();
        QTest::keyClicks(folder, studio.path({}));
        studio.find<QListWidget>("exportKinds")->setCurrentRow(0);
        QTest::mouseClick(studio.find("exportStart"), Qt::LeftButton);
        const QString file = studio.path("beach_texton28.exr");
        QTRY_VERIFY2(QFileInfo::exists(file),
                     qPrintable(studio.find<QLabel>("exportFiles")->text() +
                                studio.find<QLabel>("exportResult")->text()));
        const auto loaded = loadTextonOrImage(file.toStdString());
        QVERIFY(loaded && std::holds_alternative<TextonAsset>(*loaded));
        QVERIFY(std::get<TextonAsset>(*loaded).texton.support.size() == (Size{28, 28}));
        TXN_COMES_TRUE(studio->runner().isIdle());
        studio.find<QDialog>("exportDialog")->close();
    }

    void saveAndReopen(Studio& studio) {
        const QString file = studio.path("beach.txnproj");
        QVERIFY(studio.window().isWindowModified());
        studio.activate();
        QTest::keyClick(&studio.window(), Qt::Key_S, Qt::ControlModifier);
        typeFileName(studio, "saveDialog", file);
        TXN_COMES_TRUE(!studio.window().isWindowModified());
        QVERIFY(QFileInfo::exists(file));
        const Project saved = studio.project();

        // A change, a change of mind, and back.
        studio.document().change("Contrast", [](Project& p) { p.noise.contrast = 0.5; });
        studio.window().close();
        TXN_COMES_TRUE(studio.find<QMessageBox>("saveQuestion") != nullptr);
        studio.find<QMessageBox>("saveQuestion")->button(QMessageBox::Cancel)->click();
        QVERIFY(studio.window().isVisible());
        TXN_COMES_TRUE(studio.find<QMessageBox>("saveQuestion") == nullptr);
        studio.window().files().open(file);
        TXN_COMES_TRUE(studio.find<QMessageBox>("saveQuestion") != nullptr);
        studio.find<QMessageBox>("saveQuestion")->button(QMessageBox::Discard)->click();
        TXN_COMES_TRUE(studio.project().noise.contrast == 1.0);
        QVERIFY(studio.settle());
        // Everything is as it was; the picture itself came back from the file.
        Project reopened = studio.project();
        QCOMPARE(reopened.source->hash(), saved.source->hash());
        reopened.source = saved.source;
        QVERIFY(reopened == saved);
        QCOMPARE(studio.settings().recentFiles().first(), file);
    }
};

QTEST_MAIN(TestAppStory)
#include "TestAppStory.moc"
