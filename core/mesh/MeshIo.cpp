// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/MeshIo.h"

#include "core/base/OutputFiles.h"
#include "core/mesh/MeshReaders.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include <glm/geometric.hpp>

namespace txn {
namespace {

using Path = std::filesystem::path;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30U;
constexpr double kFarthestCoordinate = 1e12;

enum class MeshFormat { Obj, Ply };

Result<MeshFormat> formatByEnding(const Path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (ending == ".obj")
        return MeshFormat::Obj;
    if (ending == ".ply")
        return MeshFormat::Ply;
    return Error{ErrorCode::Unsupported,
                 "cannot read " + quoted(path) + ": a mesh must be an .obj or a .ply file"};
}

Result<std::string> readWhole(const Path& path) {
    std::error_code ec;
    const auto status = std::filesystem::status(path, ec);
    if (!std::filesystem::exists(status)) {
        if (!ec || status.type() == std::filesystem::file_type::not_found)
            return Error{ErrorCode::NotFound,
                         "there is no file " + quoted(path) + "; was it moved or renamed?"};
        return unreadableMesh(path, ec.message());
    }
    if (std::filesystem::is_directory(status))
        return unreadableMesh(path, "it is a folder; give a mesh file");
    if (!std::filesystem::is_regular_file(status))
        return unreadableMesh(path, "it is not a plain file; give a mesh file");
    const auto size = std::filesystem::file_size(path, ec);
    if (ec)
        return unreadableMesh(path, ec.message());
    if (size == 0)
        return unreadableMesh(path, "the file is empty");
    if (size > kMostBytes)
        return Error{ErrorCode::TooLarge, quoted(path) + " is larger than 1 GiB"};
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        return unreadableMesh(path, "it cannot be opened, or ends early");
    return bytes;
}

bool usable(float number) {
    return std::abs(number) <= kFarthestCoordinate;
}
bool usable(const glm::vec2& p) {
    return usable(p.x) && usable(p.y);
}
bool usable(const glm::vec3& p) {
    return usable(p.x) && usable(p.y) && usable(p.z);
}

Result<void> check(const RawMesh& raw, const Path& path) {
    if (raw.faceSizes.empty())
        return unreadableMesh(path, "it has no triangles, so it is damaged or of another kind");
    if (raw.positions.size() > kMostVertices)
        return tooLargeMesh(path, "vertices");
    const auto good = [](const auto& v) { return usable(v); };
    if (!std::all_of(raw.positions.begin(), raw.positions.end(), good) ||
        !std::all_of(raw.uvs.begin(), raw.uvs.end(), good))
        return unreadableMesh(path, "a coordinate is not finite, or beyond 1e12");
    const auto inRange = [](std::uint32_t index, std::size_t count) {
        return index == kNoIndex || index < count;
    };
    for (const auto& [position, uv, normal] : raw.corners) {
        if (position >= raw.positions.size() || !inRange(uv, raw.uvs.size()) ||
            !inRange(normal, raw.normals.size()))
            return unreadableMesh(path, "a face has an index out of range");
    }
    return {};
}

/// Triangles of a polygon, in any plane and not convex, by clipping ears: corners that turn
/// outwards and whose triangle no other corner lies in. Where there is none, as in a polygon that
/// crosses itself, or none is found in reasonable time, the rest becomes a fan.
std::vector<Triangle> divided(std::span<const glm::vec3> polygon) {
    if (polygon.size() == 3)
        return {{0, 1, 2}};
    glm::dvec3 normal(0.0);
    for (std::size_t k = 2; k < polygon.size(); ++k)
        normal += glm::cross(glm::dvec3(polygon[k - 1]) - glm::dvec3(polygon[0]),
                             glm::dvec3(polygon[k]) - glm::dvec3(polygon[0]));
    glm::length_t u = 1;
    glm::length_t v = 2;
    for (const glm::length_t axis : {1, 2}) {
        if (std::abs(normal[axis]) > std::abs(normal[(u + 2) % 3])) {
            u = (axis + 1) % 3;
            v = (axis + 2) % 3;
        }
    }
    if (normal[3 - u - v] < 0.0)
        std::swap(u, v);
    std::vector<glm::dvec2> flat;
    for (const glm::vec3& p : polygon)
        flat.emplace_back(p[u], p[v]);
    const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec2 ab = flat[b] - flat[a];
        const glm::dvec2 ac = flat[c] - flat[a];
        return ab.x * ac.y - ab.y * ac.x;
    };
    const auto same = [&](std::uint32_t a, std::uint32_t b) { return flat[a] == flat[b]; };
    std::vector<std::uint32_t> ring(polygon.size());
    std::iota(ring.begin(), ring.end(), 0U);
    std::size_t tests = 16 * polygon.size();
    const auto isEar = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return turn(a, b, c) > 0.0 && std::none_of(ring.begin(), ring.end(), [&](std::uint32_t p) {
                   return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0 &&
                          !same(p, a) && !same(p, b) && !same(p, c);
               });
    };
    std::vector<Triangle> triangles;
    std::size_t at = 1;
    for (std::size_t failed = 0; ring.size() > 3 && failed < ring.size() && tests > 0;) {
        at %= ring.size();
        const Triangle ear{ring[(at + ring.size() - 1) % ring.size()],
                           ring[at],
                           ring[(at + 1) % ring.size()]};
        --tests;
        if (isEar(ear[0], ear[1], ear[2])) {
            triangles.push_back(ear);
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
            failed = 0;
        } else {
            ++at;
            ++failed;
        }
    }
    for (std::size_t k = 2; k < ring.size(); ++k)
        triangles.push_back({ring[0], ring[k - 1], ring[k]});
    return triangles;
}

