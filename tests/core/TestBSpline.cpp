// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/BSpline.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <complex>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

/// Gauss-Legendre with five points, exact up to degree 9, on pieces of half a unit.
template <class Function>
double integrate(double from, double to, Function f) {
    constexpr double kPoints[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double sum = 0.0;
    const int pieces = static_cast<int>(std::lround((to - from) * 2.0));
    for (int i = 0; i < pieces; ++i) {
        const double center = from + 0.5 * i + 0.25;
        sum += kWeights[0] * f(center) * 0.25;
        for (int p = 1; p < 3; ++p)
            sum += kWeights[p] * 0.25 *
                   (f(center - 0.25 * kPoints[p]) + f(center + 0.25 * kPoints[p]));
    }
    return sum;
}

/// Centred B-spline by the recursion of Cox and de Boor.
double deBoor(int order, double y) {
    if (order == 0)
        return y >= -0.5 && y < 0.5 ? 1.0 : 0.0;
    const double half = 0.5 * (order + 1);
    return ((half + y) * deBoor(order - 1, y + 0.5) + (half - y) * deBoor(order - 1, y - 0.5)) /
           order;
}

} // namespace

class TestBSpline : public QObject {
    Q_OBJECT

  private slots:
    void order_data() {
        QTest::addColumn<int>("order");
        for (const int order : {0, 1, 3, 5})
            QTest::addRow("order %d", order) << order;
    }

    void knownValues() {
        QCOMPARE(bspline(0, 0.0), 1.0);
        QCOMPARE(bspline(0, -0.5), 1.0);
        QCOMPARE(bspline(0, 0.5), 0.0);
        QCOMPARE(bspline(1, 0.25), 0.75);
        QCOMPARE(bspline(1, -0.25), 0.75);
        QCOMPARE(bspline(3, 0.0), 2.0 / 3.0);
        QCOMPARE(bspline(3, 1.0), 1.0 / 6.0);
        QCOMPARE(bspline(3, -1.0), 1.0 / 6.0);
        QCOMPARE(bspline(3, 0.5), 23.0 / 48.0);
        QCOMPARE(bspline(5, 0.0), 11.0 / 20.0);
        QCOMPARE(bspline(5, 1.0), 13.0 / 60.0);
        QCOMPARE(bspline(5, 2.0), 1.0 / 120.0);
        for (const int order : {-1, 2, 4, 6})
            QVERIFY(!isInterpolationOrder(order));
    }

    void partitionOfUnity_data() { order_data(); }

    void partitionOfUnity() {
        QFETCH(int, order);
        QVERIFY(isInterpolationOrder(order));
        TestRandom random(1);
        for (int i = 0; i < 200; ++i) {
            const double y = i < 5 ? -0.5 + 0.25 * i : random.uniform(-3.0, 3.0);
            double sum = 0.0;
            for (int n = -8; n <= 8; ++n)
                sum += bspline(order, y - n);
            TXN_AT_MOST(std::abs(sum - 1.0), 1e-14);
        }
    }

    void recursionHolds_data() { order_data(); }

    void recursionHolds() {
        QFETCH(int, order);
        TestRandom random(2);
        for (int i = 0; i < 200; ++i) {
            const double y = random.uniform(-0.5 * order - 1.5, 0.5 * order + 1.5);
            TXN_AT_MOST(std::abs(bspline(order, y) - deBoor(order, y)), 1e-14);
        }
    }

    void integralIsTheIntegral_data() { order_data(); }

