// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/OutputFiles.h"
#include "core/mesh/MeshReaders.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <tiny_obj_loader.h>

namespace txn {
namespace {

using Path = std::filesystem::path;

/// tinyobjloader takes a comment behind a face for corners, and knows no lines that go on.
void blankCommentsAndContinuations(std::string& text) {
    bool comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n' || text[i] == '\r') {
            comment = false;
        } else if (comment || text[i] == '#') {
            comment = true;
            text[i] = ' ';
        } else if (text[i] == '\\') {
            const std::size_t end = text.compare(i + 1, 2, "\r\n") == 0 ? i + 3 : i + 2;
            if (end <= text.size() && (text[end - 1] == '\n' || text[end - 1] == '\r'))
                std::fill(text.begin() + static_cast<std::ptrdiff_t>(i),
                          text.begin() + static_cast<std::ptrdiff_t>(end),
                          ' ');
        }
    }
}

/// Whether more digits follow each other than an index has; atoi would wrap around.
bool hasLongNumber(std::string_view line) {
    std::size_t digits = 0;
    return std::any_of(line.begin(), line.end(), [&](char c) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        return digits > 9;
    });
}

/// tinyobjloader takes what is no number for 0, and indices modulo 2^32.
Result<void> checkLine(std::string_view line, const Path& path) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const auto length = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view keyword = line.substr(0, length);
    const auto allOf = [&](const char* allowed) {
        return line.find_first_not_of(allowed, length) == std::string_view::npos;
    };
    if (keyword == "f" && line.size() > 32 * kMostCorners)
        return tooLargeMesh(path, "corners in one face");
    if (((keyword == "v" || keyword == "vt") && !allOf(" \t0123456789+-.eE")) ||
        (keyword == "f" && (!allOf(" \t0123456789+-/") || hasLongNumber(line))))
        return unreadableMesh(path, "the line " + quoted(Path(line.substr(0, 60))) + " is damaged");
    return {};
}

/// What the callbacks fill. They cannot stop the parser, so that after an error they do nothing.
struct Reading {
    const Path& path;
    RawMesh mesh;
    Result<void> state;
};

template <class Vector>
void add(void* reading, std::vector<Vector> RawMesh::*list, Vector value) {
    auto& [path, mesh, state] = *static_cast<Reading*>(reading);
    if (state && (mesh.*list).size() >= 4 * kMostVertices)
        state = tooLargeMesh(path, "vertices");
    if (state)
        (mesh.*list).push_back(value);
}

/// From 0 and kNoIndex for 0; negative ones count back from the newest. What is out of range stays
/// so.
std::uint32_t resolved(int index, std::size_t count) {
    if (index < 0)
        return static_cast<std::uint32_t>(
            std::min<std::int64_t>(static_cast<std::int64_t>(count) + index, kNoIndex - 1));
    return index == 0 ? kNoIndex : static_cast<std::uint32_t>(index - 1);
}

void addFace(void* reading, tinyobj::index_t* indices, int count) {
    auto& [path, mesh, state] = *static_cast<Reading*>(reading);
    if (state)
        state = mesh.beginFace(static_cast<std::size_t>(count), path);
    for (int k = 0; k < count && state; ++k)
        mesh.corners.push_back({resolved(indices[k].vertex_index, mesh.positions.size()),
                                resolved(indices[k].texcoord_index, mesh.uvs.size()),
                                resolved(indices[k].normal_index, mesh.normals.size())});
}

} // namespace

Result<RawMesh> readObj(std::string text, const Path& path) {
    if (text.find('\0') != std::string::npos)
        return unreadableMesh(path, "it is no Wavefront OBJ file, which is text");
    if (text.starts_with("\xEF\xBB\xBF"))
        text.replace(0, 3, 3, ' ');
    blankCommentsAndContinuations(text);
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
        if (auto ok = checkLine(std::string_view(text).substr(start, end - start), path); !ok)
            return ok.error();
        start = end + 1;
    }

    Reading reading{path, {}, {}};
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* r, float x, float y, float z, float) {
        add(r, &RawMesh::positions, glm::vec3(x, y, z));
    };
    callbacks.texcoord_cb = [](void* r, float u, float v, float) {
        add(r, &RawMesh::uvs, glm::vec2(u, v));
    };
    callbacks.normal_cb = [](void* r, float x, float y, float z) {
        add(r, &RawMesh::normals, glm::vec3(x, y, z));
    };
    callbacks.index_cb = addFace;
    std::istringstream stream(std::move(text));
    if (!tinyobj::LoadObjWithCallback(stream, callbacks, &reading))
        return unreadableMesh(path, "it is no Wavefront OBJ file, or damaged");
    if (!reading.state)
        return reading.state.error();
    return std::move(reading.mesh);
}

} // namespace txn
