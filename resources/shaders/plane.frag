// SPDX-License-Identifier: CC0-1.0
// The plane seen straight from above.
// TXN_MATERIAL 1: shaded as a material.
#include "texton_noise.glsl"
#if TXN_MATERIAL
#include "material.glsl"
uniform vec3 surfaceX; // the exemplar's x and y: to the right, up, to the eye
uniform vec3 surfaceY;
#endif

uniform ivec2 middle;   // the pixel from which steps are counted, y down
uniform int height;     // of the picture
uniform ivec2 baseCell; // where the middle's centre lies
uniform vec2 basePlace;
// From a pixel to its right and lower neighbour, in cells, as a sum of a number of few bits, whose
// multiples are exact, and a small rest: no rounding however large the picture.
uniform vec2 rightHigh;
uniform vec2 rightLow;
uniform vec2 downHigh;
uniform vec2 downLow;

out vec4 color;

void main() {
    vec2 n = vec2(ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y)) - middle);
    vec2 high = n.x * rightHigh + n.y * downHigh;
    vec2 whole = floor(high);
    vec2 place = high - whole + (n.x * rightLow + n.y * downLow + basePlace);
    vec2 carry = floor(place);
    color = textonNoise(baseCell + ivec2(whole) + ivec2(carry),
                        place - carry,
                        (rightHigh + rightLow) * txnCell,
                        (downHigh + downLow) * txnCell);
#if TXN_MATERIAL
    mat3 frame = mat3(surfaceX, surfaceY, vec3(0.0, 0.0, 1.0));
    color = shaded(color, ivec2(gl_FragCoord.xy), frame, frame[2]);
#endif
}
