// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/BuiltinMeshes.h"
#include "core/noise/MixedProcess.h"
#include "gl/MaterialTextons.h"
#include "tests/helpers/GlReference.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>
#include <epoxy/gl.h>
#include <functional>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

/// As for plain noise: see TestGlNoise. The noise has a standard deviation of 1, or near it.
constexpr double kTolerance = 1e-4;
constexpr double kSigmas = 5.0; ///< in standard errors of a mean over seeds

using TextonList = std::shared_ptr<const std::vector<Texton>>;

TextonList listOf(std::vector<Texton> textons) {
    return std::make_shared<const std::vector<Texton>>(std::move(textons));
}

/// Unlike each other in everything that may differ, means far apart.
TextonList textonsOf(int count, TextonRecipe recipe) {
    std::vector<Texton> textons;
    for (int r = 0; r < count; ++r) {
        textons.push_back(makeTexton(recipe));
        for (double& mean : textons.back().mean)
            mean += 0.7 * r;
        ++recipe.seed;
        recipe.offset += 0.2;
    }
    return listOf(std::move(textons));
}

/// No noise, only means.
TextonList meansOf(int count, Size support) {
    std::vector<Texton> textons = *textonsOf(count, {1, 1, support, 3, 71});
    for (Texton& texton : textons)
        texton.kernels = {Image(support, 3)};
    return listOf(std::move(textons));
}

MixingMap evenMap(double rho) {
    MixingMap map;
    map.rho.at(0, 0, 0) = static_cast<float>(rho);
    return map;
}

/// Anything, texel by texel.
MixingMap randomMap(Size texels, const MapPlacement& placement, MapBoundary boundary) {
    MixingMap map{Image(texels, 1), placement, boundary};
    TestRandom random(77);
    for (float& rho : map.rho.samples())
        rho = static_cast<float>(random.uniform());
    return map;
}

/// All A to the left of x = 0, all B to the right.
MixingMap twoSides() {
    MixingMap map{Image(Size{2, 1}, 1), {-1000.0, -1000.0, 2000.0, 2000.0}, MapBoundary::Clamp};
    map.rho.at(1, 0, 0) = 1.0F;
    return map;
}

std::shared_ptr<const TextonField> fieldOf(const TextonList& textons, const MixingMap& map) {
    return std::make_shared<const TextonField>(map,
                                               static_cast<int>(textons->size()),
                                               textons->front().footprint());
}

/// Columns [from, to) of a picture.
Image columns(const Image& image, int from, int to) {
    Image part(Size{to - from, image.height()}, image.channels());
    for (int c = 0; c < image.channels(); ++c) {
        for (int y = 0; y < image.height(); ++y)
            std::copy(image.row(c, y).begin() + from,
                      image.row(c, y).begin() + to,
                      part.row(c, y).begin());
    }
    return part;
}

struct Case {
    NoiseProcess process = NoiseProcess::Stratified;
    int order = 1;
    int kernels = 1;
    int channels = 3;
    int textons = 5;
    MixingMap map = randomMap({40, 31}, {-30.0, -34.0, 61.0, 49.0}, MapBoundary::Clamp);
    std::optional<Period> period;
    PlaneView view{3.25, -7.5};
    PlaneMethod method = PlaneMethod::PerPixel;
    int supersampling = 1;
};

} // namespace

Q_DECLARE_METATYPE(Case)

