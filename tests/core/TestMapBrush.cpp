// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/MapBrush.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <limits>

using namespace txn;
using namespace txn::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto kModes = {BrushMode::Paint, BrushMode::Smooth, BrushMode::Erase};

struct Touch {
    double x = 0.0;
    double y = 0.0;
    double pressure = 1.0;
};
using Path = std::vector<Touch>;

struct Way {
    Symmetry symmetry;
    bool repeats = false;
};

Brush brushOf(double radius, double hardness = 0.5, double strength = 1.0) {
    Brush brush;
    brush.radius = radius;
    brush.hardness = hardness;
    brush.strength = strength;
    return brush;
}

Brush withMode(Brush brush, BrushMode mode) {
    brush.mode = mode;
    return brush;
}

/// The map after a stroke.
Image painted(const Image& before, const Brush& brush, const Path& path, Way way = {}) {
    Image map = before;
    BrushStroke stroke(before, brush, way.symmetry, way.repeats);
    for (const Touch& touch : path)
        stroke.moveTo(touch.x, touch.y, touch.pressure, map);
    return map;
}

Image roughMap(Size size, std::uint64_t seed) {
    TestRandom random(seed);
    Image rho(size, 1);
    for (float& v : rho.samples())
        v = static_cast<float>(std::clamp(random.uniform(-0.2, 1.2), 0.0, 1.0));
    return rho;
}

/// Touches all over the map and a little beyond.
Path scribble(Size size, int touches, std::uint64_t seed) {
    TestRandom random(seed);
    Path path;
    for (int i = 0; i < touches; ++i)
        path.push_back({random.uniform(-0.2, 1.2) * size.width,
                        random.uniform(-0.2, 1.2) * size.height,
                        random.uniform(0.3, 1.0)});
    return path;
}

/// The same way with so many touches on every segment.
Path finer(const Path& path, int steps) {
    Path fine{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Touch& a = path[i - 1];
        const Touch& b = path[i];
        for (int step = 1; step <= steps; ++step) {
            const double t = static_cast<double>(step) / steps;
            fine.push_back({std::lerp(a.x, b.x, t),
                            std::lerp(a.y, b.y, t),
                            std::lerp(a.pressure, b.pressure, t)});
        }
    }
    return fine;
}

Image mirroredX(const Image& map) {
    Image out = map;
    for (int y = 0; y < map.height(); ++y)
        std::ranges::reverse(out.row(0, y));
    return out;
}

Image mirroredY(const Image& map) {
    Image out = map;
    for (int y = 0; y < map.height(); ++y)
        std::ranges::copy(map.row(0, map.height() - 1 - y), out.row(0, y).begin());
    return out;
}

Image shifted(const Image& map, int right, int down) {
    Image out = map;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x)
            out.at((x + right) % map.width(), (y + down) % map.height(), 0) = map.at(x, y, 0);
    }
    return out;
}

bool isMap(const Image& map) {
    return std::ranges::all_of(map.samples(), [](float v) { return v >= 0.0F && v <= 1.0F; });
}

/// a <= b everywhere but for rounding.
bool isBelow(const Image& a, const Image& b) {
    return std::ranges::equal(a.samples(), b.samples(), [](float low, float high) {
        return low <= high + 1e-6F;
    });
}

bool contains(const std::vector<Rect>& rects, int x, int y) {
    return std::ranges::any_of(rects, [&](const Rect& r) {
        return x >= r.x && y >= r.y && x < r.x + r.size.width && y < r.y + r.size.height;
    });
}

/// How many texels of every value there are, in the order of the first row.
std::vector<int> widthsAlong(std::span<const float> row) {
    std::vector<int> widths;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i == 0 || row[i] != row[i - 1])
            widths.push_back(0);
        ++widths.back();
    }
    return widths;
}

} // namespace

class TestMapBrush : public QObject {
    Q_OBJECT

