// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"
#include "core/qa/Autocovariance.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/GlReference.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

/// Single precision: places to some 1e-6 pixels times slopes of some ten kernels, and sums of up to
/// a thousand values. The noise has a standard deviation of 1.
constexpr double kTolerance = 1e-4;

/// A mean over seeds may stray this many of its own standard errors from the law: chance would take
/// one of the some hundred comparisons here beyond that once in ten thousand choices of seeds.
constexpr double kSigmas = 5.0;

struct Case {
    NoiseProcess process = NoiseProcess::Stratified;
    int order = 1;
    int kernels = 1;
    int channels = 3;
    Size support{17, 12};
    bool disc = false;
    double meanImpacts = 12.0;
    std::optional<Period> period;
    PlaneView view{3.25, -7.5};
    PlaneMethod method = PlaneMethod::PerPixel;
    Size size{60, 44};
    int supersampling = 1;
};

Texton textonOf(const Case& c) {
    // The sum of the coefficients is not zero: the Poisson mean has to be taken off.
    Texton texton = makeTexton({c.order, c.kernels, c.support, c.channels, 11, 0.3});
    return c.disc ? cutTo(std::move(texton), Support::disc(c.support.width)) : texton;
}

NoiseStyle styleOf(const Case& c) {
    NoiseStyle style = pointStyle(c.process, c.meanImpacts);
    style.noise.period = c.period;
    style.planeMethod = c.method;
    style.supersampling = c.supersampling;
    return style;
}

/// Mean product over all pairs of pixels inside, the true means removed: unbiased.
double productMean(const Image& image, const Texton& texton, int i, int j, int dx, int dy) {
    const double meanI = texton.mean[static_cast<std::size_t>(i)];
    const double meanJ = texton.mean[static_cast<std::size_t>(j)];
    double sum = 0.0;
    int count = 0;
    for (int y = std::max(0, -dy); y < std::min(image.height(), image.height() - dy); ++y) {
        for (int x = std::max(0, -dx); x < std::min(image.width(), image.width() - dx); ++x) {
            sum += (static_cast<double>(image.at(x + dx, y + dy, i)) - meanI) *
                   (static_cast<double>(image.at(x, y, j)) - meanJ);
            ++count;
        }
    }
    return sum / count;
}

} // namespace

Q_DECLARE_METATYPE(Case)

