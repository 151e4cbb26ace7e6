// SPDX-License-Identifier: CC0-1.0

// What a pixel of the picture averages over. By TXN_FILTER:
// 0: nothing, it sees a point;
// 1: the ellipse of its own shape on the plane, by the hardware's anisotropic filter;
// 2: the same square all over the picture, by TXN_FETCHES (1 or 4) fetches from mipmaps;
// 3: as 1, by several fetches along the ellipse's longer axis.
// TXN_FADES 0: pixels are known not to be larger than footprints.
struct TxnPixel {
    vec2 dx; // steps in exemplar pixels to the next pixel of the picture
    vec2 dy;
    vec2 before; // how far outside its footprint a filtered kernel reaches, to the left and up
    vec2 after;  // and to the right and down
    vec4 fade;   // by what the fluctuation has to be scaled
#ifdef TXN_MIXED
    vec4 fadeSlope; // of a mixture, at r along its textons: fade + r fadeSlope + r (1 - r) fadeBend
    vec4 fadeBend;
#endif
    vec2 axis;   // of the ellipse, the longer one, as long as the pixel is there
    float level;
    int fetches;
};

uniform vec2 txnFootprint; // in exemplar pixels

#if TXN_FILTER
uniform float txnReach;     // the longer side of the footprint
uniform float txnStart;     // where in the footprint the texture of a kernel begins
uniform sampler3D txnFades; // see FilterFade.h; of a mixture: of its three terms, side by side

// Beyond one footprint the filter grows no further, since the number of impulses to look at would,
// too; what is still to be averaged only makes the fluctuation fainter, by a factor known from the
// covariance of the noise. a >= b: axes of the ellipse, angle: of the longer one. Where in a table
// that factor is, and by what to scale it besides; the latter is 0 where nothing gets fainter.
vec4 txnFadePlace(float a, float b, float angle) {
    if (a <= txnReach)
        return vec4(0.0);
    vec3 size = vec3(TXN_FADE_MAJOR, textureSize(txnFades, 0).yz);
    vec2 octaves = log2(vec2(a, max(b, 1e-6)) / txnReach) + vec2(0.0, float(TXN_FADE_MINOR));
    vec2 beyond = max(octaves - (size.xy - 1.0), 0.0);
    return vec4(min(octaves.x, size.x - 1.0) + 0.5,
                (octaves.y + 0.5) / size.y,
                angle / 3.14159265 + 0.5 / size.z,
                exp2(-0.5 * (beyond.x + beyond.y)));
}

vec4 txnFadeAt(int table, vec4 place, vec4 unchanged) {
    if (place.w == 0.0)
        return unchanged;
    float x = float(table * TXN_FADE_MAJOR) + place.x;
    return textureLod(txnFades, vec3(x / float(textureSize(txnFades, 0).x), place.yz), 0.0) *
           place.w;
}

void txnSetFade(inout TxnPixel pixel, float a, float b, float angle) {
    vec4 place = txnFadePlace(a, b, angle);
    pixel.fade = txnFadeAt(0, place, vec4(1.0));
#ifdef TXN_MIXED
    pixel.fadeSlope = txnFadeAt(1, place, vec4(0.0));
    pixel.fadeBend = txnFadeAt(2, place, vec4(0.0));
#endif
}

#if TXN_FILTER == 2
uniform vec2 txnBefore;
uniform vec2 txnAfter;

TxnPixel txnPixel(vec2 dx, vec2 dy) {
    TxnPixel pixel;
    pixel.dx = dx;
    pixel.dy = dy;
    pixel.before = txnBefore;
    pixel.after = txnAfter;
    pixel.fade = vec4(1.0);
#if TXN_FADES
    float side = length(dx);
    txnSetFade(pixel, side, side, 0.0);
#endif
    return pixel;
}
#else
uniform float txnAnisotropy;   // longest to shortest side that is filtered; 1: mipmaps only
uniform float txnDensity;      // texels per exemplar pixel
uniform float txnMipmapShare;  // side of the texels to fetch, in sides of what they stand for
uniform float txnSharpest;     // up to this side of a pixel nothing has to be filtered,
uniform float txnRamp;         // and within this much more all of it
uniform vec2 txnExtent;        // of what the texture of a kernel holds, from txnStart on

TxnPixel txnPixel(vec2 dx, vec2 dy) {
    TxnPixel pixel;
    // Axes of the ellipse with the parallelogram's second moments, dx dx^T + dy dy^T.
    float xx = dx.x * dx.x + dy.x * dy.x;
    float xy = dx.x * dx.y + dy.x * dy.y;
    float yy = dx.y * dx.y + dy.y * dy.y;
    float radius = length(vec2(0.5 * (xx - yy), xy));
    float a = sqrt(max(0.5 * (xx + yy) + radius, 1e-12));
    float b = min(a, abs(dx.x * dy.y - dx.y * dy.x) / a);
    // A circle has no longer axis, and atan(0, 0) no value.
    float angle = radius > 0.0 ? 0.5 * atan(2.0 * xy, xx - yy) : 0.0;
    txnSetFade(pixel, a, b, angle);
    a = min(a, txnReach);
    b = min(b, txnReach);
    pixel.dx = dx * min(1.0, txnReach / max(length(dx), 1e-6));
    pixel.dy = dy * min(1.0, txnReach / max(length(dy), 1e-6));
    pixel.axis = a * vec2(cos(angle), sin(angle));
    pixel.fetches = int(clamp(ceil(a / max(b, 1e-3) - 0.05), 1.0, txnAnisotropy));
    float width = max(b, a / float(pixel.fetches)); // of what a fetch averages over
    float ramp = clamp((width - txnSharpest) / txnRamp, 0.0, 1.0);
    pixel.level = log2(max(1.0, mix(1.0, width * txnDensity * txnMipmapShare, ramp)));
    // Texels of the coarser of two levels are at most twice as large, and reach out by half.
#if TXN_FILTER == 1
    pixel.before = 0.5 * abs(pixel.axis) + width;
#else
    pixel.before = 0.5 * (1.0 - 1.0 / float(pixel.fetches)) * abs(pixel.axis) +
                   txnMipmapShare * width;
#endif
    // The last of them may end beyond the kernel.
    float texel = exp2(ceil(pixel.level)) / txnDensity;
    vec2 end = txnStart + ceil(txnExtent / texel) * texel;
    pixel.after = pixel.before + max(end - txnFootprint, 0.0);
    return pixel;
}
#endif
#else
TxnPixel txnPixel(vec2 dx, vec2 dy) {
    TxnPixel pixel;
    pixel.dx = dx;
    pixel.dy = dy;
    pixel.before = vec2(0.0);
    pixel.after = vec2(0.0);
    pixel.fade = vec4(1.0);
    return pixel;
}
#endif
