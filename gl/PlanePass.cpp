// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/PlanePass.h"

#include "core/noise/ImpulseProcess.h"
#include "gl/NoiseUniforms.h"
#include "gl/PlaneMap.h"

#include <cmath>
#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace txn {
namespace {

/// Tells the shader in which cell a point lies, and where in it; cells as the hash counts them.
void setBase(ShaderProgram& program, const NoiseSource& source, glm::dvec2 point) {
    const ImpulseProcess impulses = source.impulses();
    const glm::dvec2 place = point / glm::dvec2(impulses.cellWidth(), impulses.cellHeight());
    const glm::dvec2 cell = glm::floor(place);
    program.set("baseCell", glm::ivec2(cell));
    program.set("basePlace", glm::vec2(place - cell));
    applyPlaneField(program, source, impulses, glm::ivec2(cell));
}

/// value to about 11 bits, the last one the same for all of a picture's steps: its products with
/// counts of pixels, and their sums, are exact in single precision.
glm::dvec2 coarse(glm::dvec2 value, double largest) {
    const double unit = std::exp2(std::ceil(std::log2(largest)) - 10.0);
    return glm::round(value / unit) * unit;
}

} // namespace

namespace {

constexpr int kReliefUnit = 7; ///< above those of all passes

}

void applyPlaneField(ShaderProgram& shader,
                     const NoiseSource& source,
                     const ImpulseProcess& impulses,
                     glm::ivec2 base) {
    if (source.field != nullptr)
        source.field->apply(
            shader,
            {base, {impulses.cellWidth(), impulses.cellHeight()}, 0.5 * source.footprint()});
}

void applyPlanePlace(ShaderProgram& shader,
                     const NoiseSource& source,
                     const PlaneMap& map,
                     Size size,
                     glm::dvec2 shift) {
    setBase(shader, source, map.middle + shift.x * map.right + shift.y * map.down);
    const ImpulseProcess impulses = source.impulses();
    const glm::dvec2 cell{impulses.cellWidth(), impulses.cellHeight()};
    const glm::dvec2 right = map.right / cell;
    const glm::dvec2 down = map.down / cell;
    const glm::dvec2 sizes = glm::max(glm::abs(right), glm::abs(down));
    const double largest = std::max(sizes.x, sizes.y);
    const glm::dvec2 rightHigh = coarse(right, largest);
    const glm::dvec2 downHigh = coarse(down, largest);
    shader.set("middle", middlePixel(size));
    shader.set("rightHigh", glm::vec2(rightHigh));
    shader.set("rightLow", glm::vec2(right - rightHigh));
    shader.set("downHigh", glm::vec2(downHigh));
    shader.set("downLow", glm::vec2(down - downHigh));
}

void addSourceDefines(ShaderDefines& defines, const NoiseSource& source) {
    if (source.field != nullptr)
        source.field->addDefines(defines);
    defines.emplace_back("TXN_MATERIAL", source.reliefTexture != 0 ? "1" : "0");
}

void applyMaterial(ShaderProgram& shader, const NoiseSource& source, const glm::dvec3& toLight) {
    if (source.reliefTexture == 0)
        return;
    glActiveTexture(GL_TEXTURE0 + kReliefUnit);
    glBindTexture(GL_TEXTURE_2D, source.reliefTexture);
    glActiveTexture(GL_TEXTURE0);
    shader.set("relief", kReliefUnit);
    shader.set("toLight", glm::vec3(toLight));
}

void unbindMaterial() {
    glActiveTexture(GL_TEXTURE0 + kReliefUnit);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

void applyPlaneMaterial(ShaderProgram& shader,
                        const NoiseSource& source,
                        glm::dvec2 right,
                        glm::dvec2 down) {
    applyMaterial(shader, source, source.style.light.direction());
    // The exemplar's axes on the picture, whose y points down and the viewer's up.
    const glm::dmat2 toPicture = glm::inverse(glm::dmat2(right, down));
    const auto seen = [&](const glm::dvec2& axis) {
        const glm::dvec2 unit = glm::normalize(toPicture * axis);
        return glm::vec3(unit.x, -unit.y, 0.0);
    };
    shader.set("surfaceX", seen({1.0, 0.0}));
    shader.set("surfaceY", seen({0.0, 1.0}));
}

Result<void>
PlanePass::draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift) {
    ShaderDefines defines = source.gpu.definesOneScale(source.style.filter, 1.0 / view.zoom);
    addNoiseDefines(defines, source.style.noise);
    addSourceDefines(defines, source);
    auto program = m_above.get(source.context, defines);
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    shader.use();
    setNoiseUniforms(shader, source.first(), source.style.noise);
    const PlaneMap map = planeMap(view, size);
    source.gpu.applyOneScale(shader, source.context, source.style.filter, map.right, map.down);
    applyPlaneMaterial(shader, source, map.right, map.down);
    applyPlanePlace(shader, source, map, size, shift);
    shader.set("height", size.height);
    m_triangle.draw(source.context);
    return {};
}

Result<void>
PlanePass::draw(const NoiseSource& source, const GroundView& view, Size size, glm::dvec2 shift) {
    ShaderDefines defines = source.gpu.defines(source.context, source.style.filter);
    addNoiseDefines(defines, source.style.noise);
    addSourceDefines(defines, source);
    auto program = m_ground.get(source.context, defines);
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    shader.use();
    source.gpu.apply(shader, source.context, source.style.filter);
    setNoiseUniforms(shader, source.first(), source.style.noise);
    const GroundMap map = groundMap(view, size);
    applyMaterial(shader, source, map.fromView * source.style.light.direction());
    shader.set("eye", glm::vec3(map.eye));
    setBase(shader, source, map.base);
    shader.set("middle", middlePixel(size));
    shader.set("height", size.height);
    shader.set("rayMiddle", glm::vec3(map.middle + shift.x * map.right + shift.y * map.down));
    shader.set("rayRight", glm::vec3(map.right));
    shader.set("rayDown", glm::vec3(map.down));
    shader.set("background", pictureColor(view.background, source.first().transfer));
    m_triangle.draw(source.context);
    return {};
}

} // namespace txn
