// SPDX-License-Identifier: CC0-1.0
// Adds a share of one picture to another.
uniform sampler2D picture;
uniform float share;

out vec4 color;

void main() {
    color = share * texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
