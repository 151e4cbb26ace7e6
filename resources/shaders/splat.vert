// SPDX-License-Identifier: CC0-1.0
// One impulse of the plane seen from above: a quad over its footprint.
uniform vec2 pictureSize;
uniform vec2 txnFootprint;
uniform vec2 margin;
uniform mat2 planeToPicture;

// Where the footprint's corner lands: a pixel, y down, and the place in it.
layout(location = 0) in ivec2 anchor;
layout(location = 1) in vec2 anchorPlace;
layout(location = 2) in int signedKernel; // kernel + 1, negative with a negative sign

flat out ivec2 footprintPixel;
flat out vec2 footprintPlace;
flat out int impulseKernel;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 y = corner * (txnFootprint + 2.0 * margin) - margin;
    vec2 pixel = vec2(anchor) + (anchorPlace + planeToPicture * y);
    gl_Position = vec4((2.0 * pixel / pictureSize - 1.0) * vec2(1.0, -1.0), 0.0, 1.0);
    footprintPixel = anchor;
    footprintPlace = anchorPlace;
    impulseKernel = signedKernel;
}
