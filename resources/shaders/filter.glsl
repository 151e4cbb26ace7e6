// SPDX-License-Identifier: CC0-1.0

// What a pixel of the picture averages over. By TXN_FILTER:
// 0: nothing, it sees a point;
// 1: the ellipse of its own shape on the plane, by the hardware's anisotropic filter;
// 2: the same square all over the picture, by TXN_FETCHES (1 or 4) fetches from mipmaps;
// 3: as 1, by several fetches along the ellipse's longer axis.
struct TxnPixel {
    vec2 dx; // steps in exemplar pixels to the next pixel of the picture
    vec2 dy;
    vec2 before; // how far outside its footprint a filtered kernel reaches, to the left and up
    vec2 after;  // and to the right and down
    vec4 fade;   // by what the fluctuation has to be scaled
    vec2 axis;   // of the ellipse, the longer one, as long as the pixel is there
    float level;
    int fetches;
};

#if TXN_FILTER
uniform float txnAnisotropy; // longest to shortest side that is filtered; 1: mipmaps only
uniform float txnReach;      // the longer side of the footprint
uniform float txnDensity;    // texels per exemplar pixel
uniform vec2 txnFootprint;   // in exemplar pixels
uniform vec2 txnExtent;      // of what the texture of a kernel holds, from txnStart on
uniform float txnStart;
uniform float txnMipmapShare; // side of the texels to fetch, in sides of what they stand for
uniform sampler3D txnFades;  // see FilterFade.h

// Beyond one footprint the filter grows no further, since the number of impulses to look at would,
// too; what is still to be averaged only makes the fluctuation fainter, by a factor known from the
// covariance of the noise.
TxnPixel txnPixel(vec2 dx, vec2 dy) {
    TxnPixel pixel;
    // Axes of the ellipse with the parallelogram's second moments, dx dx^T + dy dy^T.
    float xx = dx.x * dx.x + dy.x * dy.x;
    float xy = dx.x * dx.y + dy.x * dy.y;
    float yy = dx.y * dx.y + dy.y * dy.y;
    float middle = 0.5 * (xx + yy);
    float radius = length(vec2(0.5 * (xx - yy), xy));
    float a = sqrt(max(middle + radius, 1e-12));
    float b = min(a, abs(dx.x * dy.y - dx.y * dy.x) / a);
    float angle = 0.5 * atan(2.0 * xy, xx - yy); // of the longer axis
    pixel.axis = a * vec2(cos(angle), sin(angle));
    pixel.fade = vec4(1.0);
    if (a > txnReach) {
        vec3 size = vec3(textureSize(txnFades, 0));
        vec2 octaves = log2(vec2(a, max(b, 1e-6)) / txnReach);
        pixel.fade = texture(txnFades,
                             vec3((octaves.x + 0.5) / size.x,
                                  (octaves.y + float(TXN_FADE_MINOR) + 0.5) / size.y,
                                  angle / 3.14159265 + 0.5 / size.z)) *
                     exp2(-0.5 * max(octaves.x - (size.x - 1.0), 0.0)) *
                     exp2(-0.5 * max(octaves.y + float(TXN_FADE_MINOR) - (size.y - 1.0), 0.0));
        dx *= min(1.0, txnReach / max(length(dx), 1e-6));
        dy *= min(1.0, txnReach / max(length(dy), 1e-6));
        pixel.axis *= txnReach / a;
        a = txnReach;
        b = min(b, txnReach);
    }
    pixel.dx = dx;
    pixel.dy = dy;
    pixel.fetches = int(clamp(ceil(a / max(b, 1e-3) - 0.05), 1.0, txnAnisotropy));
    float width = max(b, a / float(pixel.fetches)); // of what a fetch averages over
    pixel.level = width > 1.0 ? log2(width * txnDensity * txnMipmapShare) : 0.0;
    // Texels of the coarser of two levels are at most twice as large, and reach out by half.
#if TXN_FILTER == 1
    pixel.before = 0.5 * abs(pixel.axis) + width;
#else
    pixel.before = 0.5 * (1.0 - 1.0 / float(pixel.fetches)) * abs(pixel.axis) +
                   txnMipmapShare * width;
#endif
    // The last of them may end beyond the kernel.
    float texel = exp2(ceil(max(pixel.level, 0.0))) / txnDensity;
    vec2 end = txnStart + ceil(txnExtent / texel) * texel;
    pixel.after = pixel.before + max(end - txnFootprint, 0.0);
    return pixel;
}
#else
TxnPixel txnPixel(vec2 dx, vec2 dy) {
    return TxnPixel(dx, dy, vec2(0.0), vec2(0.0), vec4(1.0), vec2(0.0), 0.0, 1);
}
#endif