/// Three vertices of its own for every triangle, so that each side of a crease has a normal.
/// Normals are as in the file, zero for faces of which a corner has none.
TriangleMesh separateTriangles(const RawMesh& raw) {
    const bool uvs = std::none_of(raw.corners.begin(), raw.corners.end(), [](const auto& corner) {
        return corner[1] == kNoIndex;
    });
    TriangleMesh mesh;
    std::vector<glm::vec3> polygon;
    std::span<const RawMesh::Corner> rest = raw.corners;
    for (const std::uint32_t size : raw.faceSizes) {
        const auto corners = rest.first(size);
        rest = rest.subspan(size);
        polygon.clear();
        bool normals = true;
        for (const auto& corner : corners) {
            polygon.push_back(raw.positions[corner[0]]);
            normals = normals && corner[2] != kNoIndex;
        }
        for (const Triangle& triangle : divided(polygon)) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const std::uint32_t k : triangle) {
                mesh.positions.push_back(polygon[k]);
                mesh.normals.push_back(normals ? raw.normals[corners[k][2]] : glm::vec3(0.0F));
                if (uvs)
                    mesh.uvs.push_back(raw.uvs[corners[k][1]]);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            if (isDegenerate(mesh, mesh.triangles.back())) {
                mesh.triangles.pop_back();
                mesh.positions.resize(first);
                mesh.normals.resize(first);
                mesh.uvs.resize(uvs ? first : 0);
            }
        }
    }
    return mesh;
}

/// Normals of length 1, computed where there are none.
void completeNormals(TriangleMesh& mesh) {
    const auto length = [](const glm::vec3& v) { return glm::length(glm::dvec3(v)); };
    const auto bad = [&](const glm::vec3& v) { return !(length(v) > 1e-30 && length(v) < 1e30); };
    if (std::any_of(mesh.normals.begin(), mesh.normals.end(), bad)) {
        const std::vector<glm::vec3> computed = smoothNormals(mesh);
        for (std::size_t v = 0; v < computed.size(); ++v) {
            if (bad(mesh.normals[v]))
                mesh.normals[v] = computed[v];
        }
    }
    for (glm::vec3& normal : mesh.normals)
        normal = glm::vec3(glm::dvec3(normal) / length(normal));
}

