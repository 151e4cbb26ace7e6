// SPDX-License-Identifier: CC0-1.0

// Texton noise in the plane: Galerne, Leclaire, Moisan, "Texton Noise", Computer Graphics Forum
// 2017. TXN_PROCESS 0: stratified, one impulse in each cell, with random signs; 1: a Poisson process
// with random signs; 2: without, as in the paper. TXN_MIXED: of a mixture of textons.
#include "hash.glsl"
#include "kernel.glsl"
#ifdef TXN_MIXED
#include "mixing.glsl"
#endif

uniform uint txnSeed;
uniform int txnKernelCount;
uniform vec2 txnCell;    // size of a cell in exemplar pixels; one impulse each, or one on average
uniform ivec2 txnPeriod; // in cells, after which noise repeats; 0: never
uniform vec4 txnGain;
uniform vec4 txnOffset;

// Noise at a point given as a cell of the plane and the place in it (in cells, any number). dx, dy:
// steps in exemplar pixels to the next pixel of the picture.
vec4 textonNoise(ivec2 cell, vec2 place, vec2 dx, vec2 dy) {
    TxnPixel pixel = txnPixel(dx, dy);
    ivec2 first = ivec2(floor(place - (txnFootprint + pixel.after) / txnCell));
    ivec2 last = ivec2(floor(place + pixel.before / txnCell));
#ifdef TXN_MIXED
    TxnMapPlace onMap = txnMapPlace(cell);
    TxnMixedSum sum = TxnMixedSum(vec4(0.0), vec4(0.0), vec4(0.0));
#else
    vec4 sum = vec4(0.0);
#endif
    // There is a cell at least. Where the processor draws, a loop whose end is tested first is gone
    // through once more than needed.
    int j = first.y;
    do {
        int i = first.x;
        do {
            uvec2 hashed = uvec2(txnWrapped(cell.x + i, txnPeriod.x),
                                 txnWrapped(cell.y + j, txnPeriod.y));
            int count = 1;
#if TXN_PROCESS != 0
            count = txnPoissonCount(txnHash(uvec4(hashed, 0xffffffffu, txnSeed)).x);
#endif
            for (int n = 0; n < count; ++n) {
                uvec4 h = txnHash(uvec4(hashed, uint(n), txnSeed));
                // From the top left corner of the footprint that was dropped there.
                vec2 dropped = vec2(txnUnit(h.x), txnUnit(h.y));
                vec2 y = (place - vec2(i, j) - dropped) * txnCell;
                if (all(greaterThanEqual(y, -pixel.before)) &&
                    all(lessThan(y, txnFootprint + pixel.after))) {
                    int kernel = int(((h.w >> 16u) * uint(txnKernelCount)) >> 16u);
                    float weight = TXN_PROCESS != 2 && (h.z >> 31u) != 0u ? -1.0 : 1.0;
#ifdef TXN_MIXED
                    int texton =
                        txnTextonAt(onMap, vec2(i, j) + dropped, (h.w & 0xffffu) >> 6u);
                    kernel += texton * txnKernelCount;
                    txnAdd(sum, texton, weight * txnKernel(kernel, y, pixel));
#else
                    sum += weight * txnKernel(kernel, y, pixel);
#endif
                }
            }
        } while (++i <= last.x);
    } while (++j <= last.y);
#ifdef TXN_MIXED
    return txnMean(cell, place, dx, dy) + txnGain * txnFaded(sum, pixel);
#else
    return txnOffset + txnGain * pixel.fade * sum;
#endif
}

// The same at a point in exemplar pixels.
vec4 textonNoise(vec2 point, vec2 dx, vec2 dy) {
    vec2 place = clamp(point / txnCell, -1e8, 1e8);
    vec2 cell = floor(place);
    return textonNoise(ivec2(cell), place - cell, dx, dy);
}