  private slots:
    void aDabOfFullHardnessIsADisc() {
        for (const double radius : {1.0, 2.5, 10.0, 40.0}) {
            const Touch at{50.3, 47.8};
            const Image map = painted(Image({100, 100}, 1), brushOf(radius, 1.0), {at});
            for (int y = 0; y < 100; ++y) {
                for (int x = 0; x < 100; ++x) {
                    const double distance = std::hypot(x + 0.5 - at.x, y + 0.5 - at.y);
                    if (distance < radius - 1.0 - 0.01)
                        QCOMPARE(map.at(x, y, 0), 1.0F);
                    if (distance > radius + 0.01)
                        QCOMPARE(map.at(x, y, 0), 0.0F);
                }
            }
        }
    }

    void aSoftDabFallsAsItShould() {
        const Image map = painted(Image({101, 101}, 1), brushOf(40.0, 0.25, 0.8), {{50.5, 50.5}});
        for (int x = 50; x < 101; ++x) {
            const double t = std::clamp((40.0 - (x - 50)) / 30.0, 0.0, 1.0);
            TXN_AT_MOST(
                std::abs(static_cast<double>(map.at(x, 50, 0)) - 0.8 * t * t * (3.0 - 2.0 * t)),
                1e-6);
            QCOMPARE(map.at(50, x, 0), map.at(x, 50, 0));
        }
    }

    void aStrokeNeverGoesBeyondItsStrength() {
        const Image before = roughMap({120, 90}, 1);
        for (const float target : {0.0F, 0.4F, 1.0F}) {
            Brush brush = brushOf(15.0, 0.6, 0.3);
            brush.target = target;
            Path path = scribble(before.size(), 60, 2);
            for (Touch& touch : path)
                touch.pressure = 1.0;
            const Image map = painted(before, brush, path);
            int full = 0;
            for (std::size_t i = 0; i < map.samples().size(); ++i) {
                const auto from = static_cast<double>(before.samples()[i]);
                const auto way = static_cast<double>(target) - from;
                const double gone = static_cast<double>(map.samples()[i]) - from;
                TXN_AT_MOST(std::abs(gone), 0.3 * std::abs(way) + 1e-6);
                full += std::abs(gone - 0.3 * way) < 1e-6 ? 1 : 0;
            }
            QVERIFY(full > 90 * 120 / 2); // and it goes that far where it has been
        }
    }

    void thereAndBackIsAsGoodAsThere() {
        const Path there{{20, 30}, {130, 70}};
        const Path back{{20, 30}, {130, 70}, {20, 30}, {130, 70}};
        const Image before = roughMap({150, 100}, 3);
        const Image once = painted(before, brushOf(20.0, 0.0, 0.7), there);
        const Image often = painted(before, brushOf(20.0, 0.0, 0.7), back);
        // Dabs of the way back lie between those of the way there, and up to one of them beyond: a
        // sixteenth of the radius, where the edge falls by 1.5 per radius.
        TXN_AT_MOST(largestDifference(once.samples(), often.samples()), 0.7 * 1.5 / 16.0);
    }

    void howOftenTheMouseReportsDoesNotMatter() {
        const Image before = roughMap({300, 200}, 4);
        for (const BrushMode mode : kModes) {
            for (const double radius : {1.5, 12.0, 70.0}) {
                const Brush brush = withMode(brushOf(radius, 0.5, 0.9), mode);
                const Path path = scribble(before.size(), 12, 5);
                const Image coarse = painted(before, brush, path);
                for (const int steps : {2, 17, 400}) {
                    const Image fine = painted(before, brush, finer(path, steps));
                    // Places of dabs may differ by 1 / 256 texel where they are rounded.
                    TXN_AT_MOST(largestDifference(coarse.samples(), fine.samples()),
                                std::min(1.0, 0.02 / radius) + 1e-5);
                }
            }
        }
    }

    void wayThatIsAWholeNumberOfDabsHasAllOfThem() {
        const Image blank({100, 100}, 1);
        for (int dabs = 30; dabs < 60; ++dabs) {
            const Brush brush = brushOf(17.6);
            const Path path{{10.0, 50.0}, {10.0 + 1.1 * dabs, 50.0}};
            const Image coarse = painted(blank, brush, path);
            for (const int steps : {3, 7, 13, 499})
                TXN_AT_MOST(largestDifference(coarse.samples(),
                                              painted(blank, brush, finer(path, steps)).samples()),
                            2e-3);
        }
    }

