// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/CommandPalette.h"
#include "app/widgets/KeyMapOverlay.h"
#include "app/widgets/ShortcutEditor.h"
#include "tests/app/Studio.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QHeaderView>
#include <QHelpEvent>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollBar>
#include <QSpinBox>
#include <QTabBar>
#include <QToolTip>
#include <QTreeWidget>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

QString nameOf(const QWidget& widget) {
    QStringList names;
    for (const QWidget* each = &widget; each != nullptr; each = each->parentWidget())
        names.prepend(each->objectName().isEmpty()
                          ? QString::fromLatin1(each->metaObject()->className())
                          : each->objectName());
    return names.join('/');
}

/// What somebody can use, left out what belongs to the inside of Qt's own controls.
QList<QWidget*> controlsOf(QWidget& root) {
    QList<QWidget*> controls;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const bool inner = widget->objectName().startsWith("qt_") ||
                           qobject_cast<QScrollBar*>(widget) != nullptr ||
                           qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) != nullptr ||
                           qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr ||
                           widget->inherits("QComboBoxPrivateContainer") ||
                           widget->inherits("QComboBoxListView") ||
                           qobject_cast<QHeaderView*>(widget) != nullptr ||
                           qobject_cast<QTabBar*>(widget->parentWidget()) != nullptr ||
                           qobject_cast<QAbstractScrollArea*>(widget->parentWidget()) != nullptr ||
                           qobject_cast<QKeySequenceEdit*>(widget->parentWidget()) != nullptr;
        const bool used = qobject_cast<QAbstractButton*>(widget) != nullptr ||
                          qobject_cast<QComboBox*>(widget) != nullptr ||
                          qobject_cast<QLineEdit*>(widget) != nullptr ||
                          qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
                          qobject_cast<QAbstractItemView*>(widget) != nullptr ||
                          qobject_cast<QKeySequenceEdit*>(widget) != nullptr ||
                          widget->focusPolicy() == Qt::StrongFocus;
        // Docks' own buttons and tabs are explained by Qt.
        if (used && !inner && !widget->inherits("QDockWidgetTitleButton") &&
            !widget->inherits("QTabBar") && !widget->inherits("QMenu") &&
            !widget->inherits("QToolBarExtension") && !widget->inherits("QScrollArea"))
            controls.append(widget);
    }
    return controls;
}

template <class Text>
QString fromHereUp(QWidget& widget, Text text) {
    for (QWidget* each = &widget; each != nullptr && !each->isWindow();
         each = each->parentWidget()) {
        if (!(each->*text)().isEmpty())
            return (each->*text)();
    }
    return {};
}

void everyControlIsExplained(QWidget& root) {
    const QList<QWidget*> controls = controlsOf(root);
    QVERIFY(controls.size() > 3);
    for (QWidget* control : controls) {
        const QByteArray name = nameOf(*control).toUtf8();
        // A tip over a picture would be in the way.
        QVERIFY2(!fromHereUp(*control, &QWidget::toolTip).isEmpty() ||
                     qobject_cast<PictureView*>(control) != nullptr,
                 name);
        QVERIFY2(!fromHereUp(*control, &QWidget::whatsThis).isEmpty(), name);
        const auto* button = qobject_cast<QAbstractButton*>(control);
        const bool named = !control->accessibleName().isEmpty() ||
                           (button != nullptr && !button->text().isEmpty());
        QVERIFY2(named || control->focusPolicy() == Qt::NoFocus, name);
    }
}

/// All actions that can be reached from the menu bar.
void collect(const QList<QAction*>& from, QSet<const QAction*>& found) {
    for (const QAction* each : from) {
        found.insert(each);
        if (each->menu() != nullptr)
            collect(each->menu()->actions(), found);
    }
}

} // namespace

class TestControls : public QObject {
    Q_OBJECT

