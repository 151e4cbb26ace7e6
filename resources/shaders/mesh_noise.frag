// SPDX-License-Identifier: CC0-1.0
// Noise on what mesh_geometry.frag has seen. TXN_SMOOTH 1: outlines by coverage;
// TXN_MATERIAL 1: shaded as a material.
// Both kinds of noise share these, and a file is included once, wherever that is.
#include "hash.glsl"
#include "kernel.glsl"
#ifdef TXN_MIXED
#include "mixing.glsl"
#endif
#if TXN_SURFACE
#include "surface_noise.glsl"
#else
#include "texton_noise.glsl"
#endif
#include "lighting.glsl"
#if TXN_MATERIAL
#include "material.glsl"
uniform vec3 toEye;
#endif

uniform sampler2D seenPoint;
uniform sampler2D seenNormal;
uniform sampler2D seenRight;
uniform sampler2D seenSteps;
uniform sampler2D coverage;
uniform vec4 background;

out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 point = texelFetch(seenPoint, pixel, 0);
    float share = point.w;
#if TXN_SMOOTH
    share = texelFetch(coverage, pixel, 0).r;
    // A pixel whose centre just misses the mesh shows what a neighbour sees.
    ivec2 center = pixel;
    ivec2 last = textureSize(seenPoint, 0) - 1;
    for (int i = 0; i < 9 && share > 0.0 && point.w == 0.0; ++i) {
        pixel = clamp(center + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        point = texelFetch(seenPoint, pixel, 0);
    }
#endif
    if (share == 0.0 || point.w == 0.0) {
        color = background;
        return;
    }
    vec3 normal = texelFetch(seenNormal, pixel, 0).xyz;
    vec4 steps = texelFetch(seenSteps, pixel, 0);
#if TXN_SURFACE
    vec3 right = texelFetch(seenRight, pixel, 0).xyz;
    vec4 noise =
        surfaceNoise(point.xyz, mat3(right, cross(right, normal), normal), steps.xy, steps.zw);
#else
    vec4 noise = textonNoise(point.xy, steps.xy, steps.zw);
#endif
#if TXN_MATERIAL
    vec4 right4 = texelFetch(seenRight, pixel, 0);
    mat3 frame = mat3(right4.xyz, right4.w * cross(right4.xyz, normal), normal);
    color = mix(background, shaded(noise, pixel, frame, toEye), share);
#else
    color = mix(background, vec4(lit(noise.rgb, normal), noise.a), share);
#endif
}
