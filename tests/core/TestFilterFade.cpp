// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/FilterFade.h"
#include "core/noise/SpotNoise.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

double at(const FilterFade& fade, int i, int j, int k, int channel = 0) {
    return static_cast<double>(fade.ratios[static_cast<std::size_t>(
        ((k * FilterFade::kMinor + j) * FilterFade::kMajor + i) * fade.channels + channel)]);
}

double reach(const Texton& texton) {
    return std::max(texton.footprint().width, texton.footprint().height);
}

/// Standard deviation of the noise of a texton averaged over boxes, but for a factor: the norm of
/// the kernels so averaged, everything sampled. Independent of covariances and lags.
double boxDeviation(const Texton& texton, double a, double b, double angle, int density) {
    const Size footprint = texton.footprint();
    const double start = texton.frame() + 0.5;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    double total = 0.0;
    for (int q = 0; q < texton.kernelCount(); ++q) {
        struct Sample {
            double along, across, value;
        };
        std::vector<Sample> samples;
        for (int y = 0; y < footprint.height * density; ++y) {
            for (int x = 0; x < footprint.width * density; ++x) {
                const double px = (x + 0.5) / density;
                const double py = (y + 0.5) / density;
                const double value = kernelValue(texton, q, 0, px - start, py - start);
                const double fromX = px - 0.5 * footprint.width;
                const double fromY = py - 0.5 * footprint.height;
                samples.push_back({fromX * cosine + fromY * sine,
                                   fromY * cosine - fromX * sine,
                                   value / (density * density)});
            }
        }
        // Places of the box in its own directions, on a grid fine beside the kernel.
        const double size = std::hypot(footprint.width, footprint.height);
        const double step = 0.37;
        const int along = static_cast<int>(std::ceil(0.5 * (size + a) / step));
        const int across = static_cast<int>(std::ceil(0.5 * (size + b) / step));
        // Samples sorted by strips: sum along first.
        for (int v = -across; v <= across; ++v) {
            std::vector<std::pair<double, double>> strip;
            for (const Sample& s : samples) {
                if (std::abs(s.across - v * step) <= 0.5 * b)
                    strip.emplace_back(s.along, s.value);
            }
            std::sort(strip.begin(), strip.end());
            std::vector<double> sums{0.0};
            for (const auto& s : strip)
                sums.push_back(sums.back() + s.second);
            const auto below = [&](double x) {
                const auto it = std::lower_bound(strip.begin(), strip.end(), std::pair{x, -1e300});
                return sums[static_cast<std::size_t>(it - strip.begin())];
            };
            for (int u = -along; u <= along; ++u) {
                const double sum = below(u * step + 0.5 * a) - below(u * step - 0.5 * a);
                total += sum * sum * step * step / (a * a * b * b);
            }
        }
    }
    return std::sqrt(total);
}

/// Kernels with a sum, as wide as high or not.
Texton positive(Size size, int kernels = 1, int channels = 1) {
    return makeTexton({1, kernels, size, channels, 41, 1.5});
}

Texton withoutSum(Texton texton) {
    for (Image& kernel : texton.kernels) {
        for (int c = 0; c < kernel.channels(); ++c) {
            const auto mean = static_cast<float>(meanOf(kernel.plane(c)));
            for (float& v : kernel.plane(c))
                v -= mean;
        }
    }
    return texton;
}

} // namespace

class TestFilterFade : public QObject {
    Q_OBJECT

  private slots:
    void theTableIsComplete() {
        for (const int channels : {1, 3}) {
            for (const Size size : {Size{1, 1}, {7, 5}, {90, 3}}) {
                const FilterFade fade = filterFade(positive(size, 2, channels));
                QCOMPARE(fade.channels, channels);
                QCOMPARE(fade.ratios.size(),
                         static_cast<std::size_t>(FilterFade::kMajor * FilterFade::kMinor *
                                                  FilterFade::kAngles * channels));
                QVERIFY(allFinite(fade.ratios));
                QVERIFY(std::all_of(fade.ratios.begin(), fade.ratios.end(), [](float v) {
                    return v >= 0.0F && v <= 1.0F;
                }));
            }
        }
    }

