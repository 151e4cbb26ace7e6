// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/SpotNoise.h"
#include "core/noise/SurfaceNoise.h"
#include "core/qa/Autocovariance.h"
#include "core/spectral/BSpline.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

using namespace txn;
using namespace txn::test;

namespace {

/// A mean over seeds may stray this many of its own standard errors from the law.
constexpr double kSigmas = 5.0;

const SurfaceFrame kUpright{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
const SurfaceFrame kAskew{{2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0},
                          {-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0},
                          {1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0}};

NoiseParams paramsOf(int process, double meanImpacts = 24.0, std::uint32_t seed = 5) {
    NoiseParams params;
    params.process = static_cast<NoiseProcess>(process);
    params.meanImpacts = meanImpacts;
    params.seed = {seed};
    return params;
}

/// [TN17] section 6 written down once more: all impulses far around, whole B-splines.
double naiveSurfaceNoise(const Texton& texton,
                         const NoiseParams& params,
                         const SurfaceFrame& frame,
                         const glm::dvec3& point,
                         int channel) {
    const Size footprint = texton.footprint();
    const double r = std::max(footprint.width, footprint.height);
    const double kernels = texton.kernelCount();
    const double lambda = params.meanImpacts / (r * r * r);
    const SurfaceImpulses impulses(params, footprint, texton.kernelCount());
    double sum = 0.0;
    double mean = 0.0;
    impulses.visit(point - 2.0 * r, point + 2.0 * r, [&](const SurfaceImpulse& impulse) {
        const glm::dvec3 from = point - impulse.place;
        const double weight = 1.0 - 2.0 * std::abs(glm::dot(from, frame.normal)) / r;
        const Image& kernel = texton.kernels[static_cast<std::size_t>(impulse.kernel)];
        const double x = glm::dot(from, frame.right);
        const double y = glm::dot(from, frame.down);
        for (int ky = 0; ky < kernel.height() && weight > 0.0; ++ky) {
            // The middle of the kernel lies on the impulse.
            const double wy =
                bspline(texton.interpolationOrder, y - (ky - 0.5 * (kernel.height() - 1)));
            for (int kx = 0; kx < kernel.width() && wy != 0.0; ++kx)
                sum += static_cast<double>(impulse.sign) * weight * wy *
                       bspline(texton.interpolationOrder, x - (kx - 0.5 * (kernel.width() - 1))) *
                       static_cast<double>(kernel.at(kx, ky, channel));
        }
    });
    if (params.process == NoiseProcess::Poisson) {
        for (const Image& kernel : texton.kernels) {
            for (const float v : kernel.plane(channel))
                mean += lambda / kernels * r / 2.0 * static_cast<double>(v);
        }
    }
    return texton.mean[static_cast<std::size_t>(channel)] +
           (sum - mean) / std::sqrt(lambda / kernels * r / 3.0);
}

} // namespace

class TestSurfaceNoise : public QObject {
    Q_OBJECT

    static void processes() {
        QTest::addColumn<int>("process");
        for (const int process : {0, 1, 2})
            QTest::addRow("%s", toString(static_cast<NoiseProcess>(process)).data()) << process;
    }

  private slots:
    void isItsDefinition_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        for (const int process : {0, 1, 2}) {
            for (const int order : {0, 1, 3, 5}) {
                for (const int kernels : {1, 3})
                    QTest::addRow("%s order %d Q %d",
                                  toString(static_cast<NoiseProcess>(process)).data(),
                                  order,
                                  kernels)
                        << process << order << kernels;
            }
        }
    }

    void isItsDefinition() {
        QFETCH(int, process);
        QFETCH(int, order);
        QFETCH(int, kernels);
        TestRandom random(3);
        for (const Size support : {Size{7, 5}, {4, 9}}) {
            const Texton texton = makeTexton({order, kernels, support, 2, 31, 0.3});
            for (const double meanImpacts : {2.0, 30.0}) {
                const NoiseParams params = paramsOf(process, meanImpacts);
                const SurfaceNoise noise(texton, params);
                for (int i = 0; i < 12; ++i) {
                    const double far = i % 3 == 2 ? 1e6 : 20.0;
                    const glm::dvec3 point{random.uniform(-far, far),
                                           random.uniform(-far, far),
                                           random.uniform(-far, far)};
                    const SurfaceFrame& frame = i % 2 == 0 ? kUpright : kAskew;
                    std::array<double, 2> values{};
                    noise.evaluate(point, frame, values);
                    for (int c = 0; c < 2; ++c)
                        // B-spline weights are rounded to single precision.
                        TXN_AT_MOST(std::abs(values[static_cast<std::size_t>(c)] -
                                             naiveSurfaceNoise(texton, params, frame, point, c)),
                                    1e-5);
                }
            }
        }
    }

