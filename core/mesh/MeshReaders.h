// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace txn {

constexpr std::size_t kMostVertices = std::size_t{1} << 24U;
constexpr std::size_t kMostTriangles = std::size_t{1} << 24U;
constexpr std::size_t kMostCorners = 1024; ///< of one polygon

constexpr std::uint32_t kNoIndex = UINT32_MAX;

/// Polygons as a file has them. Numbers may be infinite or NaN and indices out of range; loadMesh
/// checks them.
struct RawMesh {
    using Corner = std::array<std::uint32_t, 3>; ///< position, uv, normal; kNoIndex for none

    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;
    std::vector<Corner> corners; ///< of all faces, one after the other
    std::vector<std::uint32_t> faceSizes;
    std::size_t triangleCount = 0;

    /// To be called before the face's corners are added.
    /// Errors: Unreadable for fewer than three corners; TooLarge.
    [[nodiscard]] Result<void> beginFace(std::size_t cornerCount,
                                         const std::filesystem::path& path);
};

/// Through tinyobjloader, which opens no other file.
[[nodiscard]] Result<RawMesh> readObj(std::string text, const std::filesystem::path& path);

/// ASCII and both binary forms; elements and properties of other names are skipped.
[[nodiscard]] Result<RawMesh> readPly(std::string_view bytes, const std::filesystem::path& path);

[[nodiscard]] Error unreadableMesh(const std::filesystem::path& path, const std::string& reason);
[[nodiscard]] Error tooLargeMesh(const std::filesystem::path& path, const std::string& what);

} // namespace txn
