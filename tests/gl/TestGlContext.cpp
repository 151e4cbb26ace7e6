// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/BuiltinMeshes.h"
#include "gl/FramebufferScope.h"
#include "gl/GlHandle.h"
#include "gl/ShaderFiles.h"
#include "gl/ShaderLibrary.h"
#include "gl/ShaderProgram.h"
#include "gl/ShaderVariants.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

#include <array>
#include <epoxy/gl.h>
#include <limits>
#include <set>

using namespace txn;
using namespace txn::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Size kSize{40, 32};

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

int bound(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

std::array<int, 4> viewport() {
    std::array<int, 4> values{};
    glGetIntegerv(GL_VIEWPORT, values.data());
    return values;
}

/// Views of all kinds that a renderer with a mesh can draw.
std::vector<View> allViews() {
    MeshView byUv;
    byUv.mapping = MeshView::Mapping::TextureCoordinates;
    return {PlaneView{}, GroundView{}, MeshView{}, byUv};
}

std::shared_ptr<const TriangleMesh> smallPlane() {
    return std::make_shared<const TriangleMesh>(planeMesh(2));
}

} // namespace

class TestGlContext : public QObject {
    Q_OBJECT

    std::optional<HeadlessContext> m_context;

    const GlContext& gl() { return m_context->gl(); }

    NoiseRenderer fullRenderer(const TextonRecipe& recipe = {}) {
        NoiseRenderer renderer;
        renderer.setTexton(shared(makeTexton(recipe)));
        renderer.setMesh(smallPlane());
        return renderer;
    }

  private slots:
    void initTestCase() { TXN_NEEDS_GL(m_context); }

    void viewsCanBeDrawnInPieces() {
        for (const View& view : allViews()) {
            auto renderer = fullRenderer();
            const auto whole = drawn(gl(), renderer, view, pointStyle(), kSize);
            TXN_OK(whole);
            const auto target = OffscreenTarget::create(gl(), kSize);
            TXN_OK(target);
            for (int y = 0; y < kSize.height; y += 11) {
                const Rect piece{0, y, {kSize.width, std::min(11, kSize.height - y)}};
                TXN_OK(renderer.draw(gl(), view, pointStyle(), *target, piece));
            }
            QVERIFY(target->read(4, Transfer::Encoded) == *whole);
            // What is outside the piece stays.
            auto other = pointStyle();
            other.noise.seed = {99};
            TXN_OK(renderer.draw(gl(), view, other, *target, Rect{0, 8, {kSize.width, 8}}));
            const Image changed = target->read(4, Transfer::Encoded);
            for (int y = 0; y < kSize.height; ++y) {
                const bool inside = y >= 8 && y < 16;
                const auto row = changed.row(0, y);
                const auto before = whole->row(0, y);
                const bool equal = std::equal(row.begin(), row.end(), before.begin());
                QVERIFY(inside || equal);
            }
        }
    }
    void cleanupTestCase() { m_context.reset(); }

    void init() {
        if (m_context)
            m_context->makeCurrent();
    }

    /// No call has left an error behind.
    void cleanup() {
        if (m_context) {
            m_context->makeCurrent();
            QCOMPARE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        }
    }

    void theContextIsDescribed() {
        QVERIFY(!gl().renderer().empty());
        QVERIFY(!gl().version().empty());
        QVERIFY(gl().maxAnisotropy() >= 1.0F);
        QVERIFY(gl().maxTextureSide() >= 1024); // what OpenGL 3.3 promises
        QVERIFY(gl().maxTextureLayers() >= 256);
        QCOMPARE(gl().isSoftware(), gl().renderer().find("llvmpipe") != std::string::npos);
    }

