// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compute/MixSolver.h"
#include "core/qa/Autocovariance.h"
#include "core/texton/TextonSolver.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <set>

using namespace txn;
using namespace txn::test;

namespace {

constexpr Size kSize{48, 40};

Exemplar exemplarA() {
    return exemplarOf(texturedImage(kSize, 3, 1));
}

/// Other waves and colours.
Exemplar exemplarB() {
    Image image = texturedImage(kSize, 3, 2);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y, 0) += static_cast<float>(0.2 * std::sin(0.4 * x - 1.1 * y));
            image.at(x, y, 2) -= 0.15F;
        }
    }
    return exemplarOf(std::move(image));
}

ComputeParams paramsOf(TextonMethod method, int kernels = 1) {
    ComputeParams params;
    params.method = method;
    params.support = Support::rectangle({12, 12});
    params.kernels = kernels;
    params.iterations = 40;
    return params;
}

Result<MixSolver> solverFor(const ComputeParams& params, int textons, MixedTextons known = {}) {
    const Exemplar a = exemplarA();
    const Exemplar b = exemplarB();
    return makeMixSolver({a, b, true, true, params, textons}, std::move(known));
}

MixedTextons finished(MixSolver solver) {
    while (!solver.done()) {
        if (!solver.step())
            return {};
    }
    return solver.result();
}

/// How far the noise of a texton is from the model, over all lags up to four, relative.
double covarianceError(const Texton& texton, const GaussianModel& model) {
    const Image white = [&] { // the texture itself, as one spot
        Image spot(model.domain(), model.channels());
        const RealFft2d fft(model.domain());
        for (int c = 0; c < model.channels(); ++c) {
            HalfSpectrum copy(model.domain());
            for (int b = 0; b < copy.blocks(); ++b)
                std::ranges::copy(model.spot(c).block(b), copy.block(b).begin());
            fft.inverse(std::move(copy), spot.plane(c));
        }
        return spot;
    }();
    // Circular sums are what the model means.
    const auto actual = autocovariance(texton, 4);
    double difference = 0.0;
    double norm = 0.0;
    for (int dy = -4; dy <= 4; ++dy) {
        for (int dx = -4; dx <= 4; ++dx) {
            for (int i = 0; i < model.channels(); ++i) {
                for (int j = 0; j < model.channels(); ++j) {
                    double target = 0.0;
                    for (int y = 0; y < white.height(); ++y) {
                        for (int x = 0; x < white.width(); ++x)
                            target += static_cast<double>(
                                          white.at((x + dx + white.width()) % white.width(),
                                                   (y + dy + white.height()) % white.height(),
                                                   i)) *
                                      static_cast<double>(white.at(x, y, j));
                    }
                    difference += std::pow(actual.at(i, j, dx, dy) - target, 2);
                    norm += target * target;
                }
            }
        }
    }
    return std::sqrt(difference / norm);
}

double distanceOf(const Texton& a, const Texton& b) {
    double difference = 0.0;
    double norm = 0.0;
    for (std::size_t q = 0; q < a.kernels.size(); ++q) {
        for (std::size_t i = 0; i < a.kernels[q].samples().size(); ++i) {
            const auto x = static_cast<double>(a.kernels[q].samples()[i]);
            const auto y = static_cast<double>(b.kernels[q].samples()[i]);
            difference += (x - y) * (x - y);
            norm += x * x;
        }
    }
    return std::sqrt(difference / norm);
}

void addMethods() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("kernels");
    QTest::newRow("projections") << static_cast<int>(TextonMethod::Projections) << 1;
    QTest::newRow("fit, one kernel") << static_cast<int>(TextonMethod::Fit) << 1;
    QTest::newRow("fit, two kernels") << static_cast<int>(TextonMethod::Fit) << 2;
}

ComputeParams fetchedParams() {
    QFETCH(int, method);
    QFETCH(int, kernels);
    return paramsOf(static_cast<TextonMethod>(method), kernels);
}

} // namespace

class TestMixSolver : public QObject {
    Q_OBJECT

