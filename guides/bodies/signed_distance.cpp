#include "guides/bodies/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "guides/base/coordinates.h"
#include "guides/mesh/welded.h"

namespace lancret {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A side of a triangle, from the end with the lower index.
struct Side {
    std::uint32_t low, high, triangle;
    int edge;
    bool forward;  ///< the triangle runs from low to high

    auto order() const { return std::tie(low, high, triangle, edge); }
};

const TriangleMesh& checked(const TriangleMesh& mesh) {
    if (!std::ranges::all_of(mesh.positions, is_place)) {
        throw std::invalid_argument("SignedDistance: a position is out of range");
    }
    return mesh;
}

/// The angle between two vectors; 0 if one is zero.
double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

SignedDistance::SignedDistance(const TriangleMesh& mesh)
    : closest_(checked(mesh)), normals_(mesh.triangles.size()) {
    const std::vector<std::uint32_t> weld = welded(mesh.positions);
    std::vector<Triangle> triangles(mesh.triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::array<Vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            triangles[i][c] = weld[mesh.triangles[i][c]];
            p[c] = mesh.positions[triangles[i][c]].cast<double>();
        }
        const Vec3 area = (p[1] - p[0]).cross(p[2] - p[0]);
        const double size = area.norm();
        if (size > 0) normals_[i].face = area / size;
    }
    set_edges(triangles);
    set_corners(mesh, triangles);
}

void SignedDistance::set_edges(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (int e = 0; e < 3; ++e) {
            const std::uint32_t from = triangles[i][e], to = triangles[i][(e + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), i, e, from < to});
        }
    }
    std::ranges::sort(sides, {}, &Side::order);
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(), [&](const Side& s) {
            return s.low != first->low || s.high != first->high;
        });
        Vec3 sum = Vec3::Zero();
        int excess = 0;
        for (auto s = first; s != last; ++s) {
            sum += normals_[s->triangle].face;
            excess += s->forward ? 1 : -1;
        }
        const bool border = first->low != first->high && excess != 0;
        closed_ = closed_ && !border;
        for (; first != last; ++first) {
            normals_[first->triangle].edges[first->edge] = sum;
            normals_[first->triangle].border_edges[first->edge] = border;
        }
    }
}

void SignedDistance::set_corners(const TriangleMesh& mesh,
                                 const std::vector<Triangle>& triangles) {
    std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
    std::vector<char> border(mesh.positions.size(), 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t at = triangles[i][c], next = triangles[i][(c + 1) % 3];
            const std::uint32_t last = triangles[i][(c + 2) % 3];
            const Vec3 p = mesh.positions[at].cast<double>();
            sums[at] += normals_[i].face * angle(mesh.positions[next].cast<double>() - p,
                                                 mesh.positions[last].cast<double>() - p);
            if (normals_[i].border_edges[c]) border[at] = border[next] = 1;
        }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            normals_[i].corners[c] = sums[triangles[i][c]];
            normals_[i].border_corners[c] = border[triangles[i][c]] != 0;
        }
    }
}

MeshDistance SignedDistance::at(const Vec3& place, double within) const {
    const ClosestResult found = closest_.closest(place, within);
    MeshDistance out;
    if (!std::isfinite(found.distance)) return out;
    const Normals& normals = normals_[found.point.triangle];

    // The corner, edge or face that the point is on; u and v are exact there, except for
    // 2 ulp of their sum.
    const double u = found.uv.x(), v = found.uv.y();
    const bool zero[3] = {u + v >= 1 - 4e-16, u == 0, v == 0};  // of corners 0, 1, 2
    Vec3 side = normals.face;
    bool border = false;
    for (int c = 0; c < 3; ++c) {
        const int next = (c + 1) % 3, last = (c + 2) % 3;
        if (zero[next] && zero[last]) {
            side = normals.corners[c];
            border = normals.border_corners[c];
            break;
        }
        // The edge across from corner c is edge number c + 1: it runs from c + 1 to c
        // + 2.
        if (zero[c]) {
            side = normals.edges[next];
            border = normals.border_edges[next];
        }
    }
    const Vec3 away = place - found.position;
    const bool behind = !border && away.dot(side) < 0;
    out.distance = behind ? -found.distance : found.distance;
    out.point = found.position;
    out.triangle = found.point.triangle;
    // On the surface the direction to it is round-off: the normal is the surface's.
    const double noise = 1e-9 * (1 + found.position.cwiseAbs().maxCoeff());
    if (found.distance > noise) {
        out.normal = away / out.distance;
        // Renormalised: far from the surface the last digits may be lost.
        out.normal.normalize();
    } else if (side.squaredNorm() > 1e-20) {
        out.normal = side.normalized();
    } else if (!normals.face.isZero()) {
        out.normal = normals.face;
    }
    return out;
}

}  // namespace lancret