    void meanAndVarianceAreThoseOfThePlane_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<double>("meanImpacts");
        QTest::addColumn<bool>("askew");
        for (const int process : {0, 1, 2}) {
            const char* name = toString(static_cast<NoiseProcess>(process)).data();
            for (const int kernels : {1, 2}) {
                for (const bool askew : {false, true})
                    QTest::addRow("%s Q %d%s", name, kernels, askew ? " askew" : "")
                        << process << kernels << 24.0 << askew;
            }
            QTest::addRow("%s few impacts", name) << process << 1 << 2.0 << true;
        }
    }

    /// Also that the law is the same at all places of the cells and in any frame: every seed is
    /// looked at from another place.
    void meanAndVarianceAreThoseOfThePlane() {
        QFETCH(int, process);
        QFETCH(int, kernels);
        QFETCH(double, meanImpacts);
        QFETCH(bool, askew);
        const Texton texton = makeTexton({1, kernels, {5, 4}, 2, 32, 0.4});
        const Autocovariance theory = autocovariance(texton, 1);
        const SurfaceFrame& frame = askew ? kAskew : kUpright;
        TestRandom random(4);
        std::array<std::vector<double>, 2> values;
        std::array<std::vector<double>, 2> squares;
        std::vector<double> links;
        std::vector<double> neighbours;
        for (std::uint32_t seed = 1; seed <= 3000; ++seed) {
            const SurfaceNoise noise(texton, paramsOf(process, meanImpacts, seed));
            const glm::dvec3 point{random.uniform(-9.0, 9.0),
                                   random.uniform(-9.0, 9.0),
                                   random.uniform(-9.0, 9.0)};
            std::array<double, 2> here{};
            std::array<double, 2> there{};
            noise.evaluate(point, frame, here);
            // Within the tangent plane the covariance is that of the plane.
            noise.evaluate(point + frame.right - frame.down, frame, there);
            for (std::size_t c = 0; c < 2; ++c) {
                here[c] -= texton.mean[c];
                there[c] -= texton.mean[c];
                values[c].push_back(here[c]);
                squares[c].push_back(here[c] * here[c]);
            }
            links.push_back(here[0] * here[1]);
            neighbours.push_back(there[0] * here[1]);
        }
        for (int c = 0; c < 2; ++c) {
            const Estimate mean = estimate(values[static_cast<std::size_t>(c)]);
            TXN_AT_MOST(std::abs(mean.mean), kSigmas * mean.error);
            TXN_AT_MOST(mean.error, 0.03);
            const Estimate variance = estimate(squares[static_cast<std::size_t>(c)]);
            TXN_AT_MOST(std::abs(variance.mean - theory.at(c, c, 0, 0)), kSigmas * variance.error);
            TXN_AT_MOST(variance.error, meanImpacts < 10.0 ? 0.08 : 0.04);
        }
        const Estimate link = estimate(links);
        TXN_AT_MOST(std::abs(link.mean - theory.at(0, 1, 0, 0)), kSigmas * link.error);
        const Estimate neighbour = estimate(neighbours);
        TXN_AT_MOST(std::abs(neighbour.mean - theory.at(0, 1, 1, -1)), kSigmas * neighbour.error);
    }

    void theCubeHoldsTheMeanNumberOfImpacts_data() { processes(); }

    void theCubeHoldsTheMeanNumberOfImpacts() {
        QFETCH(int, process);
        for (const double meanImpacts : {0.3, 5.0, 40.0}) {
            const Size footprint{9, 7};
            std::vector<double> counts;
            double plus = 0.0;
            std::array<double, 3> kernels{};
            for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
                const SurfaceImpulses impulses(paramsOf(process, meanImpacts, seed), footprint, 3);
                QCOMPARE(impulses.side(), 9.0);
                TXN_AT_MOST(std::abs(impulses.intensity() * 729.0 - meanImpacts),
                            1e-12 * meanImpacts);
                const glm::dvec3 low{seed * 1.37, -40.0, 3.1};
                const glm::dvec3 high = low + 9.0;
                int count = 0;
                impulses.visit(low, high, [&](const SurfaceImpulse& impulse) {
                    if (impulse.place.x < low.x || impulse.place.y < low.y ||
                        impulse.place.z < low.z || impulse.place.x >= high.x ||
                        impulse.place.y >= high.y || impulse.place.z >= high.z)
                        return;
                    ++count;
                    plus += impulse.sign > 0.0F ? 1.0 : 0.0;
                    kernels[static_cast<std::size_t>(impulse.kernel)] += 1.0;
                });
                counts.push_back(count);
            }
            const Estimate mean = estimate(counts);
            TXN_AT_MOST(std::abs(mean.mean - meanImpacts), kSigmas * mean.error);
            const double total = meanOf(counts) * 2000.0;
            // Binomial counts.
            const double expectedPlus = process == 2 ? total : 0.5 * total;
            TXN_AT_MOST(std::abs(plus - expectedPlus), kSigmas * std::sqrt(0.25 * total));
            QVERIFY(process != 2 || plus == total);
            for (const double kernel : kernels)
                TXN_AT_MOST(std::abs(kernel - total / 3.0), kSigmas * std::sqrt(total * 2.0 / 9.0));
            // A Poisson count spreads as its mean, stratified ones much less.
            const double spread = varianceOf(counts) / meanImpacts;
            if (process != 0)
                TXN_AT_MOST(std::abs(spread - 1.0), 0.2);
            else if (meanImpacts >= 5.0)
                TXN_AT_MOST(spread, 0.75);
        }
    }

    void turningSpaceChangesTheLawNotAtAll() {
        // The fourth moment, too: as many impulses count in any frame, only their places differ.
        const Texton texton = makeTexton({1, 1, {5, 5}, 1, 33});
        const auto moments = [&](const SurfaceFrame& frame) {
            std::vector<double> fourth;
            TestRandom random(6);
            for (std::uint32_t seed = 1; seed <= 4000; ++seed) {
                const SurfaceNoise noise(texton, paramsOf(1, 6.0, seed));
                double value = 0.0;
                noise.evaluate({random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), 0.0},
                               frame,
                               {&value, 1});
                fourth.push_back(std::pow(value - texton.mean[0], 4.0));
            }
            return estimate(fourth);
        };
        const Estimate upright = moments(kUpright);
        const Estimate askew = moments(kAskew);
        TXN_AT_MOST(std::abs(upright.mean - askew.mean),
                    kSigmas * std::hypot(upright.error, askew.error));
        TXN_AT_MOST(upright.error, 0.1 * upright.mean);
    }

    void onlyTheFrameCountsNotTheAxes() {
        // Reversing the normal changes nothing: impulses weigh by their distance from the plane.
        const Texton texton = makeTexton({3, 2, {7, 5}, 1, 34});
        const SurfaceNoise noise(texton, paramsOf(0));
        SurfaceFrame reversed = kAskew;
        reversed.normal = -reversed.normal;
        TestRandom random(7);
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 point{random.uniform(-50.0, 50.0),
                                   random.uniform(-50.0, 50.0),
                                   random.uniform(-50.0, 50.0)};
            double a = 0.0;
            double b = 0.0;
            noise.evaluate(point, kAskew, {&a, 1});
            noise.evaluate(point, reversed, {&b, 1});
            TXN_AT_MOST(std::abs(a - b), 1e-9);
        }
    }

    void isContinuous_data() { processes(); }

    void isContinuous() {
        // Nothing pops up at the borders of cells, of the cube or of footprints: an impulse enters
        // with weight 0.
        QFETCH(int, process);
        const Texton texton = makeTexton({1, 1, {6, 6}, 1, 35});
        const SurfaceNoise noise(texton, paramsOf(process, 10.0));
        double largest = 0.0;
        double before = 0.0;
        constexpr int kSteps = 20000;
        for (int i = 0; i <= kSteps; ++i) {
            const double t = 40.0 * i / kSteps;
            double value = 0.0;
            noise.evaluate(glm::dvec3{-20.0, 7.0, -15.0} + t * glm::dvec3{0.6, 0.48, 0.64},
                           kAskew,
                           {&value, 1});
            if (i > 0)
                largest = std::max(largest, std::abs(value - before));
            before = value;
        }
        // Steps of 1/500 pixel, slopes of a few per pixel.
        TXN_AT_MOST(largest, 0.04);
    }

    void isAFunctionOfItsParameters() {
        const Texton texton = makeTexton({1, 2, {7, 5}, 1, 36});
        const auto profile = [&](const NoiseParams& params) {
            const SurfaceNoise noise(texton, params);
            std::vector<double> values;
            for (int i = 0; i < 40; ++i) {
                double value = 0.0;
                noise.evaluate({i * 3.7, i * -2.1, i * 1.3}, kAskew, {&value, 1});
                values.push_back(value);
            }
            return values;
        };
        const auto base = profile(paramsOf(0));
        QVERIFY(base == profile(paramsOf(0)));
        for (const NoiseParams& other :
             {paramsOf(1), paramsOf(2), paramsOf(0, 24.0, 6), paramsOf(0, 25.0)})
            QVERIFY(relativeError(profile(other), base) > 0.1);
        // A period is for the plane.
        NoiseParams periodic = paramsOf(0);
        periodic.period = Period{10.0, 10.0};
        QVERIFY(base == profile(periodic));
    }

    void aMapLiesAsSeenFromTheFront() {
        // Four corners of the map, of four textons: to the right and up in space is to the right
        // and up in the map, whose y points down; z changes nothing.
        std::vector<Texton> textons;
        for (std::uint64_t r = 0; r < 4; ++r) {
            textons.push_back(makeTexton({1, 2, {7, 5}, 2, 40 + r}));
            textons.back().mean[0] += static_cast<double>(r);
        }
        MixingMap map{Image(Size{2, 2}, 1), {-1000.0, -1000.0, 2000.0, 2000.0}};
        const float third = 1.0F / 3.0F;
        map.rho.at(1, 0, 0) = third;
        map.rho.at(0, 1, 0) = 2.0F * third;
        map.rho.at(1, 1, 0) = 1.0F;
        TestRandom random(8);
        for (const int process : {0, 1}) {
            const SurfaceNoise noise({textons, map}, paramsOf(process));
            for (int i = 0; i < 40; ++i) {
                const bool right = i % 2 == 1;
                const bool below = i / 2 % 2 == 1;
                const glm::dvec3 point{random.uniform(30.0, 900.0) * (right ? 1.0 : -1.0),
                                       random.uniform(30.0, 900.0) * (below ? -1.0 : 1.0),
                                       random.uniform(-900.0, 900.0)};
                const SurfaceNoise alone(
                    textons[static_cast<std::size_t>((right ? 1 : 0) + (below ? 2 : 0))],
                    paramsOf(process));
                std::array<double, 2> values{};
                std::array<double, 2> expected{};
                noise.evaluate(point, i % 3 == 0 ? kAskew : kUpright, values);
                alone.evaluate(point, i % 3 == 0 ? kAskew : kUpright, expected);
                for (std::size_t c = 0; c < 2; ++c)
                    TXN_AT_MOST(std::abs(values[c] - expected[c]), 1e-6);
            }
        }
    }

    void betweenTwoTextonsMeanAndVarianceAreBetweenTheirs() {
        // Kernels of unlike strength: chance must not depend on which of them it is.
        Texton a = makeTexton({1, 2, {5, 4}, 1, 44});
        for (float& v : a.kernels[1].samples())
            v *= 3.0F;
        Texton b = makeTexton({1, 2, {5, 4}, 1, 45});
        b.mean[0] = 2.5;
        MixingMap map;
        map.rho.at(0, 0, 0) = 0.3F;
        const double mean = 0.7 * a.mean[0] + 0.3 * b.mean[0];
        TestRandom random(9);
        std::vector<double> values;
        std::vector<double> squares;
        for (std::uint32_t seed = 1; seed <= 6000; ++seed) {
            const SurfaceNoise noise({{a, b}, map}, paramsOf(1, 24.0, seed));
            double value = 0.0;
            noise.evaluate({random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), 0.0},
                           kAskew,
                           {&value, 1});
            values.push_back(value - mean);
            squares.push_back((value - mean) * (value - mean));
        }
        const Estimate off = estimate(values);
        // Positions are multiples of 1/1024.
        TXN_AT_MOST(std::abs(off.mean), kSigmas * off.error + 2e-3);
        const Estimate variance = estimate(squares);
        TXN_AT_MOST(
            std::abs(variance.mean - 0.7 * noiseCovariance(a)[0] - 0.3 * noiseCovariance(b)[0]),
            kSigmas * variance.error);
        TXN_AT_MOST(variance.error, 0.03 * variance.mean);
    }
};

QTEST_APPLESS_MAIN(TestSurfaceNoise)
#include "TestSurfaceNoise.moc"
