// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/MeshPass.h"

#include "core/noise/SurfaceNoise.h"
#include "gl/MeshMap.h"
#include "gl/NoiseUniforms.h"

#include <cmath>
#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace txn {

namespace {

constexpr int kFirstUnit = 2; ///< of the textures of this pass; the texton has 0 and 1

ShaderDefines mappingDefines(bool surface) {
    return {{"TXN_SURFACE", surface ? "1" : "0"}};
}

void setPlaneNoise(ShaderProgram& shader, const NoiseSource& source) {
    setNoiseUniforms(shader, source.first(), source.style.noise);
    applyPlaneField(shader, source, source.impulses(), glm::ivec2(0));
}

void setSurfaceNoise(ShaderProgram& shader, const NoiseSource& source) {
    const Texton& first = source.first();
    setSurfaceNoiseUniforms(shader, first, source.style.noise);
    const SurfaceImpulses impulses(source.style.noise, first.footprint(), first.kernelCount());
    // As seen from the front: the map's y points down.
    if (source.field != nullptr)
        source.field->apply(shader,
                            {glm::ivec2(0), {impulses.cell(), -impulses.cell()}, glm::dvec2(0.0)});
}

/// The light hangs above the camera's left shoulder.
glm::vec3 towardsLight(const OrbitCamera& camera) {
    const double yaw = camera.yaw - 0.7;
    const double pitch = 0.8;
    return {std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw)};
}

/// From what is to the right, up and towards the eye to the mesh's coordinates.
glm::dmat3 fromView(const OrbitCamera& camera) {
    const glm::dvec3 back{std::cos(camera.pitch) * std::sin(camera.yaw),
                          std::sin(camera.pitch),
                          std::cos(camera.pitch) * std::cos(camera.yaw)};
    const glm::dvec3 right{std::cos(camera.yaw), 0.0, -std::sin(camera.yaw)};
    return {right, glm::cross(back, right), back};
}

} // namespace

Result<void> MeshPass::look(const GlContext& context,
                            const GpuMesh& mesh,
                            bool surface,
                            const glm::mat4& toPicture,
                            float pixelsPerUnit) {
    auto program = m_geometry.get(context, mappingDefines(surface));
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    shader.use();
    shader.set("meshToPicture", toPicture);
    shader.set("pixelsPerUnit", pixelsPerUnit);
    m_buffer.begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    mesh.draw();
    glDisable(GL_DEPTH_TEST);
    return {};
}

bool MeshPass::cover(const GlContext& context, const GpuMesh& mesh, const glm::mat4& toPicture) {
    if (m_refusedMask == m_buffer.size())
        return false;
    if (m_mask.size() != m_buffer.size()) {
        m_mask = {};
        auto made = CoverageMask::create(context, m_buffer.size());
        if (!made) {
            m_refusedMask = m_buffer.size();
            return false;
        }
        m_mask = std::move(*made);
    }
    auto program = m_cover.get(context, mappingDefines(false));
    if (!program)
        return false;
    (*program)->use();
    (*program)->set("meshToPicture", toPicture);
    m_mask.begin();
    mesh.draw();
    m_mask.end();
    return true;
}

Result<void> MeshPass::draw(const NoiseSource& source,
                            const MeshView& view,
                            const GpuMesh& mesh,
                            const MeshShape& shape,
                            const OffscreenTarget& target,
                            glm::dvec2 shift,
                            bool smooth) {
    const GlContext& context = source.context;
    if (!m_buffer || m_buffer.size() != target.size()) {
        m_buffer = {};
        auto made = MeshBuffer::create(context, target.size());
        if (!made)
            return made.error();
        m_buffer = std::move(*made);
    }
    const bool surface = view.mapping == MeshView::Mapping::Surface;
    const double scale = surface ? view.pixelsPerUnit : view.pixelsPerUnit * shape.unitsPerUv;
    // GpuMesh has moved the middle to the origin.
    const BoundingSphere bounds{glm::vec3(0.0F), shape.bounds.radius};
    const glm::mat4 toPicture = meshToPicture(view.camera, bounds, target.size(), shift);
    if (auto ok = look(context, mesh, surface, toPicture, static_cast<float>(scale)); !ok)
        return ok.error();
    smooth = smooth && cover(context, mesh, toPicture);

    ShaderDefines defines = source.gpu.defines(context, source.style.filter);
    addNoiseDefines(defines, source.style.noise);
    for (auto& define : mappingDefines(surface))
        defines.push_back(std::move(define));
    addSourceDefines(defines, source);
    defines.emplace_back("TXN_SMOOTH", smooth ? "1" : "0");
    auto program = m_noise.get(context, defines);
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    shader.use();
    source.gpu.apply(shader, context, source.style.filter);
    if (surface)
        setSurfaceNoise(shader, source);
    else
        setPlaneNoise(shader, source);
    shader.set("lighting", view.lighting ? 1 : 0);
    shader.set("encoded", source.first().transfer == Transfer::Encoded ? 1 : 0);
    if (source.reliefTexture == 0) {
        shader.set("toLight", towardsLight(view.camera));
    } else {
        const glm::dmat3 toMesh = fromView(view.camera);
        applyMaterial(shader, source, toMesh * source.style.light.direction());
        shader.set("toEye", glm::vec3(toMesh[2])); // as if from far away
    }
    shader.set("background", pictureColor(view.background, source.first().transfer));
    int unit = kFirstUnit;
    for (const char* name : {"seenPoint", "seenNormal", "seenRight", "seenSteps", "coverage"})
        shader.set(name, unit++);
    m_buffer.bindTextures(kFirstUnit);
    glActiveTexture(GL_TEXTURE0 + kFirstUnit + MeshBuffer::kTextures);
    glBindTexture(GL_TEXTURE_2D, smooth ? m_mask.texture() : 0);
    glActiveTexture(GL_TEXTURE0);

    target.bind();
    m_triangle.draw(context);
    for (int i = 0; i <= MeshBuffer::kTextures; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kFirstUnit + i));
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glActiveTexture(GL_TEXTURE0);
    return {};
}

} // namespace txn