    void nothingIsLostUpToTheFootprint() {
        for (const Texton& texton : {positive({7, 5}), withoutSum(positive({12, 12}, 2, 3))}) {
            const FilterFade fade = filterFade(texton);
            for (int k = 0; k < FilterFade::kAngles; ++k) {
                for (int j = 0; j <= FilterFade::kMinorOctaves; ++j) {
                    for (int c = 0; c < fade.channels; ++c)
                        TXN_AT_MOST(std::abs(at(fade, 0, j, k, c) - 1.0), 1e-6);
                }
            }
        }
    }

    /// The mean over a box is the mean of those over its halves, so its variance is never larger.
    void longerBoxesAreFainter() {
        for (const Texton& texton : {positive({7, 5}),
                                     withoutSum(positive({7, 5})),
                                     makeTexton({3, 2, {40, 30}, 2, 42})}) {
            const FilterFade fade = filterFade(texton);
            for (int c = 0; c < fade.channels; ++c) {
                for (int k = 0; k < FilterFade::kAngles; ++k) {
                    for (int j = 0; j < FilterFade::kMinor; ++j) {
                        for (int i = 0; i + 1 < FilterFade::kMajor; ++i)
                            QVERIFY(at(fade, i + 1, j, k, c) <= at(fade, i, j, k, c) + 1e-6);
                    }
                    for (int j = FilterFade::kMinorOctaves; j + 1 < FilterFade::kMinor; ++j) {
                        for (int i = 0; i < FilterFade::kMajor; ++i)
                            QVERIFY(at(fade, i, j + 1, k, c) <= at(fade, i, j, k, c) + 1e-6);
                    }
                }
            }
        }
    }

    /// Far beyond the kernels noise with a sum is as white noise: sigma falls as the root of the
    /// length, whatever the direction.
    void farOutItFallsAsWhiteNoise() {
        const FilterFade fade = filterFade(positive({12, 9}, 2, 2));
        for (int c = 0; c < 2; ++c) {
            for (int k = 0; k < FilterFade::kAngles; ++k) {
                for (const int j : {0, FilterFade::kMinorOctaves, FilterFade::kMinor - 1}) {
                    const double step = at(fade, FilterFade::kMajor - 1, j, k, c) /
                                        at(fade, FilterFade::kMajor - 2, j, k, c);
                    // The kernel is still 1/64 of the box.
                    TXN_AT_MOST(std::abs(step * std::numbers::sqrt2 - 1.0), 0.02);
                }
                for (const int i : {0, FilterFade::kMajor - 1}) {
                    const double step = at(fade, i, FilterFade::kMinor - 1, k, c) /
                                        at(fade, i, FilterFade::kMinor - 2, k, c);
                    TXN_AT_MOST(std::abs(step * std::numbers::sqrt2 - 1.0), 0.02);
                }
            }
        }
    }

    /// Without a sum only the boxes' edges are left: it falls at least twice as fast in octaves.
    void kernelsWithoutASumFallFaster() {
        const Texton texton = positive({12, 9});
        const FilterFade some = filterFade(texton);
        const FilterFade none = filterFade(withoutSum(texton));
        const int last = FilterFade::kMajor - 1;
        const int square = FilterFade::kMinorOctaves + last;
        for (int k = 0; k < FilterFade::kAngles; ++k)
            TXN_AT_MOST(at(none, last, square, k), 0.1 * at(some, last, square, k));
    }

