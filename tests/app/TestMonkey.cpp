// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/SliderTrack.h"
#include "core/export/Exporter.h"
#include "core/image/ImageIo.h"
#include "core/samples/Samples.h"
#include "tests/app/Studio.h"
#include "tests/helpers/Textons.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialog>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QMutex>
#include <QPointer>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>

#include <array>
#include <random>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

int environment(const char* name, int standard) {
    bool given = false;
    const int value = qEnvironmentVariableIntValue(name, &given);
    return given ? value : standard;
}

/// How long the window may take to answer, in milliseconds.
constexpr qint64 kPatientFor = 1000;

/// Warnings of Qt and of the program; what is said from any thread is kept.
class Warnings {
  public:
    Warnings() { s_previous = qInstallMessageHandler(&Warnings::take); }
    ~Warnings() { qInstallMessageHandler(s_previous); }
    Warnings(const Warnings&) = delete;
    Warnings& operator=(const Warnings&) = delete;

    static QStringList taken() {
        const QMutexLocker lock(&s_mutex);
        return std::exchange(s_texts, {});
    }

  private:
    static void take(QtMsgType type, const QMessageLogContext& context, const QString& text) {
        if (type == QtDebugMsg || type == QtInfoMsg) {
            s_previous(type, context, text);
            return;
        }
        // The X server under test has no window manager.
        if (text.contains(QLatin1String("did not become active")))
            return;
        const QMutexLocker lock(&s_mutex);
        s_texts.append(text);
    }

    static inline QtMessageHandler s_previous = nullptr;
    static inline QMutex s_mutex;
    static inline QStringList s_texts;
};

/// Would otherwise start other programs.
class NoBrowser : public QObject {
    Q_OBJECT

  public:
    NoBrowser() {
        for (const char* scheme : {"file", "http", "https", "mailto"})
            QDesktopServices::setUrlHandler(QLatin1String(scheme), this, "open");
    }
    ~NoBrowser() override {
        for (const char* scheme : {"file", "http", "https", "mailto"})
            QDesktopServices::unsetUrlHandler(QLatin1String(scheme));
    }

  public slots:
    void open(const QUrl&) {}
};

/// Does to the window whatever comes to its mind; equal seeds give equal wishes.
class Monkey {
  public:
    Monkey(Studio& studio, unsigned seed) : m_studio(studio), m_random(seed) {
        // The menu of a tool button keeps the click that opened it until it closes.
        constexpr int kLongMs = 500;
        QObject::connect(&m_menus, &QTimer::timeout, [this] {
            QWidget* open = QApplication::activePopupWidget();
            if (open != nullptr && open == m_openMenu)
                open->close();
            m_openMenu = QApplication::activePopupWidget();
        });
        m_menus.start(kLongMs);
    }

    /// What files it may drop.
    void give(const QStringList& files) { m_files = files; }

    /// One action; what it was.
    QString act() {
        closeFileDialogs();
        const int wish = pick(0, 99);
        if (wish < 22)
            return trigger();
        if (wish < 42)
            return click();
        if (wish < 54)
            return dragSlider();
        if (wish < 66)
            return dragAnywhere();
        if (wish < 76)
            return press();
        if (wish < 84)
            return turnWheel();
        if (wish < 90)
            return choose();
        if (wish < 93)
            return drop();
        if (wish < 96)
            return resize();
        return undoOrRedo();
    }

