// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectDocument.h"

#include <QSignalSpy>
#include <QtTest>

#include <random>

using namespace txn;
using namespace txn::app;

namespace {

void setIterations(ProjectDocument& document, int value, Gesture gesture = {}) {
    document.change(
        "Iterations",
        [&](Project& p) { p.texton.iterations = value; },
        gesture);
}

} // namespace

class TestDocument : public QObject {
    Q_OBJECT

  private slots:
    void aChangeCanBeUndoneAndRedone() {
        ProjectDocument document;
        QSignalSpy changed(&document, &ProjectDocument::projectChanged);
        const Project before = document.project();
        setIterations(document, 70);
        QCOMPARE(document.project().texton.iterations, 70);
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(document.project() == before);
        QVERIFY(!document.isModified());
        document.undoStack().redo();
        QCOMPARE(document.project().texton.iterations, 70);
        QCOMPARE(changed.count(), 3);
    }

    void whatChangesNothingIsNoStep() {
        ProjectDocument document;
        setIterations(document, document.project().texton.iterations);
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
    }

    void aDragIsOneStep() {
        ProjectDocument document;
        const Gesture drag = Gesture::next();
        for (int i = 60; i < 90; ++i)
            setIterations(document, i, drag);
        QCOMPARE(document.undoStack().count(), 1);
        const Gesture next = Gesture::next();
        for (int i = 90; i < 99; ++i)
            setIterations(document, i, next);
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QCOMPARE(document.project().texton.iterations, 89);
        document.undoStack().undo();
        QCOMPARE(document.project().texton.iterations, 50);
    }

    void aDragBackToItsStartLeavesNoStep() {
        ProjectDocument document;
        const Gesture drag = Gesture::next();
        setIterations(document, 60, drag);
        setIterations(document, 50, drag);
        QCOMPARE(document.undoStack().count(), 0);
    }

    void changesWithoutAGestureStayApart() {
        ProjectDocument document;
        setIterations(document, 60);
        setIterations(document, 70);
        QCOMPARE(document.undoStack().count(), 2);
    }

    void anotherProjectStartsAfresh() {
        ProjectDocument document;
        setIterations(document, 60);
        Project other;
        other.noise.meanImpacts = 5.0;
        document.reset(other, {}, "/somewhere/stone.txnproj");
        QVERIFY(document.project() == other);
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
        QCOMPARE(document.title(), "stone.txnproj");
    }

    void savingIsTheCleanState() {
        ProjectDocument document;
        setIterations(document, 60);
        document.setSaved("/somewhere/a.txnproj");
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        QVERIFY(document.isModified());
        document.undoStack().redo();
        QVERIFY(!document.isModified());
        document.markRecovered();
        QVERIFY(document.isModified());
    }

    void theViewIsNotUndone() {
        ProjectDocument document;
        QSignalSpy changed(&document, &ProjectDocument::viewChanged);
        document.changeView([](ViewState& view) { view.zoom = 3.0; });
        document.changeView([](ViewState&) {});
        QCOMPARE(changed.count(), 1);
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
    }

    void threeHundredRandomChangesCanBeUndone() {
        ProjectDocument document;
        document.change("Start", [](Project& p) {
            LoadedImage loaded;
            loaded.image = Image({8, 8}, 3);
            p.source = std::make_shared<const Source>(Source::File{"stone.png", {}, {}, {}, {}},
                                                      std::move(loaded));
        });
        std::mt19937 random(7);
        const auto pick = [&](int n) {
            return static_cast<int>(random() % static_cast<unsigned>(n));
        };
        std::vector<Project> states{document.project()};
        const int first = document.undoStack().count();
        for (int i = 0; i < 300; ++i) {
            const Gesture gesture = pick(3) == 0 ? Gesture::next() : Gesture{};
            document.change(
                "Change",
                [&](Project& p) {
                    switch (pick(8)) {
                    case 0:
                        p.edit.crop = Rect{pick(4), pick(4), {1 + pick(4), 1 + pick(4)}};
                        break;
                    case 1:
                        p.edit.straightenDegrees = pick(90);
                        break;
                    case 2:
                        p.edit.flattenRadiusPx = 1.0 + pick(50);
                        break;
                    case 3:
                        p.texton.support = {8 + pick(100), 8 + pick(100)};
                        break;
                    case 4:
                        p.texton.seed = Seed{static_cast<std::uint32_t>(random())};
                        break;
                    case 5:
                        p.noise.meanImpacts = 1.0 + pick(60);
                        break;
                    case 6:
                        p.noise.scene = static_cast<NoiseScene>(pick(4));
                        break;
                    default:
                        p.source.reset();
                        break;
                    }
                },
                gesture);
            if (document.undoStack().index() - first + 1 > static_cast<int>(states.size()))
                states.push_back(document.project());
            if (pick(5) == 0 && document.undoStack().index() > first) {
                document.undoStack().undo();
                states.resize(static_cast<std::size_t>(document.undoStack().index() - first + 1));
                QVERIFY(document.project() == states.back());
            }
        }
        while (document.undoStack().index() > first) {
            QVERIFY(document.project() ==
                    states[static_cast<std::size_t>(document.undoStack().index() - first)]);
            document.undoStack().undo();
        }
        QVERIFY(document.project() == states.front());
    }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "TestDocument.moc"
