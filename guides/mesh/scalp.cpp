#include "guides/mesh/scalp.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "guides/helix/helix.h"
#include "guides/mesh/welded.h"

namespace lancret {

namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& t = mesh.triangles[triangle];
    return {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
            mesh.positions[t[2]].cast<double>()};
}

/// Twice the area along the normal.
Vec3 area_vector(const Corners& p) { return (p[1] - p[0]).cross(p[2] - p[0]); }

/// v / |v|, or `otherwise` if v is zero.
Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
    const double norm = v.stableNorm();
    return norm > 0 ? Vec3(v / norm) : otherwise;
}

void check(const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (vertex >= mesh.positions.size()) {
                throw std::invalid_argument("make_scalp: an index is out of range");
            }
        }
    }
    if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.triangles.size()) {
        throw std::invalid_argument(
            "make_scalp: expected UVs for every triangle or none");
    }
}

}  // namespace

Scalp make_scalp(TriangleMesh mesh) {
    check(mesh);
    Scalp scalp;
    scalp.mesh = std::move(mesh);
    scalp.areas.reserve(scalp.mesh.triangles.size());
    const std::vector<std::uint32_t> weld = welded(scalp.mesh.positions);
    std::vector<Vec3> sums(weld.size(), Vec3::Zero());
    for (std::size_t i = 0; i < scalp.mesh.triangles.size(); ++i) {
        const Vec3 area = area_vector(corners_of(scalp.mesh, i));
        for (const std::uint32_t vertex : scalp.mesh.triangles[i]) {
            sums[weld[vertex]] += area;
        }
        scalp.areas.push_back(area.norm() / 2);
        scalp.area += scalp.areas.back();
    }
    scalp.normals.reserve(weld.size());
    for (const std::uint32_t vertex : weld) {
        scalp.normals.push_back(unit_or(sums[vertex], Vec3::UnitZ()));
    }
    return scalp;
}

Vec3 scalp_position(const Scalp& scalp, const MeshPoint& point) {
    const auto [p0, p1, p2] = corners_of(scalp.mesh, point.triangle);
    return p0 + double(point.u) * (p1 - p0) + double(point.v) * (p2 - p0);
}

Vec3 scalp_normal(const Scalp& scalp, const MeshPoint& point) {
    const auto& t = scalp.mesh.triangles[point.triangle];
    const double u = point.u, v = point.v;
    const Vec3 blend = (1 - u - v) * scalp.normals[t[0]] + u * scalp.normals[t[1]] +
                       v * scalp.normals[t[2]];
    // Unit vectors that cancel leave only round-off.
    if (blend.squaredNorm() > 1e-20) return blend.normalized();
    return unit_or(area_vector(corners_of(scalp.mesh, point.triangle)), Vec3::UnitZ());
}

Vec2 scalp_uv(const Scalp& scalp, const MeshPoint& point) {
    if (scalp.mesh.uvs.empty()) return Vec2::Zero();
    const auto& [t0, t1, t2] = scalp.mesh.uvs[point.triangle];
    const double u = point.u, v = point.v;
    return (1 - u - v) * t0.cast<double>() + u * t1.cast<double>() +
           v * t2.cast<double>();
}

Mat3 surface_frame(const Scalp& scalp, const MeshPoint& point) {
    const Corners p = corners_of(scalp.mesh, point.triangle);
    const Vec3 normal = scalp_normal(scalp, point);
    const std::array<Vec3, 3> edges{p[1] - p[0], p[2] - p[0], p[2] - p[1]};

    // A candidate is accepted if a fraction of its possible size remains across the
    // normal.
    Vec3 tangent = Vec3::Zero();
    const auto take = [&](const Vec3& candidate, double size) {
        const Vec3 across = candidate - normal * normal.dot(candidate);
        if (tangent.isZero(0) && across.norm() > 1e-9 * size) {
            tangent = across.normalized();
        }
    };
    if (!scalp.mesh.uvs.empty()) {
        const auto& t = scalp.mesh.uvs[point.triangle];
        const Vec2 d1 = (t[1] - t[0]).cast<double>(), d2 = (t[2] - t[0]).cast<double>();
        const double area = d1.x() * d2.y() - d1.y() * d2.x();
        const double size = d1.norm() * d2.norm();
        // dp/du is (e1 dv2 - e2 dv1) / area; only its direction matters.
        if (std::abs(area) > 1e-9 * size) {
            take(std::copysign(1.0, area) * (edges[0] * d2.y() - edges[1] * d1.y()),
                 edges[0].norm() * std::abs(d2.y()) + edges[1].norm() * std::abs(d1.y()));
        }
    }
    for (const Vec3& edge : edges) take(edge, edge.norm());
    if (tangent.isZero(0)) tangent = normal.unitOrthogonal();

    Mat3 frame;
    frame << normal, tangent, normal.cross(tangent);
    orthonormalize<double>(frame);
    return frame;
}

}  // namespace lancret
