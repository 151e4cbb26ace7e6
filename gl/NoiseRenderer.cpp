// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/NoiseRenderer.h"

#include "core/mesh/TangentField.h"
#include "gl/AveragePass.h"
#include "gl/CleanState.h"
#include "gl/FramebufferScope.h"
#include "gl/GlContext.h"
#include "gl/MeshPass.h"
#include "gl/TilePass.h"

#include <cmath>
#include <epoxy/gl.h>
#include <numbers>
#include <optional>

namespace txn {

struct NoiseRenderer::MeshData {
    std::shared_ptr<const TriangleMesh> mesh;
    std::vector<glm::vec3> tangents;
    MeshShape shape;
    bool hasTextureCoordinates = false;
};

/// A texton, and what of it is on the card.
struct NoiseRenderer::CardTexton {
    std::shared_ptr<const Texton> texton;
    std::optional<GpuTexton> exact;
    std::optional<GpuTexton> filtered;
};

/// All that lives in one context, and what it was made from.
struct NoiseRenderer::Card {
    std::weak_ptr<const void> life;
    std::shared_ptr<const MeshData> mesh;

    CardTexton base;
    CardTexton relief;
    std::optional<GpuMesh> gpuMesh;
    OffscreenTarget sample;
    OffscreenTarget reliefPicture;
    PlanePass plane;
    TilePass tiles;
    MeshPass meshes;
    AveragePass average;

    explicit Card(const GlContext& context) : life(context.life()) {}
    bool belongsTo(const GlContext& context) const {
        return !life.owner_before(context.life()) && !context.life().owner_before(life);
    }

    Result<void> drawOnce(const NoiseSource& source,
                          const View& view,
                          const OffscreenTarget& target,
                          glm::dvec2 shift,
                          bool smoothOutlines = true);
    /// With its relief, where there is one, drawn first.
    Result<void> drawShaded(NoiseSource source,
                            const View& view,
                            const OffscreenTarget& target,
                            glm::dvec2 shift);
    /// Supersampled.
    Result<void>
    drawAveraged(const NoiseSource& source, const View& view, const OffscreenTarget& target);
};

namespace {

/// Keeps drawing, and clearing, to a part of the picture.
class ScissorScope {
  public:
    ScissorScope(const std::optional<Rect>& part, Size picture) : m_active(part.has_value()) {
        if (!part)
            return;
        glEnable(GL_SCISSOR_TEST);
        glScissor(static_cast<GLint>(part->x),
                  static_cast<GLint>(picture.height - part->y - part->size.height),
                  part->size.width,
                  part->size.height);
    }
    ScissorScope(const ScissorScope&) = delete;
    ScissorScope& operator=(const ScissorScope&) = delete;
    ~ScissorScope() {
        if (m_active)
            glDisable(GL_SCISSOR_TEST);
    }

