// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texton/ColorCorrection.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <Eigen/Eigenvalues>

using namespace txn;
using namespace txn::test;

namespace {

Eigen::MatrixXd covarianceOf(const Texton& texton) {
    const auto values = noiseCovariance(texton);
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), texton.channels(), texton.channels());
}

/// A random covariance of the given rank.
Eigen::MatrixXd randomCovariance(int channels, int rank, std::uint64_t seed) {
    TestRandom random(seed);
    Eigen::MatrixXd factor(channels, rank);
    for (int i = 0; i < channels; ++i) {
        for (int j = 0; j < rank; ++j)
            factor(i, j) = random.gaussian() + (i == j ? 2.0 : 0.0);
    }
    return factor * factor.transpose();
}

bool finite(const Texton& texton) {
    return std::all_of(texton.kernels.begin(), texton.kernels.end(), [](const Image& kernel) {
        return allFinite(kernel.samples());
    });
}

} // namespace

class TestColorCorrection : public QObject {
    Q_OBJECT

  private slots:
    void noiseCovarianceIsThePlainSum_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        for (const int order : {0, 1, 3, 5}) {
            for (const int kernels : {1, 3})
                QTest::addRow("order %d Q %d", order, kernels) << order << kernels;
        }
    }

    void noiseCovarianceIsThePlainSum() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        for (const Size size : {Size{9, 4}, Size{1, 1}, Size{1, 7}, Size{8, 1}}) {
            const Texton texton = makeTexton({order, kernels, size, 3, 1});
            const auto covariance = noiseCovariance(texton);
            QCOMPARE(covariance.size(), std::size_t{9});
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j)
                    TXN_AT_MOST(std::abs(covariance[static_cast<std::size_t>(3 * i + j)] -
                                         naiveCovariance(texton, i, j, 0, 0)),
                                1e-12);
            }
        }
    }

    void fullRankMeetsTheTarget_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        for (const int channels : {1, 2, 3, 5, 16})
            QTest::addRow("C %d", channels) << 1 << 1 << channels;
        QTest::newRow("several kernels") << 3 << 3 << 3;
        QTest::newRow("order 0") << 0 << 1 << 3;
    }

    void fullRankMeetsTheTarget() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        const Texton texton = makeTexton({order, kernels, {9, 7}, channels, 2});
        const Eigen::MatrixXd target = randomCovariance(channels, channels + 2, 3);
        const Texton corrected = colorCorrected(texton, target);
        // Coefficients are rounded to single precision.
        TXN_AT_MOST((covarianceOf(corrected) - target).norm(), 1e-5 * target.norm());
        QVERIFY(corrected.support == texton.support);
        QVERIFY(corrected.mean == texton.mean);
        QCOMPARE(corrected.kernelCount(), kernels);
        QCOMPARE(corrected.interpolationOrder, order);
        // Once is enough.
        const Texton twice = colorCorrected(corrected, target);
        TXN_AT_MOST(relativeError(twice.kernels[0].samples(), corrected.kernels[0].samples()),
                    1e-4);
    }

    /// beta = B^1/2 A^-1/2 alpha with symmetric roots, and no other matrix that would do, too.
    void matrixIsTheOneOfThePaper() {
        const Texton texton = makeTexton({1, 2, {9, 7}, 3, 4});
        const Eigen::MatrixXd target = randomCovariance(3, 5, 5);
        const Texton corrected = colorCorrected(texton, target);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> a(covarianceOf(texton));
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> b(target);
        const Eigen::MatrixXd matrix = b.operatorSqrt() * a.operatorInverseSqrt();
        for (std::size_t q = 0; q < 2; ++q) {
            for (std::size_t k = 0; k < 63; ++k) {
                for (int i = 0; i < 3; ++i) {
                    double expected = 0.0;
                    for (int j = 0; j < 3; ++j)
                        expected +=
                            matrix(i, j) * static_cast<double>(texton.kernels[q].plane(j)[k]);
                    TXN_AT_MOST(
                        std::abs(static_cast<double>(corrected.kernels[q].plane(i)[k]) - expected),
                        1e-6);
                }
            }
        }
    }

    void nothingToCorrectChangesNothing() {
        const Texton texton = makeTexton({1, 2, {9, 7}, 3, 6});
        const Texton corrected = colorCorrected(texton, covarianceOf(texton));
        TXN_AT_MOST(relativeError(corrected.kernels[0].samples(), texton.kernels[0].samples()),
                    1e-6);
    }

    void supportsStayEmptyOutside() {
        const Texton texton = cutTo(makeTexton({1, 1, {9, 9}, 3, 7}), Support::disc(9));
        const Texton corrected = colorCorrected(texton, randomCovariance(3, 3, 8));
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 9; ++x)
                QCOMPARE(corrected.kernels[0].at(x, y, 1) != 0.0F, texton.support.contains(x, y));
        }
    }

    void singularCovariancesStayInTheirRange_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("grey as RGB") << 0;
        QTest::newRow("black channel") << 1;
        QTest::newRow("proportional channels, rounded") << 2;
        QTest::newRow("nothing at all") << 3;
    }

    void singularCovariancesStayInTheirRange() {
        QFETCH(int, kind);
        Texton texton = makeTexton({1, 1, {9, 7}, 3, 9});
        Image& kernel = texton.kernels[0];
        for (std::size_t k = 0; k < kernel.plane(0).size(); ++k) {
            const float v = kernel.plane(0)[k];
            if (kind == 0) {
                kernel.plane(1)[k] = v;
                kernel.plane(2)[k] = v;
            } else if (kind == 1) {
                kernel.plane(1)[k] = 0.0F;
            } else if (kind == 2) {
                kernel.plane(1)[k] = 0.3F * v;
                kernel.plane(2)[k] = -0.7F * v;
            } else {
                kernel.plane(0)[k] = kernel.plane(1)[k] = kernel.plane(2)[k] = 0.0F;
            }
        }
        // A target in the same range: four times the covariance.
        const Eigen::MatrixXd own = covarianceOf(texton);
        const Texton doubled = colorCorrected(texton, 4.0 * own);
        QVERIFY(finite(doubled));
        for (std::size_t k = 0; k < kernel.samples().size(); ++k)
            TXN_AT_MOST(std::abs(static_cast<double>(doubled.kernels[0].samples()[k]) -
                                 2.0 * static_cast<double>(kernel.samples()[k])),
                        1e-6);
        // A target that asks for more than there is: nothing blows up.
        const Texton stretched = colorCorrected(texton, randomCovariance(3, 3, 10));
        QVERIFY(finite(stretched));
        double before = 0.0;
        double after = 0.0;
        for (std::size_t k = 0; k < kernel.samples().size(); ++k) {
            before = std::max(before, static_cast<double>(std::abs(kernel.samples()[k])));
            after =
                std::max(after, static_cast<double>(std::abs(stretched.kernels[0].samples()[k])));
        }
        TXN_AT_MOST(after, 20.0 * before);
        // And a singular target gives singular noise, from full rank.
        const Eigen::MatrixXd flat = randomCovariance(3, 1, 11);
        const Texton line = colorCorrected(makeTexton({1, 1, {9, 7}, 3, 12}), flat);
        TXN_AT_MOST((covarianceOf(line) - flat).norm(), 1e-5 * flat.norm());
        const Texton none = colorCorrected(texton, Eigen::MatrixXd::Zero(3, 3));
        for (const float v : none.kernels[0].samples())
            QVERIFY(v == 0.0F);
    }
};

QTEST_APPLESS_MAIN(TestColorCorrection)
#include "TestColorCorrection.moc"
