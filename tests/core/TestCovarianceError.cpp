// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"
#include "core/qa/CovarianceError.h"
#include "core/qa/KernelChoice.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

Exemplar noiseOf(const Texton& texton, Size size, std::uint32_t seed) {
    NoiseParams params;
    params.meanImpacts = 40.0;
    params.seed = Seed{seed};
    return exemplarOf(*NoiseGrid::create(texton, params, 1.0)->render({0, 0, size}));
}

/// Channels of noise of one smooth kernel, each with impulses of its own.
Exemplar independentChannels(Size size, int channels) {
    TextonRecipe recipe;
    recipe.channels = 1;
    recipe.offset = 1.0;
    const Texton texton = makeTexton(recipe);
    Image image(size, channels);
    for (int c = 0; c < channels; ++c) {
        const auto one = noiseOf(texton, size, static_cast<std::uint32_t>(c + 1));
        std::ranges::copy(one.image.plane(0), image.plane(c).begin());
    }
    return exemplarOf(std::move(image));
}

Texton truth(int kernels, int channels) {
    TextonRecipe recipe;
    recipe.kernels = kernels;
    recipe.channels = channels;
    recipe.size = {11, 11};
    return makeTexton(recipe);
}

} // namespace

class TestCovarianceError : public QObject {
    Q_OBJECT

  private slots:
    /// The texton that a picture was made of is as far from it as the picture's halves are from its
    /// whole, give or take what two measurements differ by.
    void theTrueTextonIsAtTheFloor_data() {
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::newRow("grey") << 1 << 1;
        QTest::newRow("colour") << 2 << 3;
    }
    void theTrueTextonIsAtTheFloor() {
        QFETCH(int, kernels);
        QFETCH(int, channels);
        const Texton texton = truth(kernels, channels);
        double errors = 0.0;
        double floors = 0.0;
        for (std::uint32_t seed = 1; seed <= 6; ++seed) {
            const auto dial = covarianceError(noiseOf(texton, {200, 180}, seed), texton);
            TXN_OK(dial);
            QCOMPARE(dial->lag, 5);
            errors += dial->error;
            floors += dial->floor;
        }
        TXN_AT_MOST(errors, 1.5 * floors);
        TXN_AT_MOST(floors, 1.5 * errors);
    }

    void nothingIsFurtherThanNoTexture() {
        const Texton texton = truth(1, 2);
        Texton none = texton;
        for (float& v : none.kernels.front().samples())
            v = 0.0F;
        const auto dial = covarianceError(noiseOf(texton, {64, 64}, 3), none);
        TXN_OK(dial);
        TXN_AT_MOST(std::abs(dial->error - 1.0), 1e-12);
    }

    void equalHalvesHaveNoFloor() {
        const Image tile = texturedImage({24, 24}, 2, 4);
        Image four({48, 48}, 2);
        for (int c = 0; c < 2; ++c) {
            for (int y = 0; y < 48; ++y) {
                for (int x = 0; x < 48; ++x)
                    four.at(x, y, c) = tile.at(x % 24, y % 24, c);
            }
        }
        const auto dial = covarianceError(exemplarOf(std::move(four)), truth(1, 2));
        TXN_OK(dial);
        TXN_AT_MOST(dial->floor, 1e-9);
    }

    void smallExemplarsLookLessFar() {
        TextonRecipe recipe;
        recipe.size = {32, 32};
        recipe.channels = 1;
        const auto dial =
            covarianceError(exemplarOf(texturedImage({40, 20}, 1, 2)), makeTexton(recipe));
        TXN_OK(dial);
        QCOMPARE(dial->lag, 9);
    }

    void whatDoesNotFitSaysWhy() {
        const Texton texton = truth(1, 2);
        TXN_FAILS_WITH(covarianceError(exemplarOf(texturedImage({30, 30}, 3, 1)), texton),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(covarianceError(exemplarOf(texturedImage({30, 3}, 2, 1)), texton),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(covarianceError(exemplarOf(Image({30, 30}, 2, 0.5F)), texton),
                       ErrorCode::Degenerate);
    }

    void oneKernelIsEnoughForOneChannel() {
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        const auto chosen = chooseKernels(noiseOf(truth(1, 1), {160, 120}, 1), true, params);
        TXN_OK(chosen);
        QCOMPARE(chosen->kernels, 1);
    }

    void independentChannelsNeedTwo() {
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        for (const Size size : {Size{160, 120}, Size{120, 160}}) {
            const auto chosen = chooseKernels(independentChannels(size, 3), true, params);
            TXN_OK(chosen);
            QCOMPARE(chosen->kernels, 2);
        }
    }

    void stacksMayNeedMore() {
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        const auto chosen = chooseKernels(independentChannels({160, 120}, 6), true, params);
        TXN_OK(chosen);
        QVERIFY(chosen->kernels >= 3);
        QCOMPARE(chosen->errors.size(), std::size_t{4});
    }

    void withoutAHalfToTryOnItIsOne() {
        LeastSquaresParams params;
        params.support = Support::rectangle({20, 20});
        const auto chosen = chooseKernels(exemplarOf(randomImage({36, 30}, 2, 5)), true, params);
        TXN_OK(chosen);
        QCOMPARE(chosen->kernels, 1);
    }

    void choosingCanBeCancelled() {
        LeastSquaresParams params;
        params.support = Support::rectangle({16, 16});
        int calls = 0;
        CancelSource source;
        const auto chosen = chooseKernels(
            exemplarOf(randomImage({160, 120}, 2, 5)),
            true,
            params,
            [&](int kernels, const TextonProgress&) {
                calls += kernels; // of the first trial
                if (calls == 5)
                    source.cancel();
            },
            source.token());
        TXN_FAILS_WITH(chosen, ErrorCode::Cancelled);
        QCOMPARE(calls, 5);
    }
};

QTEST_APPLESS_MAIN(TestCovarianceError)
#include "TestCovarianceError.moc"
