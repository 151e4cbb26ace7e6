// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compute/ComputeTexton.h"
#include "core/gaussian/ChannelWeights.h"
#include "core/image/ImageGeometry.h"
#include "core/material/MapStack.h"
#include "core/material/NormalMap.h"
#include "core/qa/SupportSuggestion.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>

using namespace txn;
using namespace txn::test;

namespace {

/// The normals of the height h(x, y) = sin(a x + b y), y down, as a map with green up or down.
Image normalsOfWaves(Size size, double a, double b, bool yDown) {
    Image image(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double slope = std::cos(a * x + b * y);
            const double n[3] = {-slope * a, (yDown ? -1.0 : 1.0) * slope * b, 1.0};
            const double length = std::hypot(n[0], n[1], n[2]);
            for (int c = 0; c < 3; ++c)
                image.at(x, y, c) = static_cast<float>(0.5 + 0.5 * n[c] / length);
        }
    }
    return image;
}

MapPicture picture(std::string name, MapKind kind, Image image) {
    std::string file = name + ".png";
    return {std::move(name), kind, std::move(image), std::move(file)};
}

} // namespace

class TestMaterial : public QObject {
    Q_OBJECT

  private slots:
    void fileNamesTellWhatMapsAre_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("kind");
        const auto row = [](const char* file, MapKind kind) {
            QTest::newRow(file) << file << static_cast<int>(kind);
        };
        row("grass_basecolor.png", MapKind::Color);
        row("Grass001_1K_Color.jpg", MapKind::Color);
        row("rock-albedo.tif", MapKind::Color);
        row("MetalDiffuse.png", MapKind::Color);
        row("grass_normal.png", MapKind::Normal);
        row("Grass001_1K_NormalGL.jpg", MapKind::Normal);
        row("wall_nor_gl_2k.exr", MapKind::Normal);
        row("wall_nor_dx_2k.exr", MapKind::NormalYDown);
        row("Grass001_1K_NormalDX.jpg", MapKind::NormalYDown);
        row("Grass001_Displacement.png", MapKind::Height);
        row("sand_height.png", MapKind::Height);
        row("wall_rough_4k.png", MapKind::Roughness);
        row("Wall_AmbientOcclusion.png", MapKind::Occlusion);
        row("wall_ao.png", MapKind::Occlusion);
        row("wall_metallic.png", MapKind::Metalness);
        row("gingham_ao_rough_metal.png", MapKind::Packed);
        row("wall_arm_1k.png", MapKind::Packed);
        QTest::newRow("IMG_1234.jpg") << "IMG_1234.jpg" << -1;
        QTest::newRow("wood.png") << "wood.png" << -1;
    }
    void fileNamesTellWhatMapsAre() {
        QFETCH(QString, file);
        QFETCH(int, kind);
        const auto found = mapKindOfFileName(file.toStdString());
        QCOMPARE(found ? static_cast<int>(*found) : -1, kind);
    }

    void normalsAreSlopesAndBack_data() {
        QTest::addColumn<bool>("yDown");
        QTest::newRow("green up") << false;
        QTest::newRow("green down") << true;
    }
    void normalsAreSlopesAndBack() {
        QFETCH(bool, yDown);
        const Image normals = normalsOfWaves({24, 20}, 0.7, 0.4, yDown);
        const Image slopes = slopesOfNormals(normals, yDown);
        QCOMPARE(slopes.channels(), 2);
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 24; ++x) {
                const double wave = std::cos(0.7 * x + 0.4 * y);
                TXN_AT_MOST(std::abs(slopes.at(x, y, 0) - 0.7 * wave), 1e-5);
                TXN_AT_MOST(std::abs(slopes.at(x, y, 1) - 0.4 * wave), 1e-5);
            }
        }
        TXN_AT_MOST(imageDistance(normalsOfSlopes(slopes, yDown), normals), 1e-6);
    }

    void normalsThatLookAwayHaveNoInfiniteSlope() {
        Image normals(Size{4, 1}, 3, 0.5F); // of no length at all
        normals.at(0, 0, 2) = 0.0F;
        normals.at(1, 0, 0) = 1.0F;
        const Image slopes = slopesOfNormals(normals, false);
        for (const float v : slopes.samples())
            QVERIFY(std::abs(v) <= kSteepestSlope);
    }

    void turningAStackTurnsItsSlopes() {
        const auto stack = [](double a, double b) {
            return *stackMaps(
                {picture("normal", MapKind::Normal, normalsOfWaves({21, 21}, a, b, false))});
        };
        MapStack turned = stack(0.5, 0.2);
        turned.image = *rotated(turned.image, 90.0);
        turnSlopes(turned.image, turned.maps, 90.0);
        // The wave's slope (0.5, 0.2), y down, counter-clockwise by 90 degrees: (0.2, -0.5).
        double across = 0.0;
        double down = 0.0;
        double both = 0.0;
        for (std::size_t i = 0; i < turned.image.size().area(); ++i) {
            const double dx = turned.image.plane(0)[i];
            const double dy = turned.image.plane(1)[i];
            across += dx * dx;
            down += dy * dy;
            both += dx * dy;
        }
        TXN_AT_MOST(std::abs(both / across - (-0.5 / 0.2)), 1e-3);
        TXN_AT_MOST(std::abs(down / across - 0.25 / 0.04), 1e-2);
    }

    void stacksHoldTheirMaps() {
        const Image color = randomImage({12, 10}, 3, 1);
        const Image grey = randomImage({12, 10}, 1, 2);
        Image greyAsRgb(Size{12, 10}, 3, 0.0F, Transfer::Linear);
        for (int c = 0; c < 3; ++c)
            std::ranges::copy(grey.plane(0), greyAsRgb.plane(c).begin());
        const auto stack = stackMaps({picture("color", MapKind::Color, color),
                                      picture("height", MapKind::Height, greyAsRgb)});
        TXN_OK(stack);
        QCOMPARE(stack->image.channels(), 4);
        QVERIFY(stack->image.transfer() == Transfer::Encoded);
        TXN_AT_MOST(imageDistance(mapPicture(stack->image, stack->maps, 0), color), 0.0);
        TXN_AT_MOST(imageDistance(mapPicture(stack->image, stack->maps, 1), grey), 0.0);
        QVERIFY(channelNames(stack->maps) ==
                (std::vector<std::string>{"color.R", "color.G", "color.B", "height"}));
    }

    void mapsThatDoNotFitAreRefused() {
        const Image three = randomImage({12, 10}, 3, 1);
        TXN_FAILS_WITH(stackMaps({picture("color", MapKind::Color, three),
                                  picture("ao", MapKind::Occlusion, Image({12, 11}, 1))}),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(stackMaps({picture("height", MapKind::Height, three)}),
                       ErrorCode::Unsupported);
        TXN_FAILS_WITH(stackMaps({picture("normal", MapKind::Normal, Image({12, 10}, 1))}),
                       ErrorCode::Unsupported);
        TXN_FAILS_WITH(stackMaps({picture("x", MapKind::Data, Image({12, 10}, 9)),
                                  picture("y", MapKind::Data, Image({12, 10}, 8))}),
                       ErrorCode::Unsupported);
        TXN_FAILS_WITH(
            stackMaps({picture("x", MapKind::Data, three), picture("x", MapKind::Data, three)}),
            ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(stackMaps({}), ErrorCode::InvalidArgument);
        QVERIFY(!areMapsOf({{"n", MapKind::Normal, 1}}, 1));
        QVERIFY(!areMapsOf({{"a", MapKind::Data, 1}}, 1)); // would be read as transparency
        QVERIFY(!areMapsOf({{"x", MapKind::Data, 1}, {"x", MapKind::Data, 1}}, 2));
        QVERIFY(!areMapsOf({{"../x", MapKind::Data, 2}}, 2));
        QVERIFY(areMapsOf({{"x", MapKind::Data, 1}, {"n", MapKind::Normal, 2}}, 3));
        TXN_FAILS_WITH(makeExemplar(three, "x", {{"color", MapKind::Color, 1}}),
                       ErrorCode::SizeMismatch);
    }

    void channelsOfStacksCountAlike() {
        Image image = randomImage({64, 64}, 3, 1);
        std::ranges::transform(image.plane(0), image.plane(1).begin(), [](float v) {
            return 0.1F * v;
        });
        std::ranges::fill(image.plane(2), 0.25F);
        const MaterialMaps maps{{"x", MapKind::Data, 3}};
        const auto weights = channelWeights(*makeExemplar(image, "x", maps));
        TXN_AT_MOST(std::abs(weights[1] / weights[0] - 10.0), 1e-3);
        QCOMPARE(weights[2], 255.0); // constant: rounding is not to be blown up
        QVERIFY(channelWeights(*makeExemplar(image, "x")) == (std::vector<double>{1.0, 1.0, 1.0}));
        // And a texton of it is defined.
        const auto exemplar = *makeExemplar(image, "x", maps);
        ComputeParams params;
        params.support = Support::rectangle({12, 12});
        const auto computed = computeTexton(exemplar, GaussianModel(exemplar), params);
        TXN_OK(computed);
        for (const Image& kernel : computed->texton.kernels) {
            for (const float v : kernel.samples())
                QVERIFY(std::isfinite(v));
        }
    }

    void progressRunsFromTrialsToTheEnd() {
        const auto exemplar = exemplarOf(texturedImage({64, 48}, 3, 2));
        ComputeParams params;
        params.support = Support::rectangle({12, 12});
        double share = 0.0;
        bool choosing = true;
        bool inOrder = true;
        Texton last;
        const auto computed = computeTexton(exemplar,
                                            GaussianModel(exemplar),
                                            params,
                                            [&](const ComputeProgress& now) {
                                                inOrder = inOrder && now.share >= share &&
                                                          (choosing || !now.choosingKernels);
                                                share = now.share;
                                                choosing = now.choosingKernels;
                                                last = now.texton();
                                            });
        TXN_OK(computed);
        QVERIFY(inOrder && !choosing && share <= 1.0);
        QVERIFY(last == computed->texton);
        QCOMPARE(computed->trialErrors.size(), std::size_t{2});
        QVERIFY(!computed->relativeModelError);
        params.method = TextonMethod::Projections;
        QVERIFY(computeTexton(exemplar, GaussianModel(exemplar), params)->relativeModelError);
    }

    void supportsFollowTheCorrelation() {
        // Blurred noise: the wider the blur, the larger the support.
        const auto side = [](int blur) {
            const Image fine = randomImage({256, 256}, 1, 3);
            Image coarse(fine.size(), 1);
            for (int y = 0; y < 256; ++y) {
                for (int x = 0; x < 256; ++x)
                    coarse.at(x, y, 0) = fine.at(x / blur, y / blur, 0);
            }
            return *suggestSupport(exemplarOf(std::move(coarse)));
        };
        QCOMPARE(side(1).side, 16);
        QVERIFY(side(20).side > side(4).side);
        QVERIFY(side(20).error <= 0.2);
        TXN_FAILS_WITH(suggestSupport(exemplarOf(randomImage({31, 64}, 1, 3))),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(suggestSupport(exemplarOf(Image({64, 64}, 2, 0.5F))), ErrorCode::Degenerate);
    }
};

QTEST_APPLESS_MAIN(TestMaterial)
#include "TestMaterial.moc"