    void shaderTextsAreComplete() {
        for (const ShaderFile& file : shaderFiles()) {
            const auto text = shaderText(file.name, {{"TXN_ANY", "17"}, {"TXN_OTHER", "1"}});
            TXN_OK(text);
            QVERIFY(
                text->starts_with("#version 330 core\n#define TXN_ANY 17\n#define TXN_OTHER 1\n"));
            QCOMPARE(count(*text, "#version"), 1);
            QCOMPARE(count(*text, "#include"), 0);
            // Files that are included on several ways are there once.
            QVERIFY(count(*text, "uvec4 txnHash(uvec4 v)") <= 1);
            QVERIFY(count(*text, "TxnPixel txnPixel(vec2 dx, vec2 dy)") <= 3); // #if, #else
        }
        const auto plane = shaderText("plane.frag");
        TXN_OK(plane);
        QCOMPARE(count(*plane, "uvec4 txnHash(uvec4 v)"), 1);
        QVERIFY(plane->find("vec4 textonNoise(") != std::string::npos);
        for (const char* name : {"", "plane", "plane.frag ", "../plane.frag", "nothing.glsl"})
            TXN_FAILS_WITH(shaderText(name), ErrorCode::NotFound);
        const auto missing = shaderText("nothing.glsl");
        QVERIFY(missing.error().message.find("nothing.glsl") != std::string::npos);
    }

    void brokenShadersComeBackWithTheLog() {
        const std::string good = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
        const std::string paint =
            "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
        TXN_OK(ShaderProgram::build(gl(), "fine", good, paint));
        const auto fails =
            [&](const std::string& vertex, const std::string& fragment, const std::string& word) {
                const auto program = ShaderProgram::build(gl(), "the-name", vertex, fragment);
                return !program && program.error().code == ErrorCode::Unsupported &&
                       program.error().message.find("the-name") != std::string::npos &&
                       program.error().message.find(word) != std::string::npos;
            };
        QVERIFY(fails("#version 330 core\nvoid main() { blorb(); }\n", paint, "blorb"));
        QVERIFY(fails(good, "#version 330 core\nvoid main() { wibble = 1; }\n", "wibble"));
        // What compiles and does not link: the two disagree about a type.
        QVERIFY(fails("#version 330 core\nout vec4 between;\n"
                      "void main() { between = vec4(1.0); gl_Position = between; }\n",
                      "#version 330 core\nin vec3 between;\nout vec4 color;\n"
                      "void main() { color = vec4(between, 1.0); }\n",
                      "between"));
        ShaderVariants variants("fullscreen.vert", "not-there.frag");
        TXN_FAILS_WITH(variants.get(gl(), {}), ErrorCode::NotFound);
    }

    void variantsAreCompiledOnce() {
        ShaderVariants variants("fullscreen.vert", "average.frag");
        const auto first = variants.get(gl(), {{"A", "1"}});
        const auto other = variants.get(gl(), {{"A", "2"}});
        const auto again = variants.get(gl(), {{"A", "1"}});
        TXN_OK(first);
        TXN_OK(other);
        TXN_OK(again);
        QVERIFY(*first == *again);
        QVERIFY(*first != *other);
    }

    void unknownUniformsAreIgnored() {
        ShaderVariants variants("fullscreen.vert", "average.frag");
        const auto program = variants.get(gl(), {});
        TXN_OK(program);
        (*program)->use();
        (*program)->set("notThere", 1.0F);
        (*program)->set("notThere", 1);
        glUseProgram(0);
        QCOMPARE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }

    void everyVariantCompilesAndDraws_data() {
        QTest::addColumn<int>("order");
        for (const int order : {0, 1, 3, 5})
            QTest::addRow("order %d", order) << order;
    }

