// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/noise/NoiseParams.h"
#include "core/texton/Texton.h"
#include "gl/ShaderLibrary.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace txn {

class ImpulseProcess;
class ShaderProgram;
struct Normalization;

/// Gain and offset as the shaders want them: one channel shown as grey, alpha 1 unless it is one of
/// four channels.
struct ChannelScale {
    glm::vec4 gain{0.0F};
    glm::vec4 offset{0.0F, 0.0F, 0.0F, 1.0F};
};
[[nodiscard]] ChannelScale channelScale(const Normalization& normalization);

/// An encoded colour as pictures of the given transfer hold it, opaque.
[[nodiscard]] glm::vec4 pictureColor(const glm::vec3& encoded, Transfer transfer);

/// Adds what texton_noise.glsl and surface_noise.glsl have to be compiled with.
void addNoiseDefines(ShaderDefines& defines, const NoiseParams& params);

/// Sets the uniforms of texton_noise.glsl, save those of the kernels.
void setNoiseUniforms(ShaderProgram& program, const Texton& texton, const NoiseParams& params);
/// Those of surface_noise.glsl, likewise.
void setSurfaceNoiseUniforms(ShaderProgram& program,
                             const Texton& texton,
                             const NoiseParams& params);

} // namespace txn