  private:
    bool m_active;
};

Error outOfRange(const std::string& what, const std::string& range) {
    return Error{ErrorCode::InvalidArgument, what + " must be " + range};
}

bool between(double value, double low, double high) {
    return value >= low && value <= high; // false for NaN
}

Result<void> checkPlace(double centerX, double centerY, double zoom) {
    constexpr double kFarthest = NoiseParams::kFarthest / 2.0;
    if (!between(centerX, -kFarthest, kFarthest) || !between(centerY, -kFarthest, kFarthest))
        return outOfRange("the centre", "within 50 million pixels of the origin");
    if (!between(zoom, PlaneView::kMinZoom, PlaneView::kMaxZoom))
        return outOfRange("the zoom", "1/64 to 64");
    return {};
}

Result<void> checkCamera(const OrbitCamera& camera, double lowestPitch) {
    if (!std::isfinite(camera.yaw))
        return outOfRange("the camera's yaw", "a number");
    constexpr double kUp = std::numbers::pi / 2.0 + 1e-9;
    if (!between(camera.pitch, lowestPitch, kUp))
        return outOfRange("the camera's pitch",
                          lowestPitch > 0.0 ? "above 0 and up to 90 degrees" : "-90 to 90 degrees");
    if (!between(camera.distance, 0.01, 100.0))
        return outOfRange("the camera's distance", "0.01 to 100");
    if (!between(camera.fieldOfView,
                 OrbitCamera::kMinFieldOfView - 1e-9,
                 OrbitCamera::kMaxFieldOfView + 1e-9))
        return outOfRange("the camera's field of view", "1 to 150 degrees");
    return {};
}

} // namespace

NoiseRenderer::NoiseRenderer() = default;
NoiseRenderer::NoiseRenderer(NoiseRenderer&&) noexcept = default;
NoiseRenderer& NoiseRenderer::operator=(NoiseRenderer&&) noexcept = default;
NoiseRenderer::~NoiseRenderer() = default;

void NoiseRenderer::setTexton(std::shared_ptr<const Texton> texton) {
    m_texton = std::move(texton);
}

void NoiseRenderer::setRelief(std::shared_ptr<const Texton> relief) {
    m_relief = std::move(relief);
}

void NoiseRenderer::setMesh(std::shared_ptr<const TriangleMesh> mesh) {
    m_mesh.reset();
    if (!mesh)
        return;
    auto data = std::make_shared<MeshData>();
    data->tangents = tangentField(*mesh);
    data->shape.bounds = boundingSphere(*mesh);
    const auto scale = unitsPerUv(*mesh);
    data->hasTextureCoordinates = scale.has_value();
    data->shape.unitsPerUv = scale.value_or(1.0);
    data->mesh = std::move(mesh);
    m_mesh = std::move(data);
}

Result<void> NoiseRenderer::upload(const GlContext& context,
                                   CardTexton& card,
                                   const std::shared_ptr<const Texton>& texton,
                                   bool filtered) {
    if (card.texton != texton)
        card = {texton, {}, {}};
    auto& wanted = filtered ? card.filtered : card.exact;
    if (!texton || wanted)
        return {};
    auto made = GpuTexton::create(context, *texton, filtered);
    if (!made)
        return made.error();
    wanted = std::move(*made);
    return {};
}

Result<void>
NoiseRenderer::prepare(const GlContext& context, const View& view, const NoiseStyle& style) {
    if (m_card && !m_card->belongsTo(context)) {
        // Numbers of objects mean others here: nothing may be deleted.
        if (!m_card->life.expired())
            return Error{ErrorCode::InvalidArgument,
                         "this renderer still has objects in another OpenGL context"};
        m_card.reset();
    }
    if (!m_card)
        m_card = std::make_unique<Card>(context);
    const bool filtered = style.filter != Filter::None;
    if (auto ok = upload(context, m_card->base, m_texton, filtered); !ok)
        return ok.error();
    if (auto ok = upload(context, m_card->relief, m_relief, filtered); !ok)
        return ok.error();
    if (std::holds_alternative<MeshView>(view) && m_card->mesh != m_mesh) {
        m_card->gpuMesh.reset();
        m_card->mesh.reset();
        auto made =
            GpuMesh::create(context, *m_mesh->mesh, m_mesh->tangents, m_mesh->shape.bounds.center);
        if (!made)
            return made.error();
        m_card->gpuMesh = std::move(*made);
        m_card->mesh = m_mesh;
    }
    return {};
}

Result<void> NoiseRenderer::Card::drawOnce(const NoiseSource& source,
                                           const View& view,
                                           const OffscreenTarget& target,
                                           glm::dvec2 shift,
                                           bool smoothOutlines) {
    target.bind();
    const Size size = target.size();
    if (const auto* above = std::get_if<PlaneView>(&view)) {
        const PlaneMethod method = source.style.planeMethod;
        const bool inTiles = method == PlaneMethod::Tiles ||
                             (method == PlaneMethod::Automatic && source.context.isSoftware());
        if (inTiles && TilePass::suits(*above, source, size))
            return tiles.draw(source, *above, size, shift);
        return plane.draw(source, *above, size, shift);
    }
    if (const auto* ground = std::get_if<GroundView>(&view))
        return plane.draw(source, *ground, size, shift);
    const bool smooth =
        smoothOutlines && source.style.filter != Filter::None && source.style.supersampling == 1;
    return meshes
        .draw(source, std::get<MeshView>(view), *gpuMesh, mesh->shape, target, shift, smooth);
}

Result<void> NoiseRenderer::Card::drawShaded(NoiseSource source,
                                             const View& view,
                                             const OffscreenTarget& target,
                                             glm::dvec2 shift) {
    if (!relief.texton)
        return drawOnce(source, view, target, shift);
    if (!reliefPicture || reliefPicture.size() != target.size()) {
        reliefPicture = {};
        auto made = OffscreenTarget::create(source.context, target.size());
        if (!made)
            return made.error();
        reliefPicture = std::move(*made);
    }
    const bool filtered = source.style.filter != Filter::None;
    const NoiseSource maps{source.context,
                           *relief.texton,
                           filtered ? *relief.filtered : *relief.exact,
                           source.style};
    View plain = view;
    if (auto* onMesh = std::get_if<MeshView>(&plain))
        onMesh->lighting = false;
    if (auto ok = drawOnce(maps, plain, reliefPicture, shift, false); !ok)
        return ok.error();
    source.reliefTexture = reliefPicture.colorTexture();
    auto result = drawOnce(source, view, target, shift);
    unbindMaterial();
    return result;
}

Result<void> NoiseRenderer::Card::drawAveraged(const NoiseSource& source,
                                               const View& view,
                                               const OffscreenTarget& target) {
    if (!sample || sample.size() != target.size()) {
        sample = {};
        auto made = OffscreenTarget::create(source.context, target.size());
        if (!made)
            return made.error();
        sample = std::move(*made);
    }
    target.bind();
    AveragePass::begin();
    const int n = source.style.supersampling;
    const float share = 1.0F / static_cast<float>(n * n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const glm::dvec2 shift = (glm::dvec2(x, y) + 0.5) / static_cast<double>(n) - 0.5;
            if (auto ok = drawShaded(source, view, sample, shift); !ok)
                return ok.error();
            target.bind();
            if (auto ok = average.add(source.context, sample, share); !ok)
                return ok.error();
        }
    }
    return {};
}