  private slots:
    void everyActionIsInAMenuHasAKeyAndIsFound() {
        Studio studio;
        QSet<const QAction*> inMenus;
        collect(studio.window().menuBar()->actions(), inMenus);
        QSet<QString> keys;
        const auto& entries = studio.window().actions().entries();
        QVERIFY(entries.size() > 40);
        for (const auto& entry : entries) {
            const QByteArray id = entry.id.toUtf8();
            QVERIFY2(inMenus.contains(entry.action), id);
            QVERIFY2(!entry.action->toolTip().isEmpty(), id);
            QVERIFY2(!entry.action->whatsThis().isEmpty(), id);
            const QString key = entry.action->shortcut().toString();
            QVERIFY2(!key.isEmpty(), id);
            QVERIFY2(!keys.contains(key), id);
            keys.insert(key);
            // By its name, in the palette.
            const QString text = entry.text();
            auto* palette = CommandPalette::open(studio.window().actions(), studio.window());
            palette->findChild<QLineEdit*>("paletteSearch")->setText(text);
            auto* list = palette->findChild<QTreeWidget*>("paletteList");
            bool found = false;
            for (int row = 0; row < list->topLevelItemCount(); ++row)
                found =
                    found || list->topLevelItem(row)->data(0, Qt::UserRole).toString() == entry.id;
            QVERIFY2(found, id);
            delete palette;
        }
    }

    void thePaletteRunsWhatWasTyped() {
        Studio studio;
        QVERIFY(studio.openSmall());
        QTest::keyClick(&studio.window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        auto* search = studio.find<QLineEdit>("paletteSearch");
        QVERIFY(search != nullptr);
        QTest::keyClicks(search, "side b");
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(studio.document().view().layout, ViewLayout::SideBySide);
    }

    void everyControlOfTheWindowIsExplained() {
        Studio studio;
        QVERIFY(studio.openSmall());
        everyControlIsExplained(studio.window());
        studio.trigger("file.export");
        everyControlIsExplained(*studio.find<QDialog>("exportDialog"));
        studio.trigger("edit.shortcuts");
        everyControlIsExplained(*studio.find<ShortcutEditor>("shortcutEditor"));
    }

    void nothingIsModalButQuestions() {
        Studio studio;
        QVERIFY(studio.openSmall());
        for (const char* id : {"file.export", "edit.shortcuts", "help.about", "help.keys"}) {
            studio.trigger(id);
            QVERIFY2(QApplication::activeModalWidget() == nullptr, id);
        }
        // Nor does anything that fails open a box.
        studio.window().files().open("/nowhere.png");
        TXN_COMES_TRUE(studio.find<QLabel>("messageText")->text().contains("nowhere.png"));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QTest::mouseClick(studio.find("messageClose"), Qt::LeftButton);
        QVERIFY(!studio.find("messageBar")->isVisible());
    }

    void shortcutsAreChangedAndRemembered() {
        Studio studio;
        studio.trigger("edit.shortcuts");
        auto* list = studio.find<QTreeWidget>("shortcutList");
        for (int row = 0; row < list->topLevelItemCount(); ++row) {
            if (list->topLevelItem(row)->data(0, Qt::UserRole).toString() == "view.fit")
                list->setCurrentItem(list->topLevelItem(row));
        }
        auto* keys = studio.find<QKeySequenceEdit>("shortcutKeys");
        keys->setKeySequence(QKeySequence("Ctrl+S")); // that of saving
        emit keys->editingFinished();
        QCOMPARE(studio.window().actions().find("view.fit")->shortcut(), QKeySequence("Ctrl+S"));
        QVERIFY(studio.window().actions().find("file.save")->shortcut().isEmpty());
        QVERIFY(studio.find<QLabel>("shortcutNote")->text().contains("Save"));
        QCOMPARE(studio.settings().shortcut("view.fit", "F"), "Ctrl+S");
        QTest::mouseClick(studio.find("shortcutReset"), Qt::LeftButton);
        QCOMPARE(studio.window().actions().find("view.fit")->shortcut(), QKeySequence("F"));
        QCOMPARE(studio.window().actions().find("file.save")->shortcut(), QKeySequence("Ctrl+S"));
    }

    /// Around the window by F6 and through a panel by Tab, to every control.
    void theKeyboardIsEnough() {
        Studio studio;
        QVERIFY(studio.openSmall());
        studio.find<QDockWidget>("historyDock")->raise();
        QTest::qWait(10);
        QSet<const QWidget*> parts;
        for (int i = 0; i < 8; ++i) {
            QTest::keyClick(&studio.window(), Qt::Key_F6);
            QVERIFY(QApplication::focusWidget() != nullptr);
            for (const char* part :
                 {"viewArea", "exemplarPanel", "textonPanel", "noisePanel", "historyList"}) {
                QWidget* each = studio.find(part);
                if (each == QApplication::focusWidget() ||
                    each->isAncestorOf(QApplication::focusWidget()))
                    parts.insert(each);
            }
        }
        QCOMPARE(parts.size(), 5);
        // A panel without controls is passed over.
        studio.find<QDockWidget>("spectrumDock")->raise();
        QTest::qWait(10);
        parts.clear();
        for (int i = 0; i < 8; ++i) {
            QTest::keyClick(&studio.window(), Qt::Key_F6);
            parts.insert(QApplication::focusWidget());
        }
        QCOMPARE(parts.size(), 4);
        for (const char* panel : {"exemplarPanel", "textonPanel", "noisePanel"}) {
            QWidget* root = studio.find(panel);
            QSet<const QWidget*> reached;
            QWidget* first = root->findChildren<QWidget*>().first();
            first->setFocus();
            for (int i = 0; i < 200; ++i) {
                QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                                       : &studio.window(),
                                Qt::Key_Backtab,
                                Qt::ShiftModifier);
                reached.insert(QApplication::focusWidget());
            }
            for (QWidget* control : controlsOf(*root)) {
                if (control->isVisible() && control->isEnabled() &&
                    control->focusPolicy() != Qt::NoFocus && control->focusProxy() == nullptr)
                    QVERIFY2(reached.contains(control), nameOf(*control).toUtf8());
            }
        }
    }