    /// Whatever is open beside the window goes, as by its own close button.
    void closeOthers() {
        for (int i = 0; i < 20 && QApplication::activePopupWidget() != nullptr; ++i)
            QApplication::activePopupWidget()->close();
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget != &m_studio.window() && widget->isVisible() && widget->isWindow())
                widget->close();
        }
    }

  private:
    int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }
    template <class T>
    T* oneOf(const QList<T*>& list) {
        return list.isEmpty() ? nullptr : list[pick(0, static_cast<int>(list.size()) - 1)];
    }
    static QString described(const char* what, const QWidget* widget) {
        return QStringLiteral("%1 %2 '%3'")
            .arg(QLatin1String(what),
                 QLatin1String(widget->metaObject()->className()),
                 widget->objectName());
    }
    /// Where a user could put the mouse: a dialog takes all of it.
    QWidget* surface() const {
        if (QWidget* popup = QApplication::activePopupWidget())
            return popup;
        if (QWidget* modal = QApplication::activeModalWidget())
            return modal;
        QList<QWidget*> dialogs;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (qobject_cast<QDialog*>(widget) != nullptr && widget->isVisible())
                return widget;
        }
        return &m_studio.window();
    }
    template <class T>
    QList<T*> reachable() const {
        QList<T*> list;
        for (T* widget : surface()->findChildren<T*>()) {
            if (widget->isVisible() && widget->isEnabled() && widget->width() > 2 &&
                widget->height() > 2)
                list.append(widget);
        }
        return list;
    }
    QPoint placeIn(const QWidget* widget) {
        return {pick(0, widget->width() - 1), pick(0, widget->height() - 1)};
    }
    Qt::KeyboardModifiers modifiers() {
        return std::array<Qt::KeyboardModifiers, 6>{
            Qt::NoModifier,
            Qt::NoModifier,
            Qt::NoModifier,
            Qt::ShiftModifier,
            Qt::ControlModifier,
            Qt::AltModifier}[static_cast<std::size_t>(pick(0, 5))];
    }

    /// They show the machine's own files, which are nobody's toys.
    void closeFileDialogs() {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (qobject_cast<QFileDialog*>(widget) != nullptr && widget->isVisible())
                widget->close();
        }
    }

    QString trigger() {
        QList<QAction*> actions;
        for (const auto& entry : m_studio.window().actions().entries()) {
            if (entry.id != QLatin1String("file.quit") && entry.action->isEnabled())
                actions.append(entry.action);
        }
        // A dialog that takes all input keeps the menus from being used.
        QAction* action = oneOf(actions);
        if (action == nullptr || QApplication::activeModalWidget() != nullptr)
            return click();
        const QString name = QStringLiteral("action '%1'").arg(action->text());
        action->trigger();
        return name;
    }
    QString click() {
        QWidget* widget = pick(0, 2) > 0
                              ? static_cast<QWidget*>(oneOf(reachable<QAbstractButton>()))
                              : oneOf(reachable<QWidget>());
        if (widget == nullptr)
            return QStringLiteral("nothing to click");
        const QString name = described("click on", widget);
        const auto button = pick(0, 5) == 0 ? Qt::RightButton : Qt::LeftButton;
        const QPoint place = pick(0, 1) == 0 ? widget->rect().center() : placeIn(widget);
        if (pick(0, 7) == 0)
            QTest::mouseDClick(widget, button, modifiers(), place);
        else
            QTest::mouseClick(widget, button, modifiers(), place);
        return name;
    }
    QString drag(QWidget* widget) {
        if (widget == nullptr)
            return QStringLiteral("nothing to drag");
        const QString name = described("drag in", widget);
        const QPointer<QWidget> guard(widget);
        const auto button = pick(0, 4) == 0 ? Qt::MiddleButton : Qt::LeftButton;
        const auto keys = modifiers();
        QTest::mousePress(widget, button, keys, placeIn(widget));
        const int moves = pick(1, 8);
        for (int i = 0; i < moves && guard; ++i) {
            const QPointF place = placeIn(widget);
            QMouseEvent move(QEvent::MouseMove,
                             place,
                             widget->mapToGlobal(place),
                             Qt::NoButton,
                             button,
                             keys);
            QApplication::sendEvent(widget, &move);
            QTest::qWait(3);
        }
        if (guard)
            QTest::mouseRelease(widget, button, keys, placeIn(widget));
        return name;
    }
    QString dragSlider() { return drag(oneOf(reachable<SliderTrack>())); }
    QString dragAnywhere() {
        return pick(0, 3) > 0 ? drag(oneOf(reachable<PictureView>()))
                              : drag(oneOf(reachable<QWidget>()));
    }
    QString press() {
        QWidget* widget = QApplication::focusWidget();
        if (widget == nullptr)
            widget = surface();
        static constexpr std::array kKeys{
            Qt::Key_Escape, Qt::Key_Tab,    Qt::Key_Backtab,    Qt::Key_Space, Qt::Key_Left,
            Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down,       Qt::Key_Home,  Qt::Key_End,
            Qt::Key_PageUp, Qt::Key_Delete, Qt::Key_Return,     Qt::Key_0,     Qt::Key_1,
            Qt::Key_9,      Qt::Key_Minus,  Qt::Key_Period,     Qt::Key_A,     Qt::Key_B,
            Qt::Key_F,      Qt::Key_M,      Qt::Key_X,          Qt::Key_F1,    Qt::Key_F11,
            Qt::Key_Comma,  Qt::Key_Plus,   Qt::Key_BracketLeft};
        const auto key = kKeys[static_cast<std::size_t>(pick(0, kKeys.size() - 1))];
        const QString name = described("key in", widget) + QStringLiteral(" %1").arg(key, 0, 16);
        QTest::keyClick(widget, key, pick(0, 3) == 0 ? modifiers() : Qt::NoModifier);
        return name;
    }
    QString turnWheel() {
        QWidget* widget = pick(0, 1) == 0 ? static_cast<QWidget*>(oneOf(reachable<PictureView>()))
                                          : oneOf(reachable<QWidget>());
        if (widget == nullptr)
            return QStringLiteral("nothing to turn a wheel over");
        const QString name = described("wheel over", widget);
        const QPointF place = placeIn(widget);
        QWheelEvent event(place,
                          widget->mapToGlobal(place),
                          {},
                          {0, 120 * pick(-5, 5)},
                          Qt::NoButton,
                          modifiers(),
                          Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(widget, &event);
        return name;
    }
    QString choose() {
        if (pick(0, 1) == 0) {
            if (auto* spin = oneOf(reachable<QAbstractSpinBox>())) {
                spin->stepBy(pick(-3, 3));
                return described("spin", spin);
            }
        }
        auto* combo = oneOf(reachable<QComboBox>());
        if (combo == nullptr || combo->count() == 0)
            return QStringLiteral("nothing to choose");
        const QString name = described("choice in", combo);
        const int index = pick(0, combo->count() - 1);
        // A file dialog opens behind some: that is closed before the next action.
        combo->setCurrentIndex(index);
        emit combo->activated(index);
        return name;
    }
    QString drop() {
        QMimeData data;
        QList<QUrl> urls;
        for (int i = pick(0, 5) == 0 ? 2 : 1; i > 0; --i)
            urls.append(
                QUrl::fromLocalFile(m_files[pick(0, static_cast<int>(m_files.size()) - 1)]));
        data.setUrls(urls);
        QWidget* target = QApplication::activeModalWidget();
        if (target != nullptr)
            return QStringLiteral("no drop into a dialog");
        target = &m_studio.window();
        const QPointF place = placeIn(target);
        QDragEnterEvent enter(place.toPoint(),
                              Qt::CopyAction,
                              &data,
                              Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(target, &enter);
        QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(target, &event);
        return QStringLiteral("drop of %1").arg(urls.front().fileName());
    }
    QString resize() {
        m_studio.window().resize(pick(500, 1600), pick(400, 1000));
        return QStringLiteral("resize");
    }
    QString undoOrRedo() {
        auto& stack = m_studio.document().undoStack();
        for (int i = pick(1, 5); i > 0; --i)
            pick(0, 2) > 0 ? stack.undo() : stack.redo();
        return QStringLiteral("undo or redo");
    }

    Studio& m_studio;
    std::mt19937 m_random;
    QStringList m_files;
    QTimer m_menus;
    QPointer<QWidget> m_openMenu;
};

} // namespace

