// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/CovarianceObjective.h"
#include "core/texton/LeastSquaresTexton.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

using Shape = CovarianceObjective::Shape;

CovarianceObjective objectiveOf(const GaussianModel& model,
                                const Shape& shape,
                                const std::vector<double>& weights = {}) {
    return *CovarianceObjective::create(model, shape, weights);
}

Support supportOf(const QString& shape) {
    if (shape == "disc")
        return Support::disc(8);
    return Support::rectangle(shape == "odd" ? Size{16, 16} : Size{9, 6});
}

/// Circular autocovariance of the model at one lag, by its definition: the spot back on the domain,
/// then the sum of products.
double
circular(const std::vector<std::vector<float>>& spot, Size size, int i, int j, int dx, int dy) {
    double sum = 0.0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const int u = (x + dx + 2 * size.width) % size.width;
            const int v = (y + dy + 2 * size.height) % size.height;
            sum += static_cast<double>(spot[static_cast<std::size_t>(i)]
                                           [static_cast<std::size_t>(v * size.width + u)]) *
                   static_cast<double>(spot[static_cast<std::size_t>(j)]
                                           [static_cast<std::size_t>(y * size.width + x)]);
        }
    }
    return sum;
}

std::vector<std::vector<float>> spotOf(const GaussianModel& model) {
    std::vector<std::vector<float>> planes;
    const RealFft2d fft(model.domain());
    for (int c = 0; c < model.channels(); ++c) {
        HalfSpectrum copy(model.domain());
        for (int b = 0; b < copy.blocks(); ++b)
            std::ranges::copy(model.spot(c).block(b), copy.block(b).begin());
        planes.emplace_back(model.domain().area());
        fft.inverse(std::move(copy), planes.back());
    }
    return planes;
}

/// The last term of J.
double borderCost(const Support& support, const std::vector<double>& gamma) {
    const auto taper = [](double t) {
        const double edge = std::min(t, 1.0 - t) / 0.25;
        return edge >= 1.0   ? 1.0
               : edge <= 0.0 ? 0.0
                             : std::pow(std::sin(0.5 * std::numbers::pi * edge), 2);
    };
    const Size size = support.size();
    double sum = 0.0;
    for (std::size_t k = 0; k < gamma.size(); ++k) {
        const auto place = static_cast<int>(k % size.area());
        const int x = place % size.width;
        const int y = place / size.width;
        const double u = (x + 0.5) / size.width;
        const double v = (y + 0.5) / size.height;
        double e = support.shape() == SupportShape::Disc ? taper(0.5 + std::hypot(u - 0.5, v - 0.5))
                                                         : taper(u) * taper(v);
        if (!support.contains(x, y))
            e = 0.0;
        sum += (1.0 - e) * gamma[k] * gamma[k];
    }
    return 0.002 * sum;
}

/// The rest by its definition, lag by lag, from the texton's own covariance.
double directly(const GaussianModel& model, const Texton& texton) {
    const Size side = texton.support.size();
    const auto own = autocovariance(texton, std::max(side.width, side.height));
    const auto spot = spotOf(model);
    const auto weight = [](int lag, int size) {
        const double share = std::abs(lag) / (0.7 * size);
        return share < 1.0 ? 0.5 * (1.0 + std::cos(std::numbers::pi * share)) : 0.0;
    };
    const Size domain = model.domain();
    const auto trust = [](int lag, int length) {
        return std::sqrt(1.0 - static_cast<double>(std::abs(lag)) / length);
    };
    double sum = 0.0;
    double norm = 0.0;
    for (int dy = 1 - side.height; dy < side.height; ++dy) {
        for (int dx = 1 - side.width; dx < side.width; ++dx) {
            const double w = std::sqrt(weight(dx, side.width) * weight(dy, side.height));
            for (int i = 0; i < model.channels(); ++i) {
                for (int j = 0; j < model.channels(); ++j) {
                    const double target = trust(dx, domain.width) * trust(dy, domain.height) *
                                          circular(spot, domain, i, j, dx, dy);
                    const double difference = own.at(i, j, dx, dy) - target;
                    sum += w * difference * difference;
                    norm += w * target * target;
                }
            }
        }
    }
    return sum / norm;
}

/// A material whose covariance some small kernels make exactly: noise of a texton.
Image noiseOf(const Texton& texton, Size size, std::uint32_t seed) {
    NoiseParams params;
    params.meanImpacts = 40.0;
    params.seed = Seed{seed};
    return *NoiseGrid::create(texton, params, 1.0)->render({0, 0, size});
}

} // namespace

class TestLeastSquares : public QObject {
    Q_OBJECT

