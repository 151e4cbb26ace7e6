// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GpuTexton.h"

#include "core/noise/FilterFade.h"
#include "core/noise/Normalization.h"
#include "core/spectral/BSpline.h"
#include "gl/GlContext.h"
#include "gl/GlErrors.h"
#include "gl/NoiseUniforms.h"
#include "gl/ShaderProgram.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace txn {
namespace {

/// Pixels up to this size see points of the noise, as NoiseGrid has it at scale 1; within the ramp
/// beyond, filtering sets in, so that nothing jumps while zooming.
constexpr double kSharpest = 1.0;
constexpr double kRamp = 0.4;
constexpr float kMostFetches = 16.0F; ///< along the longer side of a pixel
constexpr int kMeansUnit = 10;        ///< above those of all passes

/// Texels of one mipmap level: R Q layers of rows of RGBA.
struct Level {
    Size size;
    std::size_t layers;
    std::vector<float> texels;

    Level(Size s, std::size_t q) : size(s), layers(q), texels(s.area() * q * 4, 0.0F) {}
    float* texel(std::size_t layer, int x, int y) {
        return texels.data() +
               ((layer * static_cast<std::size_t>(size.height) + static_cast<std::size_t>(y)) *
                    static_cast<std::size_t>(size.width) +
                static_cast<std::size_t>(x)) *
                   4;
    }
};

/// The coefficients, the first one at (start, start), zeros around them.
Level coefficients(std::span<const Texton> textons, Size size, int start) {
    const std::size_t kernels = textons.front().kernels.size();
    Level level(size, textons.size() * kernels);
    for (std::size_t q = 0; q < level.layers; ++q) {
        const Image& kernel = textons[q / kernels].kernels[q % kernels];
        for (int y = 0; y < kernel.height(); ++y) {
            for (int x = 0; x < kernel.width(); ++x) {
                for (int c = 0; c < kernel.channels(); ++c)
                    level.texel(q, x + start, y + start)[c] = kernel.at(x, y, c);
            }
        }
    }
    return level;
}

/// Samples of the kernels at density texels per exemplar pixel, for orders whose kernels are
/// smoother than what the hardware interpolates.
Level samples(std::span<const Texton> textons, Size size, int density) {
    const Texton& texton = textons.front();
    const Level grid = coefficients(textons, texton.footprint(), texton.frame());
    // Along x, then along y, each by the weights of the B-spline at the texels' centres.
    const auto resampled = [&](Level from, Size to, bool alongX) {
        Level out(to, from.layers);
        const int count = alongX ? from.size.width : from.size.height;
        const int lines = alongX ? from.size.height : from.size.width;
        const int length = std::min(alongX ? to.width : to.height, count * density);
        for (int n = 0; n < length; ++n) {
            const auto weights =
                bsplineWeights(texton.interpolationOrder, (n + 0.5) / density - 0.5);
            for (int i = 0; i <= texton.interpolationOrder; ++i) {
                const auto k = static_cast<int>(weights.first + i);
                if (k < 0 || k >= count)
                    continue;
                for (std::size_t q = 0; q < from.layers; ++q) {
                    for (int line = 0; line < lines; ++line) {
                        const float* in = alongX ? from.texel(q, k, line) : from.texel(q, line, k);
                        float* sum = alongX ? out.texel(q, n, line) : out.texel(q, line, n);
                        for (int c = 0; c < 4; ++c)
                            sum[c] += weights.weight[i] * in[c];
                    }
                }
            }
        }
        return out;
    };
    return resampled(resampled(grid, {size.width, grid.size.height}, true), size, false);
}

/// Half the size, each texel the mean of four. Sides of 1 stay.
Level halved(Level& from) {
    Level to({std::max(1, from.size.width / 2), std::max(1, from.size.height / 2)}, from.layers);
    const int stepX = from.size.width / to.size.width;
    const int stepY = from.size.height / to.size.height;
    const float weight = 1.0F / static_cast<float>(stepX * stepY);
    for (std::size_t q = 0; q < to.layers; ++q) {
        for (int y = 0; y < from.size.height; ++y) {
            for (int x = 0; x < from.size.width; ++x) {
                for (int c = 0; c < 4; ++c)
                    to.texel(q, x / stepX, y / stepY)[c] += weight * from.texel(q, x, y)[c];
            }
        }
    }
    return to;
}

int powerOfTwo(int length) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(length)));
}

