// SPDX-License-Identifier: CC0-1.0
// The plane seen straight from above.
// TXN_MATERIAL 1: shaded as a material.
#include "texton_noise.glsl"
#include "plane_place.glsl"
#if TXN_MATERIAL
#include "material.glsl"
uniform vec3 surfaceX; // the exemplar's x and y: to the right, up, to the eye
uniform vec3 surfaceY;
#endif

uniform int height; // of the picture

out vec4 color;

void main() {
    vec2 place;
    ivec2 cell = planeCell(ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y)), place);
    color = textonNoise(cell, place, (rightHigh + rightLow) * txnCell, (downHigh + downLow) * txnCell);
#if TXN_MATERIAL
    mat3 frame = mat3(surfaceX, surfaceY, vec3(0.0, 0.0, 1.0));
    color = shaded(color, ivec2(gl_FragCoord.xy), frame, frame[2]);
#endif
}
