#pragma once
// Triangle meshes in Wavefront OBJ files. The subset is told in docs/formats.md.

#include <filesystem>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// Reads vertices, texture coordinates and faces; polygons are cut into triangles, groups
/// and objects are merged, all else is passed over. Coordinates are taken as they are
/// (cm). `uvs` is empty where no corner has texture coordinates; where only some have, a
/// corner without has (0, 0). Triangles without area are kept.
///
/// Throws InputError, which names the line, where a number cannot be read, a vertex is no
/// place (not finite, or beyond kLargestCoordinate), a UV is not finite, an index points
/// nowhere, or a face has fewer than 3 or more than 1,000 corners; and where no triangle
/// is left.
TriangleMesh read_obj(const std::filesystem::path& path);

/// Writes the mesh so that read_obj gives it back: indices and order the same, numbers in
/// the shortest form that is still exact. Throws InputError where the file cannot be
/// written, and std::invalid_argument where `uvs` is neither empty nor one a triangle.
void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace lancret
