// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/TilePass.h"

#include "core/noise/Normalization.h"
#include "gl/NoiseUniforms.h"
#include "gl/PlaneMap.h"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <numeric>

namespace txn {
namespace {

constexpr int kTileSide = 8; ///< 4 and 16 are slower (docs/BENCHMARKS.md)
constexpr double kSmallestFootprintPx = 12.0;
constexpr double kMostEntries = 3e7; ///< half a gigabyte
constexpr int kImpulseUnit = 2;      ///< the texton has 0 and 1
constexpr int kStartUnit = 3;

/// An impulse in the list of a tile, as tiles.frag reads it.
struct Entry {
    float x;
    float y;
    float signedLayer;
    float unused;
};

struct Lists {
    int tilesAcross = 0;
    std::vector<std::int32_t> starts;
    std::vector<Entry> entries;
};

struct Box {
    glm::dvec2 low;
    glm::dvec2 high;
};

/// The layer in which the kernel of an impulse lies, counted from 1, with the impulse's sign.
float signedLayer(const Impulse& impulse, const NoiseSource& source, glm::dvec2 footprint) {
    int layer = impulse.kernel + 1;
    if (source.field != nullptr)
        layer += source.first().kernelCount() *
                 source.field->field().textonAt(impulse.x + 0.5 * footprint.x,
                                                impulse.y + 0.5 * footprint.y,
                                                impulse.choice);
    return static_cast<float>(impulse.sign < 0.0F ? -layer : layer);
}

/// For every tile, the impulses whose kernels meet it.
Lists tileLists(const NoiseSource& source,
                const PlaneMap& map,
                Size size,
                const GpuTexton::Reach& reach) {
    const ImpulseProcess impulses = source.impulses();
    const glm::dvec2 footprint = source.footprint();
    const int across = (size.width + kTileSide - 1) / kTileSide;
    const int down = (size.height + kTileSide - 1) / kTileSide;
    const glm::dvec2 middle = glm::dvec2(middlePixel(size)) + 0.5;
    const glm::dmat2 toPlane(map.right, map.down);
    const glm::dmat2 toPicture = glm::inverse(toPlane);
    const glm::dvec2 widened = reach.before + footprint + reach.after;

    // The boxes around the turned picture on the plane, and around a turned footprint on the
    // picture, seen from its own corner.
    const auto box = [](const glm::dmat2& turn, glm::dvec2 extent) {
        const glm::dvec2 a = turn[0] * extent.x;
        const glm::dvec2 b = turn[1] * extent.y;
        const glm::dvec2 zero(0.0);
        return Box{glm::min(zero, a) + glm::min(zero, b), glm::max(zero, a) + glm::max(zero, b)};
    };
    const glm::dvec2 corner = map.middle - toPlane * middle;
    const Box picture = box(toPlane, {size.width, size.height});
    const Box around = box(toPicture, widened);
    const glm::dvec2 before = toPicture * reach.before;

    const auto visit = [&](auto&& use) {
        impulses.visit(corner.x + picture.low.x - footprint.x - reach.after.x,
                       corner.y + picture.low.y - footprint.y - reach.after.y,
                       corner.x + picture.high.x + reach.before.x,
                       corner.y + picture.high.y + reach.before.y,
                       [&](const Impulse& impulse) {
                           const glm::dvec2 at =
                               toPicture * (glm::dvec2(impulse.x, impulse.y) - map.middle) + middle;
                           const glm::dvec2 first =
                               glm::floor((at - before + around.low) / double{kTileSide});
                           const glm::dvec2 last =
                               glm::floor((at - before + around.high) / double{kTileSide});
                           const float layer = signedLayer(impulse, source, footprint);
                           const int x1 = static_cast<int>(std::min(last.x, across - 1.0));
                           const int y1 = static_cast<int>(std::min(last.y, down - 1.0));
                           for (int y = static_cast<int>(std::max(first.y, 0.0)); y <= y1; ++y) {
                               for (int x = static_cast<int>(std::max(first.x, 0.0)); x <= x1; ++x)
                                   use(x, y, at, layer);
                           }
                       });
    };

    Lists lists;
    lists.tilesAcross = across;
    lists.starts.assign(static_cast<std::size_t>(across) * static_cast<std::size_t>(down) + 1, 0);
    const auto list = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(across) +
               static_cast<std::size_t>(x);
    };
    visit([&](int x, int y, const glm::dvec2&, float) { ++lists.starts[list(x, y) + 1]; });
    std::partial_sum(lists.starts.begin(), lists.starts.end(), lists.starts.begin());
    lists.entries.resize(static_cast<std::size_t>(lists.starts.back()));
    std::vector<std::int32_t> next(lists.starts.begin(), lists.starts.end() - 1);
    visit([&](int x, int y, const glm::dvec2& at, float layer) {
        const glm::dvec2 place = at - double{kTileSide} * glm::dvec2(x, y);
        lists.entries[static_cast<std::size_t>(next[list(x, y)]++)] = {static_cast<float>(place.x),
                                                                       static_cast<float>(place.y),
                                                                       layer,
                                                                       0.0F};
    });
    return lists;
}

} // namespace

