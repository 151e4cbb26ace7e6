// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/noise/NoiseGrid.h"
#include "core/samples/Samples.h"
#include "core/texton/TextonSolver.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

constexpr float kSky = 0.25F;

/// As an artist's: some colour, some structure.
Texton solved(const char* material, int side, int order) {
    auto sample = makeSample(material, {128, 128}, Seed{3});
    const auto exemplar = makeExemplar(std::move(*sample), material);
    TextonParams params;
    params.support = Support::rectangle({side, side});
    params.interpolationOrder = order;
    params.iterations = 15;
    auto solver = TextonSolver::create(GaussianModel(*exemplar, false), params);
    while (!solver->done())
        solver->step();
    return solver->texton();
}

GroundView towardsTheHorizon(double yaw, double pitch) {
    GroundView view;
    view.centerX = 300.0;
    view.centerY = -100.0;
    view.camera = {yaw, pitch, 1.0, 0.9};
    view.background = glm::vec3(kSky);
    return view;
}

/// First row of pixels all of which see the ground.
int firstGroundRow(const GroundView& view, Size size) {
    const double focal = 0.5 * size.height / std::tan(0.5 * view.camera.fieldOfView);
    const double horizon = 0.5 * size.height - focal * std::tan(view.camera.pitch);
    return std::max(0, static_cast<int>(std::ceil(horizon)));
}

Image rows(const Image& image, int from, int to) {
    Image part(Size{image.width(), to - from}, image.channels());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = from; y < to; ++y)
            std::copy(image.row(c, y).begin(),
                      image.row(c, y).end(),
                      part.row(c, y - from).begin());
    }
    return part;
}

/// Mean of squared deviations from the texton's means.
double energy(const Image& image, const Texton& texton) {
    double sum = 0.0;
    for (int c = 0; c < image.channels(); ++c) {
        const double mean = texton.mean[static_cast<std::size_t>(c)];
        for (const float v : image.plane(c))
            sum += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
    }
    return sum / static_cast<double>(image.samples().size());
}

} // namespace

