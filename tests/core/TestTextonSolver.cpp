// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/WhiteNoise.h"
#include "core/texton/RelativeModelError.h"
#include "core/texton/SpectralProjection.h"
#include "core/texton/TextonSolver.h"
#include "tests/helpers/Dft.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <limits>

using namespace txn;
using namespace txn::test;

namespace {

TextonParams
paramsFor(const Support& support, int order = 1, int iterations = 10, double momentum = 0.9) {
    TextonParams params;
    params.support = support;
    params.interpolationOrder = order;
    params.iterations = iterations;
    params.momentum = momentum;
    params.seed = {3};
    return params;
}

Texton solve(const GaussianModel& model, const TextonParams& params) {
    auto solver = TextonSolver::create(model, params);
    if (!solver)
        return {};
    while (!solver->done())
        solver->step();
    return solver->texton();
}

/// b^ at a frequency of the whole domain, by the definition of the DFT.
double bHat(int order, Size domain, int row, int column) {
    const auto factor = [&](int k, int length) {
        const auto b = bsplineAutocorrelation(order);
        double sum = b[0];
        for (std::size_t n = 1; n < b.size(); ++n)
            sum +=
                2.0 * b[n] * std::cos(2.0 * std::numbers::pi * static_cast<double>(n) * k / length);
        return sum;
    };
    return factor(row, domain.height) * factor(column, domain.width);
}

/// Whole spectra of the model: [channel][frequency].
std::vector<DoublePlane> spotSpectra(const GaussianModel& model) {
    std::vector<DoublePlane> spectra;
    for (int c = 0; c < model.channels(); ++c)
        spectra.push_back(wholeSpectrum(model.spot(c)));
    return spectra;
}

/// Coefficients padded with zeros to the domain, transformed.
std::vector<DoublePlane> paddedSpectra(const Image& coefficients, Size domain) {
    std::vector<DoublePlane> spectra;
    for (int c = 0; c < coefficients.channels(); ++c) {
        DoublePlane plane(domain.area());
        for (int y = 0; y < coefficients.height(); ++y) {
            for (int x = 0; x < coefficients.width(); ++x)
                plane[static_cast<std::size_t>(y * domain.width + x)] = coefficients.at(x, y, c);
        }
        spectra.push_back(naiveDft(plane, domain));
    }
    return spectra;
}

/// One projection by the book, in double precision on the whole domain: [TN17] algorithm 1.
std::vector<double>
naiveProjection(const GaussianModel& model, int order, const Image& guess, Size corner) {
    const Size domain = model.domain();
    auto target = spotSpectra(model);
    auto values = paddedSpectra(guess, domain);
    for (int row = 0; row < domain.height; ++row) {
        for (int column = 0; column < domain.width; ++column) {
            const auto k = static_cast<std::size_t>(row * domain.width + column);
            DoubleComplex product;
            for (std::size_t c = 0; c < target.size(); ++c) {
                target[c][k] /= std::sqrt(bHat(order, domain, row, column));
                product += std::conj(target[c][k]) * values[c][k];
            }
            const DoubleComplex phase =
                std::abs(product) > 0.0 ? product / std::abs(product) : DoubleComplex(1.0);
            for (std::size_t c = 0; c < target.size(); ++c)
                values[c][k] = target[c][k] * phase;
        }
    }
    std::vector<double> result;
    for (const DoublePlane& spectrum : values) {
        const auto plane = naiveDft(spectrum, domain, +1);
        for (int y = 0; y < corner.height; ++y) {
            for (int x = 0; x < corner.width; ++x)
                result.push_back(plane[static_cast<std::size_t>(y * domain.width + x)].real() /
                                 static_cast<double>(domain.area()));
        }
    }
    return result;
}

/// The formula of [SOT14] after equation 4, with the factor 2. Unweighted: with P and alpha^ in the
/// place of t_u^ and z, which is what the iteration makes smaller.
double naiveModelError(const GaussianModel& model, const Texton& texton, bool unweighted = false) {
    const Size domain = model.domain();
    const auto spot = spotSpectra(model);
    const auto values = paddedSpectra(texton.kernels.front(), domain);
    double numerator = 0.0;
    double denominator = 0.0;
    for (int row = 0; row < domain.height; ++row) {
        for (int column = row == 0 ? 1 : 0; column < domain.width; ++column) {
            const auto k = static_cast<std::size_t>(row * domain.width + column);
            const double b = bHat(texton.interpolationOrder, domain, row, column);
            const double weight = unweighted ? 1.0 / b : 1.0;
            DoubleComplex product;
            for (std::size_t c = 0; c < spot.size(); ++c) {
                numerator += weight * (std::norm(spot[c][k]) + b * std::norm(values[c][k]));
                denominator += weight * std::norm(spot[c][k]);
                product += std::conj(spot[c][k]) * values[c][k] * std::sqrt(b);
            }
            numerator -= 2.0 * weight * std::abs(product);
        }
    }
    return std::sqrt(std::max(numerator, 0.0) / denominator);
}

/// A texton as large as the domain whose spectrum is exactly what the solver looks for:
/// inverse DFT of t_u^ / sqrt(b^).
Texton perfectTexton(const GaussianModel& model, int order) {
    const Size domain = model.domain();
    Texton texton;
    texton.support = Support::rectangle(domain);
    texton.interpolationOrder = order;
    texton.mean = model.mean();
    texton.kernels.emplace_back(domain, model.channels());
    auto spectra = spotSpectra(model);
    for (int c = 0; c < model.channels(); ++c) {
        auto& spectrum = spectra[static_cast<std::size_t>(c)];
        for (int row = 0; row < domain.height; ++row) {
            for (int column = 0; column < domain.width; ++column)
                spectrum[static_cast<std::size_t>(row * domain.width + column)] /=
                    std::sqrt(bHat(order, domain, row, column));
        }
        const auto plane = naiveDft(spectrum, domain, +1);
        const auto out = texton.kernels[0].plane(c);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = static_cast<float>(plane[i].real() / static_cast<double>(domain.area()));
    }
    return texton;
}

Support cross() {
    std::vector<std::uint8_t> flags(11 * 9, 0);
    for (std::size_t i = 0; i < 11; ++i)
        flags[4 * 11 + i] = 1;
    for (std::size_t i = 0; i < 9; ++i)
        flags[i * 11 + 6] = 1;
    return *Support::mask({11, 9}, flags);
}

} // namespace