    void strokesAreEven() {
        const Image blank({600, 260}, 1);
        for (const double radius : {2.0, 10.0, 60.0, 100.0}) {
            const Path path{{110.0, 130.5}, {490.0, 130.5}};
            // Hard: the same width everywhere, to two tenths of a texel.
            const Image hard = painted(blank, brushOf(radius, 1.0), path);
            const Image soft = painted(blank, brushOf(radius, 0.0), path);
            double least = kInfinity;
            double most = 0.0;
            for (int x = 150; x < 450; ++x) {
                double width = 0.0;
                for (int y = 0; y < 260; ++y)
                    width += static_cast<double>(hard.at(x, y, 0));
                least = std::min(least, width);
                most = std::max(most, width);
                // Soft: full along the middle.
                TXN_AT_MOST(1.0 - static_cast<double>(soft.at(x, 130, 0)), 0.015);
            }
            TXN_AT_MOST(most - least, 0.3);
            TXN_AT_MOST(std::abs(most - (2.0 * radius - 1.0)), 0.3);
        }
    }

    void mirroredStrokesAreMirrored() {
        for (const Size size : {Size{160, 121}, {95, 64}}) {
            const Path path = scribble(size, 25, 6);
            for (const BrushMode mode : kModes) {
                for (const bool repeats : {false, true}) {
                    const Brush brush = withMode(brushOf(13.7, 0.4, 0.8), mode);
                    for (const auto& [x, y] :
                         {std::pair{true, false}, {false, true}, {true, true}}) {
                        Image before = roughMap(size, 7);
                        for (int i = 0; i < size.height; ++i) {
                            for (int j = 0; j < size.width; ++j)
                                before.at(j, i, 0) =
                                    before.at(x ? std::min(j, size.width - 1 - j) : j,
                                              y ? std::min(i, size.height - 1 - i) : i,
                                              0);
                        }
                        const Image map = painted(before, brush, path, {{x, y}, repeats});
                        QVERIFY(map != before);
                        QCOMPARE(map == mirroredX(map), x);
                        QCOMPARE(map == mirroredY(map), y);
                    }
                }
            }
        }
        // Copies are those of the stroke itself.
        const Path path{{20.25, 30.5}, {50.0, 10.0}};
        const Brush brush = brushOf(9.0);
        const Image blank({100, 80}, 1);
        const Image one = painted(blank, brush, path);
        const Image left = mirroredX(one);
        const Image four = painted(blank, brush, path, {{true, true}, false});
        for (std::size_t i = 0; i < four.samples().size(); ++i)
            QCOMPARE(four.samples()[i],
                     std::max({one.samples()[i],
                               left.samples()[i],
                               mirroredY(one).samples()[i],
                               mirroredY(left).samples()[i]}));
    }

    void repeatingMapsHaveNoBorder() {
        const Image before = roughMap({90, 70}, 8);
        for (const BrushMode mode : kModes) {
            for (const double radius : {2.0, 14.0, 33.0, 60.0, 500.0}) {
                const Brush brush = withMode(brushOf(radius, 0.3, 0.9), mode);
                Path path = scribble(before.size(), 5, 9);
                const Image map = painted(before, brush, path, {{}, true});
                const auto moved = [&](double right, double down) {
                    Path there = path;
                    for (Touch& touch : there) {
                        touch.x += right;
                        touch.y += down;
                    }
                    return there;
                };
                for (const auto& [right, down] : {std::pair{1, 0}, {37, 69}, {89, 11}})
                    QVERIFY(painted(shifted(before, right, down),
                                    brush,
                                    moved(right, down),
                                    {{}, true}) == shifted(map, right, down));
                QVERIFY(painted(before, brush, moved(-90.0 * 5, 70.0 * 1000), {{}, true}) == map);
            }
        }
        // One that does not repeat keeps to its side.
        const Image blank({90, 70}, 1);
        const Image clamped = painted(blank, brushOf(10.0), {{0.0, 35.0}});
        QCOMPARE(clamped.at(89, 35, 0), 0.0F);
        QCOMPARE(painted(blank, brushOf(10.0), {{0.0, 35.0}}, {{}, true}).at(89, 35, 0), 1.0F);
    }

