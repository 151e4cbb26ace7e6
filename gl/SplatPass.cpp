// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/SplatPass.h"

#include "core/noise/Normalization.h"
#include "gl/NoiseUniforms.h"
#include "gl/PlaneMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace txn {
namespace {

/// An impulse as splat.vert reads it.
struct Splat {
    std::int32_t x;
    std::int32_t y;
    float placeX;
    float placeY;
    std::int32_t signedKernel;
};

/// All impulses whose footprints, margin included, meet the picture.
std::vector<Splat> visibleSplats(const ImpulseProcess& impulses,
                                 const PlaneMap& map,
                                 Size size,
                                 glm::dvec2 footprint,
                                 double margin) {
    const glm::ivec2 middle = middlePixel(size);
    glm::dvec2 low{1e300};
    glm::dvec2 high{-1e300};
    for (const glm::ivec2 corner :
         {glm::ivec2{0, 0}, {size.width, 0}, {0, size.height}, {size.width, size.height}}) {
        const glm::dvec2 steps = glm::dvec2(corner - middle) - 0.5;
        const glm::dvec2 point = map.middle + steps.x * map.right + steps.y * map.down;
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    low -= footprint + margin;
    high += margin;
    const glm::dmat2 toPicture = glm::inverse(glm::dmat2(map.right, map.down));
    // A turned picture sees only part of that rectangle.
    const double reach = glm::length(footprint) + 2.0 * margin;
    const double far = reach * glm::length(toPicture[0]);
    std::vector<Splat> splats;
    impulses.visit(low.x, low.y, high.x, high.y, [&](const Impulse& impulse) {
        const glm::dvec2 pixel =
            toPicture * (glm::dvec2(impulse.x, impulse.y) - map.middle) + glm::dvec2(middle) + 0.5;
        if (pixel.x < -far || pixel.y < -far || pixel.x > size.width + far ||
            pixel.y > size.height + far)
            return;
        const glm::dvec2 whole = glm::floor(pixel);
        const int kernel = impulse.kernel + 1;
        splats.push_back({static_cast<std::int32_t>(whole.x),
                          static_cast<std::int32_t>(whole.y),
                          static_cast<float>(pixel.x - whole.x),
                          static_cast<float>(pixel.y - whole.y),
                          impulse.sign < 0.0F ? -kernel : kernel});
    });
    return splats;
}

void describeSplats() {
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    glVertexAttribIPointer(0, 2, GL_INT, sizeof(Splat), at(offsetof(Splat, x)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Splat), at(offsetof(Splat, placeX)));
    glVertexAttribIPointer(2, 1, GL_INT, sizeof(Splat), at(offsetof(Splat, signedKernel)));
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
}

} // namespace

bool SplatPass::suits(const PlaneView& view, const Texton& texton) {
    const Size footprint = texton.footprint();
    return std::min(footprint.width, footprint.height) * view.zoom >= kSmallestSidePx;
}

Result<void>
SplatPass::draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift) {
    auto program = m_shaders.get(source.context,
                                 source.gpu.defines(source.context, source.style.filter, true));
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    const ImpulseProcess impulses(source.style.noise,
                                  source.texton.footprint(),
                                  source.texton.kernelCount());
    PlaneMap map = planeMap(view, size);
    map.middle += shift.x * map.right + shift.y * map.down;
    // The hardware's filter reaches as far as a pixel is wide, and to the next texel.
    const double pixel = 1.0 / view.zoom;
    const double margin = source.style.filter == Filter::None ? 0.0 : std::sqrt(2.0) * pixel;
    const Size footprint = source.texton.footprint();
    const auto splats =
        visibleSplats(impulses, map, size, {footprint.width, footprint.height}, margin);

    if (!m_vertices) {
        m_vertices = GlHandle::make(source.context, GlHandle::Kind::VertexArray);
        m_impulses = GlHandle::make(source.context, GlHandle::Kind::Buffer);
    }
    shader.use();
    source.gpu.applyOneScale(shader, source.context, source.style.filter, map.right, map.down);
    const ChannelScale scale = channelScale(normalization(source.texton, impulses));
    const glm::dmat2 toPlane(map.right, map.down);
    shader.set("txnGain", scale.gain);
    shader.set("pictureSize", glm::vec2(size.width, size.height));
    shader.set("margin", glm::vec2(static_cast<float>(margin)));
    shader.set("planeToPicture", glm::mat2(glm::inverse(toPlane)));
    shader.set("pictureToPlane", glm::mat2(toPlane));
    shader.set("height", size.height);

    glClearBufferfv(GL_COLOR, 0, glm::value_ptr(scale.offset));
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(m_vertices.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_impulses.id());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(splats.size() * sizeof(Splat)),
                 splats.data(),
                 GL_STREAM_DRAW);
    describeSplats();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(splats.size()));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    return {};
}

} // namespace txn