class TestGlFilter : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;
    std::optional<NoiseRenderer> m_renderer;
    Texton m_texton;

    Result<Image> picture(const View& view, const NoiseStyle& style, Size size) {
        return drawn(m_context->gl(), *m_renderer, view, style, size, 3);
    }

  private slots:
    void initTestCase() {
        TXN_NEEDS_GL(m_context);
        m_renderer.emplace();
        m_texton = solved("sand", 24, 1);
        m_renderer->setTexton(shared(m_texton));
    }

    void init() {
        if (m_renderer)
            m_renderer->setTexton(shared(m_texton));
    }

    void cleanupTestCase() {
        m_renderer.reset();
        m_context.reset();
    }

    /// [TN17] figure 3.
    void filteredPicturesAreNearSupersampledOnes_data() {
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("pitch");
        QTest::addColumn<int>("samples");
        QTest::newRow("straight") << 0.0 << 0.3 << 20;
        QTest::newRow("aside") << std::numbers::pi / 4.0 << 0.3 << 8;
        QTest::newRow("flat") << 0.3 << 0.12 << 12;
    }

    void filteredPicturesAreNearSupersampledOnes() {
        QFETCH(double, yaw);
        QFETCH(double, pitch);
        QFETCH(int, samples);
        const Size size{96, 96};
        const GroundView view = towardsTheHorizon(yaw, pitch);
        NoiseStyle style = pointStyle();
        const auto none = picture(view, style, size);
        style.supersampling = samples;
        const auto truth = picture(view, style, size);
        style.supersampling = 1;
        style.filter = Filter::Mipmap;
        const auto mipmap = picture(view, style, size);
        style.filter = Filter::Anisotropic;
        const auto anisotropic = picture(view, style, size);
        TXN_OK(none);
        TXN_OK(truth);
        TXN_OK(mipmap);
        TXN_OK(anisotropic);
        for (const auto* image : {&*none, &*truth, &*mipmap, &*anisotropic})
            QVERIFY(allFinite(image->samples()));

        // The row that the horizon runs through is as much ground as sky.
        const int first = firstGroundRow(view, size) + 1;
        const auto error = [&](const Image& image) {
            return rmsDifference(rows(image, first, size.height).samples(),
                                 rows(*truth, first, size.height).samples());
        };
        const double deviation = std::sqrt(energy(rows(*truth, first, size.height), m_texton));
        qInfo("of the deviation %.4f: none %.3f, mipmap %.3f, anisotropic %.3f",
              deviation,
              error(*none) / deviation,
              error(*mipmap) / deviation,
              error(*anisotropic) / deviation);
        TXN_AT_MOST(error(*anisotropic), error(*none) / 3.0);
        TXN_AT_MOST(error(*anisotropic), error(*mipmap));

        // Of the same strength all the way to the horizon.
        constexpr int kBand = 8;
        const double full = energy(rows(*truth, size.height - kBand, size.height), m_texton);
        int compared = 0;
        for (int y = first; y + kBand <= size.height; y += kBand) {
            const double expected = energy(rows(*truth, y, y + kBand), m_texton);
            if (expected < 0.3 * full)
                continue;
            const double ratio = energy(rows(*anisotropic, y, y + kBand), m_texton) / expected;
            // Mipmaps are blends of blurs, not exactly boxes.
            TXN_AT_MOST(std::abs(ratio - 1.0), 0.2);
            ++compared;
        }
        QVERIFY(compared >= 5);
    }

    void nothingButSkyIsSeenAboveTheHorizon_data() {
        QTest::addColumn<int>("filter");
        QTest::newRow("none") << static_cast<int>(Filter::None);
        QTest::newRow("mipmap") << static_cast<int>(Filter::Mipmap);
        QTest::newRow("anisotropic") << static_cast<int>(Filter::Anisotropic);
        QTest::newRow("hardware") << static_cast<int>(Filter::Hardware);
    }

    void nothingButSkyIsSeenAboveTheHorizon() {
        QFETCH(int, filter);
        const Size size =
            static_cast<Filter>(filter) == Filter::Hardware ? Size{32, 32} : Size{80, 64};
        for (const double pitch : {1e-4, 0.05, 0.3}) {
            const GroundView view = towardsTheHorizon(0.8, pitch);
            NoiseStyle style = pointStyle();
            style.filter = static_cast<Filter>(filter);
            const auto image = picture(view, style, size);
            TXN_OK(image);
            QVERIFY(allFinite(image->samples()));
            const int ground = firstGroundRow(view, size);
            if (ground > 1) {
                const Image sky = rows(*image, 0, ground - 1);
                const std::vector<float> expected(sky.samples().size(), kSky);
                TXN_AT_MOST(largestDifference(sky.samples(), expected), 0.0);
            }
            // Just below it, filtered noise is its mean, next to nothing of the sky left.
            if (static_cast<Filter>(filter) != Filter::None && pitch == 0.3) {
                const Image far = rows(*image, ground + 1, ground + 2);
                for (int c = 0; c < 3; ++c)
                    TXN_AT_MOST(
                        std::abs(meanOf(far.plane(c)) - m_texton.mean[static_cast<std::size_t>(c)]),
                        0.05);
            }
            // The ground is not all sky or all mean.
            QVERIFY(pitch < 0.1 ||
                    energy(rows(*image, size.height - 4, size.height), m_texton) > 1e-4);
        }
    }

    void aHorizonThatLeansBackShowsGroundOnly() {
        // Straight down there is no sky, and pictures are those of the plane view.
        GroundView ground = towardsTheHorizon(0.4, std::numbers::pi / 2.0);
        ground.zoom = 0.7;
        const PlaneView plane{ground.centerX, ground.centerY, 0.7, 0.4};
        for (const Filter filter : {Filter::None, Filter::Mipmap, Filter::Anisotropic}) {
            NoiseStyle style = pointStyle();
            style.filter = filter;
            const auto a = picture(ground, style, {64, 48});
            const auto b = picture(plane, style, {64, 48});
            TXN_OK(a);
            TXN_OK(b);
            // Hardware weights in steps of 1/256, of noise with a deviation of about 0.05; the
            // plane view may take more fetches.
            TXN_AT_MOST(rmsDifference(a->samples(), b->samples()),
                        filter == Filter::Anisotropic ? 0.025 : 2e-3);
        }
    }

    /// From a scale at which nothing is lost to one at which hardly anything is left.
    void farFromAboveTheDeviationIsThatOfTheMeans_data() {
        QTest::addColumn<double>("zoom");
        QTest::addColumn<int>("order");
        for (const int order : {0, 1, 3}) {
            for (const double zoom : {1.0, 0.7, 0.5, 0.25})
                QTest::addRow("order %d zoom %g", order, zoom) << zoom << order;
        }
        for (const double zoom : {1.0 / 8.0, 1.0 / 16.0, 1.0 / 40.0})
            QTest::addRow("zoom %g", zoom) << zoom << 1;
    }

    void farFromAboveTheDeviationIsThatOfTheMeans() {
        QFETCH(double, zoom);
        QFETCH(int, order);
        // Kernels with a sum, so that something is left.
        const Texton texton = makeTexton({order, 2, {22, 18}, 3, 51, 0.25});
        const Size size = zoom < 0.1 ? Size{24, 20} : Size{64, 48};
        NoiseStyle style = pointStyle();
        // Averages over pixels, exactly.
        const auto grid = NoiseGrid::create(texton, style.noise, zoom);
        TXN_OK(grid);
        const auto truth = grid->render({0, 0, size});
        TXN_OK(truth);
        const double deviation = std::sqrt(energy(*truth, texton));
        const PlaneView view{0.5 * size.width / zoom, 0.5 * size.height / zoom, zoom};
        m_renderer->setTexton(shared(texton));
        for (const Filter filter : {Filter::Mipmap, Filter::Anisotropic}) {
            style.filter = filter;
            const auto image = picture(view, style, size);
            TXN_OK(image);
            QVERIFY(allFinite(image->samples()));
            const double ratio = std::sqrt(energy(*image, texton)) / deviation;
            const double error = rmsDifference(image->samples(), truth->samples()) / deviation;
            qInfo("%s: ratio of deviations %.3f, rms difference %.3f of them",
                  filter == Filter::Mipmap ? "mipmap" : "anisotropic",
                  ratio,
                  error);
            // Mipmaps are blends of blurs instead of boxes, sharpest between two levels; kernels
            // here are nearly white, the worst case.
            TXN_AT_MOST(std::abs(ratio - 1.0), zoom == 0.7 ? 0.3 : 0.2);
            TXN_AT_MOST(error, 0.6);
            // Means of a hundred footprints and more.
            for (int c = 0; c < 3; ++c)
                TXN_AT_MOST(std::abs(meanOf(image->plane(c)) - meanOf(truth->plane(c))),
                            0.1 * deviation);
        }
    }

    /// Filtering sets in gently: the artist who zooms sees no step.
    void zoomingPastOneDoesNotJump() {
        for (const int order : {0, 1, 3}) {
            const Texton texton = makeTexton({order, 1, {22, 18}, 3, 52});
            m_renderer->setTexton(shared(texton));
            for (const Filter filter : {Filter::Mipmap, Filter::Anisotropic}) {
                NoiseStyle style = pointStyle();
                style.filter = filter;
                const auto at = [&](const View& view) {
                    const auto image = picture(view, style, {96, 96});
                    return image ? std::sqrt(energy(*image, texton)) : 0.0;
                };
                GroundView ground = towardsTheHorizon(0.0, std::numbers::pi / 2.0);
                for (const double zoom : {1.0, 0.999, 0.99}) {
                    ground.zoom = zoom;
                    TXN_AT_MOST(std::abs(at(PlaneView{0.0, 0.0, zoom}) / at(PlaneView{}) - 1.0),
                                0.04);
                    TXN_AT_MOST(std::abs(at(ground) / at(PlaneView{0.0, 0.0, zoom}) - 1.0), 0.04);
                }
            }
        }
    }

    /// The driver's own filter, slow where the processor draws.
    void theHardwaresFilterIsLikeOurs() {
        const Size size{48, 48};
        const GroundView view = towardsTheHorizon(0.2, 0.4);
        NoiseStyle style = pointStyle();
        style.supersampling = 8;
        const auto truth = picture(view, style, size);
        style.supersampling = 1;
        const auto none = picture(view, style, size);
        style.filter = Filter::Hardware;
        const auto hardware = picture(view, style, size);
        TXN_OK(truth);
        TXN_OK(none);
        TXN_OK(hardware);
        QVERIFY(allFinite(hardware->samples()));
        // Drivers filter as they like; it must be of some use.
        TXN_AT_MOST(rmsDifference(hardware->samples(), truth->samples()),
                    0.7 * rmsDifference(none->samples(), truth->samples()));
    }
};

QTEST_APPLESS_MAIN(TestGlFilter)
#include "TestGlFilter.moc"
