// SPDX-License-Identifier: CC0-1.0

// Mixtures of textons: a map of the plane says which of them each impulse takes, and what the mean
// is. Whole numbers decide, the same as on the processor. TXN_MAP_REPEATS 0: beyond the map lies
// its nearest border; TXN_MEAN_LEVELS: how many levels of means there may be.
#include "hash.glsl"

// How texels lie over the cells of the impulses.
struct TxnGrid {
    vec2 high;  // texels along a cell: a number of few bits, whose multiples are exact, and a rest
    vec2 low;
    vec2 start; // where the cell txnMapCell begins: whole texels, and the rest
    vec2 rest;
};

uniform usampler2D txnMap;  // 1024 times the position along the textons
uniform TxnGrid txnMapGrid; // of txnMap, for the corners of footprints
uniform ivec2 txnMapCell;
uniform sampler2D txnMeans; // of the textons, a texel each

// Where the mean lies along the textons': coefficients of a B-spline, each with the three to its
// right, from the third left of the map on. Below them the coarser levels: fetched from mipmaps, all
// four pixels of a block would get the level of the first on some drivers.
uniform sampler2D txnMeanMap;
uniform TxnGrid txnMeanGrid;    // of the finest level
uniform ivec2 txnMeanSize;      // of the finest level
uniform ivec2 txnMeanCorners[TXN_MEAN_LEVELS]; // of the map in all levels
uniform float txnMeanDensity;   // texels of the finest level per exemplar pixel
uniform float txnCoarsestMeans; // the last level to use

// The texel in which a place in a cell lies, and where in it.
vec2 txnTexelOf(TxnGrid grid, ivec2 cell, vec2 place, out vec2 rest) {
    vec2 cells = vec2(cell - txnMapCell);
    vec2 high = cells * grid.high;
    vec2 whole = floor(high);
    rest = high - whole + (cells * grid.low + place * (grid.high + grid.low) + grid.rest);
    vec2 carry = floor(rest);
    rest -= carry;
    return grid.start + whole + carry;
}

// The texel that stands for one beyond the map, which is there from the first one on. Whole numbers
// below 2^24 are exact, and much sooner divided than integers.
vec2 txnOnMap(vec2 texel, vec2 first, vec2 size) {
#if TXN_MAP_REPEATS
    vec2 repeated = texel - floor(texel / size) * size;
    repeated += size * vec2(lessThan(repeated, vec2(0.0))); // where the quotient was rounded
    return repeated - size * vec2(greaterThanEqual(repeated, size));
#else
    return clamp(texel, first, size - 1.0);
#endif
}

// Where a pixel's cell lies on txnMap: found once for all impulses that the pixel sees.
struct TxnMapPlace {
    vec2 texel;
    vec2 rest;
    vec2 along; // texels along a cell
    vec2 size;
};

TxnMapPlace txnMapPlace(ivec2 cell) {
    TxnMapPlace at;
    at.texel = txnTexelOf(txnMapGrid, cell, vec2(0.0), at.rest);
    at.along = txnMapGrid.high + txnMapGrid.low;
    at.size = vec2(textureSize(txnMap, 0));
    return at;
}

// Which texton an impulse takes. from: where it was dropped, in cells from the corner of the pixel's
// cell; choice: 10 random bits. Places between two textons take either of them by chance, in
// proportion.
int txnTextonAt(TxnMapPlace at, vec2 from, uint choice) {
    vec2 texel = txnOnMap(at.texel + floor(at.rest + from * at.along), vec2(0.0), at.size);
    uint position = texelFetch(txnMap, ivec2(texel), 0).r;
    return int((position + 1023u - choice) >> 10u);
}

// Impulses of all textons. With TXN_FADES each is to be made as much fainter as its texton asks for:
// for that, r from 0 to 1 along the textons, their sums weighed by r and r (1 - r) are enough.
struct TxnMixedSum {
    vec4 all;
    vec4 along;
    vec4 bent;
};

void txnAdd(inout TxnMixedSum sum, int texton, vec4 value) {
    sum.all += value;
#if TXN_FADES
    float r = float(texton) / float(textureSize(txnMeans, 0).x - 1);
    sum.along += r * value;
    sum.bent += r * (1.0 - r) * value;
#endif
}

vec4 txnFaded(TxnMixedSum sum, TxnPixel pixel) {
#if TXN_FADES
    return pixel.fade * sum.all + pixel.fadeSlope * sum.along + pixel.fadeBend * sum.bent;
#else
    return sum.all;
#endif
}

// Weights of four neighbours in a cubic B-spline, t beyond the second of them.
vec4 txnWeights(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s,
                4.0 - t * t * (6.0 - 3.0 * t),
                4.0 - s * s * (6.0 - 3.0 * s),
                t * t * t) / 6.0;
}

// Where the mean lies along the textons', by one level at a place in texels of the finest.
float txnMeanPosition(vec2 texel, vec2 rest, int level) {
    ivec2 corner = txnMeanCorners[level];
    vec2 size = vec2(max(txnMeanSize >> level, 1));
    if (level > 0) {
        vec2 place = (texel + rest) * (size / vec2(txnMeanSize));
        texel = floor(place);
        rest = place - texel;
    }
    // Texel i is centred on i + 1/2.
    vec2 before = vec2(lessThan(rest, vec2(0.5)));
    rest += before - 0.5;
    texel -= before + 1.0;
    vec4 horizontal = txnWeights(rest.x);
    vec4 vertical = txnWeights(rest.y);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < 4; ++j) {
        vec2 row = txnOnMap(texel + vec2(0.0, j), vec2(-3.0, 0.0), size);
        sum += vertical[j] * texelFetch(txnMeanMap, corner + ivec2(row), 0);
    }
    return dot(horizontal, sum);
}

// The textons' means, interpolated at the smoothed map. dx, dy: steps in exemplar pixels to the
// next pixel of the picture.
vec4 txnMean(ivec2 cell, vec2 place, vec2 dx, vec2 dy) {
    vec2 rest;
    vec2 texel = txnTexelOf(txnMeanGrid, cell, place, rest);
#if TXN_FILTER
    float side = sqrt(max(dot(dx, dx), dot(dy, dy))) * txnMeanDensity;
    float level = min(log2(max(side, 1.0)), txnCoarsestMeans);
    // One level or two. What draws with the processor skips neither branches nor the first turn of
    // a loop, but the others.
    float position = 0.0;
    int n = int(level);
    do {
        position += (1.0 - abs(level - float(n))) * txnMeanPosition(texel, rest, n);
        ++n;
    } while (float(n) < level + 1.0);
#else
    float position = txnMeanPosition(texel, rest, 0);
#endif
    int left = clamp(int(position), 0, textureSize(txnMeans, 0).x - 2);
    return mix(texelFetch(txnMeans, ivec2(left, 0), 0),
               texelFetch(txnMeans, ivec2(left + 1, 0), 0),
               position - float(left));
}
