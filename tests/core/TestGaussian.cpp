// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianSampler.h"
#include "core/gaussian/WhiteNoise.h"
#include "core/spectral/PeriodicComponent.h"
#include "tests/helpers/Dft.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

constexpr double kSigmas = 5.0;

void addSizes() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto& [w, h] :
         {std::pair{24, 20}, {25, 18}, {24, 19}, {23, 29}, {31, 1}, {1, 32}, {2, 2}, {1, 1}})
        QTest::addRow("%d x %d", w, h) << w << h;
}

/// Circular covariance of channel i at x + (dx, dy) and channel j at x of a periodic image with
/// the given means.
double circular(const Image& image, const std::vector<double>& mean, int i, int j, int dx, int dy) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int nx = (x + dx + image.width()) % image.width();
            const int ny = (y + dy + image.height()) % image.height();
            sum += (static_cast<double>(image.at(nx, ny, i)) - mean[static_cast<std::size_t>(i)]) *
                   (static_cast<double>(image.at(x, y, j)) - mean[static_cast<std::size_t>(j)]);
        }
    }
    return sum / static_cast<double>(image.size().area());
}

} // namespace

class TestGaussian : public QObject {
    Q_OBJECT

  private slots:
    void whiteNoiseIsStandard() {
        const Image noise = whiteNoise({128, 96}, 2, {1});
        const double count = 128.0 * 96.0;
        for (int c = 0; c < 2; ++c) {
            std::vector<double> moments(5, 0.0);
            double right = 0.0;
            double below = 0.0;
            for (int y = 0; y < 96; ++y) {
                for (int x = 0; x < 128; ++x) {
                    const double v = noise.at(x, y, c);
                    for (int n = 1; n <= 4; ++n)
                        moments[static_cast<std::size_t>(n)] += std::pow(v, n) / count;
                    right += v * static_cast<double>(noise.at((x + 1) % 128, y, c)) / count;
                    below += v * static_cast<double>(noise.at(x, (y + 1) % 96, c)) / count;
                }
            }
            // Standard errors of the moments of Gaussian values: sqrt(1, 2, 15, 96) / sqrt(count).
            TXN_AT_MOST(std::abs(moments[1]), kSigmas / std::sqrt(count));
            TXN_AT_MOST(std::abs(moments[2] - 1.0), kSigmas * std::sqrt(2.0 / count));
            TXN_AT_MOST(std::abs(moments[3]), kSigmas * std::sqrt(15.0 / count));
            TXN_AT_MOST(std::abs(moments[4] - 3.0), kSigmas * std::sqrt(96.0 / count));
            TXN_AT_MOST(std::abs(right), kSigmas / std::sqrt(count));
            TXN_AT_MOST(std::abs(below), kSigmas / std::sqrt(count));
        }
        double link = 0.0;
        for (std::size_t i = 0; i < noise.plane(0).size(); ++i)
            link += static_cast<double>(noise.plane(0)[i]) * static_cast<double>(noise.plane(1)[i]);
        TXN_AT_MOST(std::abs(link / count), kSigmas / std::sqrt(count));

        // Every value by its place: a smaller image is a part of a larger one.
        const Image small = whiteNoise({50, 40}, 1, {1});
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 50; ++x)
                QVERIFY(small.at(x, y, 0) == noise.at(x, y, 0));
        }
        QVERIFY(!(whiteNoise({50, 40}, 1, {2}) == small));
    }

    void randomPhaseKeepsModulusAndMean_data() { addSizes(); }

    void randomPhaseKeepsModulusAndMean() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const GaussianModel model = texturedModel(size, 3, 1);
        const Image sample = sampleGaussian(model, GaussianMethod::RandomPhase, {7});
        QCOMPARE(sample.size(), size);
        const double area = static_cast<double>(size.area());
        std::vector<DoublePlane> spot;
        std::vector<DoublePlane> result;
        for (int c = 0; c < 3; ++c) {
            TXN_AT_MOST(
                std::abs(meanOf(sample.plane(c)) - model.mean()[static_cast<std::size_t>(c)]),
                1e-6);
            spot.push_back(wholeSpectrum(model.spot(c)));
            result.push_back(naiveDft(sample.plane(c), size));
        }
        double moved = 0.0;
        for (std::size_t k = 1; k < size.area(); ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    // One phase for all channels: products between channels stay, too. The sample's
                    // values are rounded to 3e-8 each.
                    const DoubleComplex before = spot[i][k] * std::conj(spot[j][k]) * area;
                    const DoubleComplex after = result[i][k] * std::conj(result[j][k]);
                    const double size2 = std::abs(result[i][k]) + std::abs(result[j][k]);
                    TXN_AT_MOST(std::abs(after - before), 1e-5 * size2 + 1e-8);
                }
            }
            moved += std::norm(result[0][k] - spot[0][k] * std::sqrt(area)) / area;
        }
        if (size.area() > 100) // and the phases did change
            QVERIFY(moved > model.covariance()(0, 0));
    }

    void averagesFollowTheModel_data() {
        QTest::addColumn<int>("method");
        QTest::newRow("ADSN") << 0;
        QTest::newRow("random phase") << 1;
    }

    void averagesFollowTheModel() {
        QFETCH(int, method);
        const Size size{40, 32};
        const Image image = texturedImage(size, 2, 2);
        const Exemplar exemplar = exemplarOf(image);
        const GaussianModel model(exemplar);
        const Image periodic = periodicComponent(image);
        constexpr int kLags[][4] = {{0, 0, 0, 0},
                                    {1, 1, 0, 0},
                                    {0, 1, 0, 0},
                                    {0, 0, 1, 0},
                                    {0, 0, 0, 1},
                                    {0, 1, 3, -2},
                                    {1, 0, 3, -2},
                                    {1, 1, -7, 5}};
        std::vector<std::vector<double>> products(std::size(kLags));
        std::vector<double> pixel;
        for (std::uint32_t seed = 1; seed <= 80; ++seed) {
            const Image sample = sampleGaussian(model, static_cast<GaussianMethod>(method), {seed});
            for (std::size_t k = 0; k < std::size(kLags); ++k) {
                const auto& lag = kLags[k];
                products[k].push_back(
                    circular(sample, model.mean(), lag[0], lag[1], lag[2], lag[3]));
            }
            for (int c = 0; c < 2; ++c)
                TXN_AT_MOST(
                    std::abs(meanOf(sample.plane(c)) - model.mean()[static_cast<std::size_t>(c)]),
                    1e-6);
            pixel.push_back(sample.at(3, 5, 0));
        }
        for (std::size_t k = 0; k < std::size(kLags); ++k) {
            const auto& lag = kLags[k];
            const Estimate product = estimate(products[k]);
            const double expected =
                circular(periodic, model.mean(), lag[0], lag[1], lag[2], lag[3]);
            // Random phase has exactly this autocovariance, each time: only rounding is left.
            const double size0 = model.covariance().trace();
            TXN_AT_MOST(std::abs(product.mean - expected),
                        method == 1 ? 1e-5 * size0 : kSigmas * product.error);
            TXN_AT_MOST(product.error, 0.1 * size0); // sharp enough to mean something
            if (method == 0)
                QVERIFY(product.error > 1e-3 * expected); // it does vary
        }
        // At a fixed place, over the seeds.
        const Estimate mean = estimate(pixel);
        TXN_AT_MOST(std::abs(mean.mean - model.mean()[0]), kSigmas * mean.error);
        const double variance = varianceOf(pixel);
        TXN_AT_MOST(std::abs(variance / model.covariance()(0, 0) - 1.0),
                    kSigmas * std::sqrt(2.0 / 80));
    }

    /// One white noise for all channels: a sum of channels is the noise of the sum.
    void channelsShareTheNoise() {
        const Image image = texturedImage({30, 22}, 2, 3);
        Image sum(image.size(), 1);
        for (std::size_t i = 0; i < sum.samples().size(); ++i)
            sum.samples()[i] = image.plane(0)[i] + image.plane(1)[i];
        const GaussianModel model(exemplarOf(image));
        const GaussianModel sumModel(exemplarOf(sum));
        const Image sample = sampleGaussian(model, GaussianMethod::Adsn, {4});
        const Image sumSample = sampleGaussian(sumModel, GaussianMethod::Adsn, {4});
        for (std::size_t i = 0; i < sum.samples().size(); ++i)
            TXN_AT_MOST(std::abs(static_cast<double>(sumSample.samples()[i]) -
                                 static_cast<double>(sample.plane(0)[i]) -
                                 static_cast<double>(sample.plane(1)[i])),
                        5e-6);
    }

    void seedsAndThreads() {
        const GaussianModel model = texturedModel({61, 45}, 3, 5);
        for (const auto method : {GaussianMethod::Adsn, GaussianMethod::RandomPhase}) {
            const auto run = [&] { return sampleGaussian(model, method, {9}); };
            const Image one = onThreads(1, run);
            QVERIFY(onThreads(1, run) == one);
            QVERIFY(onThreads(2, run) == one);
            QVERIFY(relativeError(sampleGaussian(model, method, {10}).samples(), one.samples()) >
                    0.05);
        }
    }

    /// Signs of equal size: the ramp's energy is all that the variance depends on, so that it must
    /// come out right to the last digits but for the mean that the ramp leaves.
    void enlargedModelKeepsTheCovariance() {
        const Size size{48, 40};
        Image image(size, 2);
        TestRandom random(6);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const bool sign = random.uniform() < 0.5;
                image.at(x, y, 0) = sign ? 0.75F : 0.25F;
                image.at(x, y, 1) = sign ? 0.2F : 0.6F;
            }
        }
        const Exemplar exemplar = exemplarOf(image);
        const GaussianModel plain(exemplar, false);
        for (const Size larger : {size, Size{100, 40}, Size{48, 101}, Size{128, 96}}) {
            const auto model = enlarged(exemplar, larger, false);
            TXN_OK(model);
            QCOMPARE(model->domain(), larger);
            QVERIFY(model->mean() == plain.mean());
            // The signs are not quite balanced: 1 % of the variance.
            TXN_AT_MOST((model->covariance() - plain.covariance()).norm(),
                        0.01 * plain.covariance().norm());
        }
    }

    void enlargedVersionsFollowTheExemplar() {
        // Close neighbours keep their covariance; a bound by the measured spread over exemplars.
        std::vector<double> variance;
        std::vector<double> neighbour;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            const Image image = texturedImage({64, 56}, 1, seed);
            const Exemplar exemplar = exemplarOf(image);
            const GaussianModel model(exemplar);
            const auto version =
                gaussianVersion(exemplar, {150, 130}, GaussianMethod::Adsn, {seed});
            TXN_OK(version);
            QCOMPARE(version->size(), (Size{150, 130}));
            TXN_AT_MOST(std::abs(meanOf(version->samples()) - model.mean()[0]), 1e-5);
            const Image periodic = periodicComponent(image);
            const auto error = [&](int dx, int dy) {
                return (circular(*version, model.mean(), 0, 0, dx, dy) -
                        circular(periodic, model.mean(), 0, 0, dx, dy)) /
                       model.covariance()(0, 0);
            };
            variance.push_back(error(0, 0));
            neighbour.push_back(error(3, 1));
        }
        // The ramp's weights disturb the waves of this picture by a percent or two.
        for (const auto& errors : {variance, neighbour}) {
            const Estimate error = estimate(errors);
            TXN_AT_MOST(std::abs(error.mean), kSigmas * error.error + 0.02);
            TXN_AT_MOST(error.error, 0.03);
        }
    }

    void versionsOfAnySize() {
        Image image = texturedImage({30, 24}, 2, 7);
        image.setTransfer(Transfer::Linear);
        const Exemplar exemplar = exemplarOf(image);
        const GaussianModel model(exemplar);
        for (const auto method : {GaussianMethod::Adsn, GaussianMethod::RandomPhase}) {
            const Image own = sampleGaussian(model, method, {3});
            QVERIFY(own.transfer() == Transfer::Linear);
            const auto same = gaussianVersion(exemplar, {30, 24}, method, {3});
            TXN_OK(same);
            QVERIFY(*same == own);
            // Smaller ones are its top left corner.
            const auto small = gaussianVersion(exemplar, {11, 7}, method, {3});
            TXN_OK(small);
            QCOMPARE(small->size(), (Size{11, 7}));
            for (int y = 0; y < 7; ++y) {
                for (int x = 0; x < 11; ++x)
                    QVERIFY(small->at(x, y, 1) == own.at(x, y, 1));
            }
            for (const Size size : {Size{80, 10}, Size{10, 80}, Size{61, 60}}) {
                const auto version = gaussianVersion(exemplar, size, method, {3});
                TXN_OK(version);
                QCOMPARE(version->size(), size);
                QVERIFY(version->transfer() == Transfer::Linear);
                QVERIFY(*gaussianVersion(exemplar, size, method, {3}) == *version);
                QVERIFY(varianceOf(version->plane(0)) > 0.2 * model.covariance()(0, 0));
            }
        }
    }

    void modelsOfSpots() {
        // Given directly: the mean does not count, the values do, without any factor.
        const Image spot = texturedImage({12, 10}, 2, 8);
        const GaussianModel model(spot, {0.25, 0.75});
        QVERIFY(model.mean() == (std::vector<double>{0.25, 0.75}));
        QVERIFY(model.spot(1).at(0, 0) == Complex());
        const auto expected = naiveDft(spot.plane(1), spot.size());
        const auto actual = wholeSpectrum(model.spot(1));
        for (std::size_t k = 1; k < actual.size(); ++k)
            TXN_AT_MOST(std::abs(actual[k] - expected[k]), 1e-5);
        TXN_AT_MOST(std::abs(model.covariance()(0, 0) - 120.0 * varianceOf(spot.plane(0))), 1e-5);
    }
};

QTEST_APPLESS_MAIN(TestGaussian)
#include "TestGaussian.moc"