    void arrowsLookAround() {
        Studio studio;
        QVERIFY(studio.openSmall());
        studio.document().change("View",
                                 [](Project& p) { p.noise.scene = NoiseScene::Perspective; });
        PictureView* view = studio.window().views().views()[3];
        view->setFocus();
        const double yaw = studio.document().view().yaw;
        QTest::keyClick(view, Qt::Key_Left);
        QVERIFY(studio.document().view().yaw != yaw);
        const double zoom = studio.document().view().zoom;
        studio.trigger("view.zoomIn");
        QVERIFY(studio.document().view().zoom > zoom);
        studio.trigger("view.wipe");
        const double wipe = studio.document().view().wipe;
        QTest::keyClick(studio.window().views().views()[0], Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(studio.document().view().wipe > wipe);
    }

    void smallStepsOfSlidersArrive() {
        Studio studio;
        QVERIFY(studio.openSmall());
        for (const char* name :
             {"noiseContrast", "noiseBrightness", "noiseScale", "noiseImpacts"}) {
            QWidget* track = studio.part(name, "track");
            const Project before = studio.project();
            QTest::keyClick(track, Qt::Key_Right, Qt::ShiftModifier);
            QVERIFY2(studio.project() != before, name);
        }
    }

    void jobsAreStoppedOneByOne() {
        Studio studio;
        QVERIFY(studio.openSmall());
        const auto before = studio->pipeline().texton();
        studio.document().change("Iterations", [](Project& p) {
            p.texton.method = TextonMethod::Projections;
            p.texton.iterations = 100000;
        });
        TXN_COMES_TRUE(studio->pipeline().texton() != before);
        TXN_COMES_TRUE(
            studio.find<QTreeWidget>("jobsList")->findChild<QAbstractButton*>("jobStop"));
        studio.find<QTreeWidget>("jobsList")->findChild<QAbstractButton*>("jobStop")->click();
        QCOMPARE(studio->pipeline().texton(), before);
        TXN_COMES_TRUE(studio->runner().isIdle());
    }

    void whatIsThisAnswers() {
        Studio studio;
        QVERIFY(studio.openSmall());
        QWidget* track = studio.part("textonSupport", "track");
        QHelpEvent query(QEvent::QueryWhatsThis, {3, 3}, track->mapToGlobal(QPoint(3, 3)));
        QVERIFY(QApplication::sendEvent(track, &query) && query.isAccepted());
    }
};

QTEST_MAIN(TestControls)
#include "TestControls.moc"
