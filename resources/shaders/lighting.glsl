// SPDX-License-Identifier: CC0-1.0

uniform int lighting;  // 0: colours as they are
uniform int encoded;   // whether colours follow the sRGB curve
uniform vec3 toLight;  // unit vector

vec3 decoded(vec3 c) {
    return mix(c / 12.92, pow((max(c, 0.0) + 0.055) / 1.055, vec3(2.4)),
               vec3(greaterThan(c, vec3(0.04045))));
}

vec3 encodedColor(vec3 c) {
    return mix(c * 12.92, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055,
               vec3(greaterThan(c, vec3(0.0031308))));
}

// A matte surface under one light and a bright sky.
vec3 lit(vec3 noise, vec3 normal) {
    if (lighting == 0)
        return noise;
    float sky = 0.5 + 0.5 * normal.y;
    float light = 0.15 + 0.2 * sky + 0.75 * max(dot(normal, toLight), 0.0);
    return encoded != 0 ? encodedColor(light * decoded(noise)) : light * noise;
}
