// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageIo.h"
#include "core/mesh/BuiltinMeshes.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <filesystem>

using namespace txn;
using namespace txn::test;

namespace {

constexpr Size kSize{64, 48};

/// Integers and roots only: the same on every machine.
Texton goldenTexton() {
    Texton texton = makeTexton({1, 2, {18, 14}, 3, 81, 0.2});
    for (Image& kernel : texton.kernels) {
        for (float& v : kernel.samples())
            v *= 0.15F;
    }
    return texton;
}

NoiseStyle styleOf(Filter filter) {
    NoiseStyle style = pointStyle();
    style.filter = filter;
    return style;
}

} // namespace

Q_DECLARE_METATYPE(View)
Q_DECLARE_METATYPE(NoiseStyle)

/// Pictures as they once were, looked at and found good. TXN_UPDATE_GOLDEN=1 draws them anew.
class TestGlGolden : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;

  private slots:
    void initTestCase() { TXN_NEEDS_GL(m_context); }
    void cleanupTestCase() { m_context.reset(); }

    void picturesStayAsTheyAre_data() {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<View>("view");
        QTest::addColumn<NoiseStyle>("style");
        QTest::newRow("plane") << "" << View{PlaneView{123.4, -56.7, 1.6, 0.5}}
                               << styleOf(Filter::None);
        GroundView ground;
        ground.camera = {0.4, 0.35, 1.0, 0.8};
        ground.zoom = 1.5;
        QTest::newRow("ground") << "" << View{ground} << styleOf(Filter::Mipmap);
        // So near that no outline is seen, which might run by a pixel's centre.
        MeshView byUv;
        byUv.mapping = MeshView::Mapping::TextureCoordinates;
        byUv.pixelsPerUnit = 60.0;
        byUv.camera = {0.5, 0.6, 0.45, 0.7};
        QTest::newRow("mesh") << "sphere" << View{byUv} << styleOf(Filter::None);
        MeshView surface;
        surface.pixelsPerUnit = 50.0;
        surface.camera = {0.3, 0.9, 0.3, 0.5};
        QTest::newRow("surface") << "plane" << View{surface} << styleOf(Filter::None);
    }

    void picturesStayAsTheyAre() {
        QFETCH(QString, mesh);
        QFETCH(View, view);
        QFETCH(NoiseStyle, style);
        NoiseRenderer renderer;
        renderer.setTexton(shared(goldenTexton()));
        if (!mesh.isEmpty()) {
            auto shape = builtinMesh(mesh.toStdString());
            QVERIFY(shape.has_value());
            renderer.setMesh(std::make_shared<const TriangleMesh>(std::move(*shape)));
        }
        const auto image = drawn(m_context->gl(), renderer, view, style, kSize, 3);
        TXN_OK(image);
        const std::filesystem::path path = std::filesystem::path(TXN_SOURCE_DIR) / "tests/golden" /
                                           (std::string(QTest::currentDataTag()) + ".exr");
        if (qEnvironmentVariableIntValue("TXN_UPDATE_GOLDEN") == 1) {
            std::filesystem::create_directories(path.parent_path());
            TXN_OK(saveImage(*image, path));
            QSKIP("drawn anew");
        }
        const auto golden = loadImage(path);
        TXN_OK(golden);
        // Half floats of values about 1 are off by up to 2.5e-4. Other drivers weigh texels in
        // steps of 1/256 and round levels, which shows where contrasts are sharp.
        TXN_AT_MOST(rmsDifference(image->samples(), golden->image.samples()), 2e-3);
        TXN_AT_MOST(largestDifference(image->samples(), golden->image.samples()), 2e-2);
        QVERIFY(varianceOf(image->plane(0)) > 1e-3);
    }
};

QTEST_APPLESS_MAIN(TestGlGolden)
#include "TestGlGolden.moc"