class TestGlNoise : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;
    std::optional<NoiseRenderer> m_renderer; // keeps its shaders from row to row

    Result<Image> picture(const Texton& texton,
                          const View& view,
                          const NoiseStyle& style,
                          Size size,
                          int channels = 4) {
        m_renderer->setTexton(shared(texton));
        return drawn(m_context->gl(), *m_renderer, view, style, size, channels);
    }

  private slots:
    void initTestCase() {
        TXN_NEEDS_GL(m_context);
        m_renderer.emplace();
    }

    void cleanupTestCase() {
        m_renderer.reset();
        m_context.reset();
    }

    void everyPixelIsAPointOfTheNoise_data() {
        QTest::addColumn<Case>("c");
        for (const PlaneMethod method : {PlaneMethod::PerPixel, PlaneMethod::Tiles}) {
            const char* how = method == PlaneMethod::Tiles ? "tiles" : "pixels";
            const auto add = [&](const QByteArray& name, const std::function<void(Case&)>& change) {
                Case c;
                c.method = method;
                change(c);
                QTest::addRow("%s %s", how, name.constData()) << c;
            };
            for (const int process : {0, 1, 2}) {
                const auto kind = static_cast<NoiseProcess>(process);
                const QByteArray name(toString(kind).data());
                for (const int order : {0, 1, 3, 5}) {
                    for (const int kernels : {1, 3})
                        add(name + " order " + QByteArray::number(order) + " Q " +
                                QByteArray::number(kernels),
                            [&](Case& c) {
                                c.process = kind;
                                c.order = order;
                                c.kernels = kernels;
                            });
                }
                for (const double impacts : {0.1, 1.0, 200.0})
                    add(name + " MNI " + QByteArray::number(impacts), [&](Case& c) {
                        c.process = kind;
                        c.kernels = 2;
                        c.meanImpacts = impacts;
                        c.channels = 1;
                    });
                for (const auto& [x, y] :
                     {std::pair{1e6, 1e6}, {-1e6, 3e6}, {49999000.5, -49999000.25}}) {
                    add(name + " at " + QByteArray::number(x) + " " + QByteArray::number(y),
                        [&, x = x, y = y](Case& c) {
                            c.process = kind;
                            c.view.centerX = x;
                            c.view.centerY = y;
                            c.view.rotation = 0.4;
                            c.view.zoom = 1.7;
                        });
                }
                for (const Period& period :
                     {Period{40.0, 30.0}, Period{33.3, 20.7}, Period{6.0, 5.0}})
                    add(name + " period " + QByteArray::number(period.width), [&](Case& c) {
                        c.process = kind;
                        c.period = period;
                        c.view.centerX = -1003.0; // negative cells wrap, too
                        c.size = {71, 52};
                    });
            }
            add("tiny period far away", [](Case& c) {
                c.period = Period{1.5, 1.25};
                c.meanImpacts = 200.0;
                c.channels = 1;
                c.view.centerX = -49999000.5;
                c.view.centerY = 49999000.5;
                c.size = {20, 16};
            });
            for (const int channels : {1, 2, 4})
                add(QByteArray::number(channels) + " channels",
                    [&](Case& c) { c.channels = channels; });
            for (const Size support : {Size{1, 1}, {9, 30}, {30, 9}, {20, 20}, {14, 1}})
                add("support " + QByteArray::fromStdString(sizeText(support)), [&](Case& c) {
                    c.support = support;
                    c.kernels = 2;
                });
            add("disc", [](Case& c) {
                c.support = {17, 17};
                c.disc = true;
            });
            // Far out footprints have to be large, or points are evaluated one by one after all.
            for (const double zoom : {0.25, 1.0 / 3.0, 0.99, 3.0, 17.3, 64.0}) {
                for (const double rotation : {0.0, 0.3, 2.5, -7.0})
                    add("zoom " + QByteArray::number(zoom) + " turned " +
                            QByteArray::number(rotation),
                        [&](Case& c) {
                            c.view.zoom = zoom;
                            c.view.rotation = rotation;
                            c.channels = 1;
                            c.kernels = 2;
                            c.support = zoom < 1.0 ? Size{60, 50} : c.support;
                            c.size = {43, 31};
                        });
            }
            add("order 0 zoomed", [](Case& c) {
                c.order = 0;
                c.view.zoom = 3.3;
                c.view.rotation = 1.0;
            });
            add("order 5 zoomed", [](Case& c) {
                c.order = 5;
                c.view.zoom = 3.3;
                c.view.rotation = 1.0;
            });
            for (const Size size : {Size{1, 1}, {2, 1}, {1, 7}, {101, 3}})
                add("picture " + QByteArray::fromStdString(sizeText(size)),
                    [&](Case& c) { c.size = size; });
            for (const int n : {2, 3})
                add("supersampled by " + QByteArray::number(n), [&](Case& c) {
                    c.supersampling = n;
                    c.view.zoom = 0.8;
                    c.view.rotation = 0.5;
                    c.size = {31, 24};
                });
        }
    }

    void everyPixelIsAPointOfTheNoise() {
        QFETCH(Case, c);
        const Texton texton = textonOf(c);
        const NoiseStyle style = styleOf(c);
        const auto image = picture(texton, c.view, style, c.size);
        TXN_OK(image);
        const Image expected = reference(
            texton,
            style.noise,
            c.size,
            [&](double x, double y) { return planePoint(c.view, c.size, x, y); },
            c.supersampling);
        if (c.order == 0) {
            // Where a pixel sits on the edge of a coefficient, rounding picks the side.
            TXN_AT_MOST(shareBeyond(image->samples(), expected.samples(), kTolerance), 1e-3);
        } else {
            TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), kTolerance);
        }
        QVERIFY(c.size.area() < 100 || c.meanImpacts < 1.0 || varianceOf(image->plane(0)) > 0.01);
    }

    void agreesWithTheGrid_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<double>("zoom");
        QTest::addColumn<qint64>("left");
        QTest::addColumn<qint64>("top");
        for (const int order : {0, 1, 3}) {
            QTest::addRow("order %d", order) << order << 2 << 1.0 << qint64{-100} << qint64{-77};
            QTest::addRow("order %d far", order)
                << order << 1 << 1.0 << qint64{-1000000} << qint64{3000000};
            QTest::addRow("order %d enlarged", order)
                << order << 1 << 2.5 << qint64{31} << qint64{-64};
        }
    }

    void agreesWithTheGrid() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(double, zoom);
        QFETCH(qint64, left);
        QFETCH(qint64, top);
        const Texton texton = makeTexton({order, kernels, {16, 24}, 3, 12, 0.2});
        const Size size{201, 150};
        for (const PlaneMethod method : {PlaneMethod::PerPixel, PlaneMethod::Tiles}) {
            for (const int process : {0, 1, 2}) {
                NoiseStyle style = pointStyle(static_cast<NoiseProcess>(process));
                style.planeMethod = method;
                const auto grid = NoiseGrid::create(texton, style.noise, zoom);
                TXN_OK(grid);
                const auto expected = grid->render({left, top, size});
                TXN_OK(expected);
                const PlaneView view{(static_cast<double>(left) + 0.5 * size.width) / zoom,
                                     (static_cast<double>(top) + 0.5 * size.height) / zoom,
                                     zoom};
                const auto image = picture(texton, view, style, size, 3);
                TXN_OK(image);
                if (order == 0)
                    TXN_AT_MOST(shareBeyond(image->samples(), expected->samples(), kTolerance),
                                1e-3);
                else
                    TXN_AT_MOST(largestDifference(image->samples(), expected->samples()),
                                kTolerance);
            }
        }
    }

    void tilesAreThePicturePerPixel_data() {
        QTest::addColumn<int>("filter");
        QTest::addColumn<double>("zoom");
        for (const double zoom : {0.3, 1.0, 4.0}) {
            QTest::addRow("none %g", zoom) << static_cast<int>(Filter::None) << zoom;
            QTest::addRow("mipmap %g", zoom) << static_cast<int>(Filter::Mipmap) << zoom;
            QTest::addRow("anisotropic %g", zoom) << static_cast<int>(Filter::Anisotropic) << zoom;
        }
    }

    void tilesAreThePicturePerPixel() {
        QFETCH(int, filter);
        QFETCH(double, zoom);
        for (const int order : {1, 3}) {
            const Texton texton = makeTexton({order, 2, {46, 46}, 4, 13});
            NoiseStyle style = pointStyle();
            style.filter = static_cast<Filter>(filter);
            const PlaneView view{-40.3, 11.2, zoom, 0.7};
            style.planeMethod = PlaneMethod::PerPixel;
            const auto pixels = picture(texton, view, style, {90, 71});
            style.planeMethod = PlaneMethod::Tiles;
            const auto tiles = picture(texton, view, style, {90, 71});
            style.planeMethod = PlaneMethod::Automatic;
            const auto automatic = picture(texton, view, style, {90, 71});
            TXN_OK(pixels);
            TXN_OK(tiles);
            TXN_OK(automatic);
            // The hardware weighs in steps of 1/256; a place may round to either neighbour.
            const double tolerance = style.filter == Filter::None ? kTolerance : 5e-3;
            TXN_AT_MOST(largestDifference(pixels->samples(), tiles->samples()), tolerance);
            TXN_AT_MOST(largestDifference(pixels->samples(), automatic->samples()), tolerance);
        }
    }

    void aPeriodRepeatsExactly() {
        const Texton texton = makeTexton({1, 2, {17, 12}, 3, 14});
        for (const int process : {0, 1, 2}) {
            NoiseStyle style = pointStyle(static_cast<NoiseProcess>(process));
            style.noise.period = Period{48.0, 40.0};
            const Size size{48, 40};
            const auto here = picture(texton, PlaneView{24.0, 20.0}, style, size);
            const auto there = picture(texton, PlaneView{24.0 - 96.0, 20.0 + 4000.0}, style, size);
            const auto half = picture(texton, PlaneView{48.0, 20.0}, style, size);
            TXN_OK(here);
            TXN_OK(there);
            TXN_OK(half);
            TXN_AT_MOST(largestDifference(here->samples(), there->samples()), kTolerance);
            QVERIFY(largestDifference(here->samples(), half->samples()) > 0.1);
        }
    }

    void channelsAreShownInOrder() {
        for (const int channels : {1, 2, 3, 4}) {
            const Texton texton = makeTexton({1, 1, {12, 12}, channels, 15});
            const auto image = picture(texton, PlaneView{}, pointStyle(), {40, 40});
            TXN_OK(image);
            if (channels == 1) {
                for (const int c : {1, 2})
                    TXN_AT_MOST(largestDifference(image->plane(0), image->plane(c)), 0.0);
            } else {
                QVERIFY(largestDifference(image->plane(0), image->plane(1)) > 0.1);
            }
            const std::vector<float> ones(image->size().area(), 1.0F);
            if (channels < 4)
                TXN_AT_MOST(largestDifference(image->plane(3), ones), 0.0);
            else
                QVERIFY(largestDifference(image->plane(3), image->plane(2)) > 0.1);
        }
    }

    void turningByAQuarterTurnsThePicture() {
        const Texton texton = makeTexton({1, 2, {17, 12}, 3, 16});
        const Size size{64, 64};
        const auto straight = picture(texton, PlaneView{7.0, 3.0}, pointStyle(), size);
        const auto turned =
            picture(texton, PlaneView{7.0, 3.0, 1.0, std::numbers::pi / 2.0}, pointStyle(), size);
        TXN_OK(straight);
        TXN_OK(turned);
        // Clockwise: the top row comes to the right.
        Image expected(size, 4);
        for (int c = 0; c < 4; ++c) {
            for (int y = 0; y < 64; ++y) {
                for (int x = 0; x < 64; ++x)
                    expected.at(63 - y, x, c) = straight->at(x, y, c);
            }
        }
        TXN_AT_MOST(largestDifference(turned->samples(), expected.samples()), kTolerance);
    }

    void statisticsFollowTheTheory_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<bool>("tiles");
        QTest::addColumn<bool>("turned");
        for (const int process : {0, 1, 2}) {
            const auto name = toString(static_cast<NoiseProcess>(process));
            QTest::addRow("%s pixels", name.data()) << process << false << false;
            QTest::addRow("%s tiles", name.data()) << process << true << false;
            QTest::addRow("%s turned", name.data()) << process << true << true;
        }
    }

    void statisticsFollowTheTheory() {
        QFETCH(int, process);
        QFETCH(bool, tiles);
        QFETCH(bool, turned);
        constexpr std::uint32_t kSeeds = 30;
        const Texton texton = makeTexton({1, 2, {10, 8}, 2, 17, 0.4});
        const Autocovariance theory = autocovariance(texton, 4);
        const auto covariance = noiseCovariance(texton);
        struct Lag {
            int i, j, dx, dy;
        };
        constexpr std::array<Lag, 8> kLags{{{0, 0, 0, 0},
                                            {1, 1, 0, 0},
                                            {0, 1, 0, 0},
                                            {0, 0, 1, 0},
                                            {1, 1, 0, 2},
                                            {0, 1, 3, -1},
                                            {1, 0, 3, -1},
                                            {0, 0, -2, 3}}};
        std::array<std::vector<double>, 2> means;
        std::array<std::vector<double>, kLags.size()> products;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            NoiseStyle style = pointStyle(static_cast<NoiseProcess>(process), 8.0, seed);
            style.planeMethod = tiles ? PlaneMethod::Tiles : PlaneMethod::PerPixel;
            const PlaneView view{0.0, 0.0, 1.0, turned ? std::numbers::pi / 2.0 : 0.0};
            const auto image = picture(texton, view, style, {128, 128}, 2);
            TXN_OK(image);
            for (int c = 0; c < 2; ++c)
                means[static_cast<std::size_t>(c)].push_back(meanOf(image->plane(c)));
            for (std::size_t k = 0; k < kLags.size(); ++k) {
                const Lag& lag = kLags[k];
                products[k].push_back(productMean(*image, texton, lag.i, lag.j, lag.dx, lag.dy));
            }
        }
        for (std::size_t c = 0; c < means.size(); ++c) {
            const Estimate mean = estimate(means[c]);
            TXN_AT_MOST(std::abs(mean.mean - texton.mean[c]), kSigmas * mean.error);
            TXN_AT_MOST(mean.error, 0.04); // the standard deviation of the noise is 1
        }
        for (std::size_t k = 0; k < kLags.size(); ++k) {
            const Lag& lag = kLags[k];
            // Clockwise: the picture's x axis runs along the plane's -y, its y axis along x.
            const double expected = turned ? theory.at(lag.i, lag.j, lag.dy, -lag.dx)
                                           : theory.at(lag.i, lag.j, lag.dx, lag.dy);
            const Estimate product = estimate(products[k]);
            TXN_AT_MOST(std::abs(product.mean - expected), kSigmas * product.error);
            TXN_AT_MOST(product.error, 0.04);
            if (lag.dx == 0 && lag.dy == 0)
                TXN_AT_MOST(
                    std::abs(expected - covariance[static_cast<std::size_t>(2 * lag.i + lag.j)]),
                    1e-6);
        }
    }

    void filtersChangeNothingWhereNothingIsToBeFiltered_data() {
        QTest::addColumn<int>("filter");
        QTest::addColumn<double>("zoom");
        for (const double zoom : {1.0, 2.5, 8.0}) {
            QTest::addRow("mipmap %g", zoom) << static_cast<int>(Filter::Mipmap) << zoom;
            QTest::addRow("anisotropic %g", zoom) << static_cast<int>(Filter::Anisotropic) << zoom;
        }
    }

    void filtersChangeNothingWhereNothingIsToBeFiltered() {
        QFETCH(int, filter);
        QFETCH(double, zoom);
        for (const PlaneMethod method : {PlaneMethod::PerPixel, PlaneMethod::Tiles}) {
            for (const int order : {0, 1, 3, 5}) {
                const Texton texton = makeTexton({order, 2, {20, 20}, 3, 18});
                NoiseStyle style = pointStyle();
                style.planeMethod = method;
                const PlaneView view{5.3, 8.1, zoom, 0.2};
                const auto exact = picture(texton, view, style, {70, 50});
                style.filter = static_cast<Filter>(filter);
                const auto image = picture(texton, view, style, {70, 50});
                TXN_OK(exact);
                TXN_OK(image);
                const double error = rmsDifference(image->samples(), exact->samples());
                // The hardware's weights have 8 bits. From order 3 on kernels are drawn from
                // samples half a pixel apart, linear in between, and at scale 1 averaged over a
                // pixel.
                const double smooth = zoom == 1.0 ? 0.25 : 0.1;
                TXN_AT_MOST(error, order > 1 ? smooth : order == 1 ? 3e-3 : 0.05);
            }
        }
    }

    /// The ground seen at an angle, by a camera written down once more.
    void theGroundIsWhereTheCameraSeesIt_data() {
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("pitch");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("fieldOfView");
        QTest::addColumn<double>("centerX");
        QTest::newRow("straight") << 0.0 << 0.7 << 1.0 << 0.8 << 0.0;
        QTest::newRow("turned") << 0.6 << 0.5 << 1.0 << 0.8 << 13.0;
        QTest::newRow("from behind") << 3.5 << 0.5 << 0.7 << 0.5 << -5.0;
        QTest::newRow("from above") << -0.4 << std::numbers::pi / 2.0 << 1.5 << 1.2 << 3.0;
        QTest::newRow("far away") << 0.6 << 0.5 << 1.0 << 0.8 << 3e6;
        QTest::newRow("with a horizon") << 0.2 << 0.2 << 1.0 << 0.9 << 4.0;
    }

    void theGroundIsWhereTheCameraSeesIt() {
        QFETCH(double, yaw);
        QFETCH(double, pitch);
        QFETCH(double, distance);
        QFETCH(double, fieldOfView);
        QFETCH(double, centerX);
        const Texton texton = makeTexton({1, 2, {17, 12}, 3, 19});
        GroundView view;
        view.centerX = centerX;
        view.centerY = -21.5;
        view.zoom = 1.3;
        view.camera = {yaw, pitch, distance, fieldOfView};
        view.background = glm::vec3(2.0F);
        const Size size{61, 46};
        const double focal = 0.5 * size.height / std::tan(0.5 * fieldOfView);
        const double far = distance * focal / view.zoom; // from the eye to the centre
        // East, north, up; the plane's y points south.
        const double toEye[3] = {std::cos(pitch) * std::sin(yaw),
                                 -std::cos(pitch) * std::cos(yaw),
                                 std::sin(pitch)};
        const double right[3] = {std::cos(yaw), std::sin(yaw), 0.0};
        const double up[3] = {-std::sin(pitch) * std::sin(yaw),
                              std::sin(pitch) * std::cos(yaw),
                              std::cos(pitch)};
        double farthest = 0.0;
        const auto where = [&](double x, double y) -> std::optional<std::pair<double, double>> {
            double ray[3];
            for (int i = 0; i < 3; ++i)
                ray[i] = -focal * toEye[i] + (x - 0.5 * size.width) * right[i] -
                         (y - 0.5 * size.height) * up[i];
            if (ray[2] >= 0.0)
                return {};
            const double t = -far * toEye[2] / ray[2];
            const double east = far * toEye[0] + t * ray[0];
            const double north = far * toEye[1] + t * ray[1];
            farthest = std::max({farthest, std::abs(east), std::abs(north)});
            return std::pair{view.centerX + east, view.centerY - north};
        };
        const Image expected = reference(texton, pointStyle().noise, size, where, 1, 2.0F);
        const auto image = picture(texton, view, pointStyle(), size);
        TXN_OK(image);
        // A point is known to 2^-24 of its distance, a few times over, and slopes are about 1.
        const double tolerance = std::max(2e-4, 2e-6 * std::min(farthest, 1000.0));
        if (farthest < 1000.0)
            TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), tolerance);
        else // next to the horizon places are lost
            TXN_AT_MOST(shareBeyond(image->samples(), expected.samples(), tolerance), 0.02);
    }

    void seedsAndProcessesDiffer() {
        const Texton texton = makeTexton({1, 1, {17, 12}, 1, 20});
        std::vector<Image> images;
        for (const int process : {0, 1, 2}) {
            for (const std::uint32_t seed : {0U, 1U, 0xffffffffU}) {
                const auto image =
                    picture(texton,
                            PlaneView{},
                            pointStyle(static_cast<NoiseProcess>(process), 12.0, seed),
                            {40, 40});
                TXN_OK(image);
                images.push_back(*image);
            }
        }
        for (std::size_t i = 0; i < images.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(rmsDifference(images[i].samples(), images[j].samples()) > 0.1);
        }
    }
};

QTEST_APPLESS_MAIN(TestGlNoise)
#include "TestGlNoise.moc"
