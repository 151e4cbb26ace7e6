// SPDX-License-Identifier: CC0-1.0
// What a pixel sees of a mesh. Noise is computed from it once a pixel, however small the triangles.
in vec3 pointNormal;
#if TXN_SURFACE
in vec3 point;
in vec3 pointTangent;
#else
in vec2 point;
in vec3 placeOnMesh;
#endif

layout(location = 0) out vec4 seenPoint;  // in exemplar pixels; w: 1
layout(location = 1) out vec4 seenNormal;
layout(location = 2) out vec4 seenRight;  // the direction of a kernel's x; w: -1 where mirrored
layout(location = 3) out vec4 seenSteps;  // to the next pixels, in a kernel's x and y

void main() {
    vec3 normal = normalize(pointNormal);
    seenNormal = vec4(normal, 0.0);
#if TXN_SURFACE
    vec3 right = pointTangent - dot(pointTangent, normal) * normal;
    if (dot(right, right) < 1e-12) // at a singular point of the field any direction will do
        right = cross(normal, abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
    right = normalize(right);
    vec3 down = cross(right, normal);
    vec3 dx = dFdx(point);
    vec3 dy = dFdy(point);
    seenPoint = vec4(point, 1.0);
    seenRight = vec4(right, 1.0);
    seenSteps = vec4(dot(dx, right), dot(dx, down), dot(dy, right), dot(dy, down));
#else
    seenPoint = vec4(point, 0.0, 1.0);
    // The direction on the mesh in which the first coordinate grows and the second one stays.
    vec2 dx = dFdx(point);
    vec2 dy = dFdy(point);
    float area = dx.x * dy.y - dy.x * dx.y;
    vec3 right = (dFdx(placeOnMesh) * dy.y - dFdy(placeOnMesh) * dx.y) * (area < 0.0 ? -1.0 : 1.0);
    right -= dot(right, normal) * normal;
    if (dot(right, right) < 1e-24)
        right = cross(normal, abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
    right = normalize(right);
    vec3 down = (dFdy(placeOnMesh) * dx.x - dFdx(placeOnMesh) * dy.x) * (area < 0.0 ? -1.0 : 1.0);
    seenRight = vec4(right, dot(down, cross(right, normal)) < 0.0 ? -1.0 : 1.0);
    seenSteps = vec4(dx, dy);
#endif
}
