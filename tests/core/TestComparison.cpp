// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ColorTransfer.h"
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "core/qa/Comparison.h"
#include "core/qa/RadialSpectrum.h"
#include "core/spectral/PeriodicComponent.h"
#include "core/texton/RelativeModelError.h"
#include "tests/helpers/Dft.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

/// contrast * (u - 1/2) + 1/2 + shift, per channel.
Image changed(Image image, float contrast, float shift) {
    for (float& v : image.samples())
        v = contrast * (v - 0.5F) + 0.5F + shift;
    return image;
}

Image noiseOf(const Texton& texton, Size size) {
    NoiseParams params;
    params.meanImpacts = 30.0;
    return *NoiseGrid::create(texton, params)->render({0, 0, size});
}

} // namespace

class TestComparison : public QObject {
    Q_OBJECT

  private slots:
    void autocovarianceOfPicturesIsTheNaiveSum_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("maxLag");
        QTest::newRow("16 x 12") << 16 << 12 << 3 << 4;
        QTest::newRow("largest lag") << 9 << 13 << 2 << 8;
        QTest::newRow("prime") << 23 << 17 << 1 << 5;
        QTest::newRow("one row") << 20 << 1 << 2 << 0;
        QTest::newRow("one pixel") << 1 << 1 << 1 << 0;
    }

    void autocovarianceOfPicturesIsTheNaiveSum() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, channels);
        QFETCH(int, maxLag);
        const Image image = texturedImage({width, height}, channels, 1);
        const Autocovariance result = autocovariance(image, maxLag);
        QCOMPARE(result.channels(), channels);
        QCOMPARE(result.maxLag(), maxLag);
        double norm = 0.0;
        double worst = 0.0;
        for (int i = 0; i < channels; ++i) {
            for (int j = 0; j < channels; ++j) {
                for (int dy = -maxLag; dy <= maxLag; ++dy) {
                    for (int dx = -maxLag; dx <= maxLag; ++dx) {
                        double sum = 0.0;
                        int count = 0;
                        for (int y = 0; y < height; ++y) {
                            for (int x = 0; x < width; ++x) {
                                if (x + dx < 0 || y + dy < 0 || x + dx >= width || y + dy >= height)
                                    continue;
                                sum += (static_cast<double>(image.at(x + dx, y + dy, i)) -
                                        meanOf(image.plane(i))) *
                                       (static_cast<double>(image.at(x, y, j)) -
                                        meanOf(image.plane(j)));
                                ++count;
                            }
                        }
                        const double expected = sum / count;
                        norm += expected * expected;
                        worst = std::max(worst, std::abs(result.at(i, j, dx, dy) - expected));
                    }
                }
            }
        }
        // Single precision FFTs of values of about 0.1, few pairs at the largest lags.
        TXN_AT_MOST(worst, 1e-7);
        TXN_AT_MOST(std::abs(result.norm(maxLag) - std::sqrt(norm)), 1e-6);
        TXN_AT_MOST(result.distance(result, maxLag), 0.0);
    }

    void autocovarianceOfTextonsIsTheNaiveSum_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const int order : {0, 1, 3, 5}) {
            QTest::addRow("order %d", order) << order << 2 << 6 << 4;
            QTest::addRow("order %d, one pixel", order) << order << 1 << 1 << 1;
            QTest::addRow("order %d, one row", order) << order << 1 << 9 << 1;
        }
    }

    void autocovarianceOfTextonsIsTheNaiveSum() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, width);
        QFETCH(int, height);
        const Texton texton = makeTexton({order, kernels, {width, height}, 2, 2});
        constexpr int kMaxLag = 12; // beyond the reach of the kernels
        const Autocovariance result = autocovariance(texton, kMaxLag);
        double worst = 0.0;
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j) {
                for (int dy = -kMaxLag; dy <= kMaxLag; ++dy) {
                    for (int dx = -kMaxLag; dx <= kMaxLag; ++dx)
                        worst = std::max(worst,
                                         std::abs(result.at(i, j, dx, dy) -
                                                  naiveCovariance(texton, i, j, dx, dy)));
                }
            }
        }
        TXN_AT_MOST(worst, 1e-6); // variance 1, single precision FFTs
        const auto covariance = noiseCovariance(texton);
        TXN_AT_MOST(std::abs(result.at(0, 1, 0, 0) - covariance[1]), 1e-6);
    }

    void distancesCountEveryLag() {
        Autocovariance a(2, 2);
        Autocovariance b(2, 3);
        a.at(0, 1, 2, -1) = 3.0;
        b.at(1, 1, 0, 1) = 4.0;
        b.at(0, 0, 3, 0) = 100.0; // beyond the lag that is asked for
        QCOMPARE(a.distance(b, 2), 5.0);
        QCOMPARE(a.distance(b, 1), 4.0);
        QCOMPARE(a.norm(2), 3.0);
        QCOMPARE(a.norm(1), 0.0);
        QCOMPARE(b.norm(3), std::sqrt(16.0 + 10000.0));
        QVERIFY(a.at(0, 1, -2, 1) == 0.0);
    }

    void everythingEqualsItself() {
        const Exemplar picture = exemplarOf(texturedImage({64, 48}, 3, 3));
        const Texton texton = makeTexton({3, 2, {9, 7}, 3, 4});
        for (const Texture& texture : {Texture(picture), Texture(texton)}) {
            const auto result = compare(texture, texture);
            TXN_OK(result);
            QCOMPARE(result->meanDifference, 0.0);
            QCOMPARE(result->colorCovarianceError, 0.0);
            QCOMPARE(result->covarianceError, 0.0);
            QCOMPARE(result->spectrumDifference, 0.0);
            QVERIFY(result->meanA == result->meanB);
            QVERIFY(!result->relativeModelError);
        }
    }

    void knownDifferencesGiveKnownNumbers() {
        const Image image = texturedImage({64, 48}, 3, 5);
        const Exemplar a = exemplarOf(image);

        Image shifted = image;
        for (float& v : shifted.plane(1))
            v -= 0.125F;
        const auto shift = compare(a, exemplarOf(shifted));
        TXN_OK(shift);
        TXN_AT_MOST(std::abs(shift->meanDifference - 0.125), 1e-6);
        TXN_AT_MOST(std::abs(shift->meanA[1] - shift->meanB[1] - 0.125), 1e-6);
        TXN_AT_MOST(shift->colorCovarianceError, 1e-5);
        TXN_AT_MOST(shift->covarianceError, 1e-5);
        TXN_AT_MOST(shift->spectrumDifference, 1e-3);
        QCOMPARE(shift->lag, 12); // a quarter of the smaller side

        // Contrast 0.8: variances 0.64, an error of 0.36 and -1.938 dB.
        const auto contrast = compare(a, exemplarOf(changed(image, 0.8F, 0.0F)));
        TXN_OK(contrast);
        TXN_AT_MOST(std::abs(contrast->colorCovarianceError - 0.36), 1e-5);
        TXN_AT_MOST(std::abs(contrast->covarianceError - 0.36), 1e-5);
        TXN_AT_MOST(std::abs(contrast->spectrumDifference - 20.0 * std::log10(1.0 / 0.8)), 1e-3);
        // Relative to the first: the other way round it is larger.
        const auto back = compare(exemplarOf(changed(image, 0.8F, 0.0F)), a);
        TXN_OK(back);
        TXN_AT_MOST(std::abs(back->colorCovarianceError - 0.36 / 0.64), 1e-5);

        // A flat colour is an error of 1, as far as nothing.
        const auto flat = compare(a, exemplarOf(Image({64, 48}, 3, 0.5F)));
        TXN_OK(flat);
        TXN_AT_MOST(std::abs(flat->colorCovarianceError - 1.0), 1e-5);
        TXN_AT_MOST(std::abs(flat->covarianceError - 1.0), 1e-5);

        // Turned upside down: colours the same, structure not.
        Image flipped = image;
        for (int c = 0; c < 3; ++c) {
            for (int y = 0; y < 48; ++y) {
                for (int x = 0; x < 64; ++x)
                    flipped.at(x, y, c) = image.at(63 - x, y, c);
            }
        }
        const auto mirror = compare(a, exemplarOf(flipped));
        TXN_OK(mirror);
        TXN_AT_MOST(mirror->colorCovarianceError, 1e-5);
        QVERIFY(mirror->covarianceError > 0.2);
    }

    void textonIsNearItsOwnNoise() {
        const Texton texton = makeTexton({1, 2, {9, 7}, 3, 6});
        const auto result = compare(exemplarOf(noiseOf(texton, {512, 512})), texton, 10);
        TXN_OK(result);
        // One sample of 512 x 512 with a correlation length of some four pixels: about 1 %.
        TXN_AT_MOST(result->meanDifference, 0.05);
        TXN_AT_MOST(result->colorCovarianceError, 0.05);
        TXN_AT_MOST(result->covarianceError, 0.08);
        // Rings average few frequencies near 0 only.
        TXN_AT_MOST(result->spectrumDifference, 1.0);
        QVERIFY(result->relativeModelError.has_value() == false); // two kernels: not defined

        const Texton one = makeTexton({1, 1, {9, 7}, 3, 7});
        const Exemplar sample = exemplarOf(noiseOf(one, {128, 128}));
        const auto single = compare(one, sample);
        TXN_OK(single);
        QVERIFY(single->relativeModelError.has_value());
        TXN_AT_MOST(
            std::abs(*single->relativeModelError - *relativeModelError(GaussianModel(sample), one)),
            1e-12);
        // The error of a Gaussian picture against its own texton is sqrt(1 - pi/4) = 0.463; this
        // sample is small. Another texton is further away in all respects.
        TXN_AT_MOST(std::abs(*single->relativeModelError - 0.463), 0.08);
        const auto other = compare(makeTexton({1, 1, {9, 7}, 3, 8}), sample);
        TXN_OK(other);
        QVERIFY(other->covarianceError > 1.5 * single->covarianceError);
        QVERIFY(*other->relativeModelError > *single->relativeModelError + 0.05);
    }

    void picturesMayDifferInSize() {
        const Texton texton = makeTexton({1, 1, {5, 5}, 1, 9});
        const auto result = compare(exemplarOf(noiseOf(texton, {300, 260})),
                                    exemplarOf(noiseOf(texton, {150, 200})),
                                    6);
        TXN_OK(result);
        QCOMPARE(result->lag, 6);
        TXN_AT_MOST(result->covarianceError, 0.2);
    }

    void transfersAreBroughtTogether() {
        const Image encoded = changed(texturedImage({48, 40}, 3, 10), 0.8F, 0.0F);
        const Image linear = toLinear(encoded);
        QVERIFY(linear.transfer() == Transfer::Linear);
        const auto result = compare(exemplarOf(encoded), exemplarOf(linear));
        TXN_OK(result);
        TXN_AT_MOST(result->meanDifference, 1e-5);
        TXN_AT_MOST(result->covarianceError, 1e-4);
        // Two textons cannot be converted.
        Texton a = makeTexton({1, 1, {5, 5}, 3, 11});
        Texton b = a;
        b.transfer = Transfer::Linear;
        TXN_FAILS_WITH(compare(a, b), ErrorCode::SizeMismatch);
    }

    void whatDoesNotFitIsAnError() {
        const Exemplar rgb = exemplarOf(texturedImage({40, 30}, 3, 12));
        const Exemplar grey = exemplarOf(texturedImage({40, 30}, 1, 12));
        const Exemplar flat = exemplarOf(Image({40, 30}, 3, 0.5F));
        TXN_FAILS_WITH(compare(rgb, grey), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(compare(makeTexton({1, 1, {5, 5}, 2, 1}), rgb), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(compare(rgb, rgb, 30), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(compare(rgb, rgb, -1), ErrorCode::SizeMismatch);
        TXN_OK(compare(rgb, rgb, 29));
        TXN_OK(compare(rgb, rgb, 0));
        TXN_FAILS_WITH(compare(flat, rgb), ErrorCode::Degenerate);
    }

    void spectrumFindsTheRing() {
        // A wave of 10 periods in 64 pixels: 0.15625 cycles per pixel, ring 10.
        Image image({64, 64}, 2);
        for (int c = 0; c < 2; ++c) {
            for (int y = 0; y < 64; ++y) {
                for (int x = 0; x < 64; ++x)
                    image.at(x, y, c) = static_cast<float>(
                        0.1 * (1 + c) * std::cos(2.0 * std::numbers::pi * 10.0 * y / 64.0));
            }
        }
        const RadialSpectrum spectrum = radialSpectrum(GaussianModel(exemplarOf(image), false));
        for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
            if (i == 10)
                QVERIFY(spectrum.power[i] > 0.1);
            else
                TXN_AT_MOST(spectrum.power[i], 1e-9);
        }
        // White noise: the variance of all channels, at every frequency.
        const Image noise = randomImage({128, 128}, 2, 13, 0.2);
        const RadialSpectrum white = radialSpectrum(GaussianModel(exemplarOf(noise), false));
        for (std::size_t i = 4; i < white.power.size(); ++i)
            TXN_AT_MOST(std::abs(white.power[i] / 0.08 - 1.0), 0.3);
    }

    /// Every frequency of the whole DFT once, in the ring of its distance from 0.
    void spectrumIsTheMeanOverRings() {
        for (const Size size : {Size{24, 18}, Size{25, 17}, Size{30, 64}}) {
            const GaussianModel model = texturedModel(size, 2, 14);
            std::array<double, RadialSpectrum::kRings> sums{};
            std::array<double, RadialSpectrum::kRings> counts{};
            for (int c = 0; c < 2; ++c) {
                const auto whole = wholeSpectrum(model.spot(c));
                for (int row = 0; row < size.height; ++row) {
                    for (int column = row == 0 ? 1 : 0; column < size.width; ++column) {
                        const double fx =
                            std::remainder(static_cast<double>(column) / size.width, 1.0);
                        const double fy =
                            std::remainder(static_cast<double>(row) / size.height, 1.0);
                        const double radius = std::hypot(fx, fy) * 2.0 * RadialSpectrum::kRings;
                        if (radius >= RadialSpectrum::kRings)
                            continue;
                        const auto ring = static_cast<std::size_t>(radius);
                        sums[ring] +=
                            std::norm(whole[static_cast<std::size_t>(row * size.width + column)]);
                        counts[ring] += c == 0 ? 1.0 : 0.0;
                    }
                }
            }
            const RadialSpectrum spectrum = radialSpectrum(model);
            for (std::size_t i = 0; i < sums.size(); ++i) {
                const double expected = counts[i] > 0.0 ? sums[i] / counts[i] : 0.0;
                TXN_AT_MOST(std::abs(spectrum.power[i] - expected), 1e-6 * expected);
            }
        }
    }

    void spectrumOfATexton() {
        // A single coefficient: b^ over the rings, which falls from 1 to 1/3 along an axis.
        Texton texton = makeTexton({0, 1, {1, 1}, 1, 1});
        texton.kernels[0].at(0, 0, 0) = 0.5F;
        const RadialSpectrum flat = radialSpectrum(texton);
        texton.interpolationOrder = 1;
        const RadialSpectrum bilinear = radialSpectrum(texton);
        TXN_AT_MOST(std::abs(bilinear.power[1] - 0.25), 1e-3);
        // Ring 0 of so small a kernel holds frequency 0 alone, which does not count.
        QCOMPARE(flat.power[0], 0.0);
        for (std::size_t i = 1; i < flat.power.size(); ++i) {
            TXN_AT_MOST(std::abs(flat.power[i] - 0.25), 1e-6);
            QVERIFY(i == 1 || bilinear.power[i] < bilinear.power[i - 1]);
        }

        RadialSpectrum louder = flat;
        for (double& power : louder.power)
            power *= 10.0;
        TXN_AT_MOST(std::abs(differenceInDecibels(flat, louder) - 10.0), 1e-6);
        louder.power[3] = 0.0; // left out
        TXN_AT_MOST(std::abs(differenceInDecibels(flat, louder) - 10.0), 1e-6);
        QCOMPARE(differenceInDecibels(flat, RadialSpectrum{}), 0.0);
    }
};

QTEST_APPLESS_MAIN(TestComparison)
#include "TestComparison.moc"
