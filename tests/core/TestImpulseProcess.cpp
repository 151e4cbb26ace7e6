// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/ImpulseProcess.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <array>
#include <map>
#include <tuple>

using namespace txn;
using namespace txn::test;

namespace {

using Key = std::tuple<double, double, float, int>;

NoiseParams paramsOf(NoiseProcess process, double meanImpacts, std::uint32_t seed = 1) {
    NoiseParams params;
    params.process = process;
    params.meanImpacts = meanImpacts;
    params.seed = {seed};
    return params;
}

std::vector<Key>
impulsesIn(const ImpulseProcess& process, double left, double top, double right, double bottom) {
    std::vector<Key> keys;
    process.visit(left, top, right, bottom, [&](const Impulse& impulse) {
        if (impulse.x >= left && impulse.x < right && impulse.y >= top && impulse.y < bottom)
            keys.emplace_back(impulse.x, impulse.y, impulse.sign, impulse.kernel);
    });
    std::sort(keys.begin(), keys.end());
    return keys;
}

/// How many of its standard deviations chi-square lies above its mean. By chance one in 400 goes
/// beyond five for the fewest bins here, one in a million for many.
double chiSquareExcess(const std::vector<double>& counts, const std::vector<double>& expected) {
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    const double freedom = static_cast<double>(counts.size()) - 1.0;
    return (sum - freedom) / std::sqrt(2.0 * freedom);
}

double chiSquareExcess(const std::vector<double>& counts) {
    double total = 0.0;
    for (const double count : counts)
        total += count;
    return chiSquareExcess(
        counts,
        std::vector<double>(counts.size(), total / static_cast<double>(counts.size())));
}

double poissonProbability(double mean, int n) {
    return std::exp(-mean + n * std::log(mean) - std::lgamma(n + 1.0));
}

} // namespace

class TestImpulseProcess : public QObject {
    Q_OBJECT

  private slots:
    /// pcg4d, worked out by another program: the GPU's copy has to give the same.
    void hashHasKnownValues() {
        using Words = std::array<std::uint32_t, 4>;
        static_assert(hash4(0, 0, 0, 0) ==
                      Words{0x0f02f829U, 0x2d568769U, 0x32b0c43bU, 0xd32548eaU});
        static_assert(hash4(1, 2, 3, 4) ==
                      Words{0x3622cd16U, 0xf11471d8U, 0xe1109b3fU, 0x02b94c2fU});
        static_assert(hash4(0xffffffffU, 0x80000000U, 12345U, 0xdeadbeefU) ==
                      Words{0x50a95531U, 0x1479dfd1U, 0x1f12c6c2U, 0x26b43426U});
    }

    /// Any bit that cells, counters and small seeds use flips each of the upper bits of every word
    /// (those that the process reads) half the time.
    void hashSpreadsEveryBit() {
        constexpr int kSamples = 2000;
        TestRandom random(1);
        std::vector<std::array<std::uint32_t, 4>> inputs;
        for (int i = 0; i < kSamples; ++i) {
            const auto bits = random.bits();
            const auto more = random.bits();
            inputs.push_back({static_cast<std::uint32_t>(bits) % 65536U,
                              static_cast<std::uint32_t>(bits >> 32U) % 65536U,
                              static_cast<std::uint32_t>(more) % 16U,
                              static_cast<std::uint32_t>(more >> 32U) % 65536U});
        }
        double worst = 0.0;
        for (std::size_t word = 0; word < 4; ++word) {
            for (unsigned bit = 0; bit < (word == 2 ? 4U : 16U); ++bit) {
                std::array<std::array<int, 16>, 4> flips{};
                for (auto input : inputs) {
                    const auto before = hash4(input[0], input[1], input[2], input[3]);
                    input[word] ^= 1U << bit;
                    const auto after = hash4(input[0], input[1], input[2], input[3]);
                    for (std::size_t out = 0; out < 4; ++out) {
                        const std::uint32_t changed = (before[out] ^ after[out]) >> 16U;
                        for (unsigned k = 0; k < 16; ++k)
                            flips[out][k] += static_cast<int>((changed >> k) & 1U);
                    }
                }
                for (const auto& row : flips) {
                    for (const int count : row)
                        worst =
                            std::max(worst,
                                     std::abs(count - 0.5 * kSamples) / std::sqrt(0.25 * kSamples));
                }
            }
        }
        // In standard deviations, the largest of 3328: chance takes one in ten beyond 4.2.
        TXN_AT_MOST(worst, 5.5);
    }

