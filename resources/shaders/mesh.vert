// SPDX-License-Identifier: CC0-1.0
// A mesh in perspective. TXN_SURFACE 0: by texture coordinates; 1: by surface noise.
uniform mat4 meshToPicture;
uniform float pixelsPerUnit; // exemplar pixels per unit of length, or of texture coordinates

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 textureCoordinate;
layout(location = 3) in vec3 tangent;

out vec3 pointNormal;
#if TXN_SURFACE
out vec3 point; // in exemplar pixels
out vec3 pointTangent;
#else
out vec2 point;
out vec3 placeOnMesh;
#endif

void main() {
    gl_Position = meshToPicture * vec4(position, 1.0);
    pointNormal = normal;
#if TXN_SURFACE
    point = position * pixelsPerUnit;
    pointTangent = tangent;
#else
    // Meshes count texture coordinates upwards, pictures downwards.
    point = vec2(textureCoordinate.x, -textureCoordinate.y) * pixelsPerUnit;
    placeOnMesh = position;
#endif
}