    void nothingChangesOutsideTheDirtyRectangles() {
        TestRandom random(10);
        int changes = 0;
        for (int run = 0; run < 120; ++run) {
            const Size size{1 + random.below(90), 1 + random.below(90)};
            const Image before = roughMap(size, 11);
            const bool repeats = random.below(2) == 1;
            const Brush brush = withMode(brushOf(random.uniform(0.0, 30.0), random.uniform()),
                                         *(kModes.begin() + random.below(3)));
            BrushStroke stroke(before,
                               brush,
                               {random.below(2) == 1, random.below(2) == 1},
                               repeats);
            Image map = before;
            for (const Touch& touch : scribble(size, 4, static_cast<std::uint64_t>(run))) {
                const Image last = map;
                const auto dirty = stroke.moveTo(3.0 * touch.x - size.width,
                                                 3.0 * touch.y - size.height,
                                                 touch.pressure,
                                                 map);
                for (const Rect& r : dirty)
                    QVERIFY(r.x >= 0 && r.y >= 0 && r.size.width > 0 && r.size.height > 0 &&
                            r.x + r.size.width <= size.width && r.y + r.size.height <= size.height);
                for (int y = 0; y < size.height; ++y) {
                    for (int x = 0; x < size.width; ++x) {
                        if (map.at(x, y, 0) == last.at(x, y, 0))
                            continue;
                        ++changes;
                        QVERIFY(contains(dirty, x, y));
                    }
                }
            }
        }
        QVERIFY(changes > 10000);
    }

    void dirtyRectanglesAreTight() {
        const Image before({200, 200}, 1);
        Image map = before;
        BrushStroke stroke(before, brushOf(10.0), {}, false);
        QCOMPARE(stroke.moveTo(100.0, 50.0, 1.0, map), (std::vector<Rect>{{90, 40, {20, 20}}}));
        const auto line = stroke.moveTo(120.0, 50.0, 1.0, map);
        QCOMPARE(line.size(), std::size_t{1});
        QVERIFY(line[0].y == 40 && line[0].size.height == 20 && line[0].size.width <= 40);
        QVERIFY(stroke.moveTo(120.0, 500.0, 1.0, map).size() == 1);
        QVERIFY(stroke.moveTo(130.0, 500.0, 1.0, map).empty());
        BrushStroke wrapping(before, brushOf(10.0), {}, true);
        QCOMPARE(wrapping.moveTo(0.0, 200.0, 1.0, map),
                 (std::vector<Rect>{{190, 190, {10, 10}},
                                    {0, 190, {10, 10}},
                                    {190, 0, {10, 10}},
                                    {0, 0, {10, 10}}}));
    }

    void moreIsMore() {
        const Size size{120, 100};
        const Image before({120, 100}, 1, 0.1F);
        Path path = scribble(size, 6, 12);
        const auto with = [&](double radius, double hardness, double strength, double pressure) {
            for (Touch& touch : path)
                touch.pressure = pressure;
            return painted(before, brushOf(radius, hardness, strength), path);
        };
        for (const double step : {0.0, 0.2, 0.4, 0.6, 0.8}) {
            QVERIFY(isBelow(with(20.0, 0.5, step, 1.0), with(20.0, 0.5, step + 0.2, 1.0)));
            QVERIFY(isBelow(with(20.0, 0.5, 0.8, step), with(20.0, 0.5, 0.8, step + 0.2)));
            QVERIFY(isBelow(with(20.0, step, 0.8, 0.9), with(20.0, step + 0.2, 0.8, 0.9)));
        }
        for (const double radius : {0.0, 0.5, 3.0, 20.0}) // a dab: its places do not depend on it
            QVERIFY(isBelow(painted(before, brushOf(radius), {{60, 50}}),
                            painted(before, brushOf(radius + 1.0), {{60, 50}})));
        QVERIFY(with(20.0, 0.5, 0.0, 1.0) == before);
        QVERIFY(with(20.0, 0.5, 1.0, 0.0) == before);
        QVERIFY(with(0.0, 0.5, 1.0, 1.0) == before);
    }