/// Someone who does anything at all: TXN_MONKEY actions (100 by default) from the seed
/// TXN_MONKEY_SEED (1 by default).
class TestMonkey : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString picture(const char* sample, Size size) {
        const QString path = m_folder.filePath(QLatin1String(sample) + QStringLiteral(".png"));
        const auto image = makeSample(sample, size, Seed{3});
        return image && saveImage(*image, path.toStdString(), {}) ? path : QString();
    }

  private slots:
    void whateverIsDoneTheWindowAnswersAndUndoIsWhole() {
        const int actions = environment("TXN_MONKEY", 100);
        const int seed = environment("TXN_MONKEY_SEED", 1);
        qputenv("HOME", m_folder.path().toUtf8());
        const NoBrowser noBrowser;
        const Warnings warnings;
        Studio studio;
        studio.settings().setFolder(QStringLiteral("export"), m_folder.path());
        studio.settings().setFolder(QStringLiteral("open"), m_folder.path());
        QVERIFY(studio.openSmall());

        QStringList files{picture("rust", {64, 48}), picture("sand", {50, 70})};
        TextonAsset asset;
        asset.texton = makeTexton({.size = {9, 7}});
        const std::filesystem::path texton = m_folder.filePath("dropped.texton").toStdString();
        QVERIFY(saveTexton(asset, std::array{texton}));
        files << QString::fromStdString(texton.string());
        const QString project = m_folder.filePath("dropped.txnproj");
        QVERIFY(saveProject(studio.project(), {}, project));
        files << project << m_folder.filePath("missing.png");

        Monkey monkey(studio, static_cast<unsigned>(seed));
        monkey.give(files);
        std::mt19937 mood(static_cast<unsigned>(seed) + 1U);
        qint64 slowest = 0;
        for (int i = 0; i < actions; ++i) {
            QElapsedTimer clock;
            clock.start();
            const QString what = monkey.act();
            // Everything that it set off at once, and a turn of the event loop after that.
            QApplication::processEvents();
            QApplication::processEvents();
            const qint64 took = clock.elapsed();
            slowest = std::max(slowest, took);
            const QByteArray where = QStringLiteral("seed %1, action %2: %3, %4 ms")
                                         .arg(seed)
                                         .arg(i)
                                         .arg(what)
                                         .arg(took)
                                         .toUtf8();
            if (qEnvironmentVariableIsSet("TXN_MONKEY_TELL"))
                std::fprintf(stderr, "%s\n", where.constData());
            const QStringList said = Warnings::taken();
            QVERIFY2(said.isEmpty(),
                     (where + ": " + said.join(QStringLiteral("; ")).toUtf8()).constData());
#ifndef TXN_SANITIZED
            QVERIFY2(took <= kPatientFor, where.constData());
#endif
            QTest::qWait(static_cast<int>(mood() % 15));
            if (mood() % 5 == 0)
                monkey.closeOthers();
            if (!studio.window().isVisible())
                studio.window().show();
        }
        monkey.closeOthers();
        // Not that all of it succeeded: what is left may be a picture too small for its texton.
        const auto idle = [&] { return studio->runner().isIdle(); };
        QVERIFY(waitFor(idle));
        qInfo("%d actions, the slowest answer took %lld ms, %d steps to undo",
              actions,
              static_cast<long long>(slowest),
              studio.document().undoStack().index());

        auto& stack = studio.document().undoStack();
        stack.setIndex(stack.count());
        const Project before = studio.project();
        const int steps = stack.index();
        stack.setIndex(0);
        stack.setIndex(steps);
        QVERIFY(studio.project() == before);
        QVERIFY(waitFor(idle));
        QCOMPARE(Warnings::taken(), QStringList());
    }
};

QTEST_MAIN(TestMonkey)
#include "TestMonkey.moc"
