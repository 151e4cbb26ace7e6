// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GpuMesh.h"

#include "gl/GlErrors.h"

#include <cassert>
#include <cstddef>
#include <epoxy/gl.h>

namespace txn {
namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
    glm::vec3 tangent;
};

} // namespace

Result<GpuMesh> GpuMesh::create(const GlContext& context,
                                const TriangleMesh& mesh,
                                const std::vector<glm::vec3>& tangents,
                                const glm::vec3& center) {
    assert(tangents.size() == mesh.positions.size());
    forgetGlErrors();
    GpuMesh result;
    result.m_vertexArray = GlHandle::make(context, GlHandle::Kind::VertexArray);
    result.m_vertices = GlHandle::make(context, GlHandle::Kind::Buffer);
    result.m_indices = GlHandle::make(context, GlHandle::Kind::Buffer);
    result.m_indexCount = static_cast<int>(mesh.triangles.size() * 3);
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {mesh.positions[i] - center,
                       mesh.normals[i],
                       mesh.uvs.empty() ? glm::vec2(0.0F) : mesh.uvs[i],
                       tangents[i]};
    glBindVertexArray(result.m_vertexArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, result.m_vertices.id());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                 vertices.data(),
                 GL_STATIC_DRAW);
    const auto attribute = [](GLuint index, int components, std::size_t offset) {
        glVertexAttribPointer(index,
                              components,
                              GL_FLOAT,
                              GL_FALSE,
                              sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(index);
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, uv));
    attribute(3, 3, offsetof(Vertex, tangent));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, result.m_indices.id()); // kept by the vertex array
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(Triangle)),
                 mesh.triangles.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    if (auto ok = checkGlMemory("the mesh"); !ok)
        return ok.error();
    return result;
}

void GpuMesh::draw() const {
    glBindVertexArray(m_vertexArray.id());
    glDrawElements(GL_TRIANGLES, m_indexCount, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

} // namespace txn
