// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/SliderTrack.h"
#include "app/widgets/ValueSlider.h"
#include "core/samples/Samples.h"
#include "tests/app/Studio.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QThreadPool>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

#ifdef TXN_SANITIZED
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
constexpr int kDocuments = kSanitized ? 25 : 200;

/// How many different colours there are in what the view shows of the noise: 1 for a black view.
qsizetype colorsOf(PictureView& view) {
    const QImage image = view.grabPicture();
    QSet<QRgb> colors;
    for (int y = 0; y < image.height(); y += 7) {
        for (int x = 0; x < image.width(); x += 7)
            colors.insert(image.pixel(x, y));
    }
    return colors.size();
}

/// Controls whose texts do not fit.
QStringList clipped(QWidget& root) {
    QStringList found;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<QLabel*>(widget);
        const auto* button = qobject_cast<QAbstractButton*>(widget);
        const bool wraps = label != nullptr && label->wordWrap();
        const bool seen = widget->isVisible() && !widget->visibleRegion().isEmpty();
        if (!seen || widget->objectName().startsWith("qt_") || wraps ||
            (label == nullptr && button == nullptr) ||
            (label != nullptr && label->text().isEmpty()))
            continue;
        if (widget->width() < widget->sizeHint().width() ||
            widget->height() < widget->minimumSizeHint().height())
            found << (label != nullptr ? label->text() : button->text()) + '/' +
                         widget->objectName();
    }
    return found;
}

/// Controls of a panel that reach beyond what can be seen of it.
QStringList cutOff(QWidget& window) {
    QStringList found;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (!dock->isVisible())
            continue;
        for (QWidget* child : dock->widget()->findChildren<QWidget*>()) {
            const QPoint left = child->mapTo(dock, QPoint(0, 0));
            if (child->isVisible() && (left.x() < 0 || left.x() + child->width() > dock->width()))
                found << dock->objectName() + '/' + child->objectName();
        }
    }
    return found;
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

double residentMb() {
    QFile file("/proc/self/statm");
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    return file.readAll().split(' ').value(1).toDouble() * 4096.0 / 1e6;
}

} // namespace

/// What befalls the whole window: docks, languages, bad files, a lost driver, many documents.
class TestWindow : public QObject {
    Q_OBJECT

  private slots:
    void docksAreFlownAndPutBack() {
        Studio studio;
        QVERIFY(studio.openSmall());
        PictureView* noise = studio.window().views().views()[3];
        QVERIFY(colorsOf(*noise) > 20);
        for (QDockWidget* dock : studio.window().findChildren<QDockWidget*>()) {
            dock->raise();
            dock->setFloating(true);
            QTest::qWait(20);
            QVERIFY(studio.settle());
            QVERIFY2(colorsOf(*noise) > 20, dock->objectName().toUtf8());
            dock->setFloating(false);
            QTest::qWait(20);
            QVERIFY(studio.settle());
            QVERIFY2(colorsOf(*noise) > 20, dock->objectName().toUtf8());
        }
        studio.trigger("window.hideDocks");
        QVERIFY(!studio.find<QDockWidget>("textonDock")->isVisible());
        studio.trigger("window.hideDocks");
        QVERIFY(studio.find<QDockWidget>("textonDock")->isVisible());
        studio.find<QDockWidget>("textonDock")->close();
        studio.trigger("window.reset");
        QVERIFY(studio.find<QDockWidget>("textonDock")->isVisible());
    }

    void theLayoutIsRemembered() {
        Studio studio;
        studio.find<QDockWidget>("noiseDock")->hide();
        studio.window().close();
        MainWindow again(MainWindow::Parts{studio.settings(),
                                           studio.document(),
                                           studio->runner(),
                                           studio->pipeline(),
                                           studio->noise()});
        again.show();
        QVERIFY(!again.findChild<QDockWidget*>("noiseDock")->isVisible());
        QVERIFY(again.findChild<QDockWidget*>("textonDock")->isVisible());
    }