void upload(int number, const Level& level) {
    glTexImage3D(GL_TEXTURE_2D_ARRAY,
                 number,
                 GL_RGBA32F,
                 level.size.width,
                 level.size.height,
                 static_cast<GLsizei>(level.layers),
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 level.texels.data());
}

/// Four channels of a pixel: one channel is shown as grey.
void appendTexel(std::vector<float>& texels, std::span<const float> values) {
    for (std::size_t c = 0; c < 4; ++c)
        texels.push_back(values[values.size() == 1 ? 0 : std::min(c, values.size() - 1)]);
}

/// What filter.glsl looks up: the table of a texton. Of several, r from 0 to 1 along them, those of
/// f(0), f(1) - f(0) and d, where f(r) = f(0) + r (f(1) - f(0)) + r (1 - r) d goes through the
/// first, one in the middle and the last of them.
std::vector<FilterFade> fadeTables(std::span<const Texton> textons) {
    FilterFade first = filterFade(textons.front());
    if (textons.size() == 1)
        return {std::move(first)};
    FilterFade slope = filterFade(textons.back());
    const std::size_t middle = textons.size() / 2;
    const float r = static_cast<float>(middle) / static_cast<float>(textons.size() - 1);
    FilterFade bend = filterFade(textons[middle]);
    for (std::size_t i = 0; i < first.ratios.size(); ++i) {
        slope.ratios[i] -= first.ratios[i];
        const float line = first.ratios[i] + r * slope.ratios[i];
        bend.ratios[i] = r < 1.0F ? (bend.ratios[i] - line) / (r * (1.0F - r)) : 0.0F;
    }
    return {std::move(first), std::move(slope), std::move(bend)};
}

/// The tables side by side.
GlHandle fadeTexture(const GlContext& context, std::span<const Texton> textons) {
    const std::vector<FilterFade> fades = fadeTables(textons);
    const auto channels = static_cast<std::size_t>(fades.front().channels);
    const std::size_t row = FilterFade::kMajor * channels;
    std::vector<float> texels;
    texels.reserve(fades.size() * fades.front().ratios.size() / channels * 4);
    for (std::size_t start = 0; start < fades.front().ratios.size(); start += row) {
        for (const FilterFade& fade : fades) {
            for (std::size_t i = start; i < start + row; i += channels)
                appendTexel(texels, std::span(fade.ratios).subspan(i, channels));
        }
    }
    GlHandle texture = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_3D, texture.id());
    glTexImage3D(GL_TEXTURE_3D,
                 0,
                 GL_RGBA32F,
                 FilterFade::kMajor * static_cast<GLsizei>(fades.size()),
                 FilterFade::kMinor,
                 FilterFade::kAngles,
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_REPEAT);
    glBindTexture(GL_TEXTURE_3D, 0);
    return texture;
}

/// The means of the textons, a texel each, as pictures show them.
GlHandle meanTexture(const GlContext& context, std::span<const Texton> textons) {
    std::vector<glm::vec4> texels;
    texels.reserve(textons.size());
    for (const Texton& texton : textons)
        texels.push_back(channelScale({1.0, texton.mean}).offset);
    GlHandle texture = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_RGBA32F,
                 static_cast<GLsizei>(textons.size()),
                 1,
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

} // namespace

