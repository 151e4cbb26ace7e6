// SPDX-License-Identifier: CC0-1.0

// Texton noise on a surface without texture coordinates: section 6 of "Texton Noise". Impulses lie
// in space; those in a cube around a point are projected onto the tangent plane there. TXN_PROCESS and
// TXN_MIXED as in texton_noise.glsl; a map lies as seen from the front, along the x of space and
// against its y.
#include "hash.glsl"
#include "kernel.glsl"
#ifdef TXN_MIXED
#include "mixing.glsl"
#endif

uniform uint txnSeed;
uniform int txnKernelCount;
uniform float txnSpaceCell; // side of a cell in exemplar pixels; one impulse each, or one on average
uniform float txnCube;      // side of the cube: the longer side of the footprint
uniform vec4 txnGain;
uniform vec4 txnOffset;

uvec4 txnSpaceHash(ivec3 cell, uint index) {
    return txnHash(uvec4(uvec3(cell), txnSeed + index * 0x9e3779b9u));
}

// Those n for which |from + n step| <= reach, as a range; everything where step is next to nothing.
vec2 txnSlab(float from, float step, float reach) {
    float inverse = 1.0 / (abs(step) > 1e-6 ? step : 1e-6);
    float middle = -from * inverse;
    float width = abs(reach * inverse);
    return vec2(middle - width, middle + width);
}

// Noise at a point given as a cell of space and the place in it (in cells, any number). frame: the
// directions of a kernel's x and y and the normal. dx, dy: steps to the next pixel of the picture,
// in exemplar pixels along those two directions.
vec4 surfaceNoise(ivec3 cell, vec3 place, mat3 frame, vec2 dx, vec2 dy) {
    TxnPixel pixel = txnPixel(dx, dy);
    // Half the box in which impulses count, in the frame's directions, in cells.
    vec3 box = vec3(0.5 * txnFootprint + pixel.after, 0.5 * txnCube) / txnSpaceCell;
    vec3 reach = abs(frame[0]) * box.x + abs(frame[1]) * box.y + abs(frame[2]) * box.z;
    ivec3 first = ivec3(floor(place - reach));
    ivec3 last = ivec3(floor(place + reach));
    // A cell may hold such an impulse if its centre lies in this larger box.
    vec3 wide = box + 0.5 * (vec3(1.0) * mat3(abs(frame[0]), abs(frame[1]), abs(frame[2])));
#ifdef TXN_MIXED
    TxnMapPlace onMap = txnMapPlace(cell.xy);
    TxnMixedSum sum = TxnMixedSum(vec4(0.0), vec4(0.0), vec4(0.0));
#else
    vec4 sum = vec4(0.0);
#endif
    for (int k = first.z; k <= last.z; ++k) {
        for (int j = first.y; j <= last.y; ++j) {
            vec3 start = (vec3(0.5, vec2(j, k) + 0.5) - place) * frame;
            vec3 step = vec3(1.0, 0.0, 0.0) * frame;
            vec2 range = txnSlab(start.x, step.x, wide.x);
            vec2 other = txnSlab(start.y, step.y, wide.y);
            range = vec2(max(range.x, other.x), min(range.y, other.y));
            other = txnSlab(start.z, step.z, wide.z);
            range = vec2(max(range.x, other.x), min(range.y, other.y));
            range = clamp(range, vec2(first.x), vec2(last.x + 1));
            for (int i = int(ceil(range.x - 1e-3)); i <= int(floor(range.y + 1e-3)); ++i) {
                ivec3 hashed = cell + ivec3(i, j, k);
                int count = TXN_PROCESS == 0 ? 1 : txnPoissonCount(txnSpaceHash(hashed, 0u).x);
                for (int n = 1; n <= count; ++n) {
                    uvec4 h = txnSpaceHash(hashed, uint(n));
                    vec3 waiting = vec3(txnUnit(h.x), txnUnit(h.y), txnUnit(h.z));
                    vec3 from = (place - vec3(i, j, k) - waiting) * frame;
                    if (all(lessThan(abs(from), box))) {
                        int kernel = int((((h.w >> 15u) & 0xffffu) * uint(txnKernelCount)) >> 16u);
                        vec2 y = from.xy * txnSpaceCell + 0.5 * txnFootprint;
                        float weight = 1.0 - abs(from.z) / box.z;
                        if (TXN_PROCESS != 2 && (h.w >> 31u) != 0u)
                            weight = -weight;
#ifdef TXN_MIXED
                        int texton =
                            txnTextonAt(onMap, vec2(i, j) + waiting.xy, (h.w >> 5u) & 0x3ffu);
                        kernel += texton * txnKernelCount;
                        txnAdd(sum, texton, weight * txnKernel(kernel, y, pixel));
#else
                        sum += weight * txnKernel(kernel, y, pixel);
#endif
                    }
                }
            }
        }
    }
#ifdef TXN_MIXED
    return txnMean(cell.xy, place.xy, dx, dy) + txnGain * txnFaded(sum, pixel);
#else
    return txnOffset + txnGain * pixel.fade * sum;
#endif
}

// The same at a point in exemplar pixels.
vec4 surfaceNoise(vec3 point, mat3 frame, vec2 dx, vec2 dy) {
    vec3 place = clamp(point / txnSpaceCell, -1e8, 1e8);
    vec3 cell = floor(place);
    return surfaceNoise(ivec3(cell), place - cell, frame, dx, dy);
}
