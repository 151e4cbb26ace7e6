// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/OutputFiles.h"
#include "core/noise/NoiseParams.h"
#include "core/texton/Texton.h"

#include <string>

namespace txn::app {

// What an engine needs to draw the noise: one shader file, the texels, the numbers, an example.
// Textons of 1 to 4 channels.

/// One self-contained file of GLSL 330, CC0: the files of resources/shaders with all parameters as
/// constants, and `vec4 textonNoise(vec2 point)` in exemplar pixels. What is left for the caller to
/// bind is the texture of kernelTexels().
[[nodiscard]] Result<std::string> engineShader(const Texton& texton, const NoiseParams& noise);

/// The kernels with their frame of zeros, ready for glTexImage3D: RGBA, float32 in the machine's
/// byte order, row after row, footprint wide and high, a layer per kernel.
[[nodiscard]] std::string kernelTexels(const Texton& texton);

/// Sizes and parameters, for readers that cannot parse GLSL.
[[nodiscard]] std::string engineParameters(const Texton& texton, const NoiseParams& noise);

/// A program that draws 512 x 512 pixels of the noise from files called name.glsl and name.f32 into
/// a PPM file.
[[nodiscard]] Result<std::string> engineExample(const Texton& texton, const std::string& name);

} // namespace txn::app
