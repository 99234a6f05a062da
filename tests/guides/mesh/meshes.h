#pragma once
// Meshes with known areas, normals and UVs.

#include <cmath>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// A grid of nu x nv cells of two triangles each over (u, v) in [0, 1]^2.
template <class Position>
TriangleMesh grid_mesh(std::uint32_t nu, std::uint32_t nv, Position position) {
    TriangleMesh mesh;
    const auto uv_of = [&](std::uint32_t i, std::uint32_t j) {
        return Vec2f(float(i) / float(nu), float(j) / float(nv));
    };
    for (std::uint32_t j = 0; j <= nv; ++j) {
        for (std::uint32_t i = 0; i <= nu; ++i) {
            const Vec2f uv = uv_of(i, j);
            mesh.positions.push_back(position(uv.x(), uv.y()));
        }
    }
    for (std::uint32_t j = 0; j < nv; ++j) {
        for (std::uint32_t i = 0; i < nu; ++i) {
            const std::uint32_t at = j * (nu + 1) + i;
            mesh.triangles.push_back({at, at + 1, at + nu + 2});
            mesh.uvs.push_back({uv_of(i, j), uv_of(i + 1, j), uv_of(i + 1, j + 1)});
            mesh.triangles.push_back({at, at + nu + 2, at + nu + 1});
            mesh.uvs.push_back({uv_of(i, j), uv_of(i + 1, j + 1), uv_of(i, j + 1)});
        }
    }
    return mesh;
}

/// The square [0, side]^2 at z = 0, facing +Z, of cells x cells.
inline TriangleMesh square_mesh(float side, std::uint32_t cells) {
    return grid_mesh(cells, cells,
                     [=](float u, float v) { return Vec3f(side * u, side * v, 0); });
}

/// The unit sphere, facing outwards, with a seam of doubled vertices and poles of
/// triangles without area.
inline TriangleMesh sphere_mesh(std::uint32_t cells) {
    return grid_mesh(2 * cells, cells, [=](float u, float v) {
        const bool seam = u == 1, pole = v == 0 || v == 1;
        const float phi = seam ? 0 : 2 * kPif * u;
        const float theta = kPif * v;
        const float ring = pole ? 0 : std::sin(theta);
        return Vec3f(ring * std::sin(phi), -std::cos(theta), ring * std::cos(phi));
    });
}

}  // namespace lancret
