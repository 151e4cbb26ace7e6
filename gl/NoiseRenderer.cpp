// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/NoiseRenderer.h"

#include "core/mesh/TangentField.h"
#include "core/noise/MixedProcess.h"
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

/// Textons, and what of them is on the card.
struct NoiseRenderer::CardTextons {
    SharedTextons textons;
    std::optional<GpuTexton> exact;
    std::optional<GpuTexton> filtered;
};

/// All that lives in one context, and what it was made from.
struct NoiseRenderer::Card {
    std::weak_ptr<const void> life;
    std::shared_ptr<const MeshData> mesh;

    CardTextons base;
    CardTextons relief;
    GpuField field;
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

    NoiseSource
    source(const GlContext& context, const CardTextons& from, const NoiseStyle& style) const;
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
    m_textons = SharedTextons(std::move(texton));
}

void NoiseRenderer::setRelief(std::shared_ptr<const Texton> relief) {
    m_reliefs = SharedTextons(std::move(relief));
}

void NoiseRenderer::setTextons(std::shared_ptr<const std::vector<Texton>> textons) {
    m_textons = SharedTextons(std::move(textons));
}

void NoiseRenderer::setReliefs(std::shared_ptr<const std::vector<Texton>> reliefs) {
    m_reliefs = SharedTextons(std::move(reliefs));
}

void NoiseRenderer::setField(std::shared_ptr<const TextonField> field) {
    m_field = std::move(field);
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
                                   CardTextons& card,
                                   const SharedTextons& textons,
                                   bool filtered) {
    if (card.textons != textons) {
        card = {};
        if (textons.empty())
            return {};
        // Once for each list, since it looks at all coefficients.
        if (auto ok = checkMixedTextons(textons.list()); !ok)
            return ok.error();
        card.textons = textons;
    }
    auto& wanted = filtered ? card.filtered : card.exact;
    if (textons.empty() || wanted)
        return {};
    auto made = GpuTexton::create(context, textons.list(), filtered);
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
    if (auto ok = upload(context, m_card->base, m_textons, filtered); !ok)
        return ok.error();
    if (auto ok = upload(context, m_card->relief, m_reliefs, filtered); !ok)
        return ok.error();
    if (m_textons.list().size() > 1) {
        if (auto ok = m_card->field.hold(context, m_field); !ok)
            return ok.error();
    }
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

/// Refuses what SpotNoise does, and a field or a relief of other textons.
Result<void> NoiseRenderer::checkField(const NoiseParams& params) const {
    const std::size_t count = m_textons.list().size();
    if (!m_reliefs.empty() && m_reliefs.list().size() != count)
        return Error{ErrorCode::SizeMismatch,
                     "a material needs as many textons for its relief as for its colours"};
    if (count == 1)
        return {};
    if (!m_field || static_cast<std::size_t>(m_field->textonCount()) != count)
        return Error{ErrorCode::InvalidArgument,
                     "a mixture needs a map that leads to all of its textons"};
    return checkMixing(count, m_field->placement(), m_field->boundary(), params);
}

NoiseSource NoiseRenderer::Card::source(const GlContext& context,
                                        const CardTextons& from,
                                        const NoiseStyle& style) const {
    return {context,
            from.textons.list(),
            style.filter != Filter::None ? *from.filtered : *from.exact,
            from.textons.list().size() > 1 ? &field : nullptr,
            style};
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
    if (relief.textons.empty())
        return drawOnce(source, view, target, shift);
    if (!reliefPicture || reliefPicture.size() != target.size()) {
        reliefPicture = {};
        auto made = OffscreenTarget::create(source.context, target.size());
        if (!made)
            return made.error();
        reliefPicture = std::move(*made);
    }
    const NoiseSource maps = this->source(source.context, relief, source.style);
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
    if (m_textons.empty())
        return Error{ErrorCode::InvalidArgument, "there is no texton to draw"};
    if (auto ok = checkField(style.noise); !ok)
        return ok.error();
    if (const auto* meshView = std::get_if<MeshView>(&view)) {
        if (!m_mesh || m_mesh->mesh->triangles.empty())
            return Error{ErrorCode::InvalidArgument, "there is no mesh to draw on"};
        if (meshView->mapping == MeshView::Mapping::TextureCoordinates &&
            !m_mesh->hasTextureCoordinates)
            return Error{ErrorCode::InvalidArgument,
                         "the mesh has no texture coordinates; please use surface noise"};
    }
    const FramebufferScope restore;
    startFromDefaults();
    const ScissorScope onlyPart(part, target.size());
    if (auto ok = prepare(context, view, style); !ok)
        return ok.error();
    const NoiseSource source = m_card->source(context, m_card->base, style);
    auto result = style.supersampling > 1 ? m_card->drawAveraged(source, view, target)
                                          : m_card->drawShaded(source, view, target, {0.0, 0.0});
    GpuTexton::unbind();
    GpuField::unbind();
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
