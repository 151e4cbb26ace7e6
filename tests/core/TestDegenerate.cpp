// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianSampler.h"
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "core/qa/Comparison.h"
#include "core/sheet/ContactSheet.h"
#include "core/spectral/Lighting.h"
#include "core/spectral/PeriodicComponent.h"
#include "core/texton/ColorCorrection.h"
#include "core/texton/TextonSolver.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <functional>
#include <limits>

using namespace txn;
using namespace txn::test;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Almost the largest sample that is allowed.
constexpr double kLargest = 0.99 * static_cast<double>(Exemplar::kLargestSample);

/// An image by a formula.
Image imageOf(Size size, int channels, const std::function<double(int, int, int)>& value) {
    Image image(size, channels);
    for (int c = 0; c < channels; ++c) {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x)
                image.at(x, y, c) = static_cast<float>(value(x, y, c));
        }
    }
    return image;
}

Image scaled(Image image, double factor) {
    for (float& v : image.samples())
        v = static_cast<float>(v * factor);
    return image;
}

bool finite(const Comparison& result) {
    return allFinite(result.meanA) && allFinite(result.meanB) &&
           std::isfinite(result.meanDifference) && std::isfinite(result.covarianceError) &&
           std::isfinite(result.colorCovarianceError) && std::isfinite(result.spectrumDifference) &&
           std::isfinite(result.relativeModelError.value_or(0.0));
}

Texton solved(const GaussianModel& model, const Support& support, int order, bool& failed) {
    TextonParams params;
    params.support = support;
    params.interpolationOrder = order;
    params.iterations = 8;
    auto solver = TextonSolver::create(model, params);
    failed = !solver;
    if (failed)
        return {};
    while (!solver->done())
        solver->step();
    return solver->texton();
}

} // namespace

/// Pictures without texture, or with very odd ones, through everything: a defined result or an
/// error, and never a value that is not a number.
class TestDegenerate : public QObject {
    Q_OBJECT

  private slots:
    void oddPicturesGiveFiniteResults_data() {
        QTest::addColumn<Image>("image");
        QTest::addColumn<bool>("flat");
        QTest::newRow("black") << Image({24, 20}, 3, 0.0F) << true;
        QTest::newRow("white") << Image({24, 20}, 3, 1.0F) << true;
        QTest::newRow("grey") << Image({25, 19}, 1, 0.3F) << true;
        QTest::newRow("far from zero") << Image({24, 20}, 3, 12345.678F) << true;
        QTest::newRow("one pixel") << Image({1, 1}, 3, 0.5F) << true;
        QTest::newRow("two pixels")
            << imageOf({2, 1}, 1, [](int x, int, int) { return x; }) << false;
        QTest::newRow("2 x 2") << imageOf({2, 2}, 2, [](int x, int y, int c) {
            return x * (1 + c) + y;
        }) << false;
        QTest::newRow("one row") << texturedImage({57, 1}, 3, 1) << false;
        QTest::newRow("one column") << texturedImage({1, 64}, 3, 2) << false;
        QTest::newRow("black channel") << imageOf({24, 20}, 3, [](int x, int y, int c) {
            return c == 1 ? 0.0 : std::sin(x * 1.3 + y * c);
        }) << false;
        QTest::newRow("constant channel") << imageOf({24, 20}, 3, [](int x, int y, int c) {
            return c == 2 ? 0.7 : std::sin(x * 1.3 + y * 0.7 + c);
        }) << false;
        QTest::newRow("grey as RGB") << imageOf({32, 20}, 3, [](int x, int y, int) {
            return 0.5 + 0.3 * std::sin(x * 1.1 + y * y * 0.1);
        }) << false;
        QTest::newRow("proportional channels") << imageOf({32, 20}, 3, [](int x, int y, int c) {
            return (1.0 + 0.3 * c) * std::sin(x * 1.1 + y * y * 0.1);
        }) << false;
        QTest::newRow("one bright pixel")
            << imageOf({24, 20}, 1, [](int x, int y, int) { return x == 5 && y == 7 ? 1.0 : 0.0; })
            << false;
        QTest::newRow("checkerboard")
            << imageOf({24, 20}, 3, [](int x, int y, int) { return (x + y) % 2; }) << false;
        QTest::newRow("stripes") << imageOf({24, 20}, 3, [](int x, int, int) { return x % 2; })
                                 << false;
        QTest::newRow("slope") << imageOf({24, 20}, 3, [](int x, int y, int) {
            return 0.01 * x + 0.02 * y;
        }) << false;
        QTest::newRow("tiny contrast") << imageOf({24, 20}, 1, [](int x, int y, int) {
            return x == 3 && y == 4 ? 254.0 / 255.0 : 1.0;
        }) << false;
        QTest::newRow("small values") << scaled(texturedImage({24, 20}, 3, 3), 1e-15) << false;
        QTest::newRow("large values") << scaled(texturedImage({24, 20}, 3, 4), kLargest) << false;
        QTest::newRow("large checkerboard") << imageOf({300, 260}, 1, [](int x, int y, int) {
            return (x + y) % 2 == 0 ? kLargest : -kLargest;
        }) << false;
        QTest::newRow("sixteen channels") << texturedImage({24, 20}, 16, 5) << false;
    }