    void everyVariantCompilesAndDraws() {
        QFETCH(int, order);
        NoiseRenderer renderer = fullRenderer({order, 2, {9, 7}, 4, 71});
        const Size size{8, 6};
        for (const View& view : allViews()) {
            for (const Filter filter :
                 {Filter::None, Filter::Mipmap, Filter::Anisotropic, Filter::Hardware}) {
                for (const PlaneMethod method : {PlaneMethod::PerPixel, PlaneMethod::Tiles}) {
                    if (!std::holds_alternative<PlaneView>(view) && method == PlaneMethod::Tiles)
                        continue;
                    NoiseStyle style = pointStyle();
                    style.filter = filter;
                    style.planeMethod = method;
                    for (const int n : {1, 2}) {
                        style.supersampling = n;
                        const auto image = drawn(gl(), renderer, view, style, size);
                        TXN_OK(image);
                        QVERIFY(allFinite(image->samples()));
                    }
                }
            }
        }
    }

    void handlesOwnWhatTheyMake() {
        for (const auto kind : {GlHandle::Kind::Buffer,
                                GlHandle::Kind::VertexArray,
                                GlHandle::Kind::Texture,
                                GlHandle::Kind::Framebuffer,
                                GlHandle::Kind::Renderbuffer,
                                GlHandle::Kind::Program}) {
            GlHandle handle = GlHandle::make(gl(), kind);
            QVERIFY(handle);
            handle.reset();
            QVERIFY(!handle);
            QCOMPARE(handle.id(), 0U);
            handle.reset();
        }
    }

    void handlesMove() {
        const auto exists = [](unsigned id) { return glIsProgram(id) == GL_TRUE; };
        GlHandle a = GlHandle::make(gl(), GlHandle::Kind::Program);
        const unsigned first = a.id();
        QVERIFY(exists(first));
        GlHandle b = std::move(a);
        QVERIFY(!a); // moved from on purpose
        QCOMPARE(b.id(), first);
        GlHandle c = GlHandle::make(gl(), GlHandle::Kind::Program);
        const unsigned second = c.id();
        b = std::move(c);
        QCOMPARE(b.id(), second);
        QVERIFY(!exists(first)); // what was in b is gone
        QVERIFY(exists(second));
        b = std::move(b);
        QVERIFY(exists(second));
        { const GlHandle d = std::move(b); }
        QVERIFY(!exists(second));
        QVERIFY(!b);
    }

    void emptyThingsNeedNoContext() {
        m_context.reset();
        {
            GlHandle handle;
            handle.reset();
            const GlHandle other = std::move(handle);
            const OffscreenTarget target;
            QVERIFY(!target);
            NoiseRenderer renderer = fullRenderer();
            renderer.release();
            NoiseRenderer moved = std::move(renderer);
            moved.setTexton(nullptr);
            moved.setMesh(nullptr);
        }
        TXN_NEEDS_GL(m_context);
    }

    void theContextMayGoFirst() {
        NoiseRenderer renderer = fullRenderer();
        OffscreenTarget target;
        GlHandle handle;
        {
            const auto context = HeadlessContext::create();
            TXN_OK(context);
            target = std::move(*OffscreenTarget::create(context->gl(), kSize));
            handle = GlHandle::make(context->gl(), GlHandle::Kind::Texture);
            for (const View& view : allViews())
                TXN_OK(renderer.draw(context->gl(), view, {}, target));
        }
        // Numbers of the dead context are in use again in this one: they must survive.
        m_context->makeCurrent();
        std::vector<GlHandle> others;
        for (int i = 0; i < 200; ++i)
            others.push_back(GlHandle::make(gl(), GlHandle::Kind::Program));
        handle.reset();
        target = {};
        renderer.release();
        for (const GlHandle& other : others)
            QVERIFY(glIsProgram(other.id()) == GL_TRUE);
    }

    void aNewContextGivesTheSamePicture() {
        NoiseRenderer renderer = fullRenderer({1, 2, {17, 12}, 3, 72});
        for (const View& view : allViews()) {
            for (const Filter filter : {Filter::None, Filter::Anisotropic}) {
                NoiseStyle style = pointStyle();
                style.filter = filter;
                style.supersampling = 2;
                std::vector<Image> images;
                for (int i = 0; i < 2; ++i) {
                    const auto context = HeadlessContext::create();
                    TXN_OK(context);
                    const auto image = drawn(context->gl(), renderer, view, style, kSize);
                    TXN_OK(image);
                    images.push_back(*image);
                }
                // And in one that has been there all the time.
                m_context->makeCurrent();
                images.push_back(*drawn(gl(), renderer, view, style, kSize));
                renderer.release();
                images.push_back(*drawn(gl(), renderer, view, style, kSize));
                renderer.release();
                for (const Image& image : images)
                    QVERIFY(image == images[0]);
                QVERIFY(varianceOf(images[0].plane(0)) > 0.0);
            }
        }
        renderer.release();
    }

