// SPDX-License-Identifier: GPL-3.0-or-later
// Writes pictures of the program's main states into a folder; see script/screenshots.
#include "app/Application.h"
#include "app/MainWindow.h"
#include "app/files/FileController.h"
#include "app/look/Language.h"
#include "app/look/Theme.h"
#include "app/panels/NoisePanel.h"
#include "app/panels/TextonPanel.h"
#include "app/views/ViewArea.h"
#include "app/widgets/ActionRegistry.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <functional>

using namespace txn::app;

namespace {

constexpr int kPatienceMs = 60000;

bool waitFor(const std::function<bool()>& condition) {
    QElapsedTimer watch;
    watch.start();
    while (!condition()) {
        if (watch.elapsed() > kPatienceMs)
            return false;
        QTest::qWait(10);
    }
    return true;
}

class Photographer {
  public:
    Photographer(QApplication& application, QDir folder, const QString& language, ThemeChoice theme)
        : m_folder(std::move(folder)), m_settings(m_home.filePath(QStringLiteral("settings.ini"))) {
        installLanguage(application, language);
        applyTheme(application, theme);
        m_settings.setTheme(theme);
        m_studio =
            std::make_unique<Application>(m_settings, m_home.filePath(QStringLiteral("recovery")));
        m_studio->window().resize(1440, 900);
        m_studio->window().show();
        m_studio->start({});
    }

    Application& studio() { return *m_studio; }
    void trigger(const char* action) {
        m_studio->window().actions().find(QLatin1String(action))->trigger();
    }
    void raise(const char* dock) {
        auto* found = m_studio->window().findChild<QDockWidget*>(QLatin1String(dock));
        found->show();
        found->raise();
    }
    void scene(NoiseScene scene) {
        m_studio->document().change(NoisePanel::tr("Noise view"),
                                    [scene](Project& project) { project.noise.scene = scene; });
    }
    void openSample(const char* name) {
        m_studio->window().files().openSample(QLatin1String(name));
    }
    /// Everything computed and the noise drawn in full.
    bool settle() {
        const auto done = [this] {
            const auto& pipeline = m_studio->pipeline();
            if (!m_studio->runner().isIdle() || !pipeline.texton() || !pipeline.texton()->finished)
                return false;
            for (const PictureView* view : m_studio->window().views().views()) {
                if (view->isVisible() && view->picture() == Picture::Noise &&
                    !view->noiseFrame().complete)
                    return false;
            }
            return true;
        };
        QTest::qWait(50);
        const bool settled = waitFor(done);
        QTest::qWait(150);
        return settled && waitFor(done);
    }
    void take(const char* name, QWidget* widget = nullptr) {
        QWidget& what = widget != nullptr ? *widget : m_studio->window();
        const QString path = m_folder.filePath(QLatin1String(name) + QStringLiteral(".png"));
        if (!what.grab().save(path))
            std::fprintf(stderr, "cannot write %s\n", qPrintable(path));
    }

  private:
    QTemporaryDir m_home;
    QDir m_folder;
    Settings m_settings;
    std::unique_ptr<Application> m_studio;
};

bool takeAll(QApplication& application, const QDir& folder) {
    bool good = true;
    {
        Photographer photographer(application, folder, QStringLiteral("en"), ThemeChoice::Dark);
        Application& studio = photographer.studio();
        good = photographer.settle() && good;
        photographer.take("first-start");

        studio.document().change(TextonPanel::tr("Iterations"), [](Project& p) {
            p.texton.iterations = 20000;
            p.texton.support = {128, 128};
        });
        QTest::qWait(700);
        photographer.take("computing");
        studio.document().undoStack().undo();
        good = photographer.settle() && good;

        photographer.openSample("stone");
        photographer.trigger("view.wipe");
        good = photographer.settle() && good;
        photographer.take("wipe");
        photographer.trigger("view.quad");
        photographer.openSample("wood");
        photographer.scene(NoiseScene::Perspective);
        good = photographer.settle() && good;
        photographer.take("perspective");
        photographer.scene(NoiseScene::Surface);
        photographer.openSample("leather");
        photographer.trigger("view.sideBySide");
        good = photographer.settle() && good;
        photographer.take("mesh");
        photographer.scene(NoiseScene::Plane);
        photographer.trigger("view.quad");
        photographer.raise("spectrumDock");
        good = photographer.settle() && good;
        photographer.take("spectrum");
        photographer.raise("histogramDock");
        good = photographer.settle() && good;
        photographer.take("histogram");
        photographer.trigger("help.keys");
        QTest::qWait(100);
        photographer.take("keys");
    }
    {
        Photographer photographer(application, folder, QStringLiteral("en"), ThemeChoice::Light);
        good = photographer.settle() && good;
        photographer.take("light");
    }
    {
        Photographer photographer(application, folder, QStringLiteral("fr"), ThemeChoice::Dark);
        good = photographer.settle() && good;
        photographer.take("french");
    }
    return good;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc != 2) {
        std::fputs("usage: screenshots FOLDER\n", stderr);
        return 2;
    }
    const QDir folder(QString::fromLocal8Bit(argv[1]));
    if (!folder.mkpath(QStringLiteral("."))) {
        std::fprintf(stderr, "cannot make the folder %s\n", argv[1]);
        return 1;
    }
    if (!takeAll(application, folder)) {
        std::fputs("something did not finish in time\n", stderr);
        return 1;
    }
    return 0;
}