    void poissonThresholdsAreExact() {
        QCOMPARE(poissonCount(0), 0);
        double cumulative = 0.0;
        for (int n = 0; n < 12; ++n) {
            cumulative += poissonProbability(1.0, n);
            const auto threshold = static_cast<std::uint32_t>(std::llround(cumulative * 0x1p32));
            QCOMPARE(poissonCount(threshold), n + 1);
            QCOMPARE(poissonCount(threshold - 1), n);
        }
        QCOMPARE(poissonCount(0xffffffffU), 12);
    }

    void intensityFollowsTheFootprint() {
        for (const double mni : {0.1, 7.3, 12.0, 1000.0}) {
            const ImpulseProcess process(paramsOf(NoiseProcess::Signed, mni), {11, 7}, 1);
            TXN_AT_MOST(std::abs(process.intensity() - mni / 77.0), 1e-12);
            QVERIFY(process.process() == NoiseProcess::Signed);
        }
        // Fitted to a tile: round(W / cell) cells, cells of 11 / sqrt(7.3) = 4.07 and 2.59.
        NoiseParams params = paramsOf(NoiseProcess::Signed, 7.3);
        params.period = Period{30.0, 20.0};
        const ImpulseProcess fitted(params, {11, 7}, 1);
        TXN_AT_MOST(std::abs(fitted.intensity() - 7.0 * 8.0 / 600.0), 1e-12);
        params.period = Period{1.0, 1.0}; // never less than one cell
        TXN_AT_MOST(std::abs(ImpulseProcess(params, {11, 7}, 1).intensity() - 1.0), 1e-12);
    }

    void stratifiedCellsHoldOneImpulseEach() {
        const ImpulseProcess process(paramsOf(NoiseProcess::Stratified, 9.0), {30, 12}, 5);
        // Cells of 10 x 4, around the origin and far away on both sides.
        std::map<std::pair<std::int64_t, std::int64_t>, int> counts;
        const double starts[][2] = {{-200.0, -80.0}, {9.0e7, -9.0e7}, {-9.9e7, 9.9e7}};
        for (const auto& start : starts) {
            counts.clear();
            process.visit(start[0] + 0.01,
                          start[1] + 0.01,
                          start[0] + 399.9,
                          start[1] + 159.9,
                          [&](const Impulse& i) {
                              ++counts[{static_cast<std::int64_t>(std::floor(i.x / 10.0)),
                                        static_cast<std::int64_t>(std::floor(i.y / 4.0))}];
                          });
            QCOMPARE(counts.size(), std::size_t{1600});
            for (const auto& [cell, count] : counts)
                QCOMPARE(count, 1);
        }
    }

