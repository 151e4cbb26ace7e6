// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ColorTransfer.h"
#include "core/mesh/BuiltinMeshes.h"
#include "core/mesh/TangentField.h"
#include "core/noise/SpotNoise.h"
#include "core/noise/SurfaceNoise.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

constexpr float kBackground = 9.0F; ///< far from any noise
constexpr double kSigmas = 5.0;     ///< in standard errors of a mean over seeds

/// What a pixel sees of a mesh.
struct Hit {
    glm::dvec3 point;
    glm::dvec3 normal;
    glm::dvec3 tangent;
    glm::dvec2 uv;
};

/// Rays of the camera that the views describe, written down once more.
class Eye {
  public:
    Eye(const OrbitCamera& camera, const BoundingSphere& bounds, Size size)
        : m_size(size), m_focal(0.5 * size.height / std::tan(0.5 * camera.fieldOfView)) {
        const double cp = std::cos(camera.pitch);
        const double sp = std::sin(camera.pitch);
        const double cy = std::cos(camera.yaw);
        const double sy = std::sin(camera.yaw);
        m_back = {cp * sy, sp, cp * cy};
        m_right = {cy, 0.0, -sy};
        m_up = {-sp * sy, cp, -sp * cy};
        // 5 percent of room around the sphere, at distance 1.
        m_place = glm::dvec3(bounds.center) +
                  m_back * (camera.distance * 1.05 * static_cast<double>(bounds.radius) /
                            std::sin(0.5 * camera.fieldOfView));
    }
    const glm::dvec3& place() const { return m_place; }
    glm::dvec3 ray(int x, int y) const {
        return (x + 0.5 - 0.5 * m_size.width) * m_right - (y + 0.5 - 0.5 * m_size.height) * m_up -
               m_focal * m_back;
    }

  private:
    Size m_size;
    double m_focal;
    glm::dvec3 m_back, m_right, m_up, m_place;
};

/// The nearest triangle on a ray; all of them are looked at.
std::optional<Hit> firstHit(const TriangleMesh& mesh,
                            const std::vector<glm::vec3>& tangents,
                            const glm::dvec3& from,
                            const glm::dvec3& ray) {
    double nearest = 1e300;
    std::optional<Hit> hit;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t[0]]);
        const glm::dvec3 ab = glm::dvec3(mesh.positions[t[1]]) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.positions[t[2]]) - a;
        const glm::dvec3 p = glm::cross(ray, ac);
        const double det = glm::dot(ab, p);
        if (std::abs(det) < 1e-14)
            continue;
        const glm::dvec3 s = from - a;
        const double u = glm::dot(s, p) / det;
        const glm::dvec3 q = glm::cross(s, ab);
        const double v = glm::dot(ray, q) / det;
        const double distance = glm::dot(ac, q) / det;
        if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0 || distance >= nearest)
            continue;
        nearest = distance;
        const auto mix = [&](const auto& values) {
            using Double =
                std::conditional_t<sizeof(values[0]) == sizeof(glm::vec2), glm::dvec2, glm::dvec3>;
            return (1.0 - u - v) * Double(values[t[0]]) + u * Double(values[t[1]]) +
                   v * Double(values[t[2]]);
        };
        hit = Hit{from + distance * ray, mix(mesh.normals), mix(tangents), {}};
        if (!mesh.uvs.empty())
            hit->uv = mix(mesh.uvs);
    }
    return hit;
}

SurfaceFrame frameOf(const Hit& hit) {
    const glm::dvec3 normal = glm::normalize(hit.normal);
    const glm::dvec3 right = glm::normalize(hit.tangent - glm::dot(hit.tangent, normal) * normal);
    return {right, glm::cross(right, normal), normal};
}

/// All vertices of the second half of the triangles are copies, put behind the others.
TriangleMesh splitInHalf(const TriangleMesh& mesh) {
    TriangleMesh split = mesh;
    for (std::size_t t = mesh.triangles.size() / 2; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t& vertex : split.triangles[t]) {
            const std::uint32_t copy = static_cast<std::uint32_t>(split.positions.size());
            split.positions.push_back(mesh.positions[vertex]);
            split.normals.push_back(mesh.normals[vertex]);
            if (!mesh.uvs.empty())
                split.uvs.push_back(mesh.uvs[vertex]);
            vertex = copy;
        }
    }
    return split;
}

