// SPDX-License-Identifier: CC0-1.0

// A material under one light and a bright sky. Its slopes (along the exemplar's x and y), roughness
// and metalness come from a picture of the same pixels that was drawn before.
#include "lighting.glsl"

uniform sampler2D relief;

// base: encoded colour and occlusion; frame: the directions of the exemplar's x and y and of the
// normal, in the coordinates of toLight and toEye, all of unit length.
vec4 shaded(vec4 base, ivec2 pixel, mat3 frame, vec3 toEye) {
    vec4 maps = texelFetch(relief, pixel, 0);
    vec3 albedo = decoded(clamp(base.rgb, 0.0, 1.0));
    float rough = clamp(maps.z, 0.05, 1.0);
    float metal = clamp(maps.w, 0.0, 1.0);
    vec3 normal = normalize(frame[2] - maps.x * frame[0] - maps.y * frame[1]);
    float toward = max(dot(normal, toLight), 0.0);
    float seen = max(dot(normal, toEye), 1e-3);
    vec3 between = normalize(toLight + toEye);
    float facing = max(dot(normal, between), 0.0);
    vec3 mirror = mix(vec3(0.04), albedo, metal); // what is reflected straight ahead
    vec3 fresnel = mirror + (1.0 - mirror) * pow(1.0 - max(dot(between, toEye), 0.0), 5.0);
    // Trowbridge and Reitz's distribution of tiny mirrors, with Smith's shadows.
    float a2 = rough * rough * rough * rough;
    float spread = facing * facing * (a2 - 1.0) + 1.0;
    float shadows = toward * sqrt(seen * seen * (1.0 - a2) + a2) +
                    seen * sqrt(toward * toward * (1.0 - a2) + a2);
    float gloss = 0.5 * a2 / (spread * spread * max(shadows, 1e-4));
    vec3 diffuse = albedo * (1.0 - metal);
    float sky = clamp(base.a, 0.0, 1.0) * (0.3 + 0.1 * dot(normal, frame[2]));
    vec3 light = 0.9 * toward * (diffuse * (1.0 - fresnel) + gloss * fresnel) +
                 sky * (diffuse + mirror);
    return vec4(encodedColor(light), 1.0);
}