class TestTextonSolver : public QObject {
    Q_OBJECT

  private slots:
    void projectionEqualsTheNaiveOne_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("cornerWidth");
        QTest::addColumn<int>("cornerHeight");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("order");
        // Heights with many, few and no useful divisors; odd, even and prime widths.
        QTest::newRow("eighths") << 48 << 64 << 9 << 8 << 3 << 1;
        QTest::newRow("quarters") << 40 << 64 << 12 << 13 << 3 << 3;
        QTest::newRow("thirds") << 33 << 60 << 33 << 17 << 2 << 1;
        QTest::newRow("fifths of odd height") << 27 << 65 << 13 << 13 << 1 << 0;
        QTest::newRow("undivided") << 50 << 64 << 20 << 40 << 3 << 5;
        QTest::newRow("whole domain") << 24 << 18 << 24 << 18 << 3 << 1;
        QTest::newRow("prime") << 31 << 37 << 10 << 7 << 3 << 1;
        QTest::newRow("one row of coefficients") << 32 << 48 << 16 << 1 << 3 << 1;
        QTest::newRow("one column of coefficients") << 32 << 48 << 1 << 16 << 3 << 1;
        QTest::newRow("one row") << 53 << 1 << 11 << 1 << 3 << 3;
        QTest::newRow("one column") << 1 << 54 << 1 << 9 << 3 << 3;
        QTest::newRow("five channels") << 36 << 42 << 8 << 7 << 5 << 1;
        QTest::newRow("sixteen channels") << 30 << 32 << 6 << 6 << 16 << 1;
        QTest::newRow("smaller than the B-spline") << 3 << 2 << 2 << 2 << 2 << 5;
    }

    void projectionEqualsTheNaiveOne() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, cornerWidth);
        QFETCH(int, cornerHeight);
        QFETCH(int, channels);
        QFETCH(int, order);
        const Size corner{cornerWidth, cornerHeight};
        const GaussianModel model = texturedModel({width, height}, channels, 11);
        const SpectralProjection projection(model, order, corner);
        QCOMPARE(projection.channels(), channels);
        const auto scaled = [&](const Image& image) {
            std::vector<double> values;
            for (const float v : image.samples())
                values.push_back(static_cast<double>(v) * projection.scale());
            return values;
        };
        const Image guess = whiteNoise(corner, channels, {12});
        Image result(corner, channels);
        projection.project(guess, result);
        // Single precision, once: some 1e-7; phases of small scalar products a little more.
        TXN_AT_MOST(
            test::relativeError(scaled(result), naiveProjection(model, order, guess, corner)),
            5e-6);
        const Image wide = whiteNoise(model.domain(), channels, {13});
        TXN_AT_MOST(test::relativeError(scaled(projection.projectFromDomain(wide)),
                                        naiveProjection(model, order, wide, corner)),
                    5e-6);

        // The same pixels when the result takes the place of the argument.
        Image inPlace = guess;
        projection.project(inPlace, inPlace);
        QVERIFY(inPlace == result);
    }

    void modelErrorFollowsTheFormula_data() { projectionEqualsTheNaiveOne_data(); }

    void modelErrorFollowsTheFormula() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, cornerWidth);
        QFETCH(int, cornerHeight);
        QFETCH(int, channels);
        QFETCH(int, order);
        const GaussianModel model = texturedModel({width, height}, channels, 14);
        Texton texton = makeTexton({order, 1, {cornerWidth, cornerHeight}, channels, 15});
        // Near the right size: where every term of the formula matters.
        const auto scale =
            static_cast<float>(0.8 * std::sqrt(model.covariance().trace() / channels));
        for (float& v : texton.kernels[0].samples())
            v *= scale;
        const auto error = relativeModelError(model, texton);
        TXN_OK(error);
        const double expected = naiveModelError(model, texton);
        TXN_AT_MOST(std::abs(*error - expected), 2e-6 * std::max(1.0, expected));
    }

    void thePerfectTextonHasNoError_data() {
        QTest::addColumn<int>("order");
        for (const int order : {0, 1, 3, 5})
            QTest::addRow("order %d", order) << order;
    }

    void thePerfectTextonHasNoError() {
        QFETCH(int, order);
        const GaussianModel model = texturedModel({30, 25}, 3, 16);
        Texton texton = perfectTexton(model, order);
        // The square root of a difference of 1e-7 between sums of single precision values.
        constexpr double kTolerance = 1e-3;
        TXN_AT_MOST(*relativeModelError(model, texton), kTolerance);

        // Signs and circular shifts of all channels together are the same texture ...
        Texton moved = texton;
        for (int c = 0; c < 3; ++c) {
            for (int y = 0; y < 25; ++y) {
                for (int x = 0; x < 30; ++x)
                    moved.kernels[0].at((x + 7) % 30, (y + 4) % 25, c) =
                        -texton.kernels[0].at(x, y, c);
            }
        }
        TXN_AT_MOST(*relativeModelError(model, moved), kTolerance);
        // ... and of one channel alone they are not.
        for (float& v : moved.kernels[0].plane(1))
            v = -v;
        QVERIFY(*relativeModelError(model, moved) > 0.1);
        // A constant does not count: frequency 0 is left out.
        for (float& v : texton.kernels[0].samples())
            v += 0.01F;
        TXN_AT_MOST(*relativeModelError(model, texton), kTolerance);
    }

    void knownModelErrors() {
        const GaussianModel model = texturedModel({30, 25}, 3, 17);
        Texton texton = perfectTexton(model, 1);
        for (const double factor : {0.0, 0.5, 2.0}) {
            Texton scaled = texton;
            for (float& v : scaled.kernels[0].samples())
                v *= static_cast<float>(factor);
            // |1 - factor|: exact but for single precision sums; 1 for no texton at all.
            TXN_AT_MOST(std::abs(*relativeModelError(model, scaled) - std::abs(1.0 - factor)),
                        1e-5);
        }
    }

    void modelErrorHasNoUnits() {
        const Image image = texturedImage({32, 28}, 3, 18);
        const GaussianModel model(exemplarOf(image));
        const Texton texton = solve(model, paramsFor(Support::rectangle({9, 9}), 1, 3));
        const double expected = *relativeModelError(model, texton);
        for (const float factor : {1e-3F, 1e6F}) {
            Image scaledImage = image;
            for (float& v : scaledImage.samples())
                v *= factor;
            Texton scaledTexton = texton;
            for (float& v : scaledTexton.kernels[0].samples())
                v *= factor;
            const auto error =
                relativeModelError(GaussianModel(exemplarOf(scaledImage)), scaledTexton);
            TXN_OK(error);
            TXN_AT_MOST(std::abs(*error - expected), 1e-5); // rounding of the scaled samples
        }
    }

    void modelErrorRefusesWhatDoesNotFit() {
        const GaussianModel model = texturedModel({20, 12}, 3, 19);
        TXN_FAILS_WITH(relativeModelError(model, makeTexton({1, 2, {5, 5}, 3, 1})),
                       ErrorCode::Unsupported);
        TXN_FAILS_WITH(relativeModelError(model, makeTexton({1, 1, {5, 5}, 2, 1})),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(relativeModelError(model, makeTexton({1, 1, {5, 13}, 3, 1})),
                       ErrorCode::SizeMismatch);
        TXN_OK(relativeModelError(model, makeTexton({1, 1, {20, 12}, 3, 1})));
        const GaussianModel flat(exemplarOf(Image({8, 8}, 3, 0.5F)));
        TXN_FAILS_WITH(relativeModelError(flat, makeTexton({1, 1, {5, 5}, 3, 1})),
                       ErrorCode::Degenerate);
    }

    void plainIterationsNeverGetWorse_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("shape");
        for (const int order : {0, 1, 3, 5}) {
            for (const int shape : {0, 1, 2})
                QTest::addRow("order %d shape %d", order, shape) << order << shape;
        }
    }

    void plainIterationsNeverGetWorse() {
        QFETCH(int, order);
        QFETCH(int, shape);
        const Support support = shape == 0   ? Support::rectangle({12, 8})
                                : shape == 1 ? Support::disc(11)
                                             : cross();
        const GaussianModel model = texturedModel({30, 24}, 3, 20);
        auto solver = TextonSolver::create(model, paramsFor(support, order, 15, 0.0));
        TXN_OK(solver);
        double previous = std::numeric_limits<double>::infinity();
        double first = 0.0;
        while (!solver->done()) {
            solver->step();
            const double error = order == 0 ? solver->relativeModelError()
                                            : naiveModelError(model, solver->texton(), true);
            TXN_AT_MOST(error, previous + 1e-6); // the last digits of single precision
            previous = error;
            if (solver->iteration() == 1)
                first = error;
        }
        QVERIFY(previous < 0.99 * first);
    }

    void momentumGetsFurther_data() {
        QTest::addColumn<int>("order");
        for (const int order : {0, 1, 3})
            QTest::addRow("order %d", order) << order;
    }

    void momentumGetsFurther() {
        QFETCH(int, order);
        const GaussianModel model = texturedModel({96, 80}, 3, 21);
        const Support support = Support::rectangle({24, 24});
        const auto errorWith = [&](double momentum) {
            return *relativeModelError(model,
                                       solve(model, paramsFor(support, order, 30, momentum)));
        };
        QVERIFY(errorWith(0.9) < errorWith(0.0) - 0.001);
    }

    /// y = z + m (z - z_prev) from the fourth iteration on, spelled out with plain projections.
    void momentumIsWhatTheDesignSays() {
        const GaussianModel model = texturedModel({40, 33}, 2, 22);
        const Support support = Support::disc(9);
        const TextonParams params = paramsFor(support, 1, 8, 0.7);
        const SpectralProjection projection(model, 1, support.size());
        const auto cut = [&](Image image) {
            Texton texton;
            texton.kernels.push_back(std::move(image));
            return cutTo(std::move(texton), support).kernels.front();
        };
        Image next = cut(whiteNoise(support.size(), 2, params.seed));
        Image current = next;
        Image previous = next;
        for (int i = 1; i <= params.iterations; ++i) {
            previous = current;
            projection.project(next, current);
            current = cut(current);
            next = current;
            for (std::size_t k = 0; i >= 3 && k < next.samples().size(); ++k)
                next.samples()[k] += 0.7F * (current.samples()[k] - previous.samples()[k]);
        }
        std::vector<double> expected;
        for (const float v : current.samples())
            expected.push_back(static_cast<double>(v) * projection.scale());
        // The same operations in the same precision.
        TXN_AT_MOST(test::relativeError(solve(model, params).kernels[0].samples(), expected), 1e-6);
    }

    void stepsAreCounted() {
        const GaussianModel model = texturedModel({20, 20}, 1, 23);
        auto solver = TextonSolver::create(model, paramsFor(Support::rectangle({5, 5}), 1, 3));
        TXN_OK(solver);
        QCOMPARE(solver->iteration(), 0);
        QVERIFY(!solver->done());
        const Texton untouched = solver->texton();
        for (const float v : untouched.kernels[0].samples())
            QCOMPARE(v, 0.0F);
        for (int i = 1; i <= 3; ++i) {
            QVERIFY(!solver->done());
            solver->step();
            QCOMPARE(solver->iteration(), i);
        }
        QVERIFY(solver->done());
        const Texton texton = solver->texton();
        solver->step();
        QCOMPARE(solver->iteration(), 3);
        QVERIFY(solver->texton() == texton);
    }

    void textonCarriesWhatTheModelSays() {
        Image image = texturedImage({24, 20}, 2, 24);
        image.setTransfer(Transfer::Linear);
        const GaussianModel model(exemplarOf(image));
        const Texton texton = solve(model, paramsFor(Support::rectangle({7, 6}), 3));
        QCOMPARE(texton.kernelCount(), 1);
        QCOMPARE(texton.channels(), 2);
        QCOMPARE(texton.interpolationOrder, 3);
        QVERIFY(texton.mean == model.mean());
        QVERIFY(texton.transfer == Transfer::Linear);
        QVERIFY(texton.kernels[0].transfer() == Transfer::Linear);
        QCOMPARE(texton.kernels[0].size(), (Size{7, 6}));
        QCOMPARE(texton.frame(), 2);
        QCOMPARE(texton.footprint(), (Size{11, 10}));
        QCOMPARE(Texton::frameFor(0), 1);
        QCOMPARE(Texton::frameFor(1), 1);
        QCOMPARE(Texton::frameFor(5), 3);
    }

    void supportIsRespected_data() {
        QTest::addColumn<int>("shape");
        QTest::newRow("disc") << 0;
        QTest::newRow("even disc") << 1;
        QTest::newRow("mask") << 2;
    }

    void supportIsRespected() {
        QFETCH(int, shape);
        const Support support = shape == 0   ? Support::disc(11)
                                : shape == 1 ? Support::disc(10)
                                             : cross();
        const GaussianModel model = texturedModel({40, 32}, 3, 25);
        for (const bool wholeStart : {false, true}) {
            auto solver = TextonSolver::create(
                model,
                paramsFor(support, 1, 6),
                whiteNoise(wholeStart ? model.domain() : support.size(), 3, {4}));
            TXN_OK(solver);
            while (!solver->done())
                solver->step();
            const Image kernel = solver->texton().kernels.front();
            QCOMPARE(kernel.size(), support.size());
            for (int c = 0; c < 3; ++c) {
                for (int y = 0; y < kernel.height(); ++y) {
                    for (int x = 0; x < kernel.width(); ++x)
                        QCOMPARE(kernel.at(x, y, c) != 0.0F, support.contains(x, y));
                }
            }
        }
    }

    void discsFollowTheFormula() {
        for (int diameter = 1; diameter <= 20; ++diameter) {
            const Support disc = Support::disc(diameter);
            QCOMPARE(disc.size(), (Size{diameter, diameter}));
            for (int y = 0; y < diameter; ++y) {
                for (int x = 0; x < diameter; ++x) {
                    const double dx = x - 0.5 * (diameter - 1);
                    const double dy = y - 0.5 * (diameter - 1);
                    QCOMPARE(disc.contains(x, y), dx * dx + dy * dy <= 0.25 * diameter * diameter);
                }
            }
        }
    }

    void badMasksAreErrors() {
        TXN_FAILS_WITH(Support::mask({2, 2}, {0, 0, 0, 0}), ErrorCode::InvalidArgument);
        QVERIFY(*Support::mask({2, 1}, {0, 17}) == *Support::mask({2, 1}, {0, 1}));
        TXN_FAILS_WITH(Support::mask({2, 2}, {1, 0, 0}), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(Support::mask({0, 2}, {}), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(Support::mask({-1, -2}, {1, 1}), ErrorCode::InvalidArgument);
    }

    void badParametersAreErrors() {
        const GaussianModel model = texturedModel({20, 12}, 2, 26);
        const Support good = Support::rectangle({5, 5});
        const auto create = [&](const TextonParams& params) {
            return TextonSolver::create(model, params);
        };
        TXN_OK(create(paramsFor(Support::rectangle({20, 12}))));
        TXN_FAILS_WITH(create(paramsFor(Support::rectangle({21, 5}))), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(create(paramsFor(Support::disc(13))), ErrorCode::SizeMismatch);
        for (const int order : {-1, 2, 4, 6, 7})
            TXN_FAILS_WITH(create(paramsFor(good, order)), ErrorCode::InvalidArgument);
        for (const int iterations : {0, -1, 100001})
            TXN_FAILS_WITH(create(paramsFor(good, 1, iterations)), ErrorCode::InvalidArgument);
        for (const double momentum : {-0.1, 1.0, 1.5, std::numeric_limits<double>::quiet_NaN()})
            TXN_FAILS_WITH(create(paramsFor(good, 1, 5, momentum)), ErrorCode::InvalidArgument);
        for (const auto& [size, channels] :
             {std::pair{Size{20, 12}, 3}, {Size{12, 20}, 2}, {Size{5, 4}, 2}})
            TXN_FAILS_WITH(
                TextonSolver::create(model, paramsFor(good), whiteNoise(size, channels, {1})),
                ErrorCode::SizeMismatch);
    }

    void flatExemplarsAreErrors() {
        for (const float value : {0.0F, 0.3F, 1.0F, 255.0F, 1e6F}) {
            const GaussianModel flat(exemplarOf(Image({16, 12}, 3, value)));
            TXN_FAILS_WITH(TextonSolver::create(flat, paramsFor(Support::rectangle({4, 4}))),
                           ErrorCode::Degenerate);
        }
        // The least that 8 bits can show is texture.
        Image faint({16, 12}, 3, 1.0F);
        faint.at(3, 3, 1) = 254.0F / 255.0F;
        TXN_OK(TextonSolver::create(GaussianModel(exemplarOf(faint)),
                                    paramsFor(Support::rectangle({4, 4}))));
    }

    void threadsAndRunsGiveTheSameBytes_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("even") << 96 << 64;
        QTest::newRow("odd") << 75 << 45;
        QTest::newRow("prime") << 61 << 53;
    }

    void threadsAndRunsGiveTheSameBytes() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Exemplar exemplar = exemplarOf(texturedImage({width, height}, 3, 27));
        const auto run = [&] {
            return solve(GaussianModel(exemplar), paramsFor(Support::disc(16), 1, 12));
        };
        const Texton one = onThreads(1, run);
        QVERIFY(onThreads(1, run) == one);
        for (int i = 0; i < 3; ++i)
            QVERIFY(onThreads(2, run) == one);
        QCOMPARE(one.kernels.size(), std::size_t{1});
        QVERIFY(allFinite(one.kernels[0].samples()));
        TextonParams other = paramsFor(Support::disc(16), 1, 12);
        other.seed = {4};
        QVERIFY(!(solve(GaussianModel(exemplar), other) == one));
    }

    void scaledExemplarsGiveScaledTextons_data() {
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("tolerance");
        // Powers of two scale without rounding; others only as well as the samples are rounded.
        QTest::newRow("1024") << 1024.0 << 1e-7;
        QTest::newRow("1e-3") << 1e-3 << 1e-4;
        QTest::newRow("1e6") << 1e6 << 1e-4;
        QTest::newRow("1e-12") << 1e-12 << 1e-4;
        QTest::newRow("1e8") << 1e8 << 1e-4;
    }

    void scaledExemplarsGiveScaledTextons() {
        QFETCH(double, factor);
        QFETCH(double, tolerance);
        const Image image = texturedImage({40, 36}, 3, 28);
        Image scaled = image;
        for (float& v : scaled.samples())
            v = static_cast<float>(v * factor);
        const TextonParams params = paramsFor(Support::rectangle({9, 8}), 1, 10);
        const Texton plain = solve(GaussianModel(exemplarOf(image)), params);
        Texton large = solve(GaussianModel(exemplarOf(scaled)), params);
        QVERIFY(!large.kernels.empty());
        std::vector<double> values;
        for (const float v : large.kernels[0].samples())
            values.push_back(static_cast<double>(v) / factor);
        TXN_AT_MOST(test::relativeError(values, plain.kernels[0].samples()), tolerance);
        for (std::size_t c = 0; c < plain.mean.size(); ++c)
            TXN_AT_MOST(std::abs(large.mean[c] / factor - plain.mean[c]), 1e-6);
    }

    void offsetsOfTheExemplarDoNotMatter() {
        // Centred before the transform: a bright picture keeps its digits.
        const Image image = texturedImage({40, 36}, 2, 29);
        Image bright = image;
        for (float& v : bright.samples())
            v += 64.0F;
        const TextonParams params = paramsFor(Support::rectangle({9, 8}), 1, 5, 0.0);
        const Texton plain = solve(GaussianModel(exemplarOf(image)), params);
        const Texton shifted = solve(GaussianModel(exemplarOf(bright)), params);
        // Samples at 64 are rounded to 4e-6, of a contrast of 0.1: 2e-5, and some iterations.
        TXN_AT_MOST(test::relativeError(shifted.kernels[0].samples(), plain.kernels[0].samples()),
                    5e-4);
    }
};

QTEST_APPLESS_MAIN(TestTextonSolver)
#include "TestTextonSolver.moc"
