// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mixing/TextonField.h"
#include "core/noise/NoiseGrid.h"
#include "core/noise/SpotNoise.h"
#include "core/spectral/BSpline.h"
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

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Textons that are easily told apart, and whose means differ much.
std::vector<Texton> textonsOf(int count, int order = 1, int kernels = 1, Size size = {9, 7}) {
    std::vector<Texton> textons;
    for (int r = 0; r < count; ++r) {
        Texton texton = makeTexton({order, kernels, size, 3, static_cast<std::uint64_t>(r + 1)});
        for (std::size_t c = 0; c < 3; ++c)
            texton.mean[c] += 0.3 * r * (c == 1 ? -1.0 : 1.0);
        textons.push_back(std::move(texton));
    }
    return textons;
}

MixingMap mapOf(Image rho, MapPlacement placement, MapBoundary boundary = MapBoundary::Clamp) {
    MixingMap map;
    map.rho = std::move(rho);
    map.placement = placement;
    map.boundary = boundary;
    return map;
}

/// Uneven values, among them 0 and 1.
Image roughMap(Size size, std::uint64_t seed) {
    TestRandom random(seed);
    Image rho(size, 1);
    for (float& v : rho.samples())
        v = static_cast<float>(std::clamp(random.uniform(-0.2, 1.2), 0.0, 1.0));
    return rho;
}

NoiseParams paramsOf(NoiseProcess process, double meanImpacts = 7.3, std::uint32_t seed = 5) {
    return {process, meanImpacts, {seed}, std::nullopt};
}

/// What the map says at a place, by its definition.
double rhoAt(const MixingMap& map, double x, double y) {
    const auto index = [&](double at, double start, double length, int count) {
        auto i = static_cast<long>(std::floor((at - start) / length * count));
        if (map.boundary == MapBoundary::Repeat)
            return static_cast<int>(((i % count) + count) % count);
        return static_cast<int>(std::clamp(i, 0L, count - 1L));
    };
    const MapPlacement& p = map.placement;
    return static_cast<double>(map.rho.at(index(x, p.left, p.width, map.rho.width()),
                                          index(y, p.top, p.height, map.rho.height()),
                                          0));
}

/// The noise of a mixture without its mean, written down once more.
double
naiveSum(const Mixture& mixture, const NoiseParams& params, int channel, double x, double y) {
    const Texton& first = mixture.textons.front();
    const Size footprint = first.footprint();
    const ImpulseProcess impulses(params, footprint, first.kernelCount());
    const double start = first.frame() + 0.5;
    const auto last = static_cast<double>(mixture.textons.size() - 1);
    double sum = 0.0;
    impulses.visit(
        x - 2.0 * footprint.width,
        y - 2.0 * footprint.height,
        x + footprint.width,
        y + footprint.height,
        [&](const Impulse& j) {
            const double rho =
                rhoAt(mixture.map, j.x + 0.5 * footprint.width, j.y + 0.5 * footprint.height);
            const double position = std::round(1024.0 * rho * last) / 1024.0;
            double r = std::floor(position);
            if (j.choice < 1024.0 * (position - r))
                r += 1.0;
            const Image& kernel = mixture.textons[static_cast<std::size_t>(r)]
                                      .kernels[static_cast<std::size_t>(j.kernel)];
            for (int ky = 0; ky < kernel.height(); ++ky) {
                const double wy = bspline(first.interpolationOrder, y - (j.y + start + ky));
                for (int kx = 0; kx < kernel.width() && wy != 0.0; ++kx)
                    sum += static_cast<double>(j.sign) * wy *
                           bspline(first.interpolationOrder, x - (j.x + start + kx)) *
                           static_cast<double>(kernel.at(kx, ky, channel));
            }
        });
    return sum / std::sqrt(impulses.intensity() / first.kernelCount());
}

std::vector<double> means(const TextonField& field, std::vector<double> xs, double y) {
    std::vector<float> out(xs.size());
    field.meanPositions(xs, std::span(&y, 1), out);
    return {out.begin(), out.end()};
}

} // namespace

class TestMixing : public QObject {
    Q_OBJECT

  private slots:
    void everyTextonHasItsOwnRho() {
        for (int textons = 2; textons <= TextonField::kMaxTextons; ++textons) {
            for (int r = 0; r < textons; ++r) {
                const auto rho = static_cast<float>(static_cast<double>(r) / (textons - 1));
                const TextonField field(mapOf(Image({2, 2}, 1, rho), {0, 0, 10, 10}),
                                        textons,
                                        {9, 9});
                QVERIFY(field.isConstant());
                for (const std::uint32_t choice : {0U, 511U, 1023U})
                    QCOMPARE(field.textonAt(3.0, 4.0, choice), r);
            }
        }
    }