Result<GpuTexton>
GpuTexton::create(const GlContext& context, std::span<const Texton> textons, bool filtered) {
    const Texton& texton = textons.front(); // what they have in common can be read from it
    const auto layers = static_cast<int>(textons.size()) * texton.kernelCount();
    if (texton.channels() > 4)
        return Error{ErrorCode::InvalidArgument,
                     "at most 4 channels can be drawn at a time, not " +
                         std::to_string(texton.channels())};
    if (layers > context.maxTextureLayers())
        return Error{ErrorCode::TooLarge,
                     "this graphics driver takes at most " +
                         std::to_string(context.maxTextureLayers()) +
                         " kernels of all textons together, not " + std::to_string(layers)};
    const Size footprint = texton.footprint();
    // Smooth kernels need more samples than coefficients, as far as memory allows.
    const int smooth = std::max(footprint.width, footprint.height) <= 128 ? 4 : 2;
    const int density = filtered && texton.interpolationOrder > 1 ? smooth : 1;
    // What has to be held: with mipmaps, the frame comes from the texture's border. A support of a
    // power of two then fills the texels of all levels.
    const int start = filtered && density == 1 ? texton.frame() : 0;
    const Size extent{footprint.width - 2 * start, footprint.height - 2 * start};
    // Powers of two: then a texel of a mipmap covers four of the level below exactly.
    const Size size =
        filtered ? Size{powerOfTwo(extent.width * density), powerOfTwo(extent.height * density)}
                 : footprint;
    if (std::max(size.width, size.height) > context.maxTextureSide())
        return Error{ErrorCode::TooLarge,
                     "this graphics driver takes textures of at most " +
                         std::to_string(context.maxTextureSide()) +
                         " pixels a side; please use a smaller support"};

    forgetGlErrors();
    GpuTexton result;
    result.m_filtered = filtered;
    result.m_order = texton.interpolationOrder;
    result.m_density = density;
    result.m_footprint = {footprint.width, footprint.height};
    result.m_start = static_cast<float>(start);
    result.m_extent = {extent.width, extent.height};
    result.m_side = glm::vec2(size.width, size.height) / static_cast<float>(density);
    result.m_kernels = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, result.m_kernels.id());
    Level level = density == 1 ? coefficients(textons, size, texton.frame() - start)
                               : samples(textons, size, density);
    upload(0, level);
    int last = 0;
    while (filtered && (level.size.width > 1 || level.size.height > 1)) {
        level = halved(level);
        upload(++last, level);
    }
    const auto set = [](GLenum name, int value) {
        glTexParameteri(GL_TEXTURE_2D_ARRAY, name, value);
    };
    set(GL_TEXTURE_MAX_LEVEL, last);
    set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    set(GL_TEXTURE_MIN_FILTER, filtered ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
    set(GL_TEXTURE_MAG_FILTER, filtered && texton.interpolationOrder > 0 ? GL_LINEAR : GL_NEAREST);
    constexpr std::array kZero{0.0F, 0.0F, 0.0F, 0.0F};
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, kZero.data());
    if (texton.channels() == 1) {
        set(GL_TEXTURE_SWIZZLE_G, GL_RED);
        set(GL_TEXTURE_SWIZZLE_B, GL_RED);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);

    if (filtered)
        result.m_fades = fadeTexture(context, textons);
    if (textons.size() > 1)
        result.m_means = meanTexture(context, textons);
    if (auto ok = checkGlMemory("the texton"); !ok)
        return ok.error();
    return result;
}

ShaderDefines GpuTexton::commonDefines() const {
    if (!m_filtered)
        return {{"TXN_FILTER", "0"}, {"TXN_ORDER", std::to_string(m_order)}, {"TXN_FADES", "0"}};
    return {{"TXN_FADE_MAJOR", std::to_string(FilterFade::kMajor)},
            {"TXN_FADE_MINOR", std::to_string(FilterFade::kMinorOctaves)}};
}

ShaderDefines GpuTexton::defines(const GlContext& context, Filter filter) const {
    ShaderDefines defines = commonDefines();
    if (!m_filtered)
        return defines;
    const bool hardware = filter == Filter::Hardware && context.maxAnisotropy() > 1.0F;
    defines.emplace_back("TXN_FILTER", hardware ? "1" : "3");
    defines.emplace_back("TXN_FADES", "1");
    return defines;
}

ShaderDefines GpuTexton::definesOneScale(Filter filter, double pixelSide) const {
    ShaderDefines defines = commonDefines();
    if (!m_filtered)
        return defines;
    const bool fades = pixelSide > static_cast<double>(std::max(m_footprint.x, m_footprint.y));
    defines.emplace_back("TXN_FILTER", "2");
    defines.emplace_back("TXN_FETCHES", std::to_string(oneScale(filter, pixelSide).fetches));
    defines.emplace_back("TXN_FADES", fades ? "1" : "0");
    return defines;
}