    void oddPicturesGiveFiniteResults() {
        QFETCH(Image, image);
        QFETCH(bool, flat);
        auto made = makeExemplar(image, "odd");
        TXN_OK(made);
        const Exemplar& exemplar = *made;
        QVERIFY(allFinite(periodicComponent(image).samples()));
        QVERIFY(std::isfinite(seamRatio(image)));
        const auto even = flattenLighting(image, 5.0);
        TXN_OK(even);
        QVERIFY(allFinite(even->samples()));

        for (const bool periodic : {true, false}) {
            const GaussianModel model(exemplar, periodic);
            QVERIFY(allFinite(model.mean()));
            QVERIFY(model.covariance().allFinite());
            for (const auto method : {GaussianMethod::Adsn, GaussianMethod::RandomPhase}) {
                const Image sample = sampleGaussian(model, method, {1});
                QVERIFY(allFinite(sample.samples()));
                const auto larger = gaussianVersion(exemplar,
                                                    {image.width() + 9, image.height() + 6},
                                                    method,
                                                    {1},
                                                    periodic);
                TXN_OK(larger);
                QVERIFY(allFinite(larger->samples()));
                if (flat) {
                    // Nothing but the mean is left, up to a rounding of single precision.
                    TXN_AT_MOST(largestDifference(sample.samples(), image.samples()),
                                1e-6 * static_cast<double>(image.at(0, 0, 0)));
                }
            }
            for (const int order : {0, 1, 5}) {
                const Size largest{std::min(6, image.width()), std::min(5, image.height())};
                for (const Size size : {Size{1, 1}, largest}) {
                    bool failed = false;
                    const Texton texton = solved(model, Support::rectangle(size), order, failed);
                    QCOMPARE(failed, flat);
                    if (flat)
                        continue;
                    QVERIFY(allFinite(texton.kernels[0].samples()));
                    const Texton corrected = colorCorrected(texton, model.covariance());
                    QVERIFY(allFinite(corrected.kernels[0].samples()));
                    for (const double scale : {1.0, 0.6}) {
                        if (scale < 1.0 && (order != 1 || !periodic))
                            continue; // the slow one, once
                        NoiseParams params;
                        params.process = NoiseProcess::Poisson;
                        params.meanImpacts = 2.0; // tiny supports make many impulses
                        const auto noise = NoiseGrid::create(corrected, params, scale);
                        TXN_OK(noise);
                        const auto pixels = noise->render({-3, -3, {20, 20}});
                        TXN_OK(pixels);
                        QVERIFY(allFinite(pixels->samples()));
                    }
                    const Image picture = textonPicture(corrected, {40, 40});
                    QVERIFY(allFinite(picture.samples()));
                    const auto comparison = compare(exemplar, corrected);
                    if (comparison)
                        QVERIFY(finite(*comparison));
                    else
                        QVERIFY(comparison.error().code == ErrorCode::Degenerate);
                }
            }
        }
        const auto same = compare(exemplar, exemplar);
        if (same)
            QVERIFY(finite(*same));
        else
            TXN_FAILS_WITH(same, ErrorCode::Degenerate);
        QCOMPARE(!same, flat);
    }

