// SPDX-License-Identifier: CC0-1.0
// The plane seen from above, each tile of the picture with a list of its impulses.
// TXN_MATERIAL 1: shaded as a material; TXN_MIXED: of a mixture of textons.
#include "kernel.glsl"
#ifdef TXN_MIXED
#include "mixing.glsl"
#include "plane_place.glsl"
#endif
#if TXN_MATERIAL
#include "material.glsl"
uniform vec3 surfaceX; // the exemplar's x and y: to the right, up, to the eye
uniform vec3 surfaceY;
#endif

uniform samplerBuffer impulses; // from the tile's corner to the footprint's, in pixels of the
                                // picture, y down; layer + 1, negative with a negative sign
uniform isamplerBuffer starts;  // of the tiles' lists, and the end of the last
uniform int tileSide;
uniform int tilesAcross;
uniform int height; // of the picture
uniform mat2 pictureToPlane;
uniform vec4 txnGain;
uniform vec4 txnOffset;

out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y));
    ivec2 tile = pixel / tileSide;
    vec2 place = vec2(pixel - tile * tileSide) + 0.5;
    int list = tile.y * tilesAcross + tile.x;
    int end = texelFetch(starts, list + 1).x;
    TxnPixel shape = txnPixel(pictureToPlane[0], pictureToPlane[1]);
    vec4 sum = vec4(0.0);
    for (int i = texelFetch(starts, list).x; i < end; ++i) {
        vec4 impulse = texelFetch(impulses, i);
        vec2 y = pictureToPlane * (place - impulse.xy);
        sum += sign(impulse.z) * txnKernel(int(abs(impulse.z)) - 1, y, shape);
    }
#ifdef TXN_MIXED
    vec2 inCell;
    ivec2 cell = planeCell(pixel, inCell);
    // Pixels are much smaller than footprints here: nothing gets fainter.
    color = txnMean(cell, inCell, pictureToPlane[0], pictureToPlane[1]) + txnGain * sum;
#else
    color = txnOffset + txnGain * shape.fade * sum;
#endif
#if TXN_MATERIAL
    mat3 frame = mat3(surfaceX, surfaceY, vec3(0.0, 0.0, 1.0));
    color = shaded(color, ivec2(gl_FragCoord.xy), frame, frame[2]);
#endif
}
