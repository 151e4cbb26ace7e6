// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"

#include <filesystem>
#include <string>

namespace txn {

/// Reads a Wavefront OBJ or a PLY file (ASCII, binary of either byte order). The name must end in
/// .obj or .ply; a PLY is told by its content even when named .obj. All of the file's groups become
/// one mesh, units stay as they are. Polygons become triangles, also where they are not convex (a
/// fan where they cross themselves). No other file is opened, so materials are not read.
/// uvs are kept as stored if all corners have one (a PLY's are per vertex; those per face are not
/// read). Normals are kept, scaled to length 1; where they are missing, zero or not finite those of
/// smoothNormals stand in, so that creases stay sharp. Vertices that are equal in everything are
/// joined, those that no triangle uses are dropped, and so are triangles without area. Of an OBJ,
/// lines of unknown kind are skipped, and numbers missing at the end of a line are 0.
/// Errors (message names the file): NotFound; Unsupported for other endings and for triangle
/// strips; TooLarge beyond 1 GiB, 2^24 vertices or triangles, 1024 corners of a polygon, or the
/// memory; Unreadable for folders, pipes, empty and damaged files, for indices out of range,
/// coordinates that are not finite or beyond 1e12, and files without any triangle.
/// Thread-safe.
[[nodiscard]] Result<TriangleMesh> loadMesh(const std::filesystem::path& path);

/// The same for the bytes of such a file that were read already; path is what messages name and
/// whose ending counts.
[[nodiscard]] Result<TriangleMesh> readMesh(std::string bytes, const std::filesystem::path& path);

} // namespace txn