/// The same with vertices that are equal in everything joined, in the order of first appearance.
TriangleMesh withJoinedVertices(const TriangleMesh& mesh) {
    const auto key = [&](std::uint32_t v) {
        const glm::vec3& p = mesh.positions[v];
        const glm::vec3& n = mesh.normals[v];
        const glm::vec2 uv = mesh.uvs.empty() ? glm::vec2(0.0F) : mesh.uvs[v];
        return std::array<float, 8>{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
    };
    std::vector<std::uint32_t> order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto keyA = key(a);
        const auto keyB = key(b);
        return keyA != keyB ? keyA < keyB : a < b;
    });
    std::vector<std::uint32_t> first(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] =
            k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
    TriangleMesh joined;
    std::vector<std::uint32_t> joinedIndex(order.size());
    for (std::uint32_t v = 0; v < first.size(); ++v) {
        if (first[v] != v) {
            joinedIndex[v] = joinedIndex[first[v]];
            continue;
        }
        joinedIndex[v] = static_cast<std::uint32_t>(joined.positions.size());
        joined.positions.push_back(mesh.positions[v]);
        joined.normals.push_back(mesh.normals[v]);
        if (!mesh.uvs.empty())
            joined.uvs.push_back(mesh.uvs[v]);
    }
    for (const Triangle& t : mesh.triangles)
        joined.triangles.push_back({joinedIndex[t[0]], joinedIndex[t[1]], joinedIndex[t[2]]});
    return joined;
}

Result<TriangleMesh> parsed(std::string bytes, const Path& path) {
    const auto byEnding = formatByEnding(path);
    if (!byEnding)
        return byEnding.error();
    const bool isPly = bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n");
    if (*byEnding == MeshFormat::Ply && !isPly)
        return unreadableMesh(path, "it does not begin as a PLY file does");
    const auto raw = isPly ? readPly(bytes, path) : readObj(std::move(bytes), path);
    if (!raw)
        return raw.error();
    if (auto checked = check(*raw, path); !checked)
        return checked.error();
    TriangleMesh mesh = separateTriangles(*raw);
    if (mesh.triangles.empty())
        return unreadableMesh(path, "all of its triangles are degenerate: they have no area");
    completeNormals(mesh);
    mesh = withJoinedVertices(mesh);
    if (mesh.positions.size() > kMostVertices)
        return tooLargeMesh(path, "vertices");
    return mesh;
}

} // namespace

Error unreadableMesh(const Path& path, const std::string& reason) {
    return {ErrorCode::Unreadable, "cannot read " + quoted(path) + ": " + reason};
}

Error tooLargeMesh(const Path& path, const std::string& what) {
    return {ErrorCode::TooLarge, quoted(path) + " has too many " + what};
}

Result<void> RawMesh::beginFace(std::size_t cornerCount, const Path& path) {
    if (cornerCount < 3)
        return unreadableMesh(path, "a face has fewer than three corners");
    if (cornerCount > kMostCorners)
        return tooLargeMesh(path, "corners in one face");
    triangleCount += cornerCount - 2;
    if (triangleCount > kMostTriangles)
        return tooLargeMesh(path, "triangles");
    faceSizes.push_back(static_cast<std::uint32_t>(cornerCount));
    return {};
}

Result<TriangleMesh> readMesh(std::string bytes, const Path& path) {
    try {
        return parsed(std::move(bytes), path);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, "there is not enough memory to read " + quoted(path)};
    } catch (...) {
        return unreadableMesh(path, "the reader failed");
    }
}

Result<TriangleMesh> loadMesh(const Path& path) {
    // Before the file is touched: other kinds are none of ours.
    if (const auto format = formatByEnding(path); !format)
        return format.error();
    try {
        auto bytes = readWhole(path);
        if (!bytes)
            return bytes.error();
        return readMesh(*std::move(bytes), path);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, "there is not enough memory to read " + quoted(path)};
    }
}

} // namespace txn
