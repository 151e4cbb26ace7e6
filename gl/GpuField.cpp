// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GpuField.h"

#include "gl/GlContext.h"
#include "gl/GlErrors.h"
#include "gl/ShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace txn {
namespace {

constexpr int kMostLevels = 14; ///< of means: from MixingMap::kMaxSide cells a side to 1
constexpr int kMapUnit = 8;     ///< above those of all passes
constexpr int kMeanUnit = 9;

/// Where a map does not repeat, coarser means than over a footprint would let its inside show
/// beyond its border.
constexpr int kCoarsestBordered = 2;

/// Binds the texture and fills it with what is to be fetched as it is.
void fill(GlHandle& texture,
          const GlContext& context,
          GLint format,
          Size size,
          GLenum channels,
          GLenum type,
          const void* data) {
    if (!texture)
        texture = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, format, size.width, size.height, 0, channels, type, data);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

/// The means of a field as mixing.glsl wants them, each level half the size of the one before:
/// below the finest one, from left to right, the others. A texel holds a coefficient and the three
/// to its right, so that a row of the B-spline is one fetch.
struct MeanLevels {
    static constexpr int kNeighbours = 3;

    std::vector<glm::ivec2> corners; ///< left of them there are as many texels as neighbours
    Size size;

    explicit MeanLevels(Size cells) : size{cells.width + kNeighbours, cells.height} {
        corners.emplace_back(kNeighbours, 0);
        int right = 0;
        for (Size level = cells; level.width > 1 || level.height > 1;) {
            level = halved(level);
            corners.emplace_back(right + kNeighbours, cells.height);
            right += level.width + kNeighbours;
        }
        if (corners.size() > 1)
            size = {std::max(size.width, right), cells.height + halved(cells).height};
    }

    static Size halved(Size level) {
        return {std::max(1, level.width / 2), std::max(1, level.height / 2)};
    }

    [[nodiscard]] std::vector<glm::vec4> texels(const TextonField& field) const {
        std::vector<glm::vec4> all(size.area());
        std::vector<float> means(field.meanCoefficients().begin(), field.meanCoefficients().end());
        Size level = field.cells();
        for (const glm::ivec2& corner : corners) {
            if (corner.y > 0) {
                means = gridMeans(means, level, halved(level));
                level = halved(level);
            }
            for (int y = 0; y < level.height; ++y) {
                const float* row = means.data() + std::ptrdiff_t{y} * level.width;
                glm::vec4* texel =
                    all.data() + std::ptrdiff_t{corner.y + y} * size.width + corner.x;
                for (int x = -kNeighbours; x < level.width; ++x) {
                    for (int i = 0; i <= kNeighbours; ++i)
                        texel[x][i] = row[onMap(x + i, level.width, field.boundary())];
                }
            }
        }
        return all;
    }

    static int onMap(int x, int count, MapBoundary boundary) {
        if (boundary == MapBoundary::Clamp)
            return std::clamp(x, 0, count - 1);
        return (x % count + count) % count;
    }
};

/// Tells the shader how the field's rectangle, cut into size texels, lies over the cells of
/// impulses; from: what is looked up for an impulse at the corner of the base cell.
void setGrid(ShaderProgram& program,
             const std::string& name,
             const TextonField& field,
             Size size,
             const CellGrid& cells,
             glm::dvec2 from) {
    const MapPlacement place = field.placement();
    const glm::dvec2 count(size.width, size.height);
    const glm::dvec2 texels = count / glm::dvec2(place.width, place.height);
    const glm::dvec2 along = cells.cell * texels;
    // About 11 bits: products with whole numbers of cells are exact in single precision.
    const glm::dvec2 unit = glm::exp2(glm::ceil(glm::log2(glm::abs(along))) - 10.0);
    const glm::dvec2 high = glm::round(along / unit) * unit;
    const glm::dvec2 start = (from - glm::dvec2(place.left, place.top)) * texels;
    glm::dvec2 whole = glm::floor(start);
    const glm::dvec2 rest = start - whole;
    if (field.boundary() == MapBoundary::Repeat)
        whole -= glm::floor(whole / count) * count;
    program.set((name + ".high").c_str(), glm::vec2(high));
    program.set((name + ".low").c_str(), glm::vec2(along - high));
    program.set((name + ".start").c_str(), glm::vec2(whole));
    program.set((name + ".rest").c_str(), glm::vec2(rest));
}

} // namespace

Result<void> GpuField::hold(const GlContext& context,
                            const std::shared_ptr<const TextonField>& field) {
    if (m_field == field)
        return {};
    m_field.reset();
    const MeanLevels levels(field->cells());
    const Size size = field->size();
    const int longest = std::max({size.width, size.height, levels.size.width, levels.size.height});
    if (longest > context.maxTextureSide())
        return Error{ErrorCode::TooLarge,
                     "this graphics driver takes maps of at most " +
                         std::to_string(context.maxTextureSide()) + " texels a side, not " +
                         std::to_string(longest)};
    forgetGlErrors();
    fill(m_map,
         context,
         GL_R16UI,
         size,
         GL_RED_INTEGER,
         GL_UNSIGNED_SHORT,
         field->positions().data());
    fill(m_means,
         context,
         GL_RGBA32F,
         levels.size,
         GL_RGBA,
         GL_FLOAT,
         levels.texels(*field).data());
    glBindTexture(GL_TEXTURE_2D, 0);
    if (auto ok = checkGlMemory("the map"); !ok)
        return ok.error();
    m_meanCorners = levels.corners;
    m_field = field;
    return {};
}

void GpuField::addDefines(ShaderDefines& defines) const {
    defines.emplace_back("TXN_MIXED", "1");
    defines.emplace_back("TXN_MAP_REPEATS", m_field->boundary() == MapBoundary::Repeat ? "1" : "0");
    defines.emplace_back("TXN_MEAN_LEVELS", std::to_string(kMostLevels));
}

void GpuField::apply(ShaderProgram& program, const CellGrid& cells) const {
    program.set("txnMap", kMapUnit);
    program.set("txnMeanMap", kMeanUnit);
    glActiveTexture(GL_TEXTURE0 + kMapUnit);
    glBindTexture(GL_TEXTURE_2D, m_map.id());
    glActiveTexture(GL_TEXTURE0 + kMeanUnit);
    glBindTexture(GL_TEXTURE_2D, m_means.id());
    glActiveTexture(GL_TEXTURE0);
    const glm::dvec2 corner = glm::dvec2(cells.base) * cells.cell;
    setGrid(program, "txnMapGrid", *m_field, m_field->size(), cells, corner + cells.middle);
    setGrid(program, "txnMeanGrid", *m_field, m_field->cells(), cells, corner);
    program.set("txnMapCell", cells.base);
    const MapPlacement place = m_field->placement();
    program.set("txnMeanDensity",
                static_cast<float>(std::max(m_field->cells().width / place.width,
                                            m_field->cells().height / place.height)));
    program.set("txnMeanSize", glm::ivec2(m_field->cells().width, m_field->cells().height));
    for (std::size_t i = 0; i < m_meanCorners.size(); ++i)
        program.set(("txnMeanCorners[" + std::to_string(i) + "]").c_str(), m_meanCorners[i]);
    const int last = static_cast<int>(m_meanCorners.size()) - 1;
    program.set("txnCoarsestMeans",
                static_cast<float>(m_field->boundary() == MapBoundary::Repeat
                                       ? last
                                       : std::min(last, kCoarsestBordered)));
}

void GpuField::unbind() {
    for (const int unit : {kMapUnit, kMeanUnit}) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glActiveTexture(GL_TEXTURE0);
}

} // namespace txn