    void integralIsTheIntegral() {
        QFETCH(int, order);
        const double half = 0.5 * (order + 1);
        TXN_AT_MOST(
            std::abs(integrate(-half, half, [&](double y) { return bspline(order, y); }) - 1.0),
            1e-14);
        QCOMPARE(bsplineIntegral(order, -half - 0.1), 0.0);
        QCOMPARE(bsplineIntegral(order, half + 0.1), 1.0);
        QCOMPARE(bsplineIntegral(order, 0.0), 0.5);
        for (double y = -half; y <= half; y += 0.5)
            TXN_AT_MOST(std::abs(bsplineIntegral(order, y) -
                                 integrate(-half, y, [&](double t) { return bspline(order, t); })),
                        1e-14);
        // Its derivative is the B-spline, where that is continuous.
        TestRandom random(3);
        for (int i = 0; i < 100; ++i) {
            const double y = random.uniform(-half, half);
            const double step = 1e-5;
            if (std::abs(std::remainder(y - 0.5 * (order + 1), 1.0)) < 2 * step)
                continue;
            const double slope =
                (bsplineIntegral(order, y + step) - bsplineIntegral(order, y - step)) / (2 * step);
            TXN_AT_MOST(std::abs(slope - bspline(order, y)), 1e-9);
        }
    }

    void autocorrelationIsTheIntegralOfProducts_data() { order_data(); }

    void autocorrelationIsTheIntegralOfProducts() {
        QFETCH(int, order);
        const auto b = bsplineAutocorrelation(order);
        QCOMPARE(static_cast<int>(b.size()), order + 1);
        const double half = 0.5 * (order + 1);
        double sum = b[0];
        for (int n = 0; n <= order; ++n) {
            // Products of degree 2 order on pieces without kinks; degree 10 at most, a hair above
            // what five points integrate exactly.
            const double expected = integrate(-half, half + n, [&](double y) {
                return bspline(order, y) * bspline(order, y - n);
            });
            TXN_AT_MOST(std::abs(b[static_cast<std::size_t>(n)] - expected), 1e-10);
            if (n > 0)
                sum += 2.0 * b[static_cast<std::size_t>(n)];
        }
        TXN_AT_MOST(std::abs(sum - 1.0), 1e-14);
    }

    void spectrumIsTheDftOfTheSamples_data() { order_data(); }

    void spectrumIsTheDftOfTheSamples() {
        QFETCH(int, order);
        const auto b = bsplineAutocorrelation(order);
        for (const int length : {1, 2, 3, 5, 8, 12, 31}) {
            // Wrapped onto the circle, as often as it takes.
            std::vector<double> circle(static_cast<std::size_t>(length), 0.0);
            for (int n = -order; n <= order; ++n)
                circle[static_cast<std::size_t>(((n % length) + length) % length)] +=
                    b[static_cast<std::size_t>(std::abs(n))];
            const auto spectrum = bsplineSpectrum(order, length);
            QCOMPARE(static_cast<int>(spectrum.size()), length);
            for (int k = 0; k < length; ++k) {
                std::complex<double> sum;
                for (int n = 0; n < length; ++n)
                    sum += circle[static_cast<std::size_t>(n)] *
                           std::polar(1.0, -2.0 * std::numbers::pi * k * n / length);
                const double value = spectrum[static_cast<std::size_t>(k)];
                TXN_AT_MOST(std::abs(value - sum), 1e-13);
                QVERIFY(value > 0.0);
            }
        }
    }

    void weightsAreTheBSpline_data() { order_data(); }

    void weightsAreTheBSpline() {
        QFETCH(int, order);
        TestRandom random(4);
        for (int i = 0; i < 400; ++i) {
            double y = random.uniform(-20.0, 20.0);
            if (i < 40)
                y = -5.0 + 0.25 * i; // halves and whole numbers
            else if (i < 80)
                y += i % 2 == 0 ? 99999980.0 : -99999980.0;
            const auto weights = bsplineWeights(order, y);
            double sum = 0.0;
            for (int k = 0; k <= order; ++k) {
                const auto n = static_cast<double>(weights.first + k);
                const auto weight = static_cast<double>(weights.weight[k]);
                TXN_AT_MOST(std::abs(weight - bspline(order, n - y)), 1e-7);
                sum += weight;
            }
            TXN_AT_MOST(std::abs(sum - 1.0), 3e-7);
            // And nothing is left out.
            TXN_AT_MOST(bspline(order, static_cast<double>(weights.first - 1) - y), 0.0);
            TXN_AT_MOST(bspline(order, static_cast<double>(weights.first + order + 1) - y), 1e-30);
        }
    }
};

QTEST_APPLESS_MAIN(TestBSpline)
#include "TestBSpline.moc"
