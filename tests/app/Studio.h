// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/Application.h"
#include "app/MainWindow.h"
#include "app/files/FileController.h"
#include "app/look/Language.h"
#include "app/look/Theme.h"
#include "app/views/ViewArea.h"
#include "app/widgets/ActionRegistry.h"
#include "tests/helpers/Verify.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <functional>

namespace txn::test {

/// Lets the program run until the condition holds; false if it never does.
inline bool waitFor(const std::function<bool()>& condition, int patienceMs = kPatienceMs) {
    QElapsedTimer watch;
    watch.start();
    while (!condition()) {
        if (watch.elapsed() > patienceMs)
            return false;
        QTest::qWait(5);
    }
    return true;
}

/// The whole program, with a home of its own, as a user has it after the start.
class Studio {
  public:
    explicit Studio(const QString& language = QStringLiteral("en"),
                    app::ThemeChoice theme = app::ThemeChoice::Dark,
                    QSize size = {1440, 900})
        : m_settings(m_home.filePath(QStringLiteral("settings.ini"))) {
        app::installLanguage(*qApp, language);
        app::applyTheme(*qApp, theme);
        m_settings.setTheme(theme);
        m_studio = std::make_unique<app::Application>(m_settings,
                                                      m_home.filePath(QStringLiteral("recovery")));
        window().resize(size);
        window().show();
        activate();
    }

    app::Application& operator*() { return *m_studio; }
    app::Application* operator->() { return m_studio.get(); }
    app::MainWindow& window() { return m_studio->window(); }
    app::ProjectDocument& document() { return m_studio->document(); }
    const app::Project& project() { return m_studio->document().project(); }
    app::Settings& settings() { return m_settings; }
    QString path(const QString& name) const { return m_home.filePath(name); }

    /// Keys go to the main window, as after a click on it; without a window manager, closing a
    /// dialog is not enough.
    void activate() {
        window().activateWindow();
        if (!QTest::qWaitForWindowActive(&window()))
            qWarning("the window did not become active");
    }

    /// A control by its name, anywhere in the window and its dialogs.
    template <class T = QWidget>
    T* find(const char* name) {
        return window().template findChild<T*>(QLatin1String(name));
    }
    QWidget* part(const char* row, const char* name) {
        return find(row)->template findChild<QWidget*>(QLatin1String(name));
    }
    void trigger(const char* action) { window().actions().find(QLatin1String(action))->trigger(); }

    /// Opens a picture of the recipe, or a file, and waits for all that follows from it.
    bool openSample(const char* name) {
        window().files().openSample(QLatin1String(name));
        return settle();
    }
    /// A corner of a sample, so that hundreds of changes do not take minutes.
    bool openSmall() {
        static const auto source = app::sampleSource(QStringLiteral("rust"));
        document().change(QStringLiteral("Open"), [](app::Project& project) {
            project.source = *source;
            project.edit.crop = Rect{0, 0, {96, 96}};
            project.texton.support = {16, 16};
            project.texton.iterations = 10;
        });
        document().undoStack().setClean(); // as after opening a photo
        return settle();
    }

    /// The same of a stack: color, normals and data.
    bool openSmallStack() {
        const auto part = [](const char* sample, const char* map, MapKind kind) {
            return app::Source::Part{*app::sampleSource(QLatin1String(sample)),
                                     QLatin1String(map),
                                     kind};
        };
        static const auto source = app::stackSource({part("cloth", "normal", MapKind::Normal),
                                                     part("rust", "color", MapKind::Color),
                                                     part("sand", "extra", MapKind::Data)});
        document().change(QStringLiteral("Open"), [](app::Project& project) {
            project.source = *source;
            project.edit.crop = Rect{0, 0, {96, 96}};
            project.texton.support = {16, 16};
        });
        document().undoStack().setClean();
        return settle();
    }

    bool isSettled() {
        const auto& pipeline = m_studio->pipeline();
        if (!m_studio->runner().isIdle() || pipeline.isStale(app::Picture::Noise) ||
            pipeline.isStale(app::Picture::Gaussian))
            return false;
        if (!pipeline.texton())
            return true;
        for (const app::PictureView* view : window().views().views()) {
            if (view->isVisible() && view->shows(app::Picture::Noise) && !view->isNoiseCurrent())
                return false;
        }
        return pipeline.texton()->finished;
    }
    /// Everything computed, and the noise drawn in full.
    bool settle() {
        QTest::qWait(30); // what was asked for has begun
        // One job may have ended and what follows from it not begun yet.
        constexpr int kCalmLooks = 5;
        int calm = 0;
        return waitFor([&] {
            calm = isSettled() ? calm + 1 : 0;
            return calm == kCalmLooks;
        });
    }

  private:
    QTemporaryDir m_home;
    app::Settings m_settings;
    std::unique_ptr<app::Application> m_studio;
};

} // namespace txn::test