    void agreesWithAveragedKernels_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("kernels");
        QTest::newRow("square") << 6 << 6 << 1;
        QTest::newRow("wide") << 9 << 3 << 1;
        QTest::newRow("tall") << 2 << 7 << 1;
        QTest::newRow("two kernels") << 6 << 4 << 2;
        QTest::newRow("beyond 32") << 50 << 21 << 1;
    }

    void agreesWithAveragedKernels() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, kernels);
        const Texton texton = positive({width, height}, kernels);
        const FilterFade fade = filterFade(texton);
        const double f = reach(texton);
        const int density = width > 32 ? 1 : 4;
        double worst = 0.0;
        for (const int k : {0, 3, 4}) {
            const double angle = std::numbers::pi * k / FilterFade::kAngles;
            for (const int j : {2, 4, 5}) {
                const double b = std::ldexp(f, j - FilterFade::kMinorOctaves);
                const double clamped = boxDeviation(texton, f, std::min(b, f), angle, density);
                for (const int i : {1, 2}) {
                    if (width > 32 && (i > 1 || j > 4))
                        continue; // dear, and nothing new
                    const double full = boxDeviation(texton, std::ldexp(f, i), b, angle, density);
                    const double error = at(fade, i, j, k) / (full / clamped) - 1.0;
                    worst = std::max(worst, std::abs(error));
                    // Kernels are taken as points where they are sampled, boxes as sharp.
                    TXN_AT_MOST(std::abs(error), 0.03);
                }
            }
        }
        qInfo("off by %.3f at worst", worst);
    }

    /// A square box is the same turned by a quarter; a texton mirrored at its diagonal has its
    /// angles mirrored.
    void symmetriesHold() {
        const Texton texton = positive({11, 6}, 2);
        const FilterFade fade = filterFade(texton);
        Texton mirrored = texton;
        mirrored.support = Support::rectangle({6, 11});
        for (std::size_t q = 0; q < texton.kernels.size(); ++q) {
            Image kernel(Size{6, 11}, 1);
            for (int y = 0; y < 11; ++y) {
                for (int x = 0; x < 6; ++x)
                    kernel.at(x, y, 0) = texton.kernels[q].at(y, x, 0);
            }
            mirrored.kernels[q] = kernel;
        }
        const FilterFade other = filterFade(mirrored);
        double asymmetry = 0.0;
        for (int k = 0; k < FilterFade::kAngles; ++k) {
            for (int i = 0; i < FilterFade::kMajor; ++i) {
                for (int j = 0; j < FilterFade::kMinor; ++j) {
                    const int angle =
                        (FilterFade::kAngles / 2 - k + FilterFade::kAngles) % FilterFade::kAngles;
                    TXN_AT_MOST(std::abs(at(fade, i, j, k) - at(other, i, j, angle)), 1e-5);
                    asymmetry =
                        std::max(asymmetry, std::abs(at(fade, i, j, k) - at(other, i, j, k)));
                }
                const int turned = (k + FilterFade::kAngles / 2) % FilterFade::kAngles;
                const int square = i + FilterFade::kMinorOctaves;
                TXN_AT_MOST(std::abs(at(fade, i, square, k) - at(fade, i, square, turned)), 1e-5);
            }
        }
        QVERIFY(asymmetry > 0.01); // there was something to mirror
    }

    void channelsAndKernelsAreIndependent() {
        const Texton texton = positive({9, 5}, 2, 3);
        const FilterFade all = filterFade(texton);
        const FilterFade first = filterFade(firstChannels(texton, 1));
        for (int k = 0; k < FilterFade::kAngles; ++k) {
            for (int j = 0; j < FilterFade::kMinor; ++j) {
                for (int i = 0; i < FilterFade::kMajor; ++i)
                    TXN_AT_MOST(std::abs(at(all, i, j, k) - at(first, i, j, k)), 1e-6);
            }
        }
        // The same kernel twice, or louder, fades alike; only ratios count.
        Texton louder = texton;
        for (Image& kernel : louder.kernels) {
            for (float& v : kernel.samples())
                v *= 3.0F;
        }
        TXN_AT_MOST(largestDifference(filterFade(louder).ratios, all.ratios), 1e-5);
        Texton twice = texton;
        twice.kernels.insert(twice.kernels.end(), texton.kernels.begin(), texton.kernels.end());
        TXN_AT_MOST(largestDifference(filterFade(twice).ratios, all.ratios), 1e-5);
    }

    void silenceStaysFinite() {
        Texton texton = positive({5, 5}, 1, 2);
        for (float& v : texton.kernels[0].plane(1))
            v = 0.0F;
        const FilterFade fade = filterFade(texton);
        QVERIFY(allFinite(fade.ratios));
        TXN_AT_MOST(std::abs(at(fade, 0, 0, 0) - 1.0), 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestFilterFade)
#include "TestFilterFade.moc"