    void pressureScalesStrengthAndRadius() {
        const Image blank({100, 100}, 1);
        const Image map = painted(blank, brushOf(40.0, 1.0, 0.8), {{50.5, 50.5, 0.25}});
        TXN_AT_MOST(std::abs(static_cast<double>(map.at(50, 50, 0)) - 0.8 * 0.25), 1e-6);
        const auto row = map.row(0, 50);
        const auto width = std::ranges::count_if(row, [](float v) { return v > 0.0F; });
        QCOMPARE(width, 2 * 24 + 1); // less than 40 * (1 + 0.25) / 2 away
        // A pen that lands lightly and presses harder without moving.
        const Image pressed = painted(blank, brushOf(40.0), {{50, 50, 0.1}, {50, 50, 1.0}});
        QVERIFY(pressed.at(50, 50, 0) > 15.0F / 16.0F);
    }

    void fullStrengthGivesTheTarget() {
        const Image before = roughMap({64, 64}, 13);
        for (const float target : {0.0F, 0.1F, 1.0F / 3.0F, 0.7F, 1.0F}) {
            Brush brush = brushOf(1e300);
            brush.target = target;
            QVERIFY(painted(before, brush, {{-3.0, 80.0}}) == Image({64, 64}, 1, target));
        }
    }

    void everyDabReachesATexel() {
        for (const double at : {10.0, 10.25, 10.5})
            QVERIFY(painted(Image({20, 20}, 1), brushOf(1e-9), {{at, at}}) != Image({20, 20}, 1));
    }

    void erasingIsPaintingWithA() {
        const Image before = roughMap({100, 80}, 14);
        Brush zero = brushOf(12.0, 0.3, 0.6);
        zero.target = 0.0F;
        Brush eraser = withMode(brushOf(12.0, 0.3, 0.6), BrushMode::Erase);
        eraser.target = 0.8F;
        const Path path = scribble(before.size(), 20, 15);
        QVERIFY(painted(before, eraser, path) == painted(before, zero, path));
    }

    void smoothingKeepsTheMeanAndLessens() {
        const Image before = roughMap({128, 96}, 16);
        for (const bool repeats : {false, true}) {
            for (const double radius : {4.0, 30.0, 1e300}) {
                const Image map = painted(before,
                                          withMode(brushOf(radius, 1.0), BrushMode::Smooth),
                                          finer({{0, 0},
                                                 {128, 0},
                                                 {128, 12},
                                                 {0, 12},
                                                 {0, 24},
                                                 {128, 24},
                                                 {128, 36},
                                                 {0, 36},
                                                 {0, 48},
                                                 {128, 48},
                                                 {128, 60},
                                                 {0, 60},
                                                 {0, 72},
                                                 {128, 72},
                                                 {128, 84},
                                                 {0, 84},
                                                 {0, 96},
                                                 {128, 96}},
                                                3),
                                          {{}, repeats});
                QVERIFY(isMap(map));
                TXN_AT_MOST(std::abs(meanOf(map.samples()) - meanOf(before.samples())), 3e-3);
                TXN_AT_MOST(varianceOf(map.samples()),
                            (radius > 4.0 ? 0.1 : 0.75) * varianceOf(before.samples()));
            }
        }
        // All of it covered: the mean is kept to rounding.
        for (const bool repeats : {false, true}) {
            Brush brush = withMode(brushOf(1000.0, 1.0), BrushMode::Smooth);
            const Image map = painted(before, brush, {{64, 48}}, {{}, repeats});
            TXN_AT_MOST(std::abs(meanOf(map.samples()) - meanOf(before.samples())), 1e-6);
        }
    }