GpuTexton::OneScale GpuTexton::oneScale(Filter filter, double pixelSide) const {
    const double width = std::min<double>(pixelSide, std::max(m_footprint.x, m_footprint.y));
    const double ramp = std::clamp((width - kSharpest) / kRamp, 0.0, 1.0);
    const bool four = filter == Filter::Anisotropic && ramp > 0.0;
    const double texels = (four ? 0.5 : 1.0) * width * m_density * kMipmapShare;
    return {four ? 4 : 1,
            four ? 0.25 * ramp * width / pixelSide : 0.0,
            std::log2(std::max(1.0, 1.0 + ramp * (texels - 1.0)))};
}

GpuTexton::Reach GpuTexton::reachOneScale(Filter filter, double pixelSide) const {
    if (!m_filtered)
        return {};
    // Texels of the coarser of two levels reach out by half, and so do the fetches; the last of
    // the texels may end beyond the kernel.
    const OneScale scale = oneScale(filter, pixelSide);
    const double texel = std::exp2(std::ceil(scale.level)) / m_density;
    const glm::dvec2 before(0.5 * texel + std::numbers::sqrt2 * scale.spread * pixelSide);
    const glm::dvec2 end = double{m_start} + glm::ceil(glm::dvec2(m_extent) / texel) * texel;
    return {before, before + glm::max(end - glm::dvec2(m_footprint), 0.0)};
}

void GpuTexton::setMinFilter(bool mipmaps) const {
    // Where the first level is all that is needed, not having to look for others saves an eighth
    // of the time on Mesa's software renderer.
    const GLint plain = m_order > 0 ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D_ARRAY,
                    GL_TEXTURE_MIN_FILTER,
                    mipmaps ? GL_LINEAR_MIPMAP_LINEAR : plain);
}

void GpuTexton::apply(ShaderProgram& program, const GlContext& context, Filter filter) const {
    program.set("txnKernels", 0);
    program.set("txnFootprint", m_footprint);
    if (m_means) {
        program.set("txnMeans", kMeansUnit);
        glActiveTexture(GL_TEXTURE0 + kMeansUnit);
        glBindTexture(GL_TEXTURE_2D, m_means.id());
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, m_kernels.id());
    if (!m_filtered)
        return;
    const float hardware =
        filter == Filter::Hardware ? std::min(context.maxAnisotropy(), kMostFetches) : 1.0F;
    // Mesa's software renderer falls back to its slow anisotropic filter even where a level is
    // asked for, unless this is 1.
    if (context.maxAnisotropy() > 1.0F)
        glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_ANISOTROPY_EXT, hardware);
    setMinFilter(true);
    program.set("txnKernelSide", m_side);
    program.set("txnStart", m_start);
    program.set("txnExtent", m_extent);
    program.set("txnAnisotropy", filter == Filter::Anisotropic ? kMostFetches : hardware);
    program.set("txnReach", std::max(m_footprint.x, m_footprint.y));
    program.set("txnDensity", static_cast<float>(m_density));
    program.set("txnMipmapShare", static_cast<float>(kMipmapShare));
    program.set("txnSharpest", static_cast<float>(kSharpest));
    program.set("txnRamp", static_cast<float>(kRamp));
    program.set("txnFades", 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_3D, m_fades.id());
    glActiveTexture(GL_TEXTURE0);
}

void GpuTexton::applyOneScale(ShaderProgram& program,
                              const GlContext& context,
                              Filter filter,
                              const glm::dvec2& right,
                              const glm::dvec2& down) const {
    apply(program, context, filter == Filter::None ? Filter::None : Filter::Mipmap);
    if (!m_filtered)
        return;
    const double side = glm::length(right);
    const OneScale scale = oneScale(filter, side);
    setMinFilter(scale.level > 0.0);
    program.set("txnLevel", static_cast<float>(scale.level));
    program.set("txnQuarterRight", glm::vec2(scale.spread * right));
    program.set("txnQuarterDown", glm::vec2(scale.spread * down));
    const Reach reach = reachOneScale(filter, side);
    program.set("txnBefore", glm::vec2(reach.before));
    program.set("txnAfter", glm::vec2(reach.after));
}

void GpuTexton::unbind() {
    glActiveTexture(GL_TEXTURE0 + kMeansUnit);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_3D, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

} // namespace txn
