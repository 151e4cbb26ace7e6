// SPDX-License-Identifier: CC0-1.0
#include "kernel.glsl"

uniform int height; // of the picture
uniform mat2 pictureToPlane;
uniform vec4 txnGain;

flat in ivec2 footprintPixel;
flat in vec2 footprintPlace;
flat in int impulseKernel;

out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y));
    vec2 y = pictureToPlane * (vec2(pixel - footprintPixel) + (0.5 - footprintPlace));
    TxnPixel shape; // all splats are of one scale
    vec4 value = txnKernel(abs(impulseKernel) - 1, y, shape);
    color = txnGain * (impulseKernel < 0 ? -value : value);
}
