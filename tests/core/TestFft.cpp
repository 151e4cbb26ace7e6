// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/ComplexLanes.h"
#include "core/spectral/Fft.h"
#include "tests/helpers/Dft.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

std::vector<Complex> valuesOf(const HalfSpectrum& spectrum) {
    std::vector<Complex> values;
    for (int b = 0; b < spectrum.blocks(); ++b)
        values.insert(values.end(), spectrum.block(b).begin(), spectrum.block(b).end());
    return values;
}

void addSizes() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto& [w, h] : {std::pair{1, 1},
                               {2, 1},
                               {1, 2},
                               {1, 7},
                               {7, 1},
                               {97, 1},
                               {1, 97},
                               {8, 6},
                               {15, 16},
                               {16, 15},
                               {14, 9},
                               {13, 17},
                               {31, 29},
                               {64, 48},
                               {63, 65},
                               {101, 20}})
        QTest::addRow("%d x %d", w, h) << w << h;
}

} // namespace

class TestFft : public QObject {
    Q_OBJECT

  private slots:
    void forwardIsTheDft_data() { addSizes(); }

    void forwardIsTheDft() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const Image image = randomImage(size, 1, 1);
        const RealFft2d fft(size);
        const HalfSpectrum spectrum = fft.forward(image.plane(0));
        QCOMPARE(spectrum.columns(), width / 2 + 1);
        QVERIFY(spectrum.blocks() * FftPlan::kLanes >= spectrum.columns());
        const DoublePlane expected = naiveDft(image.plane(0), size);
        // Single precision errors grow with the logarithm of the length: some 1e-7.
        TXN_AT_MOST(test::relativeError(wholeSpectrum(spectrum), expected), 1e-6);
        // The half that is stored, element by element, and zeros behind it.
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < spectrum.columns(); ++column)
                TXN_AT_MOST(std::abs(DoubleComplex(spectrum.at(row, column)) -
                                     expected[static_cast<std::size_t>(row * width + column)]),
                            1e-5 * std::sqrt(static_cast<double>(size.area())));
            for (int column = spectrum.columns(); column < spectrum.blocks() * FftPlan::kLanes;
                 ++column)
                QVERIFY(spectrum.at(row, column) == Complex());
        }

        // An offset is added first.
        std::vector<float> shifted(image.plane(0).begin(), image.plane(0).end());
        for (float& v : shifted)
            v -= 0.5F;
        QVERIFY(valuesOf(fft.forward(image.plane(0), -0.5F)) == valuesOf(fft.forward(shifted)));
    }

    void inverseUndoesForward_data() { addSizes(); }

    void inverseUndoesForward() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const Image image = randomImage(size, 1, 2);
        const RealFft2d fft(size);
        Image back(size, 1);
        fft.inverse(fft.forward(image.plane(0)), back.plane(0));
        TXN_AT_MOST(largestDifference(back.samples(), image.samples()), 2e-6);
    }

    void parsevalHolds_data() { addSizes(); }

    void parsevalHolds() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const Image image = randomImage(size, 1, 3);
        const HalfSpectrum spectrum = RealFft2d(size).forward(image.plane(0));
        double energy = 0.0;
        for (const float v : image.samples())
            energy += static_cast<double>(v) * static_cast<double>(v);
        double sum = 0.0;
        int count = 0;
        for (int column = 0; column < spectrum.blocks() * FftPlan::kLanes; ++column) {
            count += spectrum.multiplicity(column);
            for (int row = 0; row < height; ++row)
                sum += spectrum.multiplicity(column) *
                       static_cast<double>(std::norm(spectrum.at(row, column)));
        }
        QCOMPARE(count, width); // every column of the whole spectrum, once
        const double area = static_cast<double>(size.area());
        TXN_AT_MOST(std::abs(sum / area - energy), 1e-5 * energy);
    }

    void threadsAndRunsGiveTheSameBytes_data() { addSizes(); }

    void threadsAndRunsGiveTheSameBytes() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const Image image = randomImage(size, 1, 4);
        const auto run = [&] {
            const RealFft2d fft(size);
            HalfSpectrum spectrum = fft.forward(image.plane(0));
            auto values = valuesOf(spectrum);
            Image back(size, 1);
            fft.inverse(std::move(spectrum), back.plane(0));
            return std::pair(std::move(values), std::move(back));
        };
        const auto one = onThreads(1, run);
        QVERIFY(onThreads(1, run) == one);
        QVERIFY(onThreads(2, run) == one);
    }

    void oneDimensionalPlans() {
        for (const int length : {1, 2, 5, 8, 12, 31}) {
            const auto n = static_cast<std::size_t>(length);
            TestRandom random(5);
            AlignedBuffer<float> in(n);
            AlignedBuffer<Complex> out(n / 2 + 1);
            DoublePlane plane;
            for (float& v : in.span()) {
                v = static_cast<float>(random.gaussian());
                plane.emplace_back(v);
            }
            const auto expected = naiveDft(plane, {length, 1});
            FftPlan::realForward(length).run(in.data(), out.data());
            for (std::size_t k = 0; k < out.size(); ++k)
                TXN_AT_MOST(std::abs(DoubleComplex(out[k]) - expected[k]), 1e-5);
            for (std::size_t i = 0; i < n; ++i)
                QVERIFY(static_cast<double>(in[i]) == plane[i].real()); // the input survives
            AlignedBuffer<float> back(n);
            FftPlan::realInverse(length).run(out.data(), back.data());
            for (std::size_t i = 0; i < n; ++i)
                TXN_AT_MOST(std::abs(static_cast<double>(back[i]) / length - plane[i].real()),
                            1e-5);

            // Columns side by side, each a sequence of its own.
            AlignedBuffer<Complex> lanes(n * FftPlan::kLanes);
            std::vector<DoublePlane> columns(FftPlan::kLanes, DoublePlane(n));
            for (std::size_t i = 0; i < lanes.size(); ++i) {
                lanes[i] = Complex(static_cast<float>(random.gaussian()),
                                   static_cast<float>(random.gaussian()));
                columns[i % FftPlan::kLanes][i / FftPlan::kLanes] = lanes[i];
            }
            for (const int sign : {-1, +1}) {
                AlignedBuffer<Complex> work(lanes.size());
                std::copy(lanes.span().begin(), lanes.span().end(), work.data());
                (sign < 0 ? FftPlan::columnsForward(length) : FftPlan::columnsInverse(length))
                    .run(work.data());
                for (std::size_t lane = 0; lane < columns.size(); ++lane) {
                    const auto column = naiveDft(columns[lane], {length, 1}, sign);
                    for (std::size_t k = 0; k < n; ++k)
                        TXN_AT_MOST(
                            std::abs(DoubleComplex(work[k * FftPlan::kLanes + lane]) - column[k]),
                            1e-5);
                }
            }
        }
    }

    void cosineTransformFollowsTheDefinition_data() { addSizes(); }

    void cosineTransformFollowsTheDefinition() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Size size{width, height};
        const Image image = randomImage(size, 1, 6);
        CosineTransform2d transform(size);
        std::copy(image.samples().begin(), image.samples().end(), transform.values().begin());
        transform.forward();
        // A few frequencies of the DCT-II, 4 sum u cos cos.
        TestRandom random(7);
        for (int i = 0; i < 12; ++i) {
            const int column = random.below(width);
            const int row = random.below(height);
            double sum = 0.0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x)
                    sum += 4.0 * static_cast<double>(image.at(x, y, 0)) *
                           std::cos(std::numbers::pi * (x + 0.5) * column / width) *
                           std::cos(std::numbers::pi * (y + 0.5) * row / height);
            }
            const auto k = static_cast<std::size_t>(row * width + column);
            TXN_AT_MOST(std::abs(static_cast<double>(transform.values()[k]) - sum),
                        1e-6 * static_cast<double>(size.area()) + 1e-5);
        }
        transform.inverse();
        TXN_AT_MOST(largestDifference(transform.values(), image.samples()), 2e-6);
        CosineTransform2d moved(std::move(transform));
        TXN_AT_MOST(largestDifference(moved.values(), image.samples()), 2e-6);
    }

    void lanesDoComplexArithmetic() {
        constexpr std::size_t kRows = 13;
        constexpr std::size_t kCount = kRows * FftPlan::kLanes;
        TestRandom random(8);
        const auto draw = [&](std::size_t count) {
            AlignedBuffer<Complex> values(count);
            for (Complex& v : values.span())
                v = Complex(static_cast<float>(random.gaussian()),
                            static_cast<float>(random.gaussian()));
            return values;
        };
        const auto near = [](Complex a, DoubleComplex b) {
            return std::abs(DoubleComplex(a) - b) <= 2e-6 * (1.0 + std::abs(b));
        };
        const auto a = draw(kCount);
        const auto b = draw(kCount);
        const auto factor = draw(kRows);
        const auto start = draw(kCount);
        const auto copyOf = [](const AlignedBuffer<Complex>& from) {
            AlignedBuffer<Complex> to(from.size());
            std::copy(from.span().begin(), from.span().end(), to.data());
            return to;
        };
        auto rows = draw(kCount);
        multiplyRows(a.data(), factor.data(), rows.data(), kRows);
        auto conjugate = copyOf(start);
        addRowsTimesConjugate(a.data(), factor.data(), conjugate.data(), kRows);
        auto sums = copyOf(start);
        addProducts(a.data(), b.data(), sums.data(), kCount);
        auto products = draw(kCount);
        multiply(a.data(), b.data(), products.data(), kCount);
        for (std::size_t i = 0; i < kCount; ++i) {
            const DoubleComplex x(a[i]);
            const DoubleComplex f(factor[i / FftPlan::kLanes]);
            QVERIFY(near(rows[i], x * f));
            QVERIFY(near(conjugate[i], DoubleComplex(start[i]) + x * std::conj(f)));
            QVERIFY(near(sums[i], DoubleComplex(start[i]) + x * DoubleComplex(b[i])));
            QVERIFY(near(products[i], x * DoubleComplex(b[i])));
        }

        constexpr int kChannels = 3;
        constexpr std::size_t kStride = 150; // more than one chunk of rotateTarget, and odd
        constexpr std::size_t kUsed = 141;
        const auto target = draw(kStride * kChannels);
        auto values = draw(kStride * kChannels);
        // No phase to be had: no signal, and one whose square underflows.
        for (std::size_t c = 0; c < kChannels; ++c) {
            values[c * kStride + 3] = Complex();
            values[c * kStride + 70] = Complex(1e-30F, -1e-30F);
        }
        AlignedBuffer<Complex> dot(kUsed);
        scalarProducts(target.data(), values.data(), kChannels, kStride, dot.data(), kUsed);
        const auto before = copyOf(values);
        rotateTarget(target.data(), dot.data(), values.data(), kChannels, kStride, kUsed);
        for (std::size_t i = 0; i < kUsed; ++i) {
            DoubleComplex product;
            for (std::size_t c = 0; c < kChannels; ++c)
                product += std::conj(DoubleComplex(target[c * kStride + i])) *
                           DoubleComplex(before[c * kStride + i]);
            QVERIFY(near(dot[i], product));
            const DoubleComplex phase =
                i == 3 || i == 70 ? DoubleComplex(1.0) : product / std::abs(product);
            for (std::size_t c = 0; c < kChannels; ++c) {
                const DoubleComplex expected = DoubleComplex(target[c * kStride + i]) * phase;
                TXN_AT_MOST(std::abs(DoubleComplex(values[c * kStride + i]) - expected),
                            1e-5 * (1.0 + std::abs(expected) / std::abs(phase)));
            }
        }
        // What lies behind the count stays.
        QVERIFY(values[kUsed] == before[kUsed]);
    }
};

QTEST_APPLESS_MAIN(TestFft)
#include "TestFft.moc"