    void smoothingKeepsToTheRange() {
        Image before({100, 100}, 1); // what 1 swallows must not be missing when 1 has gone
        for (const auto& [x, y] : {std::pair{50, 20}, {20, 50}, {77, 77}}) {
            before.at(x, y, 0) = 1.0F;
            before.at(x + 2, y, 0) = 1e-25F;
            before.at(x, y + 2, 0) = 1e-25F;
        }
        QVERIFY(
            isMap(painted(before,
                          withMode(brushOf(6.0, 1.0), BrushMode::Smooth),
                          finer({{45, 20}, {60, 20}, {20, 45}, {20, 60}, {77, 77}, {77, 85}}, 3))));
    }

    void smoothingIsATent() {
        Image before({101, 101}, 1);
        before.at(50, 50, 0) = 1.0F;
        const Image map =
            painted(before, withMode(brushOf(30.0, 1.0), BrushMode::Smooth), {{50.5, 50.5}});
        const auto tent = [](int i) { return std::max(0, 11 - std::abs(i)) / 121.0; };
        for (int y = -15; y <= 15; ++y) {
            for (int x = -15; x <= 15; ++x)
                TXN_AT_MOST(
                    std::abs(static_cast<double>(map.at(50 + x, 50 + y, 0)) - tent(x) * tent(y)),
                    1e-7);
        }
    }

    void smoothingLeavesWhatIsConstant() {
        for (const float value : {0.0F, 1e-30F, 0.1F, 1.0F / 3.0F, 0.77F, 1.0F}) {
            const Image before({70, 50}, 1, value);
            for (const bool repeats : {false, true})
                QVERIFY(painted(before,
                                withMode(brushOf(17.0, 0.2, 0.9), BrushMode::Smooth),
                                scribble(before.size(), 20, 17),
                                {{}, repeats}) == before);
        }
        // A step of a map of 16 bits: away from it to the bit, too.
        Image step({400, 50}, 1, static_cast<float>(12345 / 65535.0));
        for (int y = 0; y < 50; ++y)
            std::ranges::fill(step.row(0, y).subspan(200), static_cast<float>(54321 / 65535.0));
        const Image map =
            painted(step, withMode(brushOf(60.0), BrushMode::Smooth), {{0, 25}, {400, 25}});
        for (int x = 0; x < 400; ++x) {
            if (x < 200 - 20 || x >= 200 + 20)
                QCOMPARE(map.at(x, 25, 0), step.at(x, 25, 0));
        }
        QVERIFY(map.at(199, 25, 0) != step.at(199, 25, 0));
    }

    void badInputDoesNoHarm() {
        for (const Size size : {Size{1, 1}, {1, 50}, {33, 20}}) {
            const Image before = roughMap(size, 18);
            for (const double value : {kNaN, kInfinity, -kInfinity, -1.0, 0.0, 1e-300, 1e300}) {
                for (const BrushMode mode : kModes) {
                    for (const bool repeats : {false, true}) {
                        const Way way{{true, true}, repeats};
                        Brush odd = withMode(brushOf(value, value, value), mode);
                        odd.target = static_cast<float>(value);
                        const Path path = scribble(size, 3, 19);
                        const Brush fine = withMode(brushOf(5.0), mode);
                        QVERIFY(isMap(painted(before, odd, path, way)));
                        odd = fine;
                        odd.hardness = value;
                        QVERIFY(isMap(painted(before, odd, path, way)));
                        odd.hardness = 0.5;
                        odd.target = static_cast<float>(value);
                        QVERIFY(isMap(painted(before, odd, path, way)));
                        for (const Touch& touch :
                             {Touch{value, 3.0}, {3.0, value}, {value, value}, {3.0, 3.0, value}}) {
                            QVERIFY(isMap(painted(before, fine, {touch, path[0]}, way)));
                            QVERIFY(isMap(painted(before, fine, {path[0], touch, path[1]}, way)));
                        }
                    }
                }
            }
            // Those out of their range are the nearest within.
            const auto sameAs = [&](auto set, double odd, double fine) {
                Brush a = brushOf(8.0, 0.7, 0.8);
                Brush b = a;
                set(a, odd);
                set(b, fine);
                return painted(before, a, {{1, 1}, {9, 9}}) == painted(before, b, {{1, 1}, {9, 9}});
            };
            for (const auto& [odd, within] : {std::pair{kNaN, 0.0},
                                              {-3.0, 0.0},
                                              {-kInfinity, 0.0},
                                              {7.0, 1.0},
                                              {kInfinity, 1.0}}) {
                QVERIFY(sameAs([](Brush& b, double v) { b.hardness = v; }, odd, within));
                QVERIFY(sameAs([](Brush& b, double v) { b.strength = v; }, odd, within));
                QVERIFY(sameAs([](Brush& b, double v) { b.target = static_cast<float>(v); },
                               odd,
                               within));
            }
            // As if they had not been there.
            const Brush brush = brushOf(3.0);
            QVERIFY(painted(before,
                            brush,
                            {{1, 1}, {kNaN, 5}, {5, -kInfinity}, {5, 5, kNaN}, {9, 9}}) ==
                    painted(before, brush, {{1, 1}, {9, 9}}));
            QVERIFY(painted(before, brush, {{kNaN, kNaN}, {kInfinity, 0}}) == before);
            QVERIFY(painted(before, brush, {{-1e5, 3}, {-500, 3}, {1e300, 1e300}}) == before);
        }
        // No bridge over a leap that no hand makes.
        const Image blank({50, 50}, 1);
        QVERIFY(painted(blank, brushOf(3.0), {{-1e9, 25}, {1e9, 25}}, {{}, false}) == blank);
    }