MeshView unlit(double pixelsPerUnit, const OrbitCamera& camera) {
    MeshView view;
    view.pixelsPerUnit = pixelsPerUnit;
    view.camera = camera;
    view.lighting = false;
    view.background = glm::vec3(kBackground);
    return view;
}

/// Textons unlike each other, and a map over what is between -side / 2 and side / 2, texel by texel
/// anything.
Mixture mixtureOf(int textons, TextonRecipe recipe, double side) {
    Mixture mixture;
    for (int r = 0; r < textons; ++r) {
        mixture.textons.push_back(makeTexton(recipe));
        for (double& mean : mixture.textons.back().mean)
            mean += 0.4 * r;
        ++recipe.seed;
    }
    mixture.map = {Image(Size{19, 13}, 1), {-0.5 * side, -0.5 * side, side, side}};
    TestRandom random(69);
    for (float& rho : mixture.map.rho.samples())
        rho = static_cast<float>(random.uniform());
    return mixture;
}

const OrbitCamera kFromAbove{0.0, std::numbers::pi / 2.0, 0.35, 0.8}; // nothing but mesh

} // namespace

class TestGlSurface : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;
    std::optional<NoiseRenderer> m_renderer;
    std::shared_ptr<const TriangleMesh> m_plane, m_sphere, m_torus;

    void setUp(const Mixture& mixture, const std::shared_ptr<const TriangleMesh>& mesh) {
        m_renderer->setTextons(std::make_shared<const std::vector<Texton>>(mixture.textons));
        m_renderer->setField(
            std::make_shared<const TextonField>(mixture.map,
                                                static_cast<int>(mixture.textons.size()),
                                                mixture.textons.front().footprint()));
        m_renderer->setMesh(mesh);
    }
    Result<Image> picture(const View& view, const NoiseStyle& style, Size size, int channels = 4) {
        return drawn(m_context->gl(), *m_renderer, view, style, size, channels);
    }

  private slots:
    void initTestCase() {
        TXN_NEEDS_GL(m_context);
        m_renderer.emplace();
        m_plane = std::make_shared<const TriangleMesh>(planeMesh(4));
        m_sphere = std::make_shared<const TriangleMesh>(sphereMesh());
        m_torus = std::make_shared<const TriangleMesh>(torusMesh());
    }

    void cleanupTestCase() {
        m_renderer.reset();
        m_context.reset();
    }

    void aFlatMeshShowsSurfaceNoise_data() {
        QTest::addColumn<int>("process");
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::addColumn<double>("meanImpacts");
        QTest::addColumn<int>("textons");
        for (const int process : {0, 1, 2}) {
            const char* name = toString(static_cast<NoiseProcess>(process)).data();
            for (const int order : {0, 1, 3, 5})
                QTest::addRow("%s order %d", name, order)
                    << process << order << 1 << 3 << 24.0 << 1;
            for (const int channels : {1, 2, 4})
                QTest::addRow("%s channels %d", name, channels)
                    << process << 1 << 3 << channels << 24.0 << 1;
            for (const double impacts : {0.5, 200.0})
                QTest::addRow("%s MNI %g", name, impacts) << process << 1 << 2 << 1 << impacts << 1;
            for (const int order : {0, 1, 3}) {
                for (const int kernels : {1, 3}) {
                    if (process != static_cast<int>(NoiseProcess::Poisson))
                        QTest::addRow("%s mixture order %d Q %d", name, order, kernels)
                            << process << order << kernels << 3 << 24.0 << 5;
                }
            }
        }
    }

    void aFlatMeshShowsSurfaceNoise() {
        QFETCH(int, process);
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        QFETCH(double, meanImpacts);
        QFETCH(int, textons);
        const Mixture mixture =
            mixtureOf(textons, {order, kernels, {13, 9}, channels, 61, 0.3}, 40.0);
        setUp(mixture, m_plane);
        const Size size{41, 32};
        const MeshView view = unlit(43.7, kFromAbove);
        const NoiseStyle style = pointStyle(static_cast<NoiseProcess>(process), meanImpacts);
        const auto image = picture(view, style, size);
        TXN_OK(image);
        const SurfaceNoise noise(mixture, style.noise);
        // Seen from above: x to the right, z down.
        const SurfaceFrame frame{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
        const Eye eye(view.camera, boundingSphere(*m_plane), size);
        Image expected(size, 4);
        std::vector<double> values(static_cast<std::size_t>(channels));
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const glm::dvec3 ray = eye.ray(x, y);
                const glm::dvec3 point = eye.place() - ray * (eye.place().y / ray.y);
                noise.evaluate(point * view.pixelsPerUnit, frame, values);
                for (int c = 0; c < 4; ++c) {
                    const auto shown = shownChannel(channels, c);
                    expected.at(x, y, c) =
                        shown ? static_cast<float>(values[static_cast<std::size_t>(*shown)])
                              : (c == 3 ? 1.0F : 0.0F);
                }
            }
        }
        // Places are interpolated in single precision: some 1e-5 pixels.
        if (order == 0)
            TXN_AT_MOST(shareBeyond(image->samples(), expected.samples(), 1e-3), 2e-3);
        else
            TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), 1e-3);
        QVERIFY(meanImpacts < 1.0 || varianceOf(image->plane(0)) > 0.3);
    }

    /// Every pixel by a ray: camera, depth, interpolated normals and tangents, background.
    void curvedMeshesShowSurfaceNoise_data() {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("pitch");
        QTest::addColumn<double>("distance");
        QTest::addColumn<int>("textons");
        for (const int textons : {1, 5}) {
            const char* of = textons == 1 ? "" : " mixture";
            QTest::addRow("sphere%s", of) << "sphere" << 0.0 << 0.0 << 1.0 << textons;
            QTest::addRow("sphere aside%s", of) << "sphere" << 2.3 << 0.9 << 0.7 << textons;
            QTest::addRow("torus%s", of) << "torus" << 0.5 << 0.4 << 1.0 << textons;
            QTest::addRow("torus from below%s", of) << "torus" << -2.0 << -0.7 << 1.3 << textons;
            QTest::addRow("plane at an angle%s", of) << "plane" << 0.7 << 0.5 << 0.8 << textons;
        }
    }

    void curvedMeshesShowSurfaceNoise() {
        QFETCH(QString, mesh);
        QFETCH(double, yaw);
        QFETCH(double, pitch);
        QFETCH(double, distance);
        const auto& shape = mesh == "sphere" ? m_sphere : mesh == "torus" ? m_torus : m_plane;
        QFETCH(int, textons);
        const Mixture mixture = mixtureOf(textons, {1, 2, {13, 9}, 3, 62, 0.3}, 70.0);
        setUp(mixture, shape);
        const auto tangents = tangentField(*shape);
        const Size size{37, 29};
        const Eye eye({yaw, pitch, distance, 0.8}, boundingSphere(*shape), size);
        for (const auto mapping :
             {MeshView::Mapping::Surface, MeshView::Mapping::TextureCoordinates}) {
            MeshView view = unlit(30.0, {yaw, pitch, distance, 0.8});
            view.mapping = mapping;
            const NoiseStyle style = pointStyle();
            const auto image = picture(view, style, size, 3);
            TXN_OK(image);
            const SurfaceNoise surface(mixture, style.noise);
            const SpotNoise plane(mixture, style.noise);
            const double perUv = view.pixelsPerUnit * unitsPerUv(*shape).value_or(0.0);
            Image expected(size, 3);
            std::vector<double> values(3);
            int seen = 0;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const auto hit = firstHit(*shape, tangents, eye.place(), eye.ray(x, y));
                    values.assign(3, static_cast<double>(kBackground));
                    seen += hit ? 1 : 0;
                    if (hit && mapping == MeshView::Mapping::Surface)
                        surface.evaluate(hit->point * view.pixelsPerUnit, frameOf(*hit), values);
                    else if (hit)
                        plane.evaluate(hit->uv.x * perUv, -hit->uv.y * perUv, values);
                    for (int c = 0; c < 3; ++c)
                        expected.at(x, y, c) =
                            static_cast<float>(values[static_cast<std::size_t>(c)]);
                }
            }
            QVERIFY(seen > 200);
            // Outlines and edges of triangles may fall to either side, and tangents turn fast
            // around singular points.
            TXN_AT_MOST(shareBeyond(image->samples(), expected.samples(), 5e-3), 0.01);
        }
    }

    void meanAndVarianceAreThoseOfThePlane_data() {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<int>("process");
        for (const char* mesh : {"plane", "sphere"}) {
            for (const int process : {0, 1, 2})
                QTest::addRow("%s %s", mesh, toString(static_cast<NoiseProcess>(process)).data())
                    << mesh << process;
        }
    }

    void meanAndVarianceAreThoseOfThePlane() {
        QFETCH(QString, mesh);
        QFETCH(int, process);
        const Texton texton = makeTexton({1, 2, {9, 8}, 2, 63, 0.3});
        setUp(texton, mesh == "sphere" ? m_sphere : m_plane);
        // A sphere of some 200 pixels, 20 kernels across.
        const MeshView view =
            unlit(100.0, mesh == "sphere" ? OrbitCamera{0.4, 0.5, 1.0, 0.8} : kFromAbove);
        std::array<std::vector<double>, 2> means;
        std::array<std::vector<double>, 2> variances;
        std::vector<double> links;
        for (std::uint32_t seed = 1; seed <= 30; ++seed) {
            const auto image = picture(view,
                                       pointStyle(static_cast<NoiseProcess>(process), 16.0, seed),
                                       {72, 72},
                                       3);
            TXN_OK(image);
            std::array<double, 2> sum{};
            std::array<double, 2> squares{};
            double products = 0.0;
            int count = 0;
            for (std::size_t i = 0; i < image->plane(0).size(); ++i) {
                if (image->plane(2)[i] == kBackground)
                    continue;
                ++count;
                std::array<double, 2> d{};
                for (std::size_t c = 0; c < 2; ++c) {
                    d[c] =
                        static_cast<double>(image->plane(static_cast<int>(c))[i]) - texton.mean[c];
                    sum[c] += d[c];
                    squares[c] += d[c] * d[c];
                }
                products += d[0] * d[1];
            }
            QVERIFY(count > 2000);
            for (std::size_t c = 0; c < 2; ++c) {
                means[c].push_back(sum[c] / count);
                variances[c].push_back(squares[c] / count);
            }
            links.push_back(products / count);
        }
        const auto covariance = noiseCovariance(texton);
        for (std::size_t c = 0; c < 2; ++c) {
            const Estimate mean = estimate(means[c]);
            TXN_AT_MOST(std::abs(mean.mean), kSigmas * mean.error);
            TXN_AT_MOST(mean.error, 0.03);
            const Estimate variance = estimate(variances[c]);
            TXN_AT_MOST(std::abs(variance.mean - covariance[3 * c]), kSigmas * variance.error);
            TXN_AT_MOST(variance.error, 0.04);
        }
        const Estimate link = estimate(links);
        TXN_AT_MOST(std::abs(link.mean - covariance[1]), kSigmas * link.error);
    }

    void copiesOfVerticesDoNotShow() {
        const Texton texton = makeTexton({1, 1, {13, 9}, 3, 64});
        for (const auto& mesh : {m_sphere, m_torus}) {
            const MeshView view = unlit(40.0, {0.3, 0.4, 1.0, 0.8});
            setUp(texton, mesh);
            const auto whole = picture(view, pointStyle(), {64, 64});
            setUp(texton, std::make_shared<const TriangleMesh>(splitInHalf(*mesh)));
            const auto split = picture(view, pointStyle(), {64, 64});
            TXN_OK(whole);
            TXN_OK(split);
            TXN_AT_MOST(largestDifference(whole->samples(), split->samples()), 1e-3);
        }
    }

    void theSeamOfTheTextureCoordinatesDoesNotShow() {
        // Both sides of the seam have vertices of their own, at the same places and with the same
        // tangents; noise is continuous over it.
        const auto tangents = tangentField(*m_sphere);
        const Weld weld = weldByPosition(m_sphere->positions);
        std::vector<std::optional<glm::vec3>> first(weld.pointCount);
        int copies = 0;
        for (std::size_t i = 0; i < tangents.size(); ++i) {
            // At the poles, where the copies are many, a direction has no one tangent.
            if (std::abs(m_sphere->positions[i].y) > 0.999F)
                continue;
            auto& known = first[weld.pointOfVertex[i]];
            if (known) {
                ++copies;
                TXN_AT_MOST(static_cast<double>(glm::length(*known - tangents[i])), 1e-4);
            }
            known = tangents[i];
        }
        QVERIFY(copies > 50);
    }

    void textureCoordinatesLayThePlaneOverTheMesh() {
        const Texton texton = makeTexton({1, 2, {13, 9}, 3, 65});
        setUp(texton, m_plane);
        MeshView view = unlit(31.0, kFromAbove);
        view.mapping = MeshView::Mapping::TextureCoordinates;
        const Size size{48, 48};
        const auto image = picture(view, pointStyle(), size, 3);
        TXN_OK(image);
        const SpotNoise noise(texton, pointStyle().noise);
        const Eye eye(view.camera, boundingSphere(*m_plane), size);
        Image expected(size, 3);
        std::vector<double> values(3);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const glm::dvec3 ray = eye.ray(x, y);
                const glm::dvec3 point = eye.place() - ray * (eye.place().y / ray.y);
                // The square [-1, 1]^2 is 62 pixels wide; its corner u = v = 0 lies at the bottom
                // left, where x = -1 and z = 1.
                noise.evaluate((point.x + 1.0) * 31.0, (point.z - 1.0) * 31.0, values);
                for (int c = 0; c < 3; ++c)
                    expected.at(x, y, c) = static_cast<float>(values[static_cast<std::size_t>(c)]);
            }
        }
        TXN_AT_MOST(largestDifference(image->samples(), expected.samples()), 1e-3);
    }

    void lightOnlyScalesTheColours() {
        Texton texton = makeTexton({1, 1, {13, 9}, 3, 66});
        for (Image& kernel : texton.kernels) {
            for (float& v : kernel.samples())
                v *= 0.1F; // colours of a photograph, above 0
        }
        const Size size{48, 48};
        for (const auto& mesh : {m_plane, m_sphere}) {
            std::vector<double> shades;
            Image linearShade;
            for (const Transfer transfer : {Transfer::Linear, Transfer::Encoded}) {
                texton.transfer = transfer;
                setUp(texton, mesh);
                MeshView view = unlit(30.0, {0.2, 0.7, 1.0, 0.8});
                const auto plain = picture(view, pointStyle(), size, 3);
                view.lighting = true;
                const auto lit = picture(view, pointStyle(), size, 3);
                TXN_OK(plain);
                TXN_OK(lit);
                QVERIFY(allFinite(lit->samples()));
                if (transfer == Transfer::Linear)
                    linearShade = Image(size, 1);
                const float background =
                    transfer == Transfer::Linear ? linearFromEncoded(kBackground) : kBackground;
                int count = 0;
                for (int y = 0; y < size.height; ++y) {
                    for (int x = 0; x < size.width; ++x) {
                        if (plain->at(x, y, 0) == background) {
                            QCOMPARE(lit->at(x, y, 0), background);
                            continue;
                        }
                        ++count;
                        for (int c = 0; c < 3; ++c) {
                            const auto light = [&](float v) {
                                const auto value = static_cast<double>(v);
                                if (transfer == Transfer::Linear)
                                    return value;
                                return value <= 0.04045 ? value / 12.92
                                                        : std::pow((value + 0.055) / 1.055, 2.4);
                            };
                            const double shade =
                                light(lit->at(x, y, c)) / light(plain->at(x, y, c));
                            if (transfer == Transfer::Linear && c == 0) {
                                linearShade.at(x, y, 0) = static_cast<float>(shade);
                                shades.push_back(shade);
                            }
                            // The same light on all channels and in both transfers.
                            TXN_AT_MOST(
                                std::abs(shade - static_cast<double>(linearShade.at(x, y, 0))),
                                1e-3);
                        }
                    }
                }
                QVERIFY(count > 500);
            }
            const auto [low, high] = std::minmax_element(shades.begin(), shades.end());
            QVERIFY(*low > 0.05 && *high < 1.2);
            if (mesh == m_plane)
                TXN_AT_MOST(*high - *low, 1e-4); // one normal, one shade
            else
                QVERIFY(*high - *low > 0.2);
        }
    }

    void aroundTheMeshIsBackground() {
        setUp(makeTexton({1, 1, {13, 9}, 3, 67}), m_sphere);
        for (const Filter filter : {Filter::None, Filter::Mipmap, Filter::Anisotropic}) {
            MeshView view = unlit(30.0, {0.2, 0.7, 1.0, 0.8});
            view.background = glm::vec3(0.1F, 0.2F, 0.3F);
            NoiseStyle style = pointStyle();
            style.filter = filter;
            const auto image = picture(view, style, {64, 48});
            TXN_OK(image);
            QVERIFY(allFinite(image->samples()));
            for (const auto& [x, y] : {std::pair{0, 0}, {63, 0}, {0, 47}, {63, 47}}) {
                for (int c = 0; c < 4; ++c)
                    QCOMPARE(image->at(x, y, c), c == 3 ? 1.0F : 0.1F * static_cast<float>(c + 1));
            }
            QVERIFY(image->at(32, 24, 0) != 0.1F);
        }
    }

    void backgroundsLookTheSameInLinearPictures() {
        Texton texton = makeTexton({1, 1, {13, 9}, 3, 67});
        texton.transfer = Transfer::Linear;
        setUp(texton, m_sphere);
        MeshView view = unlit(30.0, {0.2, 0.7, 1.0, 0.8});
        view.background = glm::vec3(0.1F, 0.5F, 0.9F);
        const auto image = picture(view, pointStyle(), {16, 12});
        TXN_OK(image);
        for (int c = 0; c < 3; ++c)
            QCOMPARE(image->at(0, 0, c), linearFromEncoded(view.background[c]));
    }

    void filteredMeshesLookAlike() {
        // Close by there is nothing to filter, and far away the noise gets fainter.
        setUp(makeTexton({1, 2, {22, 18}, 3, 68, 0.1}), m_plane);
        for (const auto mapping :
             {MeshView::Mapping::Surface, MeshView::Mapping::TextureCoordinates}) {
            MeshView view = unlit(14.0, kFromAbove);
            view.mapping = mapping;
            NoiseStyle style = pointStyle();
            const auto exact = picture(view, style, {64, 64}, 3);
            style.filter = Filter::Anisotropic;
            const auto filtered = picture(view, style, {64, 64}, 3);
            TXN_OK(exact);
            TXN_OK(filtered);
            // Averages of a quarter of an exemplar pixel, mostly.
            TXN_AT_MOST(rmsDifference(exact->samples(), filtered->samples()), 0.05);
            view.pixelsPerUnit = 400.0;
            style.supersampling = 6;
            style.filter = Filter::None;
            const auto truth = picture(view, style, {48, 48}, 3);
            style.supersampling = 1;
            const auto raw = picture(view, style, {48, 48}, 3);
            style.filter = Filter::Anisotropic;
            const auto far = picture(view, style, {48, 48}, 3);
            TXN_OK(truth);
            TXN_OK(raw);
            TXN_OK(far);
            TXN_AT_MOST(rmsDifference(far->samples(), truth->samples()),
                        0.5 * rmsDifference(raw->samples(), truth->samples()));
        }
    }
};

QTEST_APPLESS_MAIN(TestGlSurface)
#include "TestGlSurface.moc"