    void correctedTextonsStayInTheirRange_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("grey as RGB") << 0;
        QTest::newRow("black channel") << 1;
        QTest::newRow("constant channel") << 2;
        QTest::newRow("proportional channels") << 3;
    }

    void correctedTextonsStayInTheirRange() {
        QFETCH(int, kind);
        const Image source = texturedImage({48, 40}, 3, 6);
        const Image image = imageOf(source.size(), 3, [&](int x, int y, int c) -> double {
            switch (kind) {
            case 0:
                return source.at(x, y, 0);
            case 1:
                return c == 1 ? 0.0F : source.at(x, y, c);
            case 2:
                return c == 1 ? 0.37F : source.at(x, y, c);
            default:
                return source.at(x, y, 0) * (1.0 - 0.3 * c);
            }
        });
        const GaussianModel model(exemplarOf(image));
        bool failed = false;
        const Texton texton = solved(model, Support::rectangle({10, 10}), 1, failed);
        QVERIFY(!failed);
        const Texton corrected = colorCorrected(texton, model.covariance());
        const auto covariance = noiseCovariance(corrected);
        const double size = model.covariance().norm();
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                // Rounding of the coefficients; the singular direction must not blow up.
                TXN_AT_MOST(std::abs(covariance[static_cast<std::size_t>(3 * i + j)] -
                                     model.covariance()(i, j)),
                            1e-5 * size);
        }
        const Image& kernel = corrected.kernels[0];
        if (kind == 0) {
            for (std::size_t k = 0; k < kernel.plane(0).size(); ++k) {
                const double limit =
                    1e-6 * static_cast<double>(std::abs(kernel.plane(0)[k])) + 1e-9;
                TXN_AT_MOST(std::abs(static_cast<double>(kernel.plane(1)[k] - kernel.plane(0)[k])),
                            limit);
            }
        }
        if (kind == 1 || kind == 2) {
            // A channel without texture gets none. Its noise: 1e-6 of the others' at most.
            double largest = 0.0;
            double others = 0.0;
            for (std::size_t k = 0; k < kernel.plane(0).size(); ++k) {
                largest = std::max(largest, std::abs(static_cast<double>(kernel.plane(1)[k])));
                others = std::max(others, std::abs(static_cast<double>(kernel.plane(0)[k])));
            }
            TXN_AT_MOST(largest, 1e-6 * others);
            TXN_AT_MOST(std::abs(corrected.mean[1] - (kind == 1 ? 0.0 : 0.37)), 1e-7);
        }
    }

    void channelsOfOtherUnitsAreKept() {
        // A stack of maps with a height in millimetres beside colours: the small ones count, too.
        const Image source = texturedImage({48, 40}, 2, 7);
        for (const double factor : {1e3, 1e4}) {
            const Image image = imageOf(source.size(), 2, [&](int x, int y, int c) {
                return source.at(x, y, c) * (c == 0 ? factor : 1.0);
            });
            const GaussianModel model(exemplarOf(image));
            bool failed = false;
            const Texton texton = solved(model, Support::rectangle({10, 10}), 1, failed);
            QVERIFY(!failed);
            const auto covariance = noiseCovariance(colorCorrected(texton, model.covariance()));
            const double expected = model.covariance()(1, 1);
            TXN_AT_MOST(std::abs(covariance[3] - expected), 1e-2 * expected);
        }
    }

    void samplesThatAreNoNumbersAreErrors_data() {
        QTest::addColumn<float>("value");
        QTest::newRow("NaN") << kNan;
        QTest::newRow("infinity") << kInfinity;
        QTest::newRow("minus infinity") << -kInfinity;
        QTest::newRow("huge") << 1.1F * Exemplar::kLargestSample;
        QTest::newRow("minus huge") << -std::numeric_limits<float>::max();
    }

    void samplesThatAreNoNumbersAreErrors() {
        QFETCH(float, value);
        for (const int channel : {0, 2}) {
            Image image({9, 7}, 3, 0.5F);
            image.at(4, 6, channel) = value;
            const auto result = makeExemplar(image, "rust.png");
            TXN_FAILS_WITH(result, ErrorCode::Degenerate);
            const std::string& message = result.error().message;
            QVERIFY(message.find("rust.png") != std::string::npos);
            QVERIFY(message.find("x 4") != std::string::npos);
            QVERIFY(message.find("y 6") != std::string::npos);
        }
    }

    void exemplarsHaveLimits() {
        TXN_OK(makeExemplar(Image({3, 2}, 16, 0.1F), "a"));
        TXN_FAILS_WITH(makeExemplar(Image({3, 2}, 17, 0.1F), "a"), ErrorCode::Unsupported);
        TXN_FAILS_WITH(makeExemplar(Image(), "a"), ErrorCode::InvalidArgument);
        Image edge({3, 2}, 1, 0.0F);
        edge.at(1, 1, 0) = -Exemplar::kLargestSample;
        TXN_OK(makeExemplar(edge, "a"));
    }

    void gaussianSizesHaveLimits() {
        const Exemplar exemplar = exemplarOf(texturedImage({20, 16}, 1, 8));
        const auto version = [&](Size size) {
            return gaussianVersion(exemplar, size, GaussianMethod::Adsn, {1});
        };
        for (const Size size : {Size{0, 5}, Size{5, 0}, Size{-3, 5}})
            TXN_FAILS_WITH(version(size), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(version({1 << 15, 1 << 14}), ErrorCode::TooLarge);
        TXN_FAILS_WITH(version({2147483647, 2147483647}), ErrorCode::TooLarge);
        TXN_FAILS_WITH(enlarged(exemplar, {19, 16}), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(enlarged(exemplar, {20, 15}), ErrorCode::InvalidArgument);
        TXN_OK(version({1, 1}));
        TXN_OK(version({5, 40}));
    }
};

QTEST_APPLESS_MAIN(TestDegenerate)
#include "TestDegenerate.moc"
