// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/BuiltinMeshes.h"
#include "core/noise/SpotNoise.h"
#include "gl/MaterialTextons.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace txn;
using namespace txn::test;

namespace {

constexpr Size kSize{40, 32};

const MaterialMaps kMaps{{"color", MapKind::Color, 3},
                         {"normal", MapKind::Normal, 2},
                         {"height", MapKind::Height, 1},
                         {"roughness", MapKind::Roughness, 1},
                         {"ao", MapKind::Occlusion, 1},
                         {"extra", MapKind::Data, 2}};

/// A stack without any texture: every point is the same.
Texton evenTexton(std::vector<double> mean) {
    Texton texton;
    texton.support = Support::rectangle({8, 8});
    texton.mean = std::move(mean);
    texton.kernels = {Image({8, 8}, texton.channels())};
    return texton;
}

/// Color, slopes, height, roughness, occlusion and two of data.
Texton sloping(double slopeX, double slopeY) {
    return evenTexton({0.5, 0.5, 0.5, slopeX, slopeY, 0.5, 0.7, 1.0, 0.0, 0.0});
}

Light from(double azimuthDegrees, double elevationDegrees) {
    return {azimuthDegrees * std::numbers::pi / 180.0, elevationDegrees * std::numbers::pi / 180.0};
}

} // namespace

