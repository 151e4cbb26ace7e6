// SPDX-License-Identifier: CC0-1.0
// The plane as a ground that goes on to the horizon.
// TXN_MATERIAL 1: shaded as a material.
#include "texton_noise.glsl"
#if TXN_MATERIAL
#include "material.glsl"
uniform vec3 eye; // in exemplar pixels from the base: x, y, and height
#endif

uniform ivec2 middle; // the pixel from which steps are counted, y down
uniform int height;   // of the picture
uniform ivec2 baseCell;
uniform vec2 basePlace;
// A pixel sees the point q.xy / q.z, in exemplar pixels from the base; nothing where q.z <= 0.
uniform vec3 rayMiddle;
uniform vec3 rayRight;
uniform vec3 rayDown;
uniform vec4 background;

out vec4 color;

void main() {
    vec2 n = vec2(ivec2(gl_FragCoord.x, height - 1 - int(gl_FragCoord.y)) - middle);
    vec3 q = rayMiddle + n.x * rayRight + n.y * rayDown;
    // How much of the pixel lies below the horizon.
#if TXN_FILTER
    float ground = clamp(q.z / length(vec2(rayRight.z, rayDown.z)) + 0.5, 0.0, 1.0);
#else
    float ground = float(q.z > 0.0);
#endif
#if TXN_MATERIAL || defined(TXN_MIXED)
    if (ground == 0.0) {
        color = background;
        return;
    }
#else
    if (q.z <= 0.0) {
        color = mix(background, txnOffset, ground);
        return;
    }
#endif
    bool beyond = q.z <= 0.0;
    q.z = max(q.z, 1e-3 * length(vec2(rayRight.z, rayDown.z))); // far enough to be all mean
    vec2 point = q.xy / q.z;
    vec2 dx = (rayRight.xy - point * rayRight.z) / q.z;
    vec2 dy = (rayDown.xy - point * rayDown.z) / q.z;
    vec2 place = clamp(point / txnCell, -1e7, 1e7) + basePlace;
    vec2 cell = floor(place);
#if defined(TXN_MIXED) && !TXN_MATERIAL
    vec4 noise = beyond ? txnMean(baseCell + ivec2(cell), place - cell, dx, dy)
                        : textonNoise(baseCell + ivec2(cell), place - cell, dx, dy);
#else
    vec4 noise = textonNoise(baseCell + ivec2(cell), place - cell, dx, dy);
#endif
#if TXN_MATERIAL
    noise = shaded(noise, ivec2(gl_FragCoord.xy), mat3(1.0), normalize(eye - vec3(point, 0.0)));
#endif
    color = mix(background, noise, ground);
}
