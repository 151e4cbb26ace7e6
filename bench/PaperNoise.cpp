// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/PaperNoise.h"

#include "core/noise/Normalization.h"
#include "gl/GlContext.h"
#include "gl/ShaderLibrary.h"

#include <array>
#include <cassert>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <numeric>

namespace txn::bench {
namespace {

constexpr const char* kFragmentText = R"(#version 330 core
uniform sampler2D kernel; // the texton in its frame of zeros
uniform vec2 footprint;
uniform vec2 cellSize;
uniform float meanCount; // of impulses in a cell
uniform float noneShare; // exp(-meanCount)
uniform uint seed;
uniform vec2 pictureSize;
uniform vec4 gain;
uniform vec4 offset;

out vec4 color;

uint hashed(uint v) {
    v ^= v >> 16u;
    v *= 0x7feb352du;
    v ^= v >> 15u;
    v *= 0x846ca68bu;
    return v ^ (v >> 16u);
}

float uniformDraw(inout uint state) {
    state ^= state << 13u;
    state ^= state >> 17u;
    state ^= state << 5u;
    return float(state >> 8u) * (1.0 / 16777216.0);
}

// Inversion by sequential search.
int poissonDraw(inout uint state) {
    float rest = uniformDraw(state);
    float share = noneShare;
    int count = 0;
    while (rest >= share && count < 64) {
        rest -= share;
        ++count;
        share *= meanCount / float(count);
    }
    return count;
}

void main() {
    vec2 point = vec2(gl_FragCoord.x, pictureSize.y - gl_FragCoord.y) - 0.5 * pictureSize;
    ivec2 first = ivec2(floor((point - footprint) / cellSize));
    ivec2 last = ivec2(floor(point / cellSize));
    vec2 scale = 1.0 / footprint;
    vec4 sum = vec4(0.0);
    for (int j = first.y; j <= last.y; ++j) {
        for (int i = first.x; i <= last.x; ++i) {
            uint state = max(hashed(uint(i) + hashed(uint(j) + seed)), 1u);
            vec2 fromCell = point - vec2(i, j) * cellSize;
            int count = poissonDraw(state);
            for (int n = 0; n < count; ++n) {
                float x = uniformDraw(state);
                vec2 y = (fromCell - vec2(x, uniformDraw(state)) * cellSize) * scale;
                if (all(greaterThanEqual(y, vec2(0.0))) && all(lessThan(y, vec2(1.0))))
                    sum += textureLod(kernel, y, 0.0);
            }
        }
    }
    color = offset + gain * sum;
}
)";

/// Channels as RGBA; one as grey.
int shownChannel(int i, int channels) {
    return channels == 1 && i < 3 ? 0 : i;
}

void upload(const Texton& texton) {
    const Image& kernel = texton.kernels.front();
    const Size footprint = texton.footprint();
    const int frame = texton.frame();
    std::vector<float> texels(footprint.area() * 4, 0.0F);
    for (int y = 0; y < kernel.height(); ++y) {
        for (int x = 0; x < kernel.width(); ++x) {
            const auto place =
                static_cast<std::size_t>(y + frame) * static_cast<std::size_t>(footprint.width) +
                static_cast<std::size_t>(x + frame);
            for (int i = 0; i < 4; ++i) {
                const int c = shownChannel(i, kernel.channels());
                if (c < kernel.channels())
                    texels[4 * place + static_cast<std::size_t>(i)] = kernel.at(x, y, c);
            }
        }
    }
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_RGBA32F,
                 footprint.width,
                 footprint.height,
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array kZero{0.0F, 0.0F, 0.0F, 0.0F};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kZero.data());
}

} // namespace

Result<PaperNoise> PaperNoise::create(const GlContext& context, const Texton& texton, Seed seed) {
    assert(texton.kernelCount() == 1 && texton.interpolationOrder == 1 && texton.channels() <= 4);
    const auto vertexText = shaderText("fullscreen.vert");
    if (!vertexText)
        return vertexText.error();
    auto program = ShaderProgram::build(context, "PaperNoise", *vertexText, kFragmentText);
    if (!program)
        return program.error();
    PaperNoise result;
    result.m_program = std::move(*program);
    result.m_vertices = GlHandle::make(context, GlHandle::Kind::VertexArray);
    result.m_kernel = GlHandle::make(context, GlHandle::Kind::Texture);
    glBindTexture(GL_TEXTURE_2D, result.m_kernel.id());
    upload(texton);
    glBindTexture(GL_TEXTURE_2D, 0);

    const Size footprint = texton.footprint();
    const glm::vec2 side(footprint.width, footprint.height);
    constexpr double kMeanCount = kCellShare * kCellShare * kMeanImpacts;
    const NoiseParams params{NoiseProcess::Poisson, kMeanImpacts, seed, {}};
    const Normalization scale = normalization(texton, ImpulseProcess(params, footprint, 1));
    glm::vec4 gain{0.0F};
    glm::vec4 offset{0.0F, 0.0F, 0.0F, 1.0F};
    for (int i = 0; i < 4; ++i) {
        const int c = shownChannel(i, texton.channels());
        if (c >= texton.channels())
            continue;
        gain[i] = static_cast<float>(scale.gain);
        offset[i] = static_cast<float>(scale.offset[static_cast<std::size_t>(c)]);
    }
    result.m_program.use();
    result.m_program.set("kernel", 0);
    result.m_program.set("footprint", side);
    result.m_program.set("cellSize", static_cast<float>(kCellShare) * side);
    result.m_program.set("meanCount", static_cast<float>(kMeanCount));
    result.m_program.set("noneShare", static_cast<float>(std::exp(-kMeanCount)));
    result.m_program.set("seed", seed.value);
    result.m_program.set("gain", gain);
    result.m_program.set("offset", offset);
    glUseProgram(0);
    return result;
}

void PaperNoise::draw(const OffscreenTarget& target) {
    target.bind();
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    m_program.use();
    m_program.set("pictureSize", glm::vec2(target.size().width, target.size().height));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_kernel.id());
    glBindVertexArray(m_vertices.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
}

Result<void> PaperNoise::check(const GlContext& context, const Texton& texton) {
    constexpr Size kSize{1024, 1024};
    constexpr double kTolerance = 0.05; // twice what a picture of so few footprints strays
    const auto target = OffscreenTarget::create(context, kSize);
    if (!target)
        return target.error();
    draw(*target);
    const Image picture = target->read(texton.channels(), texton.transfer);
    const auto covariance = noiseCovariance(texton);
    const auto channels = static_cast<std::size_t>(texton.channels());
    for (std::size_t c = 0; c < channels; ++c) {
        const auto plane = picture.plane(static_cast<int>(c));
        const auto count = static_cast<double>(plane.size());
        const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / count;
        const double squares =
            std::accumulate(plane.begin(), plane.end(), 0.0, [&](double sum, float v) {
                return sum + (v - mean) * (v - mean);
            });
        const double expected = std::sqrt(covariance[c * channels + c]);
        const double deviation = std::sqrt(squares / count);
        const bool same = std::abs(mean - texton.mean[c]) <= kTolerance * expected &&
                          std::abs(deviation - expected) <= kTolerance * expected;
        if (!same)
            return Error{ErrorCode::Degenerate,
                         "the paper's noise has mean " + std::to_string(mean) + " and deviation " +
                             std::to_string(deviation) + ", not " + std::to_string(texton.mean[c]) +
                             " and " + std::to_string(expected)};
    }
    return {};
}

} // namespace txn::bench