    void contextsMayTakeTurns() {
        // Going to and fro makes everything anew; nothing of one is used in the other.
        const auto second = HeadlessContext::create();
        TXN_OK(second);
        NoiseRenderer renderer = fullRenderer();
        std::vector<Image> images;
        for (int i = 0; i < 4; ++i) {
            if (i % 2 == 0)
                m_context->makeCurrent();
            else
                second->makeCurrent();
            // Objects of the other context can only be dropped while it is current.
            const GlContext& context = i % 2 == 0 ? gl() : second->gl();
            const auto image = drawn(context, renderer, PlaneView{}, pointStyle(), kSize);
            TXN_OK(image);
            images.push_back(*image);
            renderer.release();
        }
        for (const Image& image : images)
            QVERIFY(image == images[0]);
        m_context->makeCurrent();
    }

    /// Numbers of objects mean others there: nothing may be deleted.
    void anotherContextIsRefusedWhileTheOldOneHoldsObjects() {
        NoiseRenderer renderer = fullRenderer();
        m_context->makeCurrent();
        TXN_OK(drawn(gl(), renderer, PlaneView{}, pointStyle(), kSize));
        {
            const auto second = HeadlessContext::create();
            TXN_OK(second);
            std::vector<GlHandle> others;
            for (int i = 0; i < 50; ++i)
                others.push_back(GlHandle::make(second->gl(), GlHandle::Kind::Program));
            TXN_FAILS_WITH(drawn(second->gl(), renderer, PlaneView{}, pointStyle(), kSize),
                           ErrorCode::InvalidArgument);
            for (const GlHandle& other : others)
                QVERIFY(glIsProgram(other.id()) == GL_TRUE);
        }
        m_context->makeCurrent();
        TXN_OK(drawn(gl(), renderer, PlaneView{}, pointStyle(), kSize));
        renderer.release();
    }

    void contextsComeAndGo() {
        NoiseRenderer renderer = fullRenderer();
        std::optional<Image> first;
        for (int i = 0; i < 100; ++i) {
            const auto context = HeadlessContext::create();
            TXN_OK(context);
            const auto image = drawn(context->gl(), renderer, PlaneView{}, {}, kSize);
            TXN_OK(image);
            if (!first)
                first = *image;
            QVERIFY(*image == *first);
        }
        m_context->makeCurrent();
    }

    void renderersDoNotDisturbEachOther() {
        NoiseRenderer a = fullRenderer({1, 1, {9, 7}, 3, 73});
        NoiseRenderer b = fullRenderer({3, 2, {12, 12}, 1, 74});
        for (const View& view : allViews()) {
            const auto a1 = drawn(gl(), a, view, {}, kSize);
            const auto b1 = drawn(gl(), b, view, pointStyle(), kSize);
            const auto a2 = drawn(gl(), a, view, {}, kSize);
            const auto b2 = drawn(gl(), b, view, pointStyle(), kSize);
            TXN_OK(a1);
            TXN_OK(b1);
            TXN_OK(a2);
            TXN_OK(b2);
            QVERIFY(*a1 == *a2);
            QVERIFY(*b1 == *b2);
            QVERIFY(!(*a1 == *b1));
        }
    }