/// Noise of several textons and a map on the graphics card.
class TestGlMixture : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;
    std::optional<NoiseRenderer> m_renderer; // keeps its shaders from row to row

    Result<Image>
    picture(const View& view, const NoiseStyle& style, Size size = {60, 44}, int channels = 4) {
        return drawn(m_context->gl(), *m_renderer, view, style, size, channels);
    }
    Result<Image> mixed(const TextonList& textons,
                        const MixingMap& map,
                        const View& view,
                        const NoiseStyle& style,
                        Size size = {60, 44}) {
        m_renderer->setTextons(textons);
        m_renderer->setReliefs(nullptr);
        m_renderer->setField(fieldOf(textons, map));
        return picture(view, style, size);
    }
    Result<Image>
    plain(const Texton& texton, const View& view, const NoiseStyle& style, Size size = {60, 44}) {
        m_renderer->setTexton(shared(texton));
        m_renderer->setRelief(nullptr);
        return picture(view, style, size);
    }

    /// All ways to draw, near and far.
    static void views() {
        QTest::addColumn<int>("view");
        QTest::addColumn<int>("filter");
        QTest::addColumn<double>("scale");
        const char* names[] = {"pixels", "tiles", "ground", "mesh", "surface"};
        const std::pair<const char*, Filter> filters[] = {{"none", Filter::None},
                                                          {"mipmap", Filter::Mipmap},
                                                          {"anisotropic", Filter::Anisotropic}};
        for (int view = 0; view < 5; ++view) {
            for (const auto& [filter, value] : filters) {
                for (const double scale : {1.0, 0.3, 1.0 / 40.0}) // pixels per exemplar pixel
                    QTest::addRow("%s %s %g", names[view], filter, scale)
                        << view << static_cast<int>(value) << scale;
            }
        }
    }
    static View viewOf(int view, double scale) {
        if (view < 2)
            return PlaneView{1.5, -2.0, scale, 0.4};
        if (view == 2)
            return GroundView{1.5, -2.0, scale, {0.2, 0.3, 1.0, 0.8}};
        MeshView mesh;
        mesh.mapping =
            view == 3 ? MeshView::Mapping::TextureCoordinates : MeshView::Mapping::Surface;
        mesh.pixelsPerUnit = 30.0 / scale;
        mesh.camera = {0.1, 0.3, 0.8, 0.8};
        mesh.lighting = false;
        return mesh;
    }
    static NoiseStyle styleOf(int view, int filter) {
        NoiseStyle style = pointStyle();
        style.filter = static_cast<Filter>(filter);
        style.planeMethod = view == 1 ? PlaneMethod::Tiles : PlaneMethod::PerPixel;
        return style;
    }

  private slots:
    void initTestCase() {
        TXN_NEEDS_GL(m_context);
        m_renderer.emplace();
        m_renderer->setMesh(std::make_shared<const TriangleMesh>(sphereMesh()));
    }

    void cleanupTestCase() {
        m_renderer.reset();
        m_context.reset();
    }

    void everyPixelIsAPointOfTheMixture_data() {
        QTest::addColumn<Case>("c");
        for (const PlaneMethod method : {PlaneMethod::PerPixel, PlaneMethod::Tiles}) {
            const char* how = method == PlaneMethod::Tiles ? "tiles" : "pixels";
            const auto add = [&](const QByteArray& name, const std::function<void(Case&)>& change) {
                Case c;
                c.method = method;
                change(c);
                QTest::addRow("%s %s", how, name.constData()) << c;
            };
            for (const auto process : {NoiseProcess::Stratified, NoiseProcess::Signed}) {
                for (const int order : {0, 1, 3}) {
                    for (const int kernels : {1, 3})
                        add(QByteArray(toString(process).data()) + " order " +
                                QByteArray::number(order) + " Q " + QByteArray::number(kernels),
                            [&](Case& c) {
                                c.process = process;
                                c.order = order;
                                c.kernels = kernels;
                            });
                }
            }
            for (const int channels : {1, 2, 4})
                add(QByteArray::number(channels) + " channels",
                    [&](Case& c) { c.channels = channels; });
            for (const int textons : {2, TextonField::kMaxTextons})
                add(QByteArray::number(textons) + " textons",
                    [&](Case& c) { c.textons = textons; });
            for (const MapBoundary boundary : {MapBoundary::Clamp, MapBoundary::Repeat}) {
                const QByteArray name = boundary == MapBoundary::Clamp ? "clamp" : "repeat";
                // Footprints are 13 x 11 pixels.
                add(name + " small texels", [&](Case& c) {
                    c.map = randomMap({90, 70}, {-21.3, -24.7, 43.7, 31.9}, boundary);
                });
                add(name + " large texels", [&](Case& c) {
                    c.map = randomMap({4, 3}, {-60.1, -64.2, 97.0, 85.0}, boundary);
                });
                add(name + " beside the view", [&](Case& c) {
                    c.map = randomMap({4, 3}, {400.0, 300.0, 97.0, 85.0}, boundary);
                });
                add(name + " thin", [&](Case& c) {
                    c.map = randomMap({1, 70}, {-21.3, -24.7, 0.4, 57.0}, boundary);
                });
                add(name + " turned and enlarged", [&](Case& c) {
                    c.map.boundary = boundary;
                    c.view.zoom = 1.7;
                    c.view.rotation = 0.4;
                });
                for (const auto& [x, y] :
                     {std::pair{1e6, 1e6}, {-1e6, 3e6}, {49999000.5, -49999000.25}}) {
                    add(name + " at " + QByteArray::number(x) + " " + QByteArray::number(y),
                        [&, x = x, y = y](Case& c) {
                            c.map.boundary = boundary;
                            c.map.placement.left += x;
                            c.map.placement.top += y;
                            c.view.centerX = x;
                            c.view.centerY = y;
                            c.view.rotation = 0.4;
                            c.view.zoom = 1.7;
                        });
                }
            }
            add("far from its map", [](Case& c) {
                c.map.boundary = MapBoundary::Repeat;
                c.view.centerX = -1e6;
                c.view.centerY = 3e6;
            });
            add("period", [](Case& c) {
                c.map.boundary = MapBoundary::Repeat;
                c.period = Period{122.0, 49.0};
                c.view.centerX = -1003.0;
            });
            add("supersampled", [](Case& c) { c.supersampling = 2; });
        }
    }

    void everyPixelIsAPointOfTheMixture() {
        QFETCH(Case, c);
        const TextonList textons =
            textonsOf(c.textons, {c.order, c.kernels, {11, 9}, c.channels, 21});
        NoiseStyle style = pointStyle(c.process);
        style.noise.period = c.period;
        style.planeMethod = c.method;
        style.supersampling = c.supersampling;
        const Size size{60, 44};
        const auto image = mixed(textons, c.map, c.view, style, size);
        TXN_OK(image);
        const Image expected = reference(
            {*textons, c.map},
            style.noise,
            size,
            [&](double x, double y) { return planePoint(c.view, size, x, y); },
            c.supersampling);
        if (c.order ==
            0) // Where a pixel sits on the edge of a coefficient, rounding picks the side.
            TXN_AT_MOST(shareBeyond(image->samples(), expected.samples(), kTolerance), 1e-3);
        else
            TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), kTolerance);
        QVERIFY(varianceOf(image->plane(0)) > 0.3);
    }

    void anEvenMapIsPlainNoise_data() { views(); }
    void anEvenMapIsPlainNoise() {
        QFETCH(int, view);
        QFETCH(int, filter);
        QFETCH(double, scale);
        const TextonList textons = textonsOf(4, {1, 2, {11, 9}, 3, 22});
        const NoiseStyle style = styleOf(view, filter);
        for (const int r : {0, 2, 3}) {
            const auto one = mixed(textons, evenMap(r / 3.0), viewOf(view, scale), style);
            const auto other =
                plain((*textons)[static_cast<std::size_t>(r)], viewOf(view, scale), style);
            TXN_OK(one);
            TXN_OK(other);
            TXN_AT_MOST(largestDifference(one->samples(), other->samples()), kTolerance);
            QVERIFY(varianceOf(one->plane(0)) > 1e-4);
        }
    }

    /// Whatever the filter: only near the border do both textons count.
    void farFromTheBorderEachSideIsItsOwn_data() {
        QTest::addColumn<int>("filter");
        QTest::addColumn<double>("zoom");
        for (const double zoom : {1.0, 0.3, 1.0 / 20.0}) {
            QTest::addRow("none %g", zoom) << static_cast<int>(Filter::None) << zoom;
            QTest::addRow("mipmap %g", zoom) << static_cast<int>(Filter::Mipmap) << zoom;
            QTest::addRow("anisotropic %g", zoom) << static_cast<int>(Filter::Anisotropic) << zoom;
        }
    }
    void farFromTheBorderEachSideIsItsOwn() {
        QFETCH(int, filter);
        QFETCH(double, zoom);
        const TextonList textons = textonsOf(2, {1, 2, {11, 9}, 3, 23});
        const PlaneView view{0.0, 0.0, zoom};
        const NoiseStyle style = styleOf(0, filter);
        const Size size{120, 30};
        const auto both = mixed(textons, twoSides(), view, style, size);
        const auto left = plain((*textons)[0], view, style, size);
        const auto right = plain((*textons)[1], view, style, size);
        TXN_OK(both);
        TXN_OK(left);
        TXN_OK(right);
        TXN_AT_MOST(
            largestDifference(columns(*both, 0, 25).samples(), columns(*left, 0, 25).samples()),
            kTolerance);
        TXN_AT_MOST(largestDifference(columns(*both, 95, 120).samples(),
                                      columns(*right, 95, 120).samples()),
                    kTolerance);
        QVERIFY(rmsDifference(columns(*left, 0, 25).samples(), columns(*right, 0, 25).samples()) >
                0.1);
    }

    /// Halfway between two textons, mean and variance are halfway, averaged over pixels as well.
    void halfwayTheVarianceIsHalfOfEach_data() {
        QTest::addColumn<int>("filter");
        QTest::addColumn<double>("zoom");
        QTest::newRow("none 1") << static_cast<int>(Filter::None) << 1.0;
        for (const double zoom : {1.0, 0.3, 1.0 / 30.0, 1.0 / 64.0})
            QTest::addRow("anisotropic %g", zoom) << static_cast<int>(Filter::Anisotropic) << zoom;
    }
    void halfwayTheVarianceIsHalfOfEach() {
        QFETCH(int, filter);
        QFETCH(double, zoom);
        // Coarse and fine: averages over many pixels are far fainter for the second.
        TextonList textons = listOf(
            {makeTexton({1, 2, {11, 9}, 1, 24, 2.0}), makeTexton({1, 2, {11, 9}, 1, 25, 0.0})});
        const PlaneView view{0.0, 0.0, zoom};
        std::vector<double> means;
        std::vector<double> variances[3];
        for (std::uint32_t seed = 1; seed <= 30; ++seed) {
            NoiseStyle style = pointStyle(NoiseProcess::Signed, 8.0, seed);
            style.filter = static_cast<Filter>(filter);
            const std::array images{
                mixed(textons, evenMap(0.5), view, style, {96, 96}),
                plain((*textons)[0], view, style, {96, 96}),
                plain((*textons)[1], view, style, {96, 96}),
            };
            for (std::size_t i = 0; i < images.size(); ++i) {
                TXN_OK(images[i]);
                const double mean = meanOf(images[i]->plane(0));
                const double off = mean - 0.5;
                variances[i].push_back(varianceOf(images[i]->plane(0)) + off * off);
                if (i == 0)
                    means.push_back(mean);
            }
        }
        const Estimate mean = estimate(means);
        TXN_AT_MOST(std::abs(mean.mean - 0.5), kSigmas * mean.error);
        const Estimate both = estimate(variances[0]);
        const Estimate coarse = estimate(variances[1]);
        const Estimate fine = estimate(variances[2]);
        TXN_AT_MOST(std::abs(both.mean - 0.5 * (coarse.mean + fine.mean)),
                    kSigmas * (both.error + 0.5 * (coarse.error + fine.error)));
        TXN_AT_MOST(both.error, 0.05 * both.mean);
        QVERIFY(zoom == 1.0 || coarse.mean > 2.0 * fine.mean);
    }

    /// At an angle, with and without noise.
    void theGroundShowsTheMixture_data() {
        QTest::addColumn<bool>("noise");
        QTest::newRow("means") << false;
        QTest::newRow("noise") << true;
    }
    void theGroundShowsTheMixture() {
        QFETCH(bool, noise);
        const TextonList textons =
            noise ? textonsOf(5, {1, 2, {11, 9}, 3, 26}) : meansOf(5, {11, 9});
        const MixingMap map =
            randomMap({23, 17}, {-90.0, -150.0, 180.0, 160.0}, MapBoundary::Clamp);
        GroundView view{13.0, -21.5, 1.3, {0.0, 0.7, 1.0, 0.8}};
        const Size size{61, 46};
        const double focal = 0.5 * size.height / std::tan(0.5 * view.camera.fieldOfView);
        const double far = focal / view.zoom; // from the eye to the centre
        const double sine = std::sin(view.camera.pitch);
        const double cosine = std::cos(view.camera.pitch);
        // The camera looks north, where y is negative.
        const auto where = [&](double x, double y) {
            const double u = (x - 0.5 * size.width) / focal;
            const double v = (y - 0.5 * size.height) / focal;
            const double t = far * sine / (sine + v * cosine); // along the ray
            return std::optional(std::pair{view.centerX + t * u,
                                           view.centerY + far * cosine - t * (cosine - v * sine)});
        };
        const NoiseStyle style = pointStyle();
        const auto image = mixed(textons, map, view, style, size);
        TXN_OK(image);
        const Image expected = reference({*textons, map}, style.noise, size, where);
        TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), 4e-4);
        QVERIFY(varianceOf(image->plane(0)) > 0.05);
    }

    /// Up to the horizon nothing but the border of the map is left, or its average.
    void farAwayTheMeanIsThatOfTheMap() {
        const TextonList textons = meansOf(2, {11, 9});
        MixingMap map = randomMap({64, 64}, {-64.0, -64.0, 128.0, 128.0}, MapBoundary::Repeat);
        NoiseStyle style = pointStyle();
        style.filter = Filter::Anisotropic;
        const PlaneView above{0.0, 0.0, 1.0 / 64.0};
        const double first = textons->front().mean[0];
        const double second = textons->back().mean[0];
        const double average = first + (second - first) * meanOf(map.rho.samples());
        const auto repeated = mixed(textons, map, above, style);
        TXN_OK(repeated);
        for (const float v : repeated->plane(0))
            TXN_AT_MOST(std::abs(static_cast<double>(v) - average), 0.03);
        GroundView ground{0.0, 0.0, 1.0, {0.3, 0.2, 1.0, 0.8}};
        ground.background = glm::vec3(9.0F);
        const auto horizon = mixed(textons, map, ground, style);
        TXN_OK(horizon);
        int seen = 0;
        for (int y = 0; y < horizon->height(); ++y) {
            const float v = horizon->at(30, y, 0);
            if (v == 9.0F || horizon->at(30, std::max(y - 1, 0), 0) == 9.0F || ++seen > 5)
                continue;
            TXN_AT_MOST(std::abs(static_cast<double>(v) - average), 0.05);
        }
        QVERIFY(seen > 5);
        // Everything but the border is the other one.
        map.boundary = MapBoundary::Clamp;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                map.rho.at(x, y, 0) = x < 32 ? 0.0F : 1.0F;
        }
        const auto clamped = mixed(textons, map, above, style);
        TXN_OK(clamped);
        for (int y = 0; y < clamped->height(); ++y) {
            TXN_AT_MOST(std::abs(static_cast<double>(clamped->at(20, y, 0)) - first), 1e-5);
            TXN_AT_MOST(std::abs(static_cast<double>(clamped->at(40, y, 0)) - second), 1e-5);
        }
    }

    void materialsAreMixedByOneMap_data() {
        QTest::addColumn<int>("method");
        QTest::newRow("pixels") << static_cast<int>(PlaneMethod::PerPixel);
        QTest::newRow("tiles") << static_cast<int>(PlaneMethod::Tiles);
    }
    void materialsAreMixedByOneMap() {
        QFETCH(int, method);
        const MaterialMaps maps{{"color", MapKind::Color, 3},
                                {"normal", MapKind::Normal, 2},
                                {"roughness", MapKind::Roughness, 1},
                                {"ao", MapKind::Occlusion, 1}};
        std::vector<Texton> stacks;
        for (int r = 0; r < 2; ++r) {
            stacks.push_back(makeTexton(
                {1, 2, {11, 9}, channelCount(maps), 27 + static_cast<std::uint64_t>(r)}));
            for (Image& kernel : stacks.back().kernels) {
                for (float& v : kernel.samples())
                    v *= 0.15F;
            }
            stacks.back().mean = {0.2 + 0.4 * r, 0.5, 0.6 - 0.4 * r, 0.1 * r, 0.0, 0.8, 0.9};
        }
        const MixedMaterial material = mixedMaterial(stacks, maps);
        const PlaneView view{0.0, 0.0};
        NoiseStyle style = pointStyle();
        style.planeMethod = static_cast<PlaneMethod>(method);
        const Size size{120, 30};
        m_renderer->setTextons(material.bases);
        m_renderer->setReliefs(material.reliefs);
        m_renderer->setField(fieldOf(material.bases, twoSides()));
        const auto both = picture(view, style, size);
        TXN_OK(both);
        std::vector<Image> sides;
        for (const Texton& stack : stacks) {
            const MaterialTextons one = materialTextons(stack, maps);
            m_renderer->setTexton(one.base);
            m_renderer->setRelief(one.relief);
            auto side = picture(view, style, size);
            TXN_OK(side);
            sides.push_back(std::move(*side));
        }
        m_renderer->setRelief(nullptr);
        TXN_AT_MOST(
            largestDifference(columns(*both, 0, 45).samples(), columns(sides[0], 0, 45).samples()),
            kTolerance);
        TXN_AT_MOST(largestDifference(columns(*both, 75, 120).samples(),
                                      columns(sides[1], 75, 120).samples()),
                    kTolerance);
        QVERIFY(rmsDifference(sides[0].samples(), sides[1].samples()) > 0.05);
    }

    void paintingUploadsNoTextons() {
        const TextonList textons = textonsOf(3, {1, 2, {11, 9}, 3, 29});
        NoiseStyle style = pointStyle();
        style.filter = Filter::Anisotropic;
        TXN_OK(mixed(textons, evenMap(0.0), PlaneView{}, style));
        // Textons are the only textures with layers.
        static int s_uploads = 0;
        static auto s_upload = epoxy_glTexImage3D;
        s_uploads = 0;
        s_upload = epoxy_glTexImage3D;
        epoxy_glTexImage3D = [](auto... arguments) {
            ++s_uploads;
            s_upload(arguments...);
        };
        const auto painted = mixed(textons, evenMap(1.0), PlaneView{}, style);
        const int whilePainting = s_uploads;
        const auto other = mixed(textonsOf(3, {1, 2, {11, 9}, 3, 30}), evenMap(1.0), {}, style);
        const int withOthers = s_uploads;
        epoxy_glTexImage3D = s_upload;
        TXN_OK(painted);
        TXN_OK(other);
        QCOMPARE(whilePainting, 0);
        QVERIFY(withOthers > 0);
        const auto expected = plain(textons->back(), PlaneView{}, style);
        TXN_OK(expected);
        TXN_AT_MOST(largestDifference(painted->samples(), expected->samples()), kTolerance);
    }

    void whatDoesNotFitIsAnError() {
        const TextonList textons = textonsOf(3, {1, 1, {11, 9}, 3, 31});
        const auto refused = [&](const TextonList& list,
                                 const std::shared_ptr<const TextonField>& field,
                                 NoiseStyle style = pointStyle()) {
            m_renderer->setTextons(list);
            m_renderer->setField(field);
            return picture(PlaneView{}, style);
        };
        const auto field = fieldOf(textons, evenMap(0.5));
        TXN_OK(refused(textons, field));
        TXN_FAILS_WITH(refused(textons, nullptr), ErrorCode::InvalidArgument);
        const TextonList two = textonsOf(2, {1, 1, {11, 9}, 3, 31});
        TXN_FAILS_WITH(refused(two, field), ErrorCode::InvalidArgument);
        TXN_FAILS_WITH(refused(listOf({}), field), ErrorCode::InvalidArgument);

        const NoiseStyle poisson = pointStyle(NoiseProcess::Poisson);
        const auto asReference = checkMixedNoise({*textons, evenMap(0.5)}, poisson.noise);
        const auto signs = refused(textons, field, poisson);
        TXN_FAILS_WITH(signs, ErrorCode::InvalidArgument);
        QCOMPARE(signs.error().message, asReference.error().message);
        NoiseStyle periodic = pointStyle();
        periodic.noise.period = Period{40.0, 40.0};
        TXN_FAILS_WITH(refused(textons, field, periodic), ErrorCode::InvalidArgument);

        const auto unlike = [&](TextonRecipe recipe) {
            std::vector<Texton> list = *textons;
            list.back() = makeTexton(recipe);
            return listOf(std::move(list));
        };
        for (const TextonRecipe& recipe : {TextonRecipe{3, 1, {11, 9}, 3},
                                           TextonRecipe{1, 2, {11, 9}, 3},
                                           TextonRecipe{1, 1, {9, 11}, 3},
                                           TextonRecipe{1, 1, {11, 9}, 4}})
            TXN_FAILS_WITH(refused(unlike(recipe), field), ErrorCode::SizeMismatch);
        std::vector<Texton> numbers = *textons;
        numbers[1].kernels[0].at(2, 3, 1) = std::numeric_limits<float>::quiet_NaN();
        const TextonList broken = listOf(std::move(numbers));
        for (int i = 0; i < 2; ++i) // not only the first time
            TXN_FAILS_WITH(refused(broken, field), ErrorCode::Degenerate);

        m_renderer->setReliefs(two);
        TXN_FAILS_WITH(refused(textons, field), ErrorCode::SizeMismatch);
        m_renderer->setReliefs(nullptr);

        const int kernels = m_context->gl().maxTextureLayers() / TextonField::kMaxTextons + 1;
        const TextonList many = textonsOf(TextonField::kMaxTextons, {1, kernels, {1, 1}, 1, 32});
        TXN_FAILS_WITH(refused(many, fieldOf(many, evenMap(0.5))), ErrorCode::TooLarge);
        TXN_OK(refused(textons, field));
    }
};

QTEST_APPLESS_MAIN(TestGlMixture)
#include "TestGlMixture.moc"
