// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/GaussianModel.h"
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

void addSizes() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto& [w, h] : {std::pair{1, 1},
                               {2, 2},
                               {1, 9},
                               {10, 1},
                               {16, 12},
                               {15, 16},
                               {13, 17},
                               {49, 31},
                               {64, 64}})
        QTest::addRow("%d x %d", w, h) << w << h;
}

/// Sum over the four neighbours of their difference to the pixel: all of them on a torus, or those
/// inside the image only.
double laplacian(const Image& image, int x, int y, int c, bool wrapped) {
    const int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    double sum = 0.0;
    for (const auto& step : steps) {
        int nx = x + step[0];
        int ny = y + step[1];
        const bool inside = nx >= 0 && ny >= 0 && nx < image.width() && ny < image.height();
        if (!inside && !wrapped)
            continue;
        nx = (nx + image.width()) % image.width();
        ny = (ny + image.height()) % image.height();
        sum += static_cast<double>(image.at(nx, ny, c)) - static_cast<double>(image.at(x, y, c));
    }
    return sum;
}

} // namespace

class TestPeriodicComponent : public QObject {
    Q_OBJECT

  private slots:
    /// The definition: Delta p on the torus = Delta_i u inside, and equal means.
    void laplacianLawHolds_data() { addSizes(); }

