// SPDX-License-Identifier: CC0-1.0
// The plane seen straight from above.
#include "texton_noise.glsl"

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
}