    void aLostContextComesBack() {
        Studio studio;
        QVERIFY(studio.openSmall());
        PictureView* noise = studio.window().views().views()[3];
        const QImage before = noise->grabPicture();
        for (int i = 0; i < 5; ++i) {
            studio->noise().loseContext();
            studio.document().change("Seed", [i](Project& p) {
                p.noise.seed = Seed{static_cast<std::uint32_t>(i + 100)};
            });
            QVERIFY(studio.settle());
            QVERIFY(colorsOf(*noise) > 20);
            QVERIFY(noise->grabPicture() != before);
        }
    }

    void badFilesLeaveEverythingAsItIs_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("missing") << "missing.png" << QByteArray();
        QTest::newRow("empty") << "empty.png" << QByteArray("");
        QTest::newRow("text") << "text.jpg" << QByteArray("this is no picture at all");
        QTest::newRow("cut") << "cut.png" << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
        QTest::newRow("project") << "bad.txnproj" << QByteArray("\xd9\xd9\xf7\xa1\x61\x61", 6);
        QTest::newRow("no project") << "photo.txnproj" << QByteArray("JPEG?");
        QTest::newRow("texton") << "bad.texton" << QByteArray("TEXTON 64 64 what");
        QTest::newRow("folder") << "" << QByteArray();
    }
    void badFilesLeaveEverythingAsItIs() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        Studio studio;
        QVERIFY(studio.openSmall());
        const Project before = studio.project();
        const int steps = studio.document().undoStack().count();
        const QString path = studio.path(name);
        if (!bytes.isNull())
            write(path, bytes);
        studio.window().files().open(path);
        auto* message = studio.find<QLabel>("messageText");
        TXN_COMES_TRUE(!message->text().isEmpty());
        QVERIFY2(message->text().contains(QFileInfo(path).fileName()), qPrintable(message->text()));
        QVERIFY(!message->text().contains('\n'));
        QVERIFY(studio.project() == before);
        QCOMPARE(studio.document().undoStack().count(), steps);
        QVERIFY(studio.settings().recentFiles().isEmpty());
    }

    void aLinkThatIsNoFileIsNotAccepted() {
        Studio studio;
        QMimeData data;
        data.setUrls({QUrl("https://example.org/a.png"), QUrl("mailto:somebody")});
        QVERIFY(!FileController::canOpen(data));
        data.setUrls({QUrl("https://example.org/a.png"), QUrl::fromLocalFile("/a.png")});
        QVERIFY(FileController::canOpen(data));
    }

    void editsWhileAProjectLoadsAreAskedAbout() {
        Studio studio;
        QVERIFY(studio.openSample("sand"));
        const QString file = studio.path("a.txnproj");
        QVERIFY(saveProject(studio.project(), {}, file));
        studio.window().files().open(file);
        studio.document().change("Contrast", [](Project& p) { p.noise.contrast = 1.5; });
        TXN_COMES_TRUE(studio.find<QMessageBox>("saveQuestion") != nullptr);
        studio.find<QMessageBox>("saveQuestion")->button(QMessageBox::Cancel)->click();
        QCOMPARE(studio.project().noise.contrast, 1.5);
    }

    void theViewOfAProjectComesBack() {
        Studio studio;
        QVERIFY(studio.openSample("sand"));
        ViewState view;
        view.layout = ViewLayout::SideBySide;
        view.centerX = 33.0;
        view.zoom = 3.0;
        const QString file = studio.path("a.txnproj");
        QVERIFY(saveProject(studio.project(), view, file));
        QVERIFY(studio.openSmall());
        studio.window().files().open(file);
        TXN_COMES_TRUE(studio.document().filePath() == file);
        QVERIFY(studio.settle());
        QCOMPARE(studio.document().view().zoom, 3.0);
        QCOMPARE(studio.document().view().centerX, 33.0);
        QCOMPARE(studio.document().view().layout, ViewLayout::SideBySide);
    }

    void aTextonTakesThePlaceOfAPhotoThatIsBeingPrepared() {
        Studio studio;
        QVERIFY(studio.openSample("sand"));
        const auto asset = std::make_shared<TextonAsset>();
        asset->texton = studio->pipeline().texton()->texton;
        studio.document().change("Crop", [](Project& p) { p.edit.crop = Rect{0, 0, {200, 200}}; });
        QTest::qWait(1); // its job has begun
        studio.document().change("Open", [&](Project& p) {
            p.source.reset();
            p.importedTexton = asset;
        });
        QVERIFY(studio.settle());
        for (const Picture each : kPictures)
            QVERIFY(!studio->pipeline().isStale(each));
        studio.document().undoStack().undo();
        QVERIFY(studio.settle());
        QCOMPARE(studio->pipeline().exemplar()->exemplar.image.size(), (Size{200, 200}));
    }

    void theNewestMeshWins() {
        Studio studio;
        studio.document().change("View", [](Project& p) { p.noise.scene = NoiseScene::Surface; });
        QVERIFY(studio.openSample("sand"));
        QVERIFY(studio->pipeline().mesh() != nullptr);
        const TriangleMesh sphere = *studio->pipeline().mesh();
        studio.document().change("Mesh", [](Project& p) { p.noise.mesh = "torus"; });
        QTest::qWait(0);
        studio.document().undoStack().undo();
        QVERIFY(studio.settle());
        QVERIFY(*studio->pipeline().mesh() == sphere);
    }

    void languagesAndDirections_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("typed");
        QTest::newRow("English") << "en"
                                 << "1.25";
        QTest::newRow("French") << "fr"
                                << "1,25";
        QTest::newRow("Spanish") << "es"
                                 << "1,25";
        QTest::newRow("German") << "de"
                                << "1,25";
        QTest::newRow("Arabic") << "ar"
                                << "1.25";
        QTest::newRow("Hebrew") << "he"
                                << "1.25";
    }
    void languagesAndDirections() {
        QFETCH(QString, language);
        QFETCH(QString, typed);
        Studio studio(language);
        const bool rightToLeft = language == "ar" || language == "he";
        QCOMPARE(studio.window().isRightToLeft(), rightToLeft);
        QVERIFY(studio.openSmall());
        auto* field = static_cast<QLineEdit*>(studio.part("noiseContrast", "field"));
        field->selectAll();
        QTest::keyClicks(field, typed);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(studio.project().noise.contrast, 1.25);
        // What is shown can be typed again.
        const QString shown = field->text();
        field->selectAll();
        field->insert(shown); // as pasted: keyClicks() knows ASCII only
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(studio.project().noise.contrast, 1.25);
        // The mouse drags to where it points, whichever way the track runs.
        auto* track = static_cast<SliderTrack*>(studio.part("noiseContrast", "track"));
        const QPoint high(static_cast<int>(track->position(2.0)), track->height() / 2);
        QCOMPARE(high.x() < track->width() / 2, rightToLeft);
        QTest::mouseClick(track, Qt::LeftButton, Qt::NoModifier, high);
        QCOMPARE(studio.project().noise.contrast, 2.0);
        QVERIFY(studio.settle());
        for (const char* dock : {"spectrumDock", "histogramDock", "jobsDock", "historyDock"}) {
            studio.find<QDockWidget>(dock)->raise();
            QVERIFY(studio.settle());
            QCOMPARE(clipped(studio.window()).join(' '), QString());
            QCOMPARE(cutOff(studio.window()).join(' '), QString());
        }
        installLanguage(*qApp, "en");
    }

    void twoProgramsDoNotSaveOverEachOther() {
        Studio first;
        QVERIFY(first.openSmall());
        const QString path = first.path("shared.txnproj");
        QVERIFY(saveProject(first.project(), {}, path));
        first.window().files().open(path);
        QVERIFY(first.settle());
        QCOMPARE(first.document().filePath(), path);
        Studio second;
        second.window().files().open(path);
        QVERIFY(second.settle());
        // It is a copy, which asks for a name when it is saved.
        QVERIFY(second.project().source != nullptr);
        QVERIFY(second.document().filePath().isEmpty());
        QVERIFY(second.find<QLabel>("messageText")->text().contains("shared.txnproj"));
        second.trigger("file.save");
        TXN_COMES_TRUE(second.find<QFileDialog>("saveDialog") != nullptr);
        auto* dialog = second.find<QFileDialog>("saveDialog");
        emit dialog->fileSelected(path);
        QVERIFY(second.settle());
        QVERIFY(second.document().filePath().isEmpty());
        const QString other = first.path("other.txnproj");
        emit dialog->fileSelected(other);
        QVERIFY(second.settle());
        QCOMPARE(second.document().filePath(), other);
        dialog->close();
        // Once the first one has gone on to something else, its project is free.
        first.document().undoStack().setClean();
        first.trigger("file.new");
        QVERIFY(first.settle());
        second.window().files().open(path);
        QVERIFY(second.settle());
        QCOMPARE(second.document().filePath(), path);
    }

    void lettersOfMenusAreOfOneEntry_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "fr", "es", "de"})
            QTest::newRow(language) << language;
    }
    void lettersOfMenusAreOfOneEntry() {
        QFETCH(QString, language);
        Studio studio(language);
        QStringList twice;
        for (const QMenu* menu : studio.window().findChildren<QMenu*>()) {
            QMap<QChar, QString> taken;
            for (const QAction* action : menu->actions()) {
                const auto keys = QKeySequence::mnemonic(action->text());
                if (keys.isEmpty() || !action->isVisible())
                    continue;
                const QChar letter = keys.toString().back();
                if (taken.contains(letter))
                    twice.append(taken[letter] + " = " + action->text());
                taken[letter] = action->text();
            }
        }
        QCOMPARE(twice.join(", "), QString());
        installLanguage(*qApp, "en");
    }

    void everyThemeIsReadable_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("dark") << 0;
        QTest::newRow("light") << 1;
    }
    void everyThemeIsReadable() {
        QFETCH(int, theme);
        const ThemeColors& colors = theme == 0 ? darkColors() : lightColors();
        const auto light = [](const QColor& color) {
            const auto linear = [](float v) {
                return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
            };
            return 0.2126F * linear(color.redF()) + 0.7152F * linear(color.greenF()) +
                   0.0722F * linear(color.blueF());
        };
        // WCAG 2: (L1 + 0.05) / (L2 + 0.05).
        const auto contrast = [&](const QColor& a, const QColor& b) {
            const float x = light(a) + 0.05F;
            const float y = light(b) + 0.05F;
            return std::max(x, y) / std::min(x, y);
        };
        for (const QColor& text : {colors.text, colors.secondary, colors.stale, colors.error}) {
            for (const QColor& ground : {colors.window, colors.panel, colors.field})
                QVERIFY2(contrast(text, ground) >= 4.5F,
                         qPrintable(text.name() + " on " + ground.name()));
        }
        QVERIFY(contrast(colors.window, colors.accent) >= 4.5F); // of what is selected
    }

    void manyPhotosOnTheUndoStackCostLittle() {
        Studio studio;
        QVERIFY(studio.openSample("sand"));
        const auto first = studio.project().source;
        const std::weak_ptr<const LoadedImage> pixels = *first->picture();
        QVERIFY(studio.openSmall());
        TXN_COMES_TRUE(pixels.expired());
        QVERIFY(first->picture()); // drawn again, for whoever asks
        studio.document().undoStack().undo();
        QVERIFY(studio.settle());
        QCOMPARE(studio->pipeline().exemplar()->source, first);
    }

    /// Every kind of photo survives being embedded, also those that only their ending tells.
    void embeddedPhotosOfEveryKindComeBack_data() {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"})
            QTest::newRow(ending) << ending;
    }
    void embeddedPhotosOfEveryKindComeBack() {
        QFETCH(QString, ending);
        QTemporaryDir folder;
        const QString path = folder.filePath("photo." + ending);
        QVERIFY(saveImage(*makeSample("rust", {40, 30}, Seed{1}), path.toStdString(), {}));
        if (ending == "tga") { // as older programs write it: without the footer
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite) && file.resize(file.size() - 26));
        }
        const auto source = openSource(path);
        QVERIFY(source);
        Project project;
        project.source = *source;
        const QByteArray bytes = encodeProject(project, {}, ExemplarStorage::Embedded, "/");
        QVERIFY(QFile::remove(path));
        const auto opened = decodeProject(bytes, "/x.txnproj");
        QVERIFY2(opened, opened ? "" : opened.error().message.c_str());
        QVERIFY((*opened->project.source->picture())->image == (*(*source)->picture())->image);
        // And being let go.
        Source::letGo(*source);
        QVERIFY((*source)->picture());
    }

    void twoHundredDocumentsDoNotAddUp() {
        Studio studio;
        const std::array samples{"rust", "sand", "stone", "wood"};
        double afterTwenty = 0.0;
        for (int i = 0; i < kDocuments; ++i) {
            studio.window().files().openSample(
                QLatin1String(samples[static_cast<std::size_t>(i) % samples.size()]));
            QVERIFY(waitFor([&] { return studio.project().source != nullptr; }));
            studio.document().change("Small", [](Project& p) {
                p.edit.crop = Rect{0, 0, {128, 128}};
                p.texton.support = {24, 24};
                p.noise.seed = Seed{5};
            });
            QVERIFY(studio.settle());
            studio.document().change("Contrast", [](Project& p) { p.noise.contrast = 0.8; });
            studio.document().undoStack().undo();
            studio.document().reset({}, {}, {}); // as File > New does
            QVERIFY(waitFor([&] { return studio->runner().isIdle(); }));
            if (i == 19)
                afterTwenty = residentMb();
        }
        QVERIFY(waitFor([] { return QThreadPool::globalInstance()->activeThreadCount() == 0; }));
        const double grown = residentMb() - afterTwenty;
        qInfo("%.1f MB after 20 documents, %.1f MB more after %d", afterTwenty, grown, kDocuments);
        if (kSanitized)
            QSKIP("the sanitizer keeps freed memory");
        QVERIFY2(grown <= 20.0, QByteArray::number(grown));
    }

    void filesOutsideTheProjectAreAskedFor() {
        Studio studio;
        QVERIFY(QDir().mkpath(studio.path("project")));
        const QString photo = studio.path("photo.png");
        QVERIFY(saveImage(*makeSample("rust", {40, 30}, Seed{1}), photo.toStdString(), {}));
        const auto source = openSource(photo);
        QVERIFY(source);
        Project project;
        project.source = *source;
        project.linked = true;
        const QString path = studio.path("project/p.txnproj");
        QVERIFY(saveProject(project, {}, path));

        studio.window().files().open(path);
        TXN_COMES_TRUE(studio.find<QMessageBox>("outsideQuestion") != nullptr);
        QVERIFY(studio.find<QMessageBox>("outsideQuestion")->informativeText().contains(photo));
        studio.find<QMessageBox>("outsideQuestion")->button(QMessageBox::Cancel)->click();
        TXN_COMES_TRUE(studio.find<QMessageBox>("outsideQuestion") == nullptr);
        TXN_COMES_TRUE(studio->runner().isIdle());
        QVERIFY(studio.project().source == nullptr);

        studio.window().files().open(path);
        TXN_COMES_TRUE(studio.find<QMessageBox>("outsideQuestion") != nullptr);
        studio.find<QMessageBox>("outsideQuestion")->button(QMessageBox::Open)->click();
        TXN_COMES_TRUE(studio.project().source != nullptr);
        QCOMPARE(studio.project().source->name(), QStringLiteral("photo.png"));
        TXN_COMES_TRUE(studio->runner().isIdle());
    }
};

QTEST_MAIN(TestWindow)
#include "TestWindow.moc"
