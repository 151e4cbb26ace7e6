// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"
#include "core/noise/SpotNoise.h"
#include "core/qa/Autocovariance.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <array>

using namespace txn;
using namespace txn::test;

namespace {

/// A mean over seeds may stray this many of its own standard errors from the law: chance would take
/// one of the some thousand comparisons here beyond that once in a hundred choices of seeds.
constexpr double kSigmas = 5.0;

struct Lag {
    int i; ///< channel at x + (dx, dy)
    int j; ///< channel at x
    int dx;
    int dy;
};

constexpr std::array<Lag, 11> kLags{{{0, 0, 0, 0},
                                     {1, 1, 0, 0},
                                     {0, 1, 0, 0},
                                     {0, 0, 1, 0},
                                     {0, 0, 0, 1},
                                     {1, 1, 2, -1},
                                     {1, 1, 2, 1},
                                     {0, 1, 3, 2},
                                     {1, 0, 3, 2},
                                     {0, 1, -4, 1},
                                     {0, 0, 11, 0}}};

/// Mean product over all pairs of pixels inside, the true mean removed: unbiased.
double productMean(const Image& image, const Texton& texton, const Lag& lag) {
    const double meanI = texton.mean[static_cast<std::size_t>(lag.i)];
    const double meanJ = texton.mean[static_cast<std::size_t>(lag.j)];
    double sum = 0.0;
    int count = 0;
    for (int y = std::max(0, -lag.dy); y < std::min(image.height(), image.height() - lag.dy); ++y) {
        for (int x = std::max(0, -lag.dx); x < std::min(image.width(), image.width() - lag.dx);
             ++x) {
            sum += (static_cast<double>(image.at(x + lag.dx, y + lag.dy, lag.i)) - meanI) *
                   (static_cast<double>(image.at(x, y, lag.j)) - meanJ);
            ++count;
        }
    }
    return sum / count;
}

NoiseParams paramsOf(int process, double meanImpacts, std::uint32_t seed) {
    NoiseParams params;
    params.process = static_cast<NoiseProcess>(process);
    params.meanImpacts = meanImpacts;
    params.seed = {seed};
    return params;
}

} // namespace

/// The laws of texton noise over many seeds. Every comparison also asks the measurement to be sharp
/// enough to notice errors of some percent.
class TestNoiseStatistics : public QObject {
    Q_OBJECT