    void laplacianLawHolds() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Image image = texturedImage({width, height}, 2, 1);
        const Image periodic = periodicComponent(image);
        QCOMPARE(periodic.size(), image.size());
        QCOMPARE(periodic.channels(), 2);
        double worst = 0.0;
        for (int c = 0; c < 2; ++c) {
            TXN_AT_MOST(std::abs(meanOf(periodic.plane(c)) - meanOf(image.plane(c))), 1e-7);
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const double error = std::abs(laplacian(periodic, x, y, c, true) -
                                                  laplacian(image, x, y, c, false));
                    if (!(error <= worst))
                        worst = error;
                }
            }
        }
        TXN_AT_MOST(worst, 3e-6); // eight roundings of values of about 1/2
    }

    /// The rest is smooth: no Laplacian away from the border, where no jump feeds it.
    void restIsSmooth() {
        const Image image = texturedImage({40, 30}, 1, 2);
        const Image periodic = periodicComponent(image);
        Image smooth = image;
        for (std::size_t i = 0; i < smooth.samples().size(); ++i)
            smooth.samples()[i] -= periodic.samples()[i];
        QVERIFY(varianceOf(smooth.samples()) > 1e-5);
        for (int y = 1; y < 29; ++y) {
            for (int x = 1; x < 39; ++x)
                TXN_AT_MOST(std::abs(laplacian(smooth, x, y, 0, true)), 2e-6);
        }
    }

    void bordersThatMeetAreLeftAlone() {
        // Equal first and last rows and columns: no jump, nothing smooth to take away.
        Image image = randomImage({24, 18}, 3, 3);
        for (int c = 0; c < 3; ++c) {
            for (int y = 0; y < 18; ++y)
                image.at(23, y, c) = image.at(0, y, c);
            for (int x = 0; x < 24; ++x)
                image.at(x, 17, c) = image.at(x, 0, c);
        }
        TXN_AT_MOST(largestDifference(periodicComponent(image).samples(), image.samples()), 1e-6);
    }

    void slopesDisappear() {
        // A ramp is almost all jump: what is left varies far less.
        Image image({64, 48}, 1);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x)
                image.at(x, y, 0) = static_cast<float>(x) / 64.0F;
        }
        QVERIFY(varianceOf(periodicComponent(image).samples()) <
                0.02 * varianceOf(image.samples()));
        const Image constant({20, 14}, 2, 0.3F);
        TXN_AT_MOST(largestDifference(periodicComponent(constant).samples(), constant.samples()),
                    1e-7);
    }

    void largeOffsetsKeepTheDigits() {
        const Image image = texturedImage({40, 30}, 1, 4);
        Image bright = image;
        for (float& v : bright.samples())
            v += 1024.0F;
        const Image expected = periodicComponent(image);
        Image result = periodicComponent(bright);
        for (float& v : result.samples())
            v -= 1024.0F;
        // Samples near 1024 are rounded to 6e-5 on the way in and out.
        TXN_AT_MOST(largestDifference(result.samples(), expected.samples()), 2e-4);
    }

    void transferAndThreadsStay() {
        Image image = texturedImage({61, 53}, 3, 5);
        image.setTransfer(Transfer::Linear);
        const auto run = [&] { return periodicComponent(image); };
        const Image one = onThreads(1, run);
        QVERIFY(one.transfer() == Transfer::Linear);
        QVERIFY(onThreads(2, run) == one);
    }

    /// The model takes the short way through the Fourier domain to the same spot.
    void modelUsesThePeriodicComponent_data() { addSizes(); }

    void modelUsesThePeriodicComponent() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Image image = texturedImage({width, height}, 2, 6);
        const double area = static_cast<double>(image.size().area());
        for (const bool periodic : {true, false}) {
            const GaussianModel model(exemplarOf(image), periodic);
            const Image source = periodic ? periodicComponent(image) : image;
            QCOMPARE(model.domain(), image.size());
            for (int c = 0; c < 2; ++c) {
                const double mean = model.mean()[static_cast<std::size_t>(c)];
                TXN_AT_MOST(std::abs(mean - meanOf(image.plane(c))), 1e-12);
                DoublePlane spot;
                for (const float v : source.plane(c))
                    spot.emplace_back((static_cast<double>(v) - mean) / std::sqrt(area));
                const auto expected = naiveDft(spot, image.size());
                const auto actual = wholeSpectrum(model.spot(c));
                QVERIFY(model.spot(c).at(0, 0) == Complex());
                double largest = 0.0;
                for (std::size_t k = 1; k < actual.size(); ++k)
                    largest = std::max(largest, std::abs(actual[k] - expected[k]));
                TXN_AT_MOST(largest, 2e-6);
            }
            // Colour covariance: t_u t_u^T summed over the domain.
            for (int i = 0; i < 2; ++i) {
                for (int j = 0; j < 2; ++j) {
                    double sum = 0.0;
                    for (std::size_t k = 0; k < source.plane(0).size(); ++k)
                        sum += (static_cast<double>(source.plane(i)[k]) - meanOf(source.plane(i))) *
                               (static_cast<double>(source.plane(j)[k]) - meanOf(source.plane(j)));
                    TXN_AT_MOST(std::abs(model.covariance()(i, j) - sum / area), 1e-7);
                }
            }
        }
    }

    void seamsAreNoticed() {
        // White noise tiles: a jump is like any other. A slope does not.
        TXN_AT_MOST(std::abs(seamRatio(randomImage({64, 64}, 3, 7)) - 1.0), 0.1);
        QVERIFY(seamRatio(periodicComponent(texturedImage({64, 64}, 3, 8))) < 1.5);
        Image slope = randomImage({48, 40}, 1, 9, 0.001);
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 48; ++x)
                slope.at(x, y, 0) += 0.01F * static_cast<float>(x);
        }
        QVERIFY(seamRatio(slope) > 5.0);
        QCOMPARE(seamRatio(Image({8, 8}, 3, 0.4F)), 1.0);
        QCOMPARE(seamRatio(Image({1, 1}, 1, 0.4F)), 1.0);

        // By hand, 3 x 2: right neighbours 1, 1 | -2 and 0, 0 | 0; down 0, 1, 2 and back.
        Image image({3, 2}, 1);
        image.at(1, 0, 0) = 1.0F;
        image.at(2, 0, 0) = 2.0F;
        const double interior = (1.0 + 1.0 + 0.0 + 0.0 + 0.0 + 1.0 + 4.0) / 7.0;
        const double border = (4.0 + 0.0 + 0.0 + 1.0 + 4.0) / 5.0;
        TXN_AT_MOST(std::abs(seamRatio(image) - std::sqrt(border / interior)), 1e-12);
    }
};

QTEST_APPLESS_MAIN(TestPeriodicComponent)
#include "TestPeriodicComponent.moc"
