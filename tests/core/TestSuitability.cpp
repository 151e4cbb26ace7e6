// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianSampler.h"
#include "core/qa/Suitability.h"
#include "core/qa/TextureAnalysis.h"
#include "core/samples/Samples.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <numbers>
#include <numeric>

using namespace txn;

namespace {

Exemplar exemplar(Image image) {
    auto made = makeExemplar(std::move(image), "test");
    return made ? *made : Exemplar{};
}

Result<Suitability> assess(const Exemplar& exemplar) {
    return assessSuitability(exemplar, GaussianModel(exemplar));
}

/// Black discs on white: nothing but shapes.
Image discs(Size size) {
    Image image(size, 1, 0.9F);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (std::hypot(x % 40 - 20, y % 40 - 20) < 9.0)
                image.at(x, y, 0) = 0.1F;
        }
    }
    return image;
}

} // namespace

class TestSuitability : public QObject {
    Q_OBJECT

  private slots:
    void aGaussianTextureSuits() {
        auto rust = makeSample("rust", {256, 256}, Seed{1});
        TXN_OK(rust);
        const GaussianModel model(exemplar(std::move(*rust)));
        int suits = 0;
        for (std::uint32_t seed = 100; seed < 120; ++seed) {
            const auto verdict =
                assess(exemplar(sampleGaussian(model, GaussianMethod::Adsn, Seed{seed})));
            TXN_OK(verdict);
            suits += verdict->verdict == Verdict::Suits ? 1 : 0;
        }
        QVERIFY2(suits >= 19, QByteArray::number(suits));
    }

    void shapesAreSeen() {
        const auto verdict = assess(exemplar(discs({256, 256})));
        TXN_OK(verdict);
        QCOMPARE(verdict->verdict, Verdict::HasShapes);
    }

    void clippingIsSeen() {
        // A Gaussian texture that is too strong for [0, 1].
        auto rust = makeSample("rust", {256, 256}, Seed{1});
        TXN_OK(rust);
        Image image = sampleGaussian(GaussianModel(exemplar(std::move(*rust))),
                                     GaussianMethod::Adsn,
                                     Seed{5});
        for (float& v : image.samples())
            v = 4.0F * v;
        const auto verdict = assess(exemplar(std::move(image)));
        TXN_OK(verdict);
        QCOMPARE(verdict->verdict, Verdict::ColoursClip);
        QVERIFY(verdict->clippedShare > 0.05 && verdict->clippedShare <= 1.0);
    }

    void theNumbersAreThoseOfTheLaw() {
        // Half of the samples 0.4, half 0.6: kurtosis 1, no skewness; 0 and 1 are 5 deviations off.
        Image image({64, 64}, 1);
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                image.at(x, y, 0) = (x + y) % 2 == 0 ? 0.4F : 0.6F;
        }
        const auto verdict = assess(exemplar(std::move(image)));
        TXN_OK(verdict);
        TXN_AT_MOST(std::abs(verdict->excessKurtosis + 2.0), 1e-4);
        TXN_AT_MOST(std::abs(verdict->skewness), 1e-4);
        TXN_AT_MOST(std::abs(verdict->clippedShare - 5.733e-7), 1e-9);
    }

    void oneFlatColourIsAnError() {
        TXN_FAILS_WITH(assess(exemplar(Image({32, 32}, 3, 0.5F))), ErrorCode::Degenerate);
    }

    void canBeCancelled() {
        CancelSource source;
        source.cancel();
        const Exemplar e = exemplar(discs({64, 64}));
        TXN_FAILS_WITH(assessSuitability(e, GaussianModel(e), source.token()),
                       ErrorCode::Cancelled);
    }

    void tinyPicturesHaveAVerdict() {
        for (const Size size : {Size{4, 4}, Size{4, 70}, Size{70, 4}}) {
            Image image(size, 1, 0.5F);
            image.at(0, 0, 0) = 0.7F;
            const auto verdict = assess(exemplar(std::move(image)));
            TXN_OK(verdict);
        }
    }

    void aWaveHasItsPeakWhereItBelongs() {
        constexpr int kSide = 64;
        Image image({200, 160}, 1);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                image.at(x, y, 0) = static_cast<float>(
                    0.5 + 0.2 * std::cos(2.0 * std::numbers::pi * (8.0 * x + 4.0 * y) / kSide));
        }
        const TextureAnalysis analysis = analyseTexture(image, kSide);
        QCOMPARE(analysis.logPower.size(), (Size{kSide, kSide}));
        const int middle = kSide / 2;
        TXN_AT_MOST(std::abs(analysis.logPower.at(middle + 8, middle + 4, 0) - 1.0F), 1e-3);
        TXN_AT_MOST(std::abs(analysis.logPower.at(middle - 8, middle - 4, 0) - 1.0F), 1e-3);
        TXN_AT_MOST(analysis.logPower.at(middle + 20, middle, 0), 0.2);
        // It repeats after 8 pixels across.
        const int quarter = kSide / 4;
        TXN_AT_MOST(std::abs(analysis.autocorrelation.at(quarter, quarter, 0) - 1.0F), 1e-5);
        TXN_AT_MOST(std::abs(analysis.autocorrelation.at(quarter + 8, quarter, 0) - 1.0F), 0.05);
        TXN_AT_MOST(std::abs(analysis.autocorrelation.at(quarter + 4, quarter, 0) + 1.0F), 0.05);
    }

    void histogramsCountEverySample() {
        Image image({32, 16}, 2, 0.5F);
        image.at(3, 3, 1) = 9.0F; // beyond the histogram
        const TextureAnalysis analysis = analyseTexture(image, 16);
        QCOMPARE(analysis.histograms.size(), std::size_t{2});
        const auto total = [&](std::size_t c) {
            const auto& bins = analysis.histograms[c];
            return std::accumulate(bins.begin(), bins.end(), 0.0);
        };
        TXN_AT_MOST(std::abs(total(0) - 1.0), 1e-12);
        TXN_AT_MOST(std::abs(total(1) - (1.0 - 1.0 / 512.0)), 1e-12);
    }

    void picturesSmallerThanTheSquaresAreRepeated() {
        for (const Size size : {Size{1, 1}, Size{5, 3}, Size{300, 2}}) {
            Image image(size, 1, 0.25F);
            image.at(0, 0, 0) = 0.5F;
            const TextureAnalysis analysis = analyseTexture(image, 32);
            for (const float v : analysis.logPower.samples())
                QVERIFY(v >= 0.0F && v <= 1.0F);
            for (const float v : analysis.autocorrelation.samples())
                QVERIFY(std::isfinite(v));
        }
    }
};

QTEST_APPLESS_MAIN(TestSuitability)
#include "TestSuitability.moc"