bool TilePass::suits(const PlaneView& view, const NoiseSource& source, Size size) {
    const double width = source.footprint().x * view.zoom;
    const double height = source.footprint().y * view.zoom;
    if (std::min(width, height) < kSmallestFootprintPx)
        return false;
    // A tile meets the footprints of a rectangle as much larger; turned, of one up to twice as
    // large.
    const double tiles = static_cast<double>(size.area()) / (kTileSide * kTileSide);
    const double entries = tiles * source.style.noise.meanImpacts * 2.0 *
                           (1.0 + 2.0 * kTileSide / width) * (1.0 + 2.0 * kTileSide / height);
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return std::max(entries, tiles + 1.0) <= std::min(kMostEntries, static_cast<double>(most));
}

void TilePass::fill(Table& table,
                    const GlContext& context,
                    unsigned format,
                    const void* data,
                    std::size_t bytes,
                    int unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    if (!table.buffer)
        table.buffer = GlHandle::make(context, GlHandle::Kind::Buffer);
    glBindBuffer(GL_TEXTURE_BUFFER, table.buffer.id());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    if (!table.texture)
        table.texture = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_BUFFER, table.texture.id());
    glTexBuffer(GL_TEXTURE_BUFFER, format, table.buffer.id());
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
}

Result<void>
TilePass::draw(const NoiseSource& source, const PlaneView& view, Size size, glm::dvec2 shift) {
    const GlContext& context = source.context;
    PlaneMap map = planeMap(view, size);
    map.middle += shift.x * map.right + shift.y * map.down;
    Lists lists = tileLists(source,
                            map,
                            size,
                            source.gpu.reachOneScale(source.style.filter, 1.0 / view.zoom));
    if (lists.entries.empty())
        lists.entries.emplace_back(); // a buffer may not be empty

    ShaderDefines defines = source.gpu.definesOneScale(source.style.filter, 1.0 / view.zoom);
    addSourceDefines(defines, source);
    auto program = m_shaders.get(context, defines);
    if (!program)
        return program.error();
    ShaderProgram& shader = **program;
    shader.use();
    source.gpu.applyOneScale(shader, context, source.style.filter, map.right, map.down);
    applyPlaneMaterial(shader, source, map.right, map.down);
    if (source.field != nullptr)
        applyPlanePlace(shader, source, map, size, {0.0, 0.0}); // it is in the map already
    const ChannelScale scale = channelScale(normalization(source.first(), source.impulses()));
    shader.set("txnGain", scale.gain);
    shader.set("txnOffset", scale.offset);
    shader.set("pictureToPlane", glm::mat2(glm::dmat2(map.right, map.down)));
    shader.set("height", size.height);
    shader.set("tileSide", kTileSide);
    shader.set("tilesAcross", lists.tilesAcross);
    shader.set("impulses", kImpulseUnit);
    shader.set("starts", kStartUnit);
    fill(m_impulses,
         context,
         GL_RGBA32F,
         lists.entries.data(),
         lists.entries.size() * sizeof(Entry),
         kImpulseUnit);
    fill(m_starts,
         context,
         GL_R32I,
         lists.starts.data(),
         lists.starts.size() * sizeof(std::int32_t),
         kStartUnit);

    m_triangle.draw(context);
    for (const int unit : {kImpulseUnit, kStartUnit}) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
    glActiveTexture(GL_TEXTURE0);
    return {};
}

} // namespace txn
