#pragma once
// Triangle meshes in Wavefront OBJ files. docs/formats.md describes the supported subset.

#include <filesystem>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// Reads vertices, texture coordinates and faces. Polygons are cut into triangles, groups
/// and objects are merged, everything else is ignored. Coordinates are taken as they are
/// (cm). `uvs` is empty if no corner has texture coordinates; if only some have, the
/// others get (0, 0). Triangles without area are kept.
///
/// Throws InputError with the line if a number cannot be read, a vertex is not finite or
/// beyond kLargestCoordinate, a UV is not finite, an index is out of range, or a face has
/// fewer than 3 or more than 1,000 corners; and if there is no triangle.
TriangleMesh read_obj(const std::filesystem::path& path);

/// Writes the mesh so that read_obj returns the same indices, order and numbers; these
/// are in the shortest exact form. Throws InputError if the file cannot be written, and
/// std::invalid_argument if `uvs` is neither empty nor of one entry per triangle.
void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace lancret