    void whatIsSetIsDrawn() {
        // A new texton or mesh in the same renderer, and the old one again.
        const auto one = shared(makeTexton({1, 1, {9, 7}, 3, 75}));
        const auto two = shared(makeTexton({1, 1, {9, 7}, 3, 76}));
        const auto sphere = std::make_shared<const TriangleMesh>(sphereMesh());
        for (const Filter filter : {Filter::None, Filter::Mipmap}) {
            NoiseRenderer renderer;
            NoiseStyle style = pointStyle();
            style.filter = filter;
            const auto look = [&](const auto& texton, const auto& mesh) {
                renderer.setTexton(texton);
                renderer.setMesh(mesh);
                return drawn(gl(), renderer, MeshView{}, style, kSize);
            };
            const auto plane = smallPlane();
            const auto a = look(one, plane);
            const auto b = look(two, plane);
            const auto c = look(one, sphere);
            const auto d = look(one, plane);
            TXN_OK(a);
            TXN_OK(b);
            TXN_OK(c);
            TXN_OK(d);
            QVERIFY(*a == *d);
            QVERIFY(!(*a == *b));
            QVERIFY(!(*a == *c));
        }
    }

    void valuesOutOfRangeAreErrors() {
        NoiseRenderer renderer = fullRenderer();
        const auto target = OffscreenTarget::create(gl(), kSize);
        TXN_OK(target);
        const auto refused = [&](const View& view, const NoiseStyle& style = {}) {
            const auto result = renderer.draw(gl(), view, style, *target);
            return !result && result.error().code == ErrorCode::InvalidArgument &&
                   !result.error().message.empty();
        };
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            QVERIFY(refused(PlaneView{bad}));
            QVERIFY(refused(PlaneView{0.0, bad}));
            QVERIFY(refused(PlaneView{0.0, 0.0, bad}));
            QVERIFY(refused(PlaneView{0.0, 0.0, 1.0, bad}));
            QVERIFY(refused(GroundView{bad}));
            QVERIFY(refused(GroundView{0.0, bad}));
            QVERIFY(refused(GroundView{0.0, 0.0, bad}));
            for (int i = 0; i < 4; ++i) {
                OrbitCamera camera;
                (i == 0   ? camera.yaw
                 : i == 1 ? camera.pitch
                 : i == 2 ? camera.distance
                          : camera.fieldOfView) = bad;
                GroundView ground;
                ground.camera = camera;
                QVERIFY(refused(ground));
                MeshView mesh;
                mesh.camera = camera;
                QVERIFY(refused(mesh));
            }
            MeshView mesh;
            mesh.pixelsPerUnit = bad;
            QVERIFY(refused(mesh));
            NoiseStyle style;
            style.noise.meanImpacts = bad;
            QVERIFY(refused(PlaneView{}, style));
            style = {};
            style.noise.period = Period{bad, 10.0};
            QVERIFY(refused(PlaneView{}, style));
        }
        for (const double zoom : {0.0, -1.0, 1.0 / 65.0, 64.5}) {
            QVERIFY(refused(PlaneView{0.0, 0.0, zoom}));
            QVERIFY(refused(GroundView{0.0, 0.0, zoom}));
        }
        QVERIFY(refused(PlaneView{6e7}));
        QVERIFY(refused(PlaneView{0.0, -6e7}));
        for (const double pitch : {0.0, -0.1, 1.6}) {
            GroundView ground;
            ground.camera.pitch = pitch;
            QVERIFY(refused(ground));
        }
        for (const double pitch : {-1.6, 1.6}) {
            MeshView mesh;
            mesh.camera.pitch = pitch;
            QVERIFY(refused(mesh));
        }
        for (const double field : {0.0, 0.017, 2.7, 3.2}) {
            MeshView mesh;
            mesh.camera.fieldOfView = field;
            QVERIFY(refused(mesh));
        }
        for (const double distance : {0.0, -1.0, 1e3}) {
            MeshView mesh;
            mesh.camera.distance = distance;
            QVERIFY(refused(mesh));
        }
        for (const double scale : {0.0, -3.0}) {
            MeshView mesh;
            mesh.pixelsPerUnit = scale;
            QVERIFY(refused(mesh));
        }
        for (const int n : {-1, 0, 65}) {
            NoiseStyle style;
            style.supersampling = n;
            QVERIFY(refused(PlaneView{}, style));
        }
        for (const double impacts : {0.0, -1.0, 0.099, 1001.0}) {
            NoiseStyle style;
            style.noise.meanImpacts = impacts;
            QVERIFY(refused(PlaneView{}, style));
            TXN_FAILS_WITH(checkStyle(style), ErrorCode::InvalidArgument);
        }
    }

    void theLimitsThemselvesAreDrawn() {
        NoiseRenderer renderer = fullRenderer({1, 1, {9, 7}, 3, 77});
        const Size size{12, 10};
        std::vector<View> views{PlaneView{5e7, -5e7, PlaneView::kMinZoom, 1e6},
                                PlaneView{-5e7, 5e7, PlaneView::kMaxZoom, -1e6}};
        for (const double field : {OrbitCamera::kMinFieldOfView, OrbitCamera::kMaxFieldOfView}) {
            for (const double distance : {0.01, 100.0}) {
                for (const double pitch : {1e-4, 1.5707963267948966}) {
                    GroundView ground;
                    ground.camera = {1.0, pitch, distance, field};
                    views.emplace_back(ground);
                    MeshView mesh;
                    mesh.camera = ground.camera;
                    views.emplace_back(mesh);
                }
            }
        }
        for (const double scale : {1e-30, 1e30}) {
            MeshView mesh;
            mesh.pixelsPerUnit = scale;
            views.emplace_back(mesh);
        }
        for (const View& view : views) {
            for (const Filter filter : {Filter::None, Filter::Mipmap, Filter::Anisotropic}) {
                NoiseStyle style = pointStyle(NoiseProcess::Stratified, 4.0);
                style.filter = filter;
                const auto image = drawn(gl(), renderer, view, style, size);
                TXN_OK(image);
                QVERIFY2(allFinite(image->samples()),
                         qPrintable(QString("view %1 filter %2")
                                        .arg(&view - views.data())
                                        .arg(static_cast<int>(filter))));
            }
        }
    }

    void whatDoesNotFitIsAnError() {
        const auto target = OffscreenTarget::create(gl(), kSize);
        TXN_OK(target);
        NoiseRenderer renderer;
        for (const View& view : allViews())
            TXN_FAILS_WITH(renderer.draw(gl(), view, {}, *target), ErrorCode::InvalidArgument);
        renderer.setTexton(shared(makeTexton({})));
        TXN_OK(renderer.draw(gl(), PlaneView{}, {}, *target));
        TXN_FAILS_WITH(renderer.draw(gl(), MeshView{}, {}, *target), ErrorCode::InvalidArgument);
        renderer.setMesh(std::make_shared<const TriangleMesh>());
        TXN_FAILS_WITH(renderer.draw(gl(), MeshView{}, {}, *target), ErrorCode::InvalidArgument);

        TriangleMesh bare = planeMesh(2);
        bare.uvs.clear();
        renderer.setMesh(std::make_shared<const TriangleMesh>(bare));
        TXN_OK(renderer.draw(gl(), MeshView{}, {}, *target));
        MeshView byUv;
        byUv.mapping = MeshView::Mapping::TextureCoordinates;
        TXN_FAILS_WITH(renderer.draw(gl(), byUv, {}, *target), ErrorCode::InvalidArgument);

        for (const Filter filter : {Filter::None, Filter::Mipmap}) {
            NoiseStyle style;
            style.filter = filter;
            renderer.setTexton(shared(makeTexton({1, 1, {9, 7}, 5})));
            for (const View& view : {View{PlaneView{}}, View{GroundView{}}, View{MeshView{}}})
                TXN_FAILS_WITH(renderer.draw(gl(), view, style, *target),
                               ErrorCode::InvalidArgument);
        }
        // After all that it still draws.
        renderer.setTexton(shared(makeTexton({})));
        TXN_OK(renderer.draw(gl(), PlaneView{}, {}, *target));
        renderer.setTexton(nullptr);
        TXN_FAILS_WITH(renderer.draw(gl(), PlaneView{}, {}, *target), ErrorCode::InvalidArgument);
    }

    void hugeTextonsAreAnErrorOrDrawn() {
        Texton texton = makeTexton({1, 1, {1, 1}, 1, 78});
        texton.support = Support::rectangle({gl().maxTextureSide() + 1, 1});
        texton.kernels[0] = Image(texton.support.size(), 1, 0.01F);
        NoiseRenderer renderer;
        renderer.setTexton(shared(texton));
        const auto target = OffscreenTarget::create(gl(), {4, 4});
        for (const Filter filter : {Filter::None, Filter::Mipmap}) {
            NoiseStyle style = pointStyle();
            style.filter = filter;
            TXN_FAILS_WITH(renderer.draw(gl(), PlaneView{}, style, *target), ErrorCode::TooLarge);
        }
    }

    void targetsAreRefusedWhereTheyMustBe() {
        for (const Size size : {Size{0, 5}, Size{5, 0}, Size{-3, 5}, Size{0, 0}})
            TXN_FAILS_WITH(OffscreenTarget::create(gl(), size), ErrorCode::InvalidArgument);
        const int most = gl().maxTextureSide();
        for (const Size size : {Size{most + 1, 1}, Size{1, most + 1}})
            TXN_FAILS_WITH(OffscreenTarget::create(gl(), size), ErrorCode::TooLarge);
        const auto edge = OffscreenTarget::create(gl(), {most, 1});
        TXN_OK(edge);
        QCOMPARE(edge->size(), (Size{most, 1}));
    }

    void readingBackIsExact() {
        const auto target = OffscreenTarget::create(gl(), {7, 5});
        TXN_OK(target);
        const FramebufferScope restore;
        for (const std::array<float, 4>& values :
             {std::array{0.1F, -0.3F, 123456.789F, 0.0F},
              std::array{1.0F / 3.0F, 3.4e38F, 1e-30F, -1e-30F},
              std::array{-0.0F, 1.0F, 2.0F, 0.99999994F}}) {
            target->bind();
            glClearBufferfv(GL_COLOR, 0, values.data());
            for (const int channels : {1, 2, 3, 4}) {
                const Image image = target->read(channels, Transfer::Linear);
                QCOMPARE(image.channels(), channels);
                QVERIFY(image.transfer() == Transfer::Linear);
                QCOMPARE(image.size(), (Size{7, 5}));
                for (int c = 0; c < channels; ++c) {
                    for (const float v : image.plane(c))
                        QVERIFY(v == values[static_cast<std::size_t>(c)]);
                }
            }
        }
        // The bottom row in OpenGL's way is the last one, and left is left.
        target->bind();
        glEnable(GL_SCISSOR_TEST);
        glScissor(2, 0, 1, 1);
        constexpr std::array kMark{5.0F, 6.0F, 7.0F, 8.0F};
        glClearBufferfv(GL_COLOR, 0, kMark.data());
        glDisable(GL_SCISSOR_TEST);
        const Image image = target->read(4, Transfer::Encoded);
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 7; ++x)
                QCOMPARE(image.at(x, y, 2) == 7.0F, x == 2 && y == 4);
        }
        // Whatever the caller packs its own pixels like.
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        QVERIFY(target->read(4, Transfer::Encoded) == image);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
    }

    void scopesPutBackWhatWasBound() {
        const auto a = OffscreenTarget::create(gl(), {8, 8});
        const auto b = OffscreenTarget::create(gl(), {16, 4});
        TXN_OK(a);
        TXN_OK(b);
        const FramebufferScope whole;
        a->bind();
        const int drawA = bound(GL_DRAW_FRAMEBUFFER_BINDING);
        QVERIFY(drawA != 0);
        b->bind();
        const int drawB = bound(GL_DRAW_FRAMEBUFFER_BINDING);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawA));
        glViewport(1, 2, 3, 4);
        {
            const FramebufferScope scope;
            a->bind();
            QCOMPARE(viewport(), (std::array{0, 0, 8, 8}));
        }
        QCOMPARE(bound(GL_DRAW_FRAMEBUFFER_BINDING), drawB);
        QCOMPARE(bound(GL_READ_FRAMEBUFFER_BINDING), drawA);
        QCOMPARE(viewport(), (std::array{1, 2, 3, 4}));
    }

    void drawingLeavesTheCallersTargetBound() {
        NoiseRenderer renderer = fullRenderer();
        const auto mine = OffscreenTarget::create(gl(), {16, 16});
        const auto target = OffscreenTarget::create(gl(), kSize);
        TXN_OK(mine);
        TXN_OK(target);
        const FramebufferScope whole;
        mine->bind();
        glViewport(2, 3, 5, 7);
        const int framebuffer = bound(GL_DRAW_FRAMEBUFFER_BINDING);
        constexpr std::array kMark{0.5F, 0.25F, 0.125F, 1.0F};
        glClearBufferfv(GL_COLOR, 0, kMark.data());
        for (const View& view : allViews()) {
            for (const int n : {1, 2}) {
                NoiseStyle style;
                style.supersampling = n;
                TXN_OK(renderer.draw(gl(), view, style, *target));
                const Image image = target->read(4, Transfer::Encoded);
                QVERIFY(allFinite(image.samples()));
                QCOMPARE(bound(GL_DRAW_FRAMEBUFFER_BINDING), framebuffer);
                QCOMPARE(bound(GL_READ_FRAMEBUFFER_BINDING), framebuffer);
                QCOMPARE(viewport(), (std::array{2, 3, 5, 7}));
                QVERIFY(!glIsEnabled(GL_DEPTH_TEST));
                QVERIFY(!glIsEnabled(GL_BLEND));
            }
        }
        const Image untouched = mine->read(4, Transfer::Encoded);
        for (int c = 0; c < 4; ++c) {
            for (const float v : untouched.plane(c))
                QCOMPARE(v, kMark[static_cast<std::size_t>(c)]);
        }
    }

    void theCallersStateDoesNotSpoilThePicture() {
        NoiseRenderer renderer = fullRenderer();
        for (const View& view : allViews()) {
            for (const Filter filter : {Filter::None, Filter::Mipmap}) {
                NoiseStyle style = pointStyle();
                style.filter = filter;
                const auto clean = drawn(gl(), renderer, view, style, kSize);
                for (const GLenum test :
                     {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_BLEND})
                    glEnable(test);
                glScissor(0, 0, 2, 2);
                glDepthFunc(GL_NEVER);
                glDepthMask(GL_FALSE);
                glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
                glBlendFunc(GL_ZERO, GL_ZERO);
                glCullFace(GL_FRONT_AND_BACK);
                glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
                glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
                glPixelStorei(GL_PACK_ROW_LENGTH, 3);
                glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                glEnable(GL_RASTERIZER_DISCARD);
                glEnable(GL_COLOR_LOGIC_OP);
                glDepthRange(1.0, 1.0);
                if (view.index() == 0)
                    renderer.release(); // uploads, too
                glActiveTexture(GL_TEXTURE3);
                const auto dirty = drawn(gl(), renderer, view, style, kSize);
                for (const GLenum test :
                     {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_BLEND})
                    glDisable(test);
                glDepthFunc(GL_LESS);
                glDepthMask(GL_TRUE);
                glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
                glCullFace(GL_BACK);
                glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
                glActiveTexture(GL_TEXTURE0);
                TXN_OK(clean);
                TXN_OK(dirty);
                QVERIFY(*clean == *dirty);
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestGlContext)
#include "TestGlContext.moc"