  private slots:
    void everyTextonIsItsBarycentres_data() { addMethods(); }
    void everyTextonIsItsBarycentres() {
        const ComputeParams params = fetchedParams();
        auto solver = solverFor(params, 7);
        TXN_OK(solver);
        const auto path = BarycentrePath::create(exemplarA(), exemplarB());
        const auto mixed = finished(std::move(*solver));
        QCOMPARE(mixed.textons.size(), std::size_t{7});
        // No further off than textons of one exemplar are.
        double limit = 0.0;
        for (const double end : {0.0, 1.0}) {
            const auto alone = computeTexton(exemplarA(), path->at(end), params);
            limit = std::max(limit, 1.2 * covarianceError(alone->texton, path->at(end)));
        }
        TXN_AT_MOST(limit, 0.7);
        for (std::size_t r = 0; r < 7; ++r) {
            const MixedTexton& one = mixed.textons[r];
            TXN_AT_MOST(std::abs(one.rho - static_cast<double>(r) / 6.0), 1e-12);
            const GaussianModel model = path->at(one.rho);
            TXN_AT_MOST(largestDifference(one.texton.mean, model.mean()), 1e-9);
            QCOMPARE(one.texton.kernelCount(), *params.kernels);
            TXN_AT_MOST(covarianceError(one.texton, model), limit);
            // Colour correction makes it exact without a lag.
            const auto covariance = noiseCovariance(one.texton);
            for (int c = 0; c < 3; ++c)
                TXN_AT_MOST(std::abs(covariance[static_cast<std::size_t>(4 * c)] /
                                         model.covariance()(c, c) -
                                     1.0),
                            1e-3);
            TXN_AT_MOST(std::abs(one.distance - one.rho * path->distance()),
                        1e-5 * path->distance());
            QVERIFY(one.error > 0.0 && one.error < 1.0);
        }
    }

    void endsAreNoWorseThanAlone() {
        const ComputeParams params = paramsOf(TextonMethod::Fit, 2);
        const auto mixed = finished(*solverFor(params, 3));
        const GaussianModel a(exemplarA());
        const GaussianModel b(exemplarB());
        const auto aloneA = computeTexton(exemplarA(), a, params);
        const auto aloneB = computeTexton(exemplarB(), b, params);
        TXN_AT_MOST(mixed.textons.front().error, 1.1 * aloneA->error);
        TXN_AT_MOST(mixed.textons.back().error, 1.1 * aloneB->error);
    }

    void projectionsStartFromOneNoise() {
        const ComputeParams params = paramsOf(TextonMethod::Projections);
        const auto mixed = finished(*solverFor(params, 4));
        const auto path = BarycentrePath::create(exemplarA(), exemplarB());
        for (const MixedTexton& one : mixed.textons) {
            const auto alone = computeTexton(exemplarA(), path->at(one.rho), params);
            QVERIFY(alone->texton == one.texton);
        }
    }

    void kernelsChangeGradually() {
        const auto mixed = finished(*solverFor(paramsOf(TextonMethod::Fit, 2), 21));
        const double whole = distanceOf(mixed.textons.front().texton, mixed.textons.back().texton);
        for (std::size_t r = 1; r < mixed.textons.size(); ++r)
            TXN_AT_MOST(distanceOf(mixed.textons[r - 1].texton, mixed.textons[r].texton),
                        0.35 * whole);
    }

    void aTextonDependsOnItsRhoOnly_data() { addMethods(); }
    void aTextonDependsOnItsRhoOnly() {
        const ComputeParams params = fetchedParams();
        const auto few = finished(*solverFor(params, 3));
        const auto many = finished(*solverFor(params, 9));
        for (std::size_t r = 0; r < 3; ++r)
            QVERIFY(few.textons[r].texton == many.textons[4 * r].texton);
    }

