// SPDX-License-Identifier: CC0-1.0

// Where a pixel of the plane seen straight from above lies.
uniform ivec2 middle;   // the pixel from which steps are counted, y down
uniform ivec2 baseCell; // where the middle's centre lies
uniform vec2 basePlace;
// From a pixel to its right and lower neighbour, in cells, as a sum of a number of few bits, whose
// multiples are exact, and a small rest: no rounding however large the picture.
uniform vec2 rightHigh;
uniform vec2 rightLow;
uniform vec2 downHigh;
uniform vec2 downLow;

// The cell, and the place in it. pixel: y down.
ivec2 planeCell(ivec2 pixel, out vec2 place) {
    vec2 n = vec2(pixel - middle);
    vec2 high = n.x * rightHigh + n.y * downHigh;
    vec2 whole = floor(high);
    place = high - whole + (n.x * rightLow + n.y * downLow + basePlace);
    vec2 carry = floor(place);
    place -= carry;
    return baseCell + ivec2(whole) + ivec2(carry);
}