  private slots:
    void theObjectiveIsItsDefinition_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::addColumn<QString>("shape");
        for (const int order : {0, 1, 3, 5}) {
            for (const int kernels : {1, 3}) {
                for (const int channels : {1, 3})
                    QTest::addRow("order %d, Q %d, C %d", order, kernels, channels)
                        << order << kernels << channels << "rectangle";
            }
        }
        QTest::newRow("disc") << 1 << 2 << 2 << "disc";
        QTest::newRow("odd grid") << 1 << 2 << 2 << "odd"; // 34 lags, of which 35 points are made
    }
    void theObjectiveIsItsDefinition() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        QFETCH(QString, shape);
        const GaussianModel model = texturedModel({26, 21}, channels, 5);
        const Support support = supportOf(shape);
        const auto objective = objectiveOf(model, {support, order, kernels});
        const auto gamma = objective.start(Seed{3});
        std::vector<double> gradient(objective.variables());
        const double value = objective.evaluate(gamma, gradient);
        // Single precision transforms of some 500 points.
        double trace = 0.0; // of the target at lag 0
        for (int c = 0; c < channels; ++c)
            trace += circular(spotOf(model), model.domain(), c, c, 0, 0);
        const double expected =
            directly(model, objective.texton(gamma)) + borderCost(support, gamma) / trace;
        TXN_AT_MOST(std::abs(value - expected), 1e-5 * expected);
    }

    void theGradientIsThatOfFiniteDifferences_data() { theObjectiveIsItsDefinition_data(); }
    void theGradientIsThatOfFiniteDifferences() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        QFETCH(QString, shape);
        const GaussianModel model = texturedModel({26, 21}, channels, 6);
        const Support support = supportOf(shape);
        const auto objective = objectiveOf(model, {support, order, kernels});
        const auto gamma = objective.start(Seed{4});
        std::vector<double> gradient(objective.variables());
        std::vector<double> unused(objective.variables());
        static_cast<void>(objective.evaluate(gamma, gradient));
        TestRandom random(9);
        double size = 0.0;
        for (const double v : gamma)
            size += v * v;
        for (int trial = 0; trial < 5; ++trial) {
            std::vector<double> direction(gamma.size());
            double length = 0.0;
            for (double& d : direction) {
                d = random.gaussian();
                length += d * d;
            }
            const double h = 2e-3 * std::sqrt(size / length);
            auto forward = gamma;
            auto backward = gamma;
            double slope = 0.0;
            for (std::size_t k = 0; k < gamma.size(); ++k) {
                forward[k] += h * direction[k];
                backward[k] -= h * direction[k];
                slope += gradient[k] * direction[k];
            }
            const double measured =
                (objective.evaluate(forward, unused) - objective.evaluate(backward, unused)) /
                (2.0 * h);
            double steepest = 0.0;
            for (const double g : gradient)
                steepest += g * g;
            // J is of fourth order and its transforms are single precision: 1e-7 J / h of error.
            TXN_AT_MOST(std::abs(measured - slope), 2e-3 * std::sqrt(steepest * length));
        }
    }

    void aKnownTextonIsFound_data() {
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::newRow("grey") << 1 << 1;
        QTest::newRow("colour, two kernels") << 2 << 3;
    }
    /// From noise of a texton, the fit is no further from the truth than another piece of it is.
    void aKnownTextonIsFound() {
        QFETCH(int, kernels);
        QFETCH(int, channels);
        TextonRecipe recipe;
        recipe.kernels = kernels;
        recipe.channels = channels;
        const Texton truth = makeTexton(recipe);
        const Image piece = noiseOf(truth, {192, 160}, 1);
        const GaussianModel model(exemplarOf(piece));
        LeastSquaresParams params;
        params.support = Support::rectangle({20, 20});
        params.kernels = kernels;
        double objective = 1.0;
        const auto fitted = fitTexton(model, params, [&](const TextonProgress& now) {
            objective = now.error() * now.error();
        });
        TXN_OK(fitted);
        QCOMPARE(fitted->kernelCount(), kernels);
        const auto exact = autocovariance(truth, 10);
        const auto found = autocovariance(*fitted, 10);
        const auto sample = autocovariance(piece, 10);
        const auto another = autocovariance(noiseOf(truth, {192, 160}, 2), 10);
        TXN_AT_MOST(found.distance(exact, 10), another.distance(sample, 10));
        // And what is left of the piece it was fitted to is less than what such pieces differ by.
        const double floor = sample.distance(exact, 10) / exact.norm(10);
        TXN_AT_MOST(objective, floor * floor);
    }

    void moreKernelsFollowChannelsThatMoveIndependently() {
        // Two channels of independent noise: no single kernel has a diagonal covariance.
        const GaussianModel model(exemplarOf(randomImage({64, 64}, 2, 11)));
        LeastSquaresParams params;
        params.support = Support::rectangle({12, 12});
        double last = 0.0;
        double one = 0.0;
        const auto note = [&](const TextonProgress& now) { last = now.error() * now.error(); };
        TXN_OK(fitTexton(model, params, note));
        one = last;
        params.kernels = 2;
        TXN_OK(fitTexton(model, params, note));
        TXN_AT_MOST(last, 0.5 * one);
    }

    void progressDescendsAndShowsTheTexton() {
        const GaussianModel model = texturedModel({48, 40}, 3, 2);
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 12});
        params.kernels = 2;
        params.iterations = 30;
        std::vector<double> values;
        bool inOrder = true;
        Texton seen;
        const auto fitted = fitTexton(model, params, [&](const TextonProgress& now) {
            values.push_back(now.error());
            seen = now.texton();
            inOrder =
                inOrder && now.iterations == 30 && now.iteration == static_cast<int>(values.size());
        });
        TXN_OK(fitted);
        QVERIFY(inOrder);
        QVERIFY(!values.empty() && values.size() <= 30);
        for (std::size_t i = 1; i < values.size(); ++i)
            TXN_AT_MOST(values[i], values[i - 1]);
        QVERIFY(seen == *fitted);
        // Nothing is left on the border to be seen as a square.
        double whole = 0.0;
        double border = 0.0;
        for (const Image& kernel : seen.kernels) {
            for (int c = 0; c < 3; ++c) {
                for (int y = 0; y < 12; ++y) {
                    for (int x = 0; x < 16; ++x) {
                        const double v = kernel.at(x, y, c);
                        whole += v * v;
                        border += x == 0 || y == 0 || x == 15 || y == 11 ? v * v : 0.0;
                    }
                }
            }
        }
        TXN_AT_MOST(border, 0.03 * whole); // of 27 % of the places
    }

    void cancelEndsIt() {
        const GaussianModel model = texturedModel({48, 40}, 1, 2);
        int calls = 0;
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        CancelSource source;
        const auto fitted = fitTexton(
            model,
            params,
            [&](const TextonProgress&) {
                if (++calls == 3)
                    source.cancel();
            },
            source.token());
        TXN_FAILS_WITH(fitted, ErrorCode::Cancelled);
        QCOMPARE(calls, 3);
    }

    void theNumberOfThreadsDoesNotMatter() {
        const GaussianModel model = texturedModel({48, 40}, 3, 2);
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        params.kernels = 2;
        params.iterations = 12;
        const auto fit = [&] { return *fitTexton(model, params); };
        QVERIFY(onThreads(1, fit) == onThreads(4, fit));
    }

    void constantAndDependentChannelsAreDefined() {
        Image image(Size{40, 36}, 4);
        const Image grey = texturedImage({40, 36}, 1, 3);
        for (int c = 0; c < 3; ++c)
            std::ranges::copy(grey.plane(0), image.plane(c).begin()); // grey stored as RGB
        for (float& v : image.plane(3))
            v = 0.25F; // and a channel that is constant
        const GaussianModel model(exemplarOf(std::move(image)));
        LeastSquaresParams params;
        params.support = Support::rectangle({10, 10});
        params.kernels = 2;
        const auto fitted = fitTexton(model, params);
        TXN_OK(fitted);
        const Texton corrected = colorCorrected(*fitted, model.covariance());
        for (const Image& kernel : corrected.kernels) {
            for (const float v : kernel.samples())
                QVERIFY(std::isfinite(v));
        }
        const auto covariance = noiseCovariance(corrected);
        TXN_AT_MOST(std::abs(covariance[0] - model.covariance()(0, 0)),
                    1e-4 * model.covariance()(0, 0));
        TXN_AT_MOST(std::abs(covariance[15]), 1e-10);
    }

    void weightsMakeUnitsIrrelevant() {
        // The same picture, one channel in units a thousand times smaller.
        const Image plain = texturedImage({48, 48}, 2, 7);
        Image scaled = plain;
        for (float& v : scaled.plane(1))
            v *= 0.001F;
        LeastSquaresParams params;
        params.support = Support::rectangle({12, 12});
        params.kernels = 2;
        const auto a = fitTexton(GaussianModel(exemplarOf(plain)), params);
        params.channelWeights = {1.0, 1000.0};
        const auto b = fitTexton(GaussianModel(exemplarOf(scaled)), params);
        TXN_OK(a);
        TXN_OK(b);
        const auto first = noiseCovariance(*a);
        const auto second = noiseCovariance(*b);
        TXN_AT_MOST(std::abs(second[0] - first[0]), 0.02 * first[0]);
        TXN_AT_MOST(std::abs(second[3] * 1e6 - first[3]), 0.02 * first[3]);
    }

    void whatCannotBeFittedSaysWhy() {
        const GaussianModel model = texturedModel({30, 20}, 2, 1);
        LeastSquaresParams params;
        params.support = Support::rectangle({24, 24});
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::SizeMismatch);
        params.support = Support::rectangle({8, 8});
        params.kernels = 0;
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::InvalidArgument);
        params.kernels = 17;
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::InvalidArgument);
        params.kernels = 1;
        params.interpolationOrder = 2;
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::InvalidArgument);
        params.interpolationOrder = 1;
        params.iterations = 0;
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::InvalidArgument);
        params.iterations = 80;
        params.channelWeights = {1.0};
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::SizeMismatch);
        params.channelWeights = {1.0, -1.0};
        TXN_FAILS_WITH(fitTexton(model, params), ErrorCode::InvalidArgument);
        params.channelWeights = {};
        const GaussianModel flat(exemplarOf(Image({30, 20}, 1, 0.5F)));
        TXN_FAILS_WITH(fitTexton(flat, params), ErrorCode::Degenerate);
    }
};

QTEST_APPLESS_MAIN(TestLeastSquares)
#include "TestLeastSquares.moc"