    void fillIsOneValue() {
        Image map = roughMap({9, 7}, 20);
        fillMap(map, 0.3F);
        QVERIFY(map == Image({9, 7}, 1, 0.3F));
        fillMap(map, std::numeric_limits<float>::quiet_NaN());
        QVERIFY(map == Image({9, 7}, 1, 0.3F));
        fillMap(map, 7.0F);
        QVERIFY(map == Image({9, 7}, 1, 1.0F));
        fillMap(map, -7.0F);
        QVERIFY(map == Image({9, 7}, 1, 0.0F));
    }

    void gradientsHitTheirEnds_data() {
        QTest::addColumn<bool>("smooth");
        QTest::newRow("linear") << false;
        QTest::newRow("smooth") << true;
    }
    void gradientsHitTheirEnds() {
        QFETCH(bool, smooth);
        const Ease ease = smooth ? Ease::Smooth : Ease::Linear;
        const auto eased = [&](double t) { return smooth ? t * t * (3.0 - 2.0 * t) : t; };
        Image map({90, 60}, 1);
        linearGradient(map, {10.5, 20.5}, {70.5, 40.5}, 0.9F, 0.2F, ease);
        QCOMPARE(map.at(10, 20, 0), 0.9F);
        QCOMPARE(map.at(70, 40, 0), 0.2F);
        QCOMPARE(map.at(0, 0, 0), 0.9F);
        QCOMPARE(map.at(89, 59, 0), 0.2F);
        for (const double t : {0.25, 0.5, 0.75})
            TXN_AT_MOST(std::abs(static_cast<double>(map.at(static_cast<int>(10.0 + 60.0 * t),
                                                            static_cast<int>(20.0 + 20.0 * t),
                                                            0)) -
                                 (0.9 - 0.7 * eased(t))),
                        1e-6);
        QCOMPARE(map.at(40, 30, 0), map.at(45, 15, 0)); // across, all is equal

        radialGradient(map, {30.5, 30.5}, {30.5, 50.5}, 0.1F, 1.0F, ease);
        QCOMPARE(map.at(30, 30, 0), 0.1F);
        for (const auto& [x, y] : {std::pair{30, 50}, {50, 30}, {30, 10}, {42, 46}, {89, 59}})
            QCOMPARE(map.at(x, y, 0), 1.0F);
        TXN_AT_MOST(std::abs(static_cast<double>(map.at(40, 30, 0)) - (0.1 + 0.9 * eased(0.5))),
                    1e-6);
        for (int x = 31; x < 90; ++x)
            QVERIFY(map.at(x, 30, 0) >= map.at(x - 1, 30, 0));

        // From border to border it is gradientMap.
        linearGradient(map, {0, 0}, {90, 0}, 0.0F, 1.0F, ease);
        TXN_AT_MOST(largestDifference(map.samples(), gradientMap({90, 60}, 0.0, ease).samples()),
                    1e-6);
    }