    void placesBetweenTakeBothInProportion() {
        for (const double rho : {0.1, 0.5, 0.77}) {
            const TextonField field(mapOf(Image({1, 1}, 1, static_cast<float>(rho)), {}),
                                    8,
                                    {9, 9});
            QVERIFY(!field.isConstant());
            int sum = 0;
            for (std::uint32_t choice = 0; choice < 1024; ++choice) {
                const int r = field.textonAt(0.0, 0.0, choice);
                QVERIFY(r == static_cast<int>(rho * 7) || r == static_cast<int>(rho * 7) + 1);
                sum += r;
            }
            TXN_AT_MOST(std::abs(sum / 1024.0 - 7.0 * rho), 0.5 / 1024.0 + 1e-6);
        }
    }

    void choicesAreEven() {
        const ImpulseProcess impulses(paramsOf(NoiseProcess::Stratified), {9, 9}, 3);
        double sum = 0.0;
        double square = 0.0;
        double withKernel = 0.0;
        int count = 0;
        impulses.visit(0, 0, 600, 600, [&](const Impulse& j) {
            QVERIFY(j.choice < 1024);
            const double v = (j.choice + 0.5) / 1024.0 - 0.5;
            sum += v;
            square += v * v;
            withKernel += v * (j.kernel - 1) * static_cast<double>(j.sign);
            ++count;
        });
        TXN_AT_MOST(std::abs(sum / count), 5.0 * std::sqrt(1.0 / 12.0 / count));
        TXN_AT_MOST(std::abs(square / count - 1.0 / 12.0), 5.0 * 0.075 / std::sqrt(count));
        TXN_AT_MOST(std::abs(withKernel / count), 5.0 * std::sqrt(1.0 / 18.0 / count));
    }

    void mapsEndOrRepeat() {
        Image rho({3, 2}, 1);
        for (int i = 0; i < 6; ++i)
            rho.samples()[static_cast<std::size_t>(i)] = static_cast<float>(i) / 5.0F;
        const MapPlacement place{10.0, -4.0, 30.0, 8.0};
        const TextonField clamp(mapOf(rho, place), 6, {8, 8});
        const TextonField repeat(mapOf(rho, place, MapBoundary::Repeat), 6, {8, 8});
        for (const auto& [x, y, inClamp, inRepeat] : {std::tuple{10.0, -4.0, 0, 0},
                                                      {19.9, -0.1, 0, 0},
                                                      {20.0, 0.0, 4, 4},
                                                      {39.9, 3.9, 5, 5},
                                                      {40.0, 4.0, 5, 0},
                                                      {9.9, -4.1, 0, 5},
                                                      {-50.0, -4.0, 0, 0},
                                                      {-50.1, 100.0, 3, 2},
                                                      {1e6 + 15.0, 0.0, 5, 4}}) {
            QCOMPARE(clamp.textonAt(x, y, 0), inClamp);
            QCOMPARE(repeat.textonAt(x, y, 0), inRepeat);
        }
    }

