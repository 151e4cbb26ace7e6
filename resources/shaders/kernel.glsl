// SPDX-License-Identifier: CC0-1.0

// The kernels of a texton, or of several one after the other, one layer each, zero all around. With TXN_FILTER 0 texels are the
// coefficients, fetched and weighed by the B-spline of order TXN_ORDER in full precision; otherwise
// they are samples of the kernels with their mipmaps.
#include "filter.glsl"

uniform sampler2DArray txnKernels;
#if TXN_FILTER
uniform vec2 txnKernelSide; // what the texture spans, in exemplar pixels

vec3 txnTexturePoint(int kernel, vec2 y) {
    return vec3((y - txnStart) / txnKernelSide, float(kernel));
}
#endif

#if TXN_FILTER == 1
vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    return textureGrad(txnKernels,
                       txnTexturePoint(kernel, y),
                       pixel.dx / txnKernelSide,
                       pixel.dy / txnKernelSide);
}
#elif TXN_FILTER == 2
uniform float txnLevel;

vec4 txnFetch(int kernel, vec2 y) {
    return textureLod(txnKernels, txnTexturePoint(kernel, y), txnLevel);
}

#if TXN_FETCHES == 4
uniform vec2 txnQuarterRight; // a quarter of the step to the next pixel
uniform vec2 txnQuarterDown;

vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    return 0.25 * (txnFetch(kernel, y - txnQuarterRight - txnQuarterDown) +
                   txnFetch(kernel, y + txnQuarterRight - txnQuarterDown) +
                   txnFetch(kernel, y - txnQuarterRight + txnQuarterDown) +
                   txnFetch(kernel, y + txnQuarterRight + txnQuarterDown));
}
#else
vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    return txnFetch(kernel, y);
}
#endif
#elif TXN_FILTER == 3
vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    vec2 step = pixel.axis / float(pixel.fetches);
    vec2 at = y - 0.5 * (pixel.axis - step);
    vec4 sum = vec4(0.0);
    int i = 0;
    do { // as in texton_noise.glsl: sooner done than for
        sum += textureLod(txnKernels, txnTexturePoint(kernel, at + float(i) * step), pixel.level);
    } while (++i < pixel.fetches);
    return sum / float(pixel.fetches);
}
#else
// Outside the footprint lie zeros, as on its border.
vec4 txnTexel(int kernel, ivec2 n) {
    return texelFetch(txnKernels, ivec3(clamp(n, ivec2(0), ivec2(txnFootprint) - 1), kernel), 0);
}

#if TXN_ORDER == 0
vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    return txnTexel(kernel, ivec2(floor(y)));
}
#elif TXN_ORDER == 1
vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    vec2 from = floor(y - 0.5);
    vec2 t = y - 0.5 - from;
    ivec2 n = ivec2(from);
    vec4 top = mix(txnTexel(kernel, n), txnTexel(kernel, n + ivec2(1, 0)), t.x);
    vec4 bottom = mix(txnTexel(kernel, n + ivec2(0, 1)), txnTexel(kernel, n + ivec2(1, 1)), t.x);
    return mix(top, bottom, t.y);
}
#else
// The B-spline at distance d >= 0.
float txnSpline(float d) {
#if TXN_ORDER == 3
    float far = 2.0 - d;
    return d < 1.0 ? 2.0 / 3.0 - d * d * (1.0 - 0.5 * d) : far * far * far / 6.0;
#else // 5
    float d2 = d * d;
    float far = 3.0 - d;
    if (d < 1.0)
        return 0.55 - d2 * (0.5 - d2 * (0.25 - d / 12.0));
    if (d < 2.0)
        return 0.425 + d * (0.625 - d * (1.75 - d * (1.25 - d * (0.375 - d / 24.0))));
    return far * far * far * far * far / 120.0;
#endif
}

vec4 txnKernel(int kernel, vec2 y, TxnPixel pixel) {
    vec2 from = floor(y - 0.5);
    vec2 t = y - 0.5 - from;
    const int reach = (TXN_ORDER - 1) / 2;
    float wx[TXN_ORDER + 1];
    for (int i = 0; i <= TXN_ORDER; ++i)
        wx[i] = txnSpline(abs(t.x + float(reach - i)));
    vec4 sum = vec4(0.0);
    for (int j = 0; j <= TXN_ORDER; ++j) {
        vec4 row = vec4(0.0);
        for (int i = 0; i <= TXN_ORDER; ++i)
            row += wx[i] * txnTexel(kernel, ivec2(from) + ivec2(i, j) - reach);
        sum += txnSpline(abs(t.y + float(reach - j))) * row;
    }
    return sum;
}
#endif
#endif