/// Textons of many channels on the graphics card, and materials under a light.
class TestGlMaterial : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { TXN_NEEDS_GL(m_context); }

    /// All channels of all maps are the processor's, with several kernels as with one.
    void everyChannelIsTheProcessors_data() {
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("order");
        for (const int kernels : {1, 2, 4}) {
            for (const int order : {1, 3})
                QTest::addRow("Q %d order %d", kernels, order) << kernels << order;
        }
    }
    void everyChannelIsTheProcessors() {
        QFETCH(int, kernels);
        QFETCH(int, order);
        const Texton texton = makeTexton({order, kernels, {11, 8}, channelCount(kMaps), 5, 0.1});
        const NoiseStyle style = pointStyle(NoiseProcess::Stratified, 9.0);
        const PlaneView view{4.0, -3.0};
        const SpotNoise noise(texton, style.noise);
        std::vector<double> expected(texton.mean.size());
        for (std::size_t m = 0; m < kMaps.size(); ++m) {
            const Texton part = mapTexton(texton, kMaps, m);
            QCOMPARE(part.channels(), kMaps[m].channels);
            const Image drawn = draw(part, nullptr, view, style);
            double worst = 0.0;
            for (int y = 0; y < kSize.height; ++y) {
                for (int x = 0; x < kSize.width; ++x) {
                    noise.evaluate(view.centerX + x + 0.5 - 0.5 * kSize.width,
                                   view.centerY + y + 0.5 - 0.5 * kSize.height,
                                   expected);
                    for (int c = 0; c < part.channels(); ++c) {
                        const auto from = static_cast<std::size_t>(firstChannel(kMaps, m) + c);
                        worst = std::max(worst, std::abs(drawn.at(x, y, c) - expected[from]));
                    }
                }
            }
            TXN_AT_MOST(worst, 1e-4);
        }
    }

    /// What tilts towards the light is brighter, in all views.
    void slopesTurnToTheLight_data() {
        QTest::addColumn<QString>("view");
        QTest::addColumn<int>("method");
        QTest::newRow("per pixel") << "plane" << static_cast<int>(PlaneMethod::PerPixel);
        QTest::newRow("tiles") << "plane" << static_cast<int>(PlaneMethod::Tiles);
        QTest::newRow("ground") << "ground" << 0;
        QTest::newRow("mesh") << "mesh" << 0;
    }
    void slopesTurnToTheLight() {
        QFETCH(QString, view);
        QFETCH(int, method);
        NoiseStyle style = pointStyle(NoiseProcess::Stratified, 9.0);
        style.planeMethod = static_cast<PlaneMethod>(method);
        const auto brightness = [&](double slopeX, double slopeY, double azimuth) {
            const auto material = materialTextons(sloping(slopeX, slopeY), kMaps);
            style.light = from(azimuth, 40.0);
            return middle(draw(*material.base, material.relief, viewOf(view), style));
        };
        const double flat = brightness(0.0, 0.0, 0.0);
        QVERIFY(flat > 0.05 && flat < 1.0);
        // Falling to the right, it faces right; falling down, down.
        QVERIFY(brightness(-0.5, 0.0, 0.0) > flat + 0.02);
        QVERIFY(brightness(-0.5, 0.0, 180.0) < flat - 0.02);
        QVERIFY(brightness(0.0, -0.5, 270.0) > brightness(0.0, 0.5, 270.0) + 0.05);
        QVERIFY(brightness(0.0, -0.5, 90.0) < brightness(0.0, 0.5, 90.0) - 0.05);
    }

    void turnedPlanesTurnTheirSlopes() {
        NoiseStyle style = pointStyle(NoiseProcess::Stratified, 9.0);
        style.light = from(270.0, 40.0); // from below
        const auto material = materialTextons(sloping(-0.5, 0.0), kMaps);
        PlaneView view;
        view.rotation = 0.5 * std::numbers::pi; // clockwise: right becomes down
        const double towards = middle(draw(*material.base, material.relief, view, style));
        view.rotation = -0.5 * std::numbers::pi;
        const double away = middle(draw(*material.base, material.relief, view, style));
        QVERIFY(towards > away + 0.05);
    }

    void roughnessOcclusionAndMetalCount() {
        NoiseStyle style = pointStyle(NoiseProcess::Stratified, 9.0);
        style.light = from(0.0, 90.0);
        const MaterialMaps maps{{"color", MapKind::Color, 3}, {"orm", MapKind::Packed, 3}};
        const auto brightness = [&](double occlusion, double roughness, double metalness) {
            const auto material =
                materialTextons(evenTexton({0.5, 0.5, 0.5, occlusion, roughness, metalness}), maps);
            return middle(draw(*material.base, material.relief, PlaneView{}, style));
        };
        QVERIFY(brightness(1.0, 0.8, 0.0) > brightness(0.0, 0.8, 0.0) + 0.02);
        QVERIFY(brightness(1.0, 0.2, 0.0) > brightness(1.0, 0.9, 0.0) + 0.02); // a highlight
        QVERIFY(std::abs(brightness(1.0, 0.8, 1.0) - brightness(1.0, 0.8, 0.0)) > 0.02);
    }

    void missingMapsAreDefined() {
        const auto material = materialTextons(evenTexton({0.3}), {{"height", MapKind::Height, 1}});
        QVERIFY(material.base->mean == (std::vector<double>{0.5, 0.5, 0.5, 1.0}));
        QVERIFY(material.relief->mean == (std::vector<double>{0.0, 0.0, 0.6, 0.0}));
        const Image drawn = draw(*material.base,
                                 material.relief,
                                 PlaneView{},
                                 pointStyle(NoiseProcess::Poisson, 9.0));
        for (const float v : drawn.samples())
            QVERIFY(std::isfinite(v));
    }

  private:
    static View viewOf(const QString& name) {
        if (name == "plane")
            return PlaneView{};
        OrbitCamera fromAbove;
        fromAbove.pitch = 1.2;
        if (name == "ground") {
            GroundView ground;
            ground.camera = fromAbove;
            return ground;
        }
        MeshView mesh; // of a plane that lies on the ground
        mesh.mapping = MeshView::Mapping::TextureCoordinates;
        mesh.camera = fromAbove;
        return mesh;
    }

    Image draw(const Texton& base,
               const std::shared_ptr<const Texton>& relief,
               const View& view,
               const NoiseStyle& style) {
        NoiseRenderer renderer;
        renderer.setTexton(std::make_shared<const Texton>(base));
        renderer.setRelief(relief);
        if (std::holds_alternative<MeshView>(view))
            renderer.setMesh(std::make_shared<const TriangleMesh>(*builtinMesh("plane")));
        const auto target = OffscreenTarget::create(m_context->gl(), kSize);
        if (auto ok = renderer.draw(m_context->gl(), view, style, *target); !ok) {
            QTest::qFail(ok.error().message.c_str(), __FILE__, __LINE__);
            return Image(kSize, 4);
        }
        return target->read(4, Transfer::Encoded);
    }

    static double middle(const Image& image) {
        return image.at(kSize.width / 2, kSize.height / 2, 0);
    }

    std::optional<HeadlessContext> m_context;
};

QTEST_APPLESS_MAIN(TestGlMaterial)
#include "TestGlMaterial.moc"
