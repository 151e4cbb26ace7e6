// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/NoiseUniforms.h"

#include "core/image/ColorTransfer.h"
#include "core/noise/SurfaceNoise.h"
#include "gl/ShaderProgram.h"

#include <glm/vec2.hpp>

namespace txn {
namespace {

void setCommon(ShaderProgram& program,
               const Texton& texton,
               const NoiseParams& params,
               const Normalization& normalization) {
    const ChannelScale scale = channelScale(normalization);
    program.set("txnSeed", params.seed.value);
    program.set("txnKernelCount", texton.kernelCount());
    program.set("txnGain", scale.gain);
    program.set("txnOffset", scale.offset);
}

} // namespace

ChannelScale channelScale(const Normalization& normalization) {
    ChannelScale scale;
    const auto channels = static_cast<int>(normalization.offset.size());
    for (int i = 0; i < (channels == 4 ? 4 : 3); ++i) {
        const int c = channels == 1 ? 0 : i;
        if (c >= channels)
            break;
        scale.gain[i] = static_cast<float>(normalization.gain);
        scale.offset[i] = static_cast<float>(normalization.offset[static_cast<std::size_t>(c)]);
    }
    return scale;
}

glm::vec4 pictureColor(const glm::vec3& encoded, Transfer transfer) {
    if (transfer == Transfer::Encoded)
        return {encoded, 1.0F};
    return {linearFromEncoded(encoded.r),
            linearFromEncoded(encoded.g),
            linearFromEncoded(encoded.b),
            1.0F};
}

void addNoiseDefines(ShaderDefines& defines, const NoiseParams& params) {
    defines.emplace_back("TXN_PROCESS", std::to_string(static_cast<int>(params.process)));
}

void setNoiseUniforms(ShaderProgram& program, const Texton& texton, const NoiseParams& params) {
    const ImpulseProcess impulses(params, texton.footprint(), texton.kernelCount());
    setCommon(program, texton, params, normalization(texton, impulses));
    program.set("txnCell", glm::vec2(impulses.cellWidth(), impulses.cellHeight()));
    program.set("txnPeriod", glm::ivec2(impulses.periodX(), impulses.periodY()));
}

void setSurfaceNoiseUniforms(ShaderProgram& program,
                             const Texton& texton,
                             const NoiseParams& params) {
    const SurfaceImpulses impulses(params, texton.footprint(), texton.kernelCount());
    setCommon(program, texton, params, surfaceNormalization(texton, impulses));
    program.set("txnSpaceCell", static_cast<float>(impulses.cell()));
    program.set("txnCube", static_cast<float>(impulses.side()));
}

} // namespace txn