Result<void> NoiseRenderer::draw(const GlContext& context,
                                 const View& view,
                                 const NoiseStyle& style,
                                 const OffscreenTarget& target,
                                 const std::optional<Rect>& part) {
    if (auto ok = checkStyle(style); !ok)
        return ok.error();
    if (auto ok = checkView(view); !ok)
        return ok.error();
    if (!m_texton)
        return Error{ErrorCode::InvalidArgument, "there is no texton to draw"};
    if (const auto* meshView = std::get_if<MeshView>(&view)) {
        if (!m_mesh || m_mesh->mesh->triangles.empty())
            return Error{ErrorCode::InvalidArgument, "there is no mesh to draw on"};
        if (meshView->mapping == MeshView::Mapping::TextureCoordinates &&
            !m_mesh->hasTextureCoordinates)
            return Error{ErrorCode::Unsupported,
                         "the mesh has no texture coordinates; please use surface noise"};
    }
    const FramebufferScope restore;
    startFromDefaults();
    const ScissorScope onlyPart(part, target.size());
    if (auto ok = prepare(context, view, style); !ok)
        return ok.error();
    const bool filtered = style.filter != Filter::None;
    const NoiseSource source{context,
                             *m_texton,
                             filtered ? *m_card->base.filtered : *m_card->base.exact,
                             style};
    auto result = style.supersampling > 1 ? m_card->drawAveraged(source, view, target)
                                          : m_card->drawShaded(source, view, target, {0.0, 0.0});
    GpuTexton::unbind();
    glUseProgram(0);
    return result;
}

void NoiseRenderer::release() {
    m_card.reset();
}

Result<void> checkView(const View& view) {
    if (const auto* above = std::get_if<PlaneView>(&view)) {
        if (!std::isfinite(above->rotation))
            return outOfRange("the rotation", "a number");
        return checkPlace(above->centerX, above->centerY, above->zoom);
    }
    if (const auto* ground = std::get_if<GroundView>(&view)) {
        if (auto ok = checkPlace(ground->centerX, ground->centerY, ground->zoom); !ok)
            return ok.error();
        return checkCamera(ground->camera, 1e-4);
    }
    const auto& mesh = std::get<MeshView>(view);
    if (!(mesh.pixelsPerUnit > 0.0) || !std::isfinite(mesh.pixelsPerUnit))
        return outOfRange("the scale of the noise on the mesh", "above 0");
    return checkCamera(mesh.camera, -std::numbers::pi / 2.0 - 1e-9);
}

Result<void> checkStyle(const NoiseStyle& style) {
    if (style.supersampling < 1 || style.supersampling > NoiseStyle::kMaxSupersampling)
        return outOfRange("supersampling", "1 to " + std::to_string(NoiseStyle::kMaxSupersampling));
    return checkNoiseParams(style.noise);
}

} // namespace txn