  private slots:
    void meanAndCovarianceFollowTheTheory_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<double>("meanImpacts");
        QTest::addColumn<qint64>("start");
        for (const int process : {0, 1, 2}) {
            const auto name = toString(static_cast<NoiseProcess>(process));
            for (const int order : {0, 1, 3, 5})
                QTest::addRow("%s order %d", name.data(), order)
                    << process << order << (order == 1 ? 1 : 3) << 8.0 << qint64{0};
            QTest::addRow("%s far away", name.data())
                << process << 1 << 2 << 8.0 << qint64{1000000};
            QTest::addRow("%s farther", name.data())
                << process << 1 << 2 << 8.0 << qint64{-99000000};
            QTest::addRow("%s few impacts", name.data()) << process << 1 << 2 << 0.7 << qint64{0};
        }
    }

    void meanAndCovarianceFollowTheTheory() {
        QFETCH(int, process);
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(double, meanImpacts);
        QFETCH(qint64, start);
        constexpr std::uint32_t kSeeds = 40;
        // The sum of the coefficients is not zero: the Poisson mean has to be taken off.
        const Texton texton = makeTexton({order, kernels, {8, 6}, 2, 3, 0.4});
        const Autocovariance theory = autocovariance(texton, 11);
        std::array<std::vector<double>, 2> means;
        std::array<std::vector<double>, kLags.size()> products;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const auto grid = NoiseGrid::create(texton, paramsOf(process, meanImpacts, seed));
            TXN_OK(grid);
            // Windows of one tile each: the cheapest independent samples.
            const Size tile = grid->tileSize();
            const std::int64_t left = start / tile.width * tile.width;
            const std::int64_t top = -(start / tile.height * tile.height);
            const auto image = grid->render({left, top, {150, 150}});
            TXN_OK(image);
            for (int c = 0; c < 2; ++c)
                means[static_cast<std::size_t>(c)].push_back(meanOf(image->plane(c)));
            for (std::size_t k = 0; k < kLags.size(); ++k)
                products[k].push_back(productMean(*image, texton, kLags[k]));
        }
        for (std::size_t c = 0; c < means.size(); ++c) {
            const Estimate mean = estimate(means[c]);
            TXN_AT_MOST(std::abs(mean.mean - texton.mean[c]), kSigmas * mean.error);
            TXN_AT_MOST(mean.error, 0.03); // the standard deviation of the noise is 1
        }
        for (std::size_t k = 0; k < kLags.size(); ++k) {
            const Lag& lag = kLags[k];
            const Estimate product = estimate(products[k]);
            const double expected = theory.at(lag.i, lag.j, lag.dx, lag.dy);
            TXN_AT_MOST(std::abs(product.mean - expected), kSigmas * product.error);
            TXN_AT_MOST(product.error, 0.03);
        }
    }

    /// The noise is as strong in the middle of a cell as at its corners.
    void varianceIsTheSameEverywhere_data() {
        QTest::addColumn<int>("process");
        for (const int process : {0, 1, 2})
            QTest::addRow("%s", toString(static_cast<NoiseProcess>(process)).data()) << process;
    }

    void varianceIsTheSameEverywhere() {
        QFETCH(int, process);
        constexpr std::uint32_t kSeeds = 3000;
        const Texton texton = makeTexton({1, 2, {4, 6}, 1, 5, 0.4});
        const Size footprint = texton.footprint();
        const double meanImpacts = 4.0;
        const double cellX = footprint.width / 2.0;
        const double cellY = footprint.height / 2.0;
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.5, 0.5}, {0.0, 0.5}, {0.9, 0.1}}) {
            std::vector<double> squares;
            std::vector<double> values;
            for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
                const SpotNoise noise(texton, paramsOf(process, meanImpacts, seed));
                double value = 0.0;
                noise.evaluate((u - 3.0) * cellX, (v + 2.0) * cellY, {&value, 1});
                values.push_back(value);
                squares.push_back((value - texton.mean[0]) * (value - texton.mean[0]));
            }
            const Estimate mean = estimate(values);
            TXN_AT_MOST(std::abs(mean.mean - texton.mean[0]), kSigmas * mean.error);
            const Estimate variance = estimate(squares);
            TXN_AT_MOST(std::abs(variance.mean - noiseCovariance(texton)[0]),
                        kSigmas * variance.error);
            TXN_AT_MOST(variance.error, 0.05);
        }
    }

    /// Third and fourth moments: the Poisson noise of one positive kernel is skewed as
    /// sqrt(1 / lambda) int h^3 / (int h^2)^(3/2), signs undo that.
    void onlyThePoissonProcessIsSkewed() {
        Texton texton = makeTexton({0, 1, {3, 3}, 1, 8});
        for (float& v : texton.kernels[0].samples())
            v = 1.0F / 3.0F; // a box of 3 x 3 with variance 1
        const double meanImpacts = 5.0;
        const double lambda = meanImpacts / 25.0; // footprint 5 x 5
        for (const int process : {0, 1, 2}) {
            std::vector<double> skews;
            for (std::uint32_t seed = 1; seed <= 40; ++seed) {
                const auto image = NoiseGrid::create(texton, paramsOf(process, meanImpacts, seed))
                                       ->render({0, 0, {200, 200}});
                TXN_OK(image);
                double sum = 0.0;
                for (const float v : image->plane(0)) {
                    const double d = static_cast<double>(v) - texton.mean[0];
                    sum += d * d * d;
                }
                skews.push_back(sum / static_cast<double>(image->size().area()));
            }
            const Estimate skew = estimate(skews);
            const double expected = process == 2 ? 9.0 / 27.0 / std::sqrt(lambda) : 0.0;
            TXN_AT_MOST(std::abs(skew.mean - expected), kSigmas * skew.error);
            TXN_AT_MOST(skew.error, 0.05);
        }
    }

    /// Cells fitted to a tile keep the variance, whatever the rounding of their number.
    void tileableNoiseHasTheSameCovariance() {
        const Texton texton = makeTexton({1, 2, {8, 6}, 2, 6, 0.4});
        const Autocovariance theory = autocovariance(texton, 4);
        for (const int process : {0, 1, 2}) {
            std::vector<double> variances;
            std::vector<double> links;
            std::vector<double> means;
            for (std::uint32_t seed = 1; seed <= 60; ++seed) {
                NoiseParams params = paramsOf(process, 5.0, seed);
                params.period = Period{37.0, 53.0};
                const auto image = NoiseGrid::create(texton, params)->render({0, 0, {37, 53}});
                TXN_OK(image);
                means.push_back(meanOf(image->plane(0)));
                variances.push_back(productMean(*image, texton, {0, 0, 0, 0}));
                links.push_back(productMean(*image, texton, {0, 1, 3, -2}));
            }
            const Estimate mean = estimate(means);
            TXN_AT_MOST(std::abs(mean.mean - texton.mean[0]), kSigmas * mean.error);
            const Estimate variance = estimate(variances);
            TXN_AT_MOST(std::abs(variance.mean - theory.at(0, 0, 0, 0)), kSigmas * variance.error);
            TXN_AT_MOST(variance.error, 0.05);
            const Estimate link = estimate(links);
            TXN_AT_MOST(std::abs(link.mean - theory.at(0, 1, 3, -2)), kSigmas * link.error);
        }
    }

    /// Enlarged noise: the autocovariance at a lag of whole exemplar pixels is that of scale 1.
    void scaleDoesNotChangeTheLaw() {
        const Texton texton = makeTexton({1, 2, {8, 6}, 2, 9, 0.4});
        const Autocovariance theory = autocovariance(texton, 4);
        std::vector<double> variances;
        std::vector<double> links;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            const auto image =
                NoiseGrid::create(texton, paramsOf(0, 8.0, seed), 2.0)->render({0, 0, {200, 200}});
            TXN_OK(image);
            variances.push_back(productMean(*image, texton, {1, 1, 0, 0}));
            links.push_back(productMean(*image, texton, {0, 1, 4, -2}));
        }
        const Estimate variance = estimate(variances);
        TXN_AT_MOST(std::abs(variance.mean - theory.at(1, 1, 0, 0)), kSigmas * variance.error);
        TXN_AT_MOST(variance.error, 0.03);
        const Estimate link = estimate(links);
        TXN_AT_MOST(std::abs(link.mean - theory.at(0, 1, 2, -1)), kSigmas * link.error);
    }
};

QTEST_APPLESS_MAIN(TestNoiseStatistics)
#include "TestNoiseStatistics.moc"