    void knownTextonsAreTakenOver_data() { addMethods(); }
    void knownTextonsAreTakenOver() {
        const ComputeParams params = fetchedParams();
        const auto few = finished(*solverFor(params, 5));
        const auto fresh = finished(*solverFor(params, 9));
        auto solver = solverFor(params, 9, few);
        QCOMPARE(solver->result().textons.size(), std::size_t{5});
        int steps = 0;
        while (!solver->done()) {
            TXN_OK(solver->step());
            ++steps;
        }
        QVERIFY(steps <= 4);
        const auto& found = solver->result();
        QCOMPARE(found.textons.size(), fresh.textons.size());
        for (std::size_t r = 0; r < 9; ++r) {
            QVERIFY(found.textons[r].texton == fresh.textons[r].texton);
            TXN_AT_MOST(std::abs(found.textons[r].rho - fresh.textons[r].rho), 1e-12);
        }
        // And fewer of them need no work at all.
        auto less = solverFor(params, 3, found);
        QVERIFY(less->done());
        QCOMPARE(less->result().textons.size(), std::size_t{3});
        TXN_AT_MOST(std::abs(less->share() - 1.0), 0.0);
    }

    void stepsTellWhatIsDone_data() { addMethods(); }
    void stepsTellWhatIsDone() {
        auto solver = solverFor(fetchedParams(), 6);
        double share = solver->share();
        std::size_t count = 0;
        TXN_AT_MOST(share, 0.0);
        while (!solver->done()) {
            TXN_OK(solver->step());
            QVERIFY(solver->share() > share);
            share = solver->share();
            QVERIFY(solver->result().textons.size() >= count);
            count = solver->result().textons.size();
            QVERIFY(std::ranges::is_sorted(solver->result().textons, {}, &MixedTexton::rho));
        }
        QCOMPARE(count, std::size_t{6});
        TXN_OK(solver->step()); // nothing
    }

    void threadsDoNotMatter_data() { addMethods(); }
    void threadsDoNotMatter() {
        const ComputeParams params = fetchedParams();
        const auto run = [&](int threads) {
            return onThreads(threads, [&] { return finished(*solverFor(params, 5)); });
        };
        const auto one = run(1);
        const auto four = run(4);
        for (std::size_t r = 0; r < 5; ++r)
            QVERIFY(one.textons[r].texton == four.textons[r].texton);
    }

    void cancellingStopsAndMayGoOn_data() { addMethods(); }
    void cancellingStopsAndMayGoOn() {
        auto solver = solverFor(fetchedParams(), 3);
        // One texton, however many cores there are.
        TXN_OK(onThreads(1, [&] { return solver->step(); }));
        CancelSource source;
        source.cancel();
        TXN_FAILS_WITH(solver->step(source.token()), ErrorCode::Cancelled);
        const auto mixed = finished(std::move(*solver));
        QCOMPARE(mixed.textons.size(), std::size_t{3});
    }

    void kernelsSuitBoth() {
        ComputeParams params = paramsOf(TextonMethod::Fit);
        params.kernels.reset();
        const auto mixed = finished(*solverFor(params, 2));
        QCOMPARE(mixed.textons.size(), std::size_t{2});
        QCOMPARE(mixed.textons[0].texton.kernelCount(), mixed.textons[1].texton.kernelCount());
    }

    void badInputIsRefused() {
        for (const int textons : {-1, 0, 1, 65})
            TXN_FAILS_WITH(solverFor(paramsOf(TextonMethod::Fit), textons),
                           ErrorCode::InvalidArgument);
        ComputeParams large = paramsOf(TextonMethod::Fit);
        large.support = Support::rectangle({60, 20});
        TXN_FAILS_WITH(solverFor(large, 3)->step(), ErrorCode::SizeMismatch);
        const Exemplar a = exemplarA();
        const Exemplar flat = exemplarOf(Image(kSize, 3, 0.5F));
        TXN_FAILS_WITH(makeMixSolver({a, flat, true, true, paramsOf(TextonMethod::Fit), 3}),
                       ErrorCode::Degenerate);
        ComputeParams any = paramsOf(TextonMethod::Fit);
        any.kernels.reset(); // trials come after the checks
        TXN_FAILS_WITH(makeMixSolver({flat, a, true, true, any, 3}), ErrorCode::Degenerate);
    }
};

QTEST_APPLESS_MAIN(TestMixSolver)
#include "TestMixSolver.moc"
