// SPDX-License-Identifier: CC0-1.0

// What a pixel of the picture averages over. By TXN_FILTER:
// 0: nothing, it sees a point;
// 1: the ellipse of its own shape on the plane, by the hardware's anisotropic filter;
// 2: the same mipmap level all over the picture;
// 3: as 1, by several fetches along the ellipse's longer axis.
struct TxnPixel {
    vec2 dx; // steps in exemplar pixels to the next pixel of the picture
    vec2 dy;
    vec2 margin; // how far outside its footprint a filtered kernel reaches
    vec4 fade;   // by what the fluctuation has to be scaled
    vec2 axis;   // of the ellipse, the longer one, as long as the pixel is there
    float level;
    int fetches;
};

#if TXN_FILTER
uniform float txnAnisotropy; // longest to shortest side that is filtered; 1: mipmaps only
uniform float txnReach;      // the longer side of the footprint
uniform float txnDensity;    // texels per exemplar pixel
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
    pixel.fetches = int(clamp(ceil(a / max(b, 1e-3)), 1.0, txnAnisotropy));
    float width = max(b, a / float(pixel.fetches)); // of what a fetch averages over
    pixel.level = log2(width * txnDensity * txnMipmapShare);
    pixel.margin = 0.5 * abs(pixel.axis) + 0.5 * width;
    return pixel;
}
#else
TxnPixel txnPixel(vec2 dx, vec2 dy) {
    return TxnPixel(dx, dy, vec2(0.0), vec4(1.0), vec2(0.0), 0.0, 1);
}
#endif