    void theMeanFollowsTheMap() {
        const MapPlacement place{-20.0, 5.0, 400.0, 300.0};
        // A ramp stays a ramp, away from the ends.
        const TextonField ramp(mapOf(gradientMap({400, 300}, 0.0), place), 21, {40, 40});
        std::vector<double> xs;
        for (double x = 60.0; x < 300.0; x += 7.3)
            xs.push_back(x);
        const auto along = means(ramp, xs, 150.0);
        for (std::size_t i = 0; i < xs.size(); ++i)
            TXN_AT_MOST(std::abs(along[i] - 20.0 * (xs[i] + 20.0) / 400.0), 2e-3);
        // Beyond the ends it keeps their values.
        TXN_AT_MOST(std::abs(means(ramp, {-500.0}, 0.0)[0]), 0.3);
        TXN_AT_MOST(std::abs(means(ramp, {900.0}, 0.0)[0] - 20.0), 0.3);

        // A border becomes a passage of one footprint.
        Image border({400, 1}, 1);
        for (int x = 200; x < 400; ++x)
            border.at(x, 0, 0) = 1.0F;
        const TextonField field(mapOf(border, {0, 0, 400, 10}), 3, {40, 10});
        QCOMPARE(means(field, {170.0}, 5.0)[0], 0.0);
        QCOMPARE(means(field, {230.0}, 5.0)[0], 2.0);
        TXN_AT_MOST(std::abs(means(field, {200.0}, 5.0)[0] - 1.0), 1e-5);
        double last = 0.0;
        for (double x = 170.0; x < 230.0; x += 0.5) {
            const double now = means(field, {x}, 5.0)[0];
            TXN_AT_MOST(last, now + 1e-6);
            TXN_AT_MOST(now - last, 2.0 * 0.75 * 0.5 / 10.0 + 1e-6); // of two, the steepest
            last = now;
        }

        // Repeating maps have repeating means, and rows and columns are alike.
        const TextonField repeat(mapOf(roughMap({30, 20}, 4), {3, 2, 90, 60}, MapBoundary::Repeat),
                                 5,
                                 {20, 12});
        for (const double x : {3.0, 17.5, 80.0})
            TXN_AT_MOST(std::abs(means(repeat, {x}, 9.0)[0] - means(repeat, {x - 180.0}, 69.0)[0]),
                        1e-5);
        const TextonField across(mapOf(roughMap({30, 30}, 4), {0, 0, 90, 90}), 5, {20, 20});
        Image transposed({30, 30}, 1);
        const Image rough = roughMap({30, 30}, 4);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 30; ++x)
                transposed.at(x, y, 0) = rough.at(y, x, 0);
        }
        const TextonField down(mapOf(transposed, {0, 0, 90, 90}), 5, {20, 20});
        for (const auto& [x, y] : {std::pair{12.0, 55.0}, {1.0, 88.0}, {47.0, 30.5}})
            TXN_AT_MOST(std::abs(means(across, {x}, y)[0] - means(down, {y}, x)[0]), 1e-5);
    }

    void noiseIsItsDefinition_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<bool>("repeat");
        for (const int order : {0, 1, 3}) {
            for (const int kernels : {1, 3})
                QTest::addRow("order %d, Q %d", order, kernels)
                    << static_cast<int>(NoiseProcess::Stratified) << order << kernels
                    << (kernels == 3);
        }
        QTest::newRow("signed") << static_cast<int>(NoiseProcess::Signed) << 1 << 2 << false;
    }
    void noiseIsItsDefinition() {
        QFETCH(int, process);
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(bool, repeat);
        const NoiseParams params = paramsOf(static_cast<NoiseProcess>(process));
        const Mixture mixture(textonsOf(5, order, kernels),
                              mapOf(roughMap({7, 6}, 3),
                                    {-10.0, 4.0, 31.0, 47.0},
                                    repeat ? MapBoundary::Repeat : MapBoundary::Clamp));
        const TextonField field(mixture.map, 5, mixture.textons.front().footprint());
        const SpotNoise noise(mixture, params);
        const Rect rect{-30, -20, {80, 90}};
        const auto grid = NoiseGrid::create(mixture, params);
        TXN_OK(grid);
        const auto picture = grid->render(rect);
        std::vector<double> values(3);
        for (int y = 0; y < rect.size.height; y += 7) {
            for (int x = 0; x < rect.size.width; x += 5) {
                const double px = static_cast<double>(rect.x) + x + 0.5;
                const double py = static_cast<double>(rect.y) + y + 0.5;
                noise.evaluate(px, py, values);
                const double position = means(field, {px}, py)[0];
                const auto left = static_cast<std::size_t>(std::min(position, 3.0));
                for (int c = 0; c < 3; ++c) {
                    const auto i = static_cast<std::size_t>(c);
                    const double mean = std::lerp(mixture.textons[left].mean[i],
                                                  mixture.textons[left + 1].mean[i],
                                                  position - static_cast<double>(left));
                    TXN_AT_MOST(std::abs(values[i] - mean - naiveSum(mixture, params, c, px, py)),
                                1e-5);
                    TXN_AT_MOST(std::abs(static_cast<double>(picture->at(x, y, c)) - values[i]),
                                2e-5);
                }
            }
        }
        // Enlarged, too.
        const auto twice = NoiseGrid::create(mixture, params, 2.0)->render({-20, -20, {40, 40}});
        for (int y = 0; y < 40; y += 3) {
            for (int x = 0; x < 40; x += 3) {
                noise.evaluate((x - 19.5) / 2.0, (y - 19.5) / 2.0, values);
                for (int c = 0; c < 3; ++c)
                    TXN_AT_MOST(std::abs(static_cast<double>(twice->at(x, y, c)) -
                                         values[static_cast<std::size_t>(c)]),
                                2e-5);
            }
        }
    }

    void aConstantMapIsPlainNoise_data() {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 2.0, 0.5})
            QTest::addRow("scale %g", scale) << scale;
    }
    void aConstantMapIsPlainNoise() {
        QFETCH(double, scale);
        const auto textons = textonsOf(7, 1, 2);
        const Rect rect{-50, 3, {300, 80}};
        const auto params = paramsOf(NoiseProcess::Stratified);
        for (int r = 0; r < 7; ++r) {
            const Mixture mixture(
                textons,
                mapOf(Image({5, 4}, 1, static_cast<float>(r / 6.0)), {-10, -10, 200, 200}));
            const auto mixed = NoiseGrid::create(mixture, params, scale)->render(rect);
            const auto plain =
                NoiseGrid::create(textons[static_cast<std::size_t>(r)], params, scale)
                    ->render(rect);
            QVERIFY(*mixed == *plain);
        }
    }

    void rectanglesAndThreadsAgree() {
        const Mixture mixture(textonsOf(9), mapOf(roughMap({40, 40}, 2), {-100, -100, 700, 400}));
        for (const double scale : {1.0, 1.5}) {
            const auto grid =
                NoiseGrid::create(mixture, paramsOf(NoiseProcess::Signed, 12.0), scale);
            const auto whole = onThreads(1, [&] { return grid->render({-70, -60, {500, 400}}); });
            QVERIFY(*onThreads(4, [&] { return grid->render({-70, -60, {500, 400}}); }) == *whole);
            const auto part = grid->render({41, 33, {90, 200}});
            for (int c = 0; c < 3; ++c) {
                for (int y = 0; y < 200; ++y) {
                    const auto from = whole->row(c, y + 93).subspan(111, 90);
                    QVERIFY(std::ranges::equal(part->row(c, y), from));
                }
            }
        }
    }

    void swappingEndsAndInvertingTheMapChangesNothing() {
        const auto textons = textonsOf(5);
        auto reversed = textons;
        std::ranges::reverse(reversed);
        // Whole textons only: between two, chance would take the other one.
        Image rho = roughMap({12, 9}, 8);
        for (float& v : rho.samples())
            v = std::round(4.0F * v) / 4.0F;
        Image inverted = rho;
        for (float& v : inverted.samples())
            v = 1.0F - v;
        const MapPlacement place{0, 0, 150, 100};
        const auto params = paramsOf(NoiseProcess::Stratified);
        const Rect rect{0, 0, {150, 100}};
        const auto there = NoiseGrid::create({textons, mapOf(rho, place)}, params)->render(rect);
        const auto back =
            NoiseGrid::create({reversed, mapOf(inverted, place)}, params)->render(rect);
        TXN_AT_MOST(imageDistance(*there, *back), 2e-6);
    }

    void tilesWithItsMap() {
        const Mixture mixture(textonsOf(4),
                              mapOf(roughMap({13, 8}, 2), {0, 0, 90, 70}, MapBoundary::Repeat));
        NoiseParams params = paramsOf(NoiseProcess::Stratified);
        params.period = Period{180.0, 70.0};
        const auto grid = NoiseGrid::create(mixture, params);
        TXN_OK(grid);
        TXN_AT_MOST(
            imageDistance(*grid->render({0, 0, {180, 70}}), *grid->render({-360, 210, {180, 70}})),
            1e-5);
    }

    /// Mean square of the horizontal difference, column by column, along a gradient over textons
    /// of ever more contrast and ever coarser grain: borders between strips do not stand out.
    void stripsHaveNoSeams_data() {
        QTest::addColumn<bool>("steps");
        QTest::newRow("gradient") << false;
        QTest::newRow("strips of one texton each") << true;
    }
    void stripsHaveNoSeams() {
        QFETCH(bool, steps);
        constexpr int kTextons = 9;
        constexpr int kStrip = 40;
        const Size size{kTextons * kStrip, 2048};
        // Even energy all over the kernels, so that a border lies where the map has it.
        const auto even = [](std::uint64_t seed, double contrast) {
            Texton texton = makeTexton({1, 1, {12, 12}, 1, 1});
            texton.kernels[0] = randomImage({12, 12}, 1, seed, contrast);
            return texton;
        };
        const Texton a = even(1, 0.1);
        const Texton b = even(2, 0.3);
        std::vector<Texton> textons;
        for (int r = 0; r < kTextons; ++r) {
            Texton texton = a;
            const auto share = static_cast<float>(r) / (kTextons - 1);
            for (std::size_t i = 0; i < texton.kernels[0].samples().size(); ++i)
                texton.kernels[0].samples()[i] +=
                    share * (b.kernels[0].samples()[i] - texton.kernels[0].samples()[i]);
            texton.mean[0] += 0.2 * static_cast<double>(share);
            textons.push_back(std::move(texton));
        }
        Image rho = gradientMap({size.width, 1}, 0.0);
        for (int x = 0; x < size.width && steps; ++x)
            rho.at(x, 0, 0) = static_cast<float>(x / kStrip) / static_cast<float>(kTextons - 1);
        const Mixture mixture(textons, mapOf(rho, {0, 0, 1.0 * size.width, 1.0 * size.height}));
        std::vector<double> energy(static_cast<std::size_t>(size.width - 1), 0.0);
        constexpr int kSeeds = 6;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const auto picture =
                NoiseGrid::create(mixture, paramsOf(NoiseProcess::Stratified, 12.0, seed))
                    ->render({0, 0, size});
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x + 1 < size.width; ++x)
                    energy[static_cast<std::size_t>(x)] +=
                        std::pow(
                            static_cast<double>(picture->at(x + 1, y, 0) - picture->at(x, y, 0)),
                            2) /
                        (kSeeds * size.height);
            }
        }
        // The columns at borders against those halfway to the next border on both sides. Rows some
        // 12 pixels apart are independent: sqrt(2 * 12 / (6 * 2048)) = 4.4 % is one deviation of a
        // column; 7 columns are averaged, little less alike than one another.
        const auto around = [&](int x) {
            double sum = 0.0;
            for (int i = x - 4; i < x + 3; ++i)
                sum += energy[static_cast<std::size_t>(i)] / 7.0;
            return sum;
        };
        double bias = 0.0;
        int count = 0;
        for (int border = kStrip; border < size.width; border += kStrip) {
            const double here = around(border);
            const double inside = 0.5 * (around(border - kStrip / 2) + around(border + kStrip / 2));
            TXN_AT_MOST(std::abs(here / inside - 1.0), 0.12);
            bias += here / inside - 1.0;
            ++count;
        }
        TXN_AT_MOST(std::abs(bias / count), 0.04);
    }

    /// Where the map says rho, the variance is that of its texton, mixed over a footprint.
    void varianceFollowsTheMap() {
        auto textons = textonsOf(2);
        for (float& v : textons[1].kernels[0].samples())
            v *= 2.0F;
        Image rho({2, 1}, 1);
        rho.at(1, 0, 0) = 1.0F;
        const Mixture mixture(textons, mapOf(rho, {0, 0, 400, 600}));
        std::vector<double> left;
        std::vector<double> right;
        for (std::uint32_t seed = 1; seed <= 12; ++seed) {
            const auto grid =
                NoiseGrid::create(mixture, paramsOf(NoiseProcess::Stratified, 12.0, seed));
            left.push_back(varianceOf(grid->render({0, 0, {180, 600}})->plane(0)));
            right.push_back(varianceOf(grid->render({220, 0, {180, 600}})->plane(0)));
        }
        const auto one = estimate(left);
        const auto four = estimate(right);
        TXN_AT_MOST(std::abs(one.mean - 1.0), 5.0 * one.error);
        TXN_AT_MOST(std::abs(four.mean - 4.0), 5.0 * four.error);
    }

    void gradientsGoWhereTheyShould() {
        const auto corner = [](double angle, int x, int y) {
            return static_cast<double>(gradientMap({40, 20}, angle).at(x, y, 0));
        };
        TXN_AT_MOST(std::abs(corner(0.0, 0, 7) - 0.5 / 40.0), 1e-6);
        TXN_AT_MOST(std::abs(corner(0.0, 39, 3) - 39.5 / 40.0), 1e-6);
        TXN_AT_MOST(std::abs(corner(90.0, 5, 0) - 0.5 / 20.0), 1e-6);
        TXN_AT_MOST(std::abs(corner(180.0, 0, 0) - 39.5 / 40.0), 1e-6);
        TXN_AT_MOST(std::abs(corner(-90.0, 0, 19) - 0.5 / 20.0), 1e-6);
        TXN_AT_MOST(corner(45.0, 0, 0), 0.03);
        TXN_AT_MOST(1.0 - corner(45.0, 39, 19), 0.03);
        const Image smooth = gradientMap({100, 1}, 0.0, Ease::Smooth);
        TXN_AT_MOST(
            std::abs(static_cast<double>(smooth.at(24, 0, 0)) - 0.245 * 0.245 * (3.0 - 0.49)),
            1e-6);
    }

    void picturesBecomeMaps() {
        const auto fails = [](Image picture, ErrorCode code, const char* word) {
            const auto map = mapFromPicture(picture, "where.png");
            return !map && map.error().code == code &&
                   map.error().message.find("where.png") != std::string::npos &&
                   map.error().message.find(word) != std::string::npos;
        };
        Image grey({3, 2}, 3, 0.25F);
        QVERIFY(*mapFromPicture(grey, "m") == Image({3, 2}, 1, 0.25F));
        grey.at(1, 1, 2) = 0.5F;
        QVERIFY(fails(grey, ErrorCode::Unsupported, "color"));
        QVERIFY(fails(Image({3, 2}, 2), ErrorCode::Unsupported, "2 channels"));
        QVERIFY(fails(Image({3, 2}, 16), ErrorCode::Unsupported, "16 channels"));
        for (const float bad : {kNaN, -0.01F, 1.5F, std::numeric_limits<float>::infinity()}) {
            Image broken({4, 3}, 1, 0.5F);
            broken.at(2, 1, 0) = bad;
            QVERIFY(fails(broken, ErrorCode::Degenerate, "x 2, y 1"));
        }
        Image broken({4, 3}, 3, kNaN);
        QVERIFY(fails(broken, ErrorCode::Degenerate, "x 0, y 0"));
        QVERIFY(fails(Image({8193, 1}, 1), ErrorCode::TooLarge, "8192"));
    }

    void badInputIsRefused() {
        const auto params = paramsOf(NoiseProcess::Stratified);
        const MapPlacement place{0, 0, 100, 100};
        const Image half({1, 1}, 1, 0.5F);
        const auto with = [&](std::vector<Texton> textons, MixingMap map, NoiseParams noise) {
            return NoiseGrid::create({std::move(textons), std::move(map)}, noise);
        };
        TXN_FAILS_WITH(with({}, mapOf(half, place), params), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(with(textonsOf(65), mapOf(half, place), params), ErrorCode::InvalidArgument);
        for (const Texton& other : {makeTexton({1, 1, {8, 7}, 3, 1}),
                                    makeTexton({3, 1, {9, 7}, 3, 1}),
                                    makeTexton({1, 2, {9, 7}, 3, 1}),
                                    makeTexton({1, 1, {9, 7}, 1, 1})}) {
            auto textons = textonsOf(2);
            textons.push_back(other);
            TXN_FAILS_WITH(with(textons, mapOf(half, place), params), ErrorCode::SizeMismatch);
        }
        auto broken = textonsOf(2);
        broken[1].kernels[0].at(2, 2, 1) = kNaN;
        TXN_FAILS_WITH(with(broken, mapOf(half, place), params), ErrorCode::Degenerate);
        const auto fine = textonsOf(2);
        TXN_FAILS_WITH(with(fine, mapOf(Image({2, 2}, 3), place), params), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(with(fine, mapOf(Image({2, 2}, 1, kNaN), place), params),
                       ErrorCode::Degenerate);
        for (const MapPlacement& empty : {MapPlacement{0, 0, 0, 5},
                                          MapPlacement{0, 0, 5, -1},
                                          MapPlacement{NAN, 0, 5, 5},
                                          MapPlacement{0, 0, INFINITY, 5}})
            TXN_FAILS_WITH(with(fine, mapOf(half, empty), params), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(with(fine, mapOf(half, place), paramsOf(NoiseProcess::Poisson)),
                       ErrorCode::InvalidArgument);
        // One texton takes any process.
        TXN_OK(with(textonsOf(1), mapOf(half, place), paramsOf(NoiseProcess::Poisson)));
        NoiseParams tiled = params;
        tiled.period = Period{200.0, 100.0};
        TXN_FAILS_WITH(with(fine, mapOf(half, place), tiled), ErrorCode::InvalidArgument);
        TXN_OK(with(fine, mapOf(half, place, MapBoundary::Repeat), tiled));
        tiled.period = Period{150.0, 100.0};
        TXN_FAILS_WITH(with(fine, mapOf(half, place, MapBoundary::Repeat), tiled),
                       ErrorCode::InvalidArgument);
        TXN_OK(NoiseGrid::create(textonsOf(1)[0], tiled));
    }
};

QTEST_APPLESS_MAIN(TestMixing)
#include "TestMixing.moc"