    void placesSignsAndKernelsAreUniform_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<double>("start");
        for (const int process : {0, 1, 2}) {
            for (const double start : {0.0, -100.0, 9.0e5})
                QTest::addRow("process %d from %g", process, start) << process << start;
        }
    }

    void placesSignsAndKernelsAreUniform() {
        QFETCH(int, process);
        QFETCH(double, start);
        constexpr int kKernels = 3;
        constexpr int kBins = 12;
        // Cells of one unit.
        const ImpulseProcess impulses(paramsOf(static_cast<NoiseProcess>(process), 1.0, 17),
                                      {1, 1},
                                      kKernels);
        std::vector<double> places(kBins * kBins, 0.0);
        std::vector<double> kinds(2 * kKernels, 0.0);
        double count = 0.0;
        const double side = 200.0;
        impulses.visit(start, start, start + side - 0.5, start + side - 0.5, [&](const Impulse& i) {
            const auto bin = [](double v) { return static_cast<int>((v - std::floor(v)) * kBins); };
            ++places[static_cast<std::size_t>(bin(i.y) * kBins + bin(i.x))];
            QVERIFY(i.sign == 1.0F || i.sign == -1.0F);
            QVERIFY(i.kernel >= 0 && i.kernel < kKernels);
            ++kinds[static_cast<std::size_t>(i.kernel + (i.sign > 0.0F ? kKernels : 0))];
            ++count;
        });
        TXN_AT_MOST(chiSquareExcess(places), 5.0);
        const auto process_ = static_cast<NoiseProcess>(process);
        if (process_ == NoiseProcess::Poisson) {
            QVERIFY(kinds[0] + kinds[1] + kinds[2] == 0.0); // never a minus sign
            kinds.erase(kinds.begin(), kinds.begin() + kKernels);
        }
        TXN_AT_MOST(chiSquareExcess(kinds), 5.0);
        if (process_ == NoiseProcess::Stratified)
            QCOMPARE(count, side * side);
        else
            TXN_AT_MOST(std::abs(count - side * side), 5.0 * side);
    }

    /// What one cell does says nothing about its neighbours or about the next seed.
    void cellsAreIndependent() {
        constexpr int kSide = 150;
        const auto draw = [&](std::uint32_t seed) {
            const ImpulseProcess impulses(paramsOf(NoiseProcess::Stratified, 1.0, seed), {1, 1}, 2);
            std::vector<std::array<double, 4>> cells;
            impulses.visit(-75.0, -75.0, 74.5, 74.5, [&](const Impulse& i) {
                cells.push_back({i.x - std::floor(i.x) - 0.5,
                                 i.y - std::floor(i.y) - 0.5,
                                 static_cast<double>(i.sign),
                                 i.kernel - 0.5});
            });
            return cells;
        };
        const auto cells = draw(1);
        const auto other = draw(2);
        QCOMPARE(cells.size(), std::size_t{kSide * kSide});
        constexpr double kDeviation[4] = {0.28867513, 0.28867513, 1.0, 0.5};
        // Steps right, down, and far; the same cell under the next seed.
        const std::size_t steps[] = {1, kSide, kSide + 1, 64, 0};
        double worst = 0.0;
        for (const std::size_t step : steps) {
            const auto& second = step == 0 ? other : cells;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 4; ++j) {
                    double sum = 0.0;
                    const std::size_t count = cells.size() - step;
                    for (std::size_t k = 0; k < count; ++k)
                        sum += cells[k][i] * second[k + step][j];
                    const double error =
                        kDeviation[i] * kDeviation[j] * std::sqrt(static_cast<double>(count));
                    worst = std::max(worst, std::abs(sum) / error);
                }
            }
        }
        TXN_AT_MOST(worst, 5.0);
        // And within a cell.
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                double sum = 0.0;
                for (const auto& cell : cells)
                    sum += cell[i] * cell[j];
                TXN_AT_MOST(std::abs(sum) / (kDeviation[i] * kDeviation[j] * kSide), 5.0);
            }
        }
    }

    void countsInWindowsArePoisson_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("offset");
        // In cells of one unit: parts of a cell, whole ones, and many with cut borders.
        QTest::newRow("a tenth of a cell") << 0.5 << 0.2 << 0.1;
        QTest::newRow("one cell") << 1.0 << 1.0 << 0.0;
        QTest::newRow("one cell, cut") << 1.0 << 1.0 << 0.4;
        QTest::newRow("2.5 x 1.2") << 2.5 << 1.2 << 0.3;
        QTest::newRow("6 x 5") << 6.0 << 5.0 << 0.0;
        QTest::newRow("20.3 x 9.7") << 20.3 << 9.7 << 0.3;
    }

    void countsInWindowsArePoisson() {
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, offset);
        const double mean = width * height;
        constexpr int kWindows = 4000;
        for (const auto process : {NoiseProcess::Poisson, NoiseProcess::Signed}) {
            const ImpulseProcess impulses(paramsOf(process, 1.0, 23), {1, 1}, 1);
            const int across = 63;
            std::vector<double> counts;
            for (int i = 0; i < kWindows; ++i) {
                // Disjoint windows, on both sides of the origin.
                const double left = (i % across - 31) * std::ceil(width + offset) + offset;
                const double top = (i / across - 31) * std::ceil(height + offset) + offset;
                const auto found = impulsesIn(impulses, left, top, left + width, top + height);
                counts.push_back(static_cast<double>(found.size()));
            }
            // Bins of at least ten expected windows; both tails together in the outermost ones.
            const int most = static_cast<int>(mean + 8.0 * std::sqrt(mean)) + 8;
            std::vector<double> expected;
            std::vector<double> found;
            double e = 0.0;
            double f = 0.0;
            for (int n = 0; n <= most; ++n) {
                e += kWindows * poissonProbability(mean, n);
                f += static_cast<double>(std::count(counts.begin(), counts.end(), n));
                if (e >= 10.0) {
                    expected.push_back(e);
                    found.push_back(f);
                    e = f = 0.0;
                }
            }
            expected.back() += e;
            found.back() += f;
            TXN_AT_MOST(chiSquareExcess(found, expected), 5.0);
            // Mean and variance are equal: sharper than the bins for large means.
            TXN_AT_MOST(std::abs(meanOf(counts) - mean), 5.0 * std::sqrt(mean / kWindows));
            TXN_AT_MOST(std::abs(varianceOf(counts) / mean - 1.0),
                        5.0 * std::sqrt((2.0 + 1.0 / mean) / kWindows));
        }
    }

    void orderOfVisitingDoesNotMatter() {
        for (const auto kind :
             {NoiseProcess::Stratified, NoiseProcess::Signed, NoiseProcess::Poisson}) {
            const ImpulseProcess process(paramsOf(kind, 7.3, 31), {11, 7}, 4);
            const auto whole = impulsesIn(process, -60.0, -50.0, 60.0, 50.0);
            QVERIFY(whole.size() > 500);
            std::vector<Key> pieces;
            for (double y = 40.0; y >= -50.0; y -= 10.0) {
                for (double x = -60.0; x < 60.0; x += 7.5) {
                    const auto piece = impulsesIn(process, x, y, x + 7.5, y + 10.0);
                    pieces.insert(pieces.end(), piece.begin(), piece.end());
                }
            }
            std::sort(pieces.begin(), pieces.end());
            QVERIFY(pieces == whole);
            // Again, and under another seed.
            QVERIFY(impulsesIn(process, -60.0, -50.0, 60.0, 50.0) == whole);
            const ImpulseProcess other(paramsOf(kind, 7.3, 32), {11, 7}, 4);
            QVERIFY(impulsesIn(other, -60.0, -50.0, 60.0, 50.0) != whole);
        }
    }

    /// The plane is not mirrored or repeated at the origin, nor after any power of two of cells.
    void nothingRepeats() {
        const ImpulseProcess process(paramsOf(NoiseProcess::Stratified, 1.0, 41), {1, 1}, 1);
        const auto pattern = [&](double left, double top, bool mirrored) {
            std::vector<double> places;
            const double side = 15.5;
            process.visit(left, top, left + side, top + side, [&](const Impulse& i) {
                const double u = i.x - std::floor(i.x);
                places.push_back(mirrored ? 1.0 - u : u);
            });
            return places;
        };
        const auto base = pattern(0.0, 0.0, false);
        QCOMPARE(base.size(), std::size_t{256});
        for (const double shift : {-16.0, 256.0, 1024.0, 4096.0, 65536.0, 1048576.0, 67108864.0}) {
            for (const bool mirrored : {false, true}) {
                QVERIFY(relativeError(pattern(shift, 0.0, mirrored), base) > 0.3);
                QVERIFY(relativeError(pattern(0.0, shift, mirrored), base) > 0.3);
                QVERIFY(relativeError(pattern(shift, shift, mirrored), base) > 0.3);
            }
        }
    }

    void periodsWrap() {
        for (const auto kind :
             {NoiseProcess::Stratified, NoiseProcess::Signed, NoiseProcess::Poisson}) {
            NoiseParams params = paramsOf(kind, 7.3, 51);
            params.period = Period{33.3, 20.5};
            const ImpulseProcess process(params, {11, 7}, 4);
            // Offsets keep rounding from moving an impulse across the border of a window.
            const auto base = impulsesIn(process, -1e-7, -1e-7, 33.3 - 1e-7, 20.5 - 1e-7);
            QVERIFY(base.size() > 20);
            for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {-7, 100}}) {
                const double x = 33.3 * i - 1e-7;
                const double y = 20.5 * j - 1e-7;
                const auto copy = impulsesIn(process, x, y, x + 33.3, y + 20.5);
                QCOMPARE(copy.size(), base.size());
                for (std::size_t k = 0; k < copy.size(); ++k) {
                    TXN_AT_MOST(std::abs(std::get<0>(copy[k]) - 33.3 * i - std::get<0>(base[k])),
                                1e-9);
                    TXN_AT_MOST(std::abs(std::get<1>(copy[k]) - 20.5 * j - std::get<1>(base[k])),
                                1e-9);
                    QVERIFY(std::get<2>(copy[k]) == std::get<2>(base[k]));
                    QVERIFY(std::get<3>(copy[k]) == std::get<3>(base[k]));
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestImpulseProcess)
#include "TestImpulseProcess.moc"
