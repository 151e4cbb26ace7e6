// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/Lighting.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <limits>

using namespace txn;
using namespace txn::test;

class TestLighting : public QObject {
    Q_OBJECT

  private slots:
    /// A cosine that mirrors at the borders is scaled by 1 - exp(-(radius omega)^2 / 2).
    void responseIsThatOfTheBlur_data() {
        QTest::addColumn<int>("column");
        QTest::addColumn<int>("row");
        QTest::addColumn<double>("radius");
        QTest::newRow("slow across") << 1 << 0 << 8.0;
        QTest::newRow("slow down") << 0 << 1 << 8.0;
        QTest::newRow("both") << 2 << 3 << 6.0;
        QTest::newRow("fast") << 20 << 11 << 8.0;
        QTest::newRow("small radius") << 9 << 7 << 1.5;
    }

    void responseIsThatOfTheBlur() {
        QFETCH(int, column);
        QFETCH(int, row);
        QFETCH(double, radius);
        const Size size{60, 44};
        Image image(size, 2);
        Image expected(size, 2);
        const double omegaX = std::numbers::pi * column / size.width;
        const double omegaY = std::numbers::pi * row / size.height;
        const double kept =
            1.0 - std::exp(-0.5 * radius * radius * (omegaX * omegaX + omegaY * omegaY));
        for (int c = 0; c < 2; ++c) {
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const double wave =
                        0.2 * (1 + c) * std::cos(omegaX * (x + 0.5)) * std::cos(omegaY * (y + 0.5));
                    image.at(x, y, c) = static_cast<float>(0.5 + wave);
                    expected.at(x, y, c) = static_cast<float>(0.5 + kept * wave);
                }
            }
        }
        const auto result = flattenLighting(image, radius);
        TXN_OK(result);
        TXN_AT_MOST(largestDifference(result->samples(), expected.samples()), 1e-6);
    }

    void slopesGoAndTextureStays() {
        const Size size{96, 80};
        const Image texture = randomImage(size, 3, 1, 0.05);
        Image image = texture;
        for (int c = 0; c < 3; ++c) {
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x)
                    image.at(x, y, c) += static_cast<float>(0.005 * x - 0.003 * y + 0.1 * c);
            }
        }
        const auto result = flattenLighting(image, 10.0);
        TXN_OK(result);
        for (int c = 0; c < 3; ++c) {
            TXN_AT_MOST(std::abs(meanOf(result->plane(c)) - meanOf(image.plane(c))), 1e-6);
            // The slope had a variance of 0.0195, eight times the texture's. White noise loses
            // about 1 / (4 pi radius^2) of its variance; some of the slope's ends stay.
            double rest = 0.0;
            for (std::size_t i = 0; i < result->plane(c).size(); ++i) {
                const double d =
                    static_cast<double>(result->plane(c)[i]) - meanOf(result->plane(c)) -
                    (static_cast<double>(texture.plane(c)[i]) - meanOf(texture.plane(c)));
                rest += d * d / static_cast<double>(size.area());
            }
            TXN_AT_MOST(rest, 0.03 * varianceOf(image.plane(c)));
        }
    }

    void flatStaysFlat() {
        for (const Size size : {Size{1, 1}, Size{7, 1}, Size{1, 8}, Size{20, 15}}) {
            const Image image(size, 2, 0.37F, Transfer::Linear);
            const auto result = flattenLighting(image, 3.0);
            TXN_OK(result);
            QVERIFY(result->transfer() == Transfer::Linear);
            TXN_AT_MOST(largestDifference(result->samples(), image.samples()), 1e-7);
        }
    }

    void hugeRadiusLeavesThePicture() {
        const Image image = texturedImage({32, 24}, 1, 2);
        const auto result = flattenLighting(image, 1e6);
        TXN_OK(result);
        TXN_AT_MOST(largestDifference(result->samples(), image.samples()), 1e-6);
    }

    void badRadiiAreErrors() {
        const Image image({8, 8}, 1, 0.5F);
        for (const double radius : {0.0,
                                    -1.0,
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::infinity()})
            TXN_FAILS_WITH(flattenLighting(image, radius), ErrorCode::InvalidArgument);
    }
};

QTEST_APPLESS_MAIN(TestLighting)
#include "TestLighting.moc"
