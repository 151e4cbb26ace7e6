// SPDX-License-Identifier: GPL-3.0-or-later
// Writes pictures of the program's main states into a folder; see script/screenshots.
#include "app/panels/NoisePanel.h"
#include "app/panels/TextonPanel.h"
#include "tests/app/Studio.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <cstdio>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

constexpr int kQuality = 90;

class Photographer : public Studio {
  public:
    Photographer(QDir folder, const QString& language, ThemeChoice theme)
        : Studio(language, theme), m_folder(std::move(folder)) {
        (**this).start({});
    }

    void raise(const char* dock) {
        auto* found = find<QDockWidget>(dock);
        found->show();
        found->raise();
    }
    void scene(NoiseScene scene) {
        document().change(NoisePanel::tr("Noise view"),
                          [scene](Project& project) { project.noise.scene = scene; });
    }
    /// Of the whole window and what lies over it.
    void take(const char* name) {
        QTest::qWait(100);
        QPixmap picture = window().grab();
        QPainter painter(&picture);
        for (QWidget* over : QApplication::topLevelWidgets()) {
            if (over != &window() && over->isVisible())
                paintOver(painter, *over);
        }
        painter.end();
        const QString path = m_folder.filePath(QLatin1String(name) + QStringLiteral(".jpg"));
        if (!picture.save(path, "JPG", kQuality))
            std::fprintf(stderr, "cannot write %s\n", qPrintable(path));
    }

  private:
    void paintOver(QPainter& painter, QWidget& over) {
        const QRect place(window().mapFromGlobal(over.pos()), over.size());
        painter.drawPixmap(place.topLeft(), over.grab());
        painter.setPen(themeColors().line); // there is no window manager to frame it
        painter.drawRect(place.adjusted(-1, -1, 0, 0));
    }

    QDir m_folder;
};

/// Sand, and stone painted into it.
bool takePainting(const QDir& folder) {
    Photographer studio(folder, QStringLiteral("en"), ThemeChoice::Dark);
    bool good = studio.openSample("sand");
    studio.window().files().openSecondSample("stone");
    const auto mixed = [&] {
        const auto mix = studio->pipeline().mix();
        return mix && mix->finished && !studio->pipeline().isMixStale();
    };
    good = waitFor(mixed) && good;
    studio.raise("mixDock");
    good = studio.settle() && good;
    studio.take("mix");
    studio.document().change(QStringLiteral("New map"),
                             [](Project& project) { project.mix.map = PaintedMap(); });
    studio.document().changeView([](ViewState& view) {
        view.layout = ViewLayout::Single;
        view.shown = {Picture::Noise, Picture::Exemplar, Picture::Gaussian, Picture::Texton};
    });
    studio.window().views().setZoom(1.0);
    studio.trigger("mix.brush");
    good = studio.settle() && good;
    PictureView* view = studio.window().views().views().front();
    const auto along = [&](int i) {
        return view->rect().center() +
               QPoint(-280 + 14 * i, static_cast<int>(100.0 * std::sin(0.24 * i)));
    };
    QTest::mousePress(view, Qt::LeftButton, {}, along(0));
    for (int i = 1; i <= 40; ++i)
        QTest::mouseMove(view, along(i));
    QTest::mouseRelease(view, Qt::LeftButton, {}, along(40));
    good = studio.settle() && good;
    studio.take("painting");
    return good;
}

bool takeAll(const QDir& folder) {
    bool good = takePainting(folder);
    {
        Photographer studio(folder, QStringLiteral("en"), ThemeChoice::Dark);
        good = studio.settle() && good;
        studio.take("first-start");

        studio.raise("jobsDock");
        studio.document().change(TextonPanel::tr("Iterations"), [](Project& p) {
            p.texton.method = TextonMethod::Projections;
            p.texton.iterations = 20000;
            p.texton.support = {128, 128};
        });
        QTest::qWait(700);
        studio.take("computing");
        studio.document().undoStack().undo();
        studio.raise("historyDock");
        good = studio.settle() && good;

        auto* samples = studio.find<QMenu>("sampleMenu");
        samples->popup(studio.window().mapToGlobal(QPoint(24, 64)));
        studio.take("samples");
        samples->close();
        studio.trigger("view.wipe");
        good = studio.openSample("sand") && good;
        studio.take("wipe");
        studio.trigger("view.quad");
        studio.scene(NoiseScene::Perspective);
        studio.document().changeView([](ViewState& view) { view.pitch = 0.22; });
        good = studio.openSample("wood") && good;
        studio.take("perspective");
        studio.scene(NoiseScene::Surface);
        studio.trigger("view.sideBySide");
        good = studio.openSample("rust") && good;
        studio.take("mesh");
        studio.scene(NoiseScene::Plane);
        studio.trigger("view.quad");
        studio.raise("spectrumDock");
        good = studio.openSample("cloth") && good;
        studio.take("spectrum");
        studio.raise("histogramDock");
        good = studio.settle() && good;
        studio.take("histogram");
        studio.trigger("file.export");
        studio.find<QListWidget>("exportKinds")->setCurrentRow(1);
        studio.find<QLineEdit>("exportFolder")->setText(QStringLiteral("/home/artist/materials"));
        studio.take("export");
        studio.find<QDialog>("exportDialog")->close();
        studio.trigger("help.palette");
        QTest::keyClicks(studio.find<QLineEdit>("paletteSearch"), QStringLiteral("view"));
        studio.take("palette");
        studio.find("commandPalette")->close();
        studio.trigger("help.keys");
        studio.take("keys");
        studio.trigger("help.keys");
        studio.window().files().open(QStringLiteral("/home/artist/photos/bark.jpg"));
        good = studio.settle() && good;
        studio.take("error");
    }
    {
        Photographer studio(folder, QStringLiteral("en"), ThemeChoice::Light);
        good = studio.openSample("sand") && good;
        studio.take("light");
    }
    {
        Photographer studio(folder, QStringLiteral("fr"), ThemeChoice::Dark);
        good = studio.openSample("metal") && good;
        studio.take("french");
    }
    return good;
}

} // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    if (argc != 2) {
        std::fputs("usage: screenshots FOLDER\n", stderr);
        return 2;
    }
    const QDir folder(QString::fromLocal8Bit(argv[1]));
    if (!folder.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "cannot make the folder %s\n", argv[1]);
        return 1;
    }
    if (!takeAll(folder)) {
        std::fputs("something did not finish in time\n", stderr);
        return 1;
    }
    return 0;
}