    void badGradientsChangeNothing() {
        const Image before = roughMap({20, 10}, 21);
        Image map = before;
        const auto nan = std::numeric_limits<float>::quiet_NaN();
        for (const MapPoint to :
             {MapPoint{3, 4}, {3, 4 + 1e-12}, {kNaN, 4}, {3, kInfinity}, {-kInfinity, kNaN}}) {
            linearGradient(map, {3, 4}, to, 0.0F, 1.0F, Ease::Linear);
            linearGradient(map, to, {3, 4}, 0.0F, 1.0F, Ease::Smooth);
            radialGradient(map, {3, 4}, to, 0.0F, 1.0F, Ease::Linear);
            radialGradient(map, to, {3, 4}, 0.0F, 1.0F, Ease::Smooth);
        }
        linearGradient(map, {3, 4}, {9, 9}, nan, 1.0F, Ease::Linear);
        radialGradient(map, {3, 4}, {9, 9}, 0.5F, nan, Ease::Linear);
        QVERIFY(map == before);
        for (const double far : {1e9, 1e150, 1e300}) {
            linearGradient(map, {-far, 0}, {far, 5}, -3.0F, 5.0F, Ease::Linear);
            QVERIFY(isMap(map));
            radialGradient(map, {-far, 0}, {far, 5}, -3.0F, 5.0F, Ease::Smooth);
            QVERIFY(isMap(map));
        }
    }

    void stripsAreEquallyWide() {
        for (const int strips : {2, 3, 7, 21, 64}) {
            for (const auto& [size, degrees] :
                 {std::pair{Size{1344, 2}, 0.0}, {Size{1344, 2}, 180.0}, {Size{1000, 1}, 0.0}}) {
                const Image map = stripMap(size, strips, degrees);
                const auto widths = widthsAlong(map.row(0, 0));
                QCOMPARE(widths.size(), static_cast<std::size_t>(strips));
                for (const int width : widths) {
                    if (size.width % strips == 0)
                        QCOMPARE(width, size.width / strips);
                    QVERIFY(std::abs(width - size.width / strips) <= 1);
                }
                const auto row = map.row(0, 0);
                const bool back = degrees > 90.0;
                QCOMPARE(row.front(), back ? 1.0F : 0.0F);
                QCOMPARE(row.back(), back ? 0.0F : 1.0F);
                for (std::size_t i = 0; i < row.size(); ++i) {
                    const double strip = static_cast<double>(row[i]) * (strips - 1);
                    TXN_AT_MOST(std::abs(strip - std::round(strip)), 1e-5);
                }
            }
        }
        // Turned, and eased: those in the middle are narrower.
        const Image down = stripMap({3, 100}, 4, 90.0);
        QVERIFY(down.at(0, 24, 0) == 0.0F && down.at(2, 25, 0) == 1.0F / 3.0F);
        const auto eased = widthsAlong(stripMap({400, 1}, 4, 0.0, Ease::Smooth).row(0, 0));
        QVERIFY(eased.size() == 4 && eased[0] > 110 && eased[1] < 90 && eased[0] == eased[3]);
    }

    void badStripsAreOne() {
        for (const int strips : {1, 0, -5})
            QVERIFY(stripMap({30, 20}, strips, 30.0) == Image({30, 20}, 1));
        for (const double degrees : {kNaN, kInfinity, -kInfinity})
            QVERIFY(stripMap({30, 20}, 3, degrees) == stripMap({30, 20}, 3, 0.0));
        QVERIFY(isMap(stripMap({30, 20}, std::numeric_limits<int>::max(), 1e300)));
        QVERIFY(isMap(stripMap({8192, 1}, 4, 0.0, Ease::Smooth))); // its last texel is rounded to 1
    }
};

QTEST_APPLESS_MAIN(TestMapBrush)
#include "TestMapBrush.moc"
