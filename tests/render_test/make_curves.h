#pragma once
// Strands for tests: straight lines and a hairy sphere.

#include <cmath>
#include <cstdint>
#include <vector>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/sampling/sampler.h"

namespace lancret {

/// Curves from rows of points that the axis passes near (B-spline) or through (Hermite);
/// all rows have the same number of points.
inline Curves curves_through(const std::vector<std::vector<Vec3f>>& rows, float radius,
                             CurveShape shape = CurveShape::flat,
                             CurveBasis basis = CurveBasis::bspline) {
    Curves curves;
    curves.basis = basis;
    curves.shape = shape;
    const std::uint32_t count = rows.empty() ? 2 : std::uint32_t(rows[0].size());
    const bool hermite = basis == CurveBasis::hermite;
    curves.add_class(std::uint32_t(rows.size()), count - 1);
    curves.points = Buffer<Point4f>(curves.point_count());
    curves.tangents = Buffer<Point4f>(hermite ? curves.points.size() : 0);
    curves.segments = Buffer<std::uint32_t>(curves.segment_count());
    std::size_t out = 0;
    for (std::uint32_t j = 0; j < curves.segments.size(); ++j) {
        curves.segments[j] = curves.place_of(j).point;
    }
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        for (std::uint32_t j = 0; j < curves.points_of(i); ++j) {
            const auto& row = rows[i];
            const auto point = [&](int k) -> Vec3f {
                const int last = int(count) - 1;
                if (k < 0) return 2 * row[0] - row[1];
                if (k > last) return 2 * row[last] - row[last - 1];
                return row[k];
            };
            const Vec3f p = point(hermite ? int(j) : int(j) - 1);
            if (hermite) {
                const Vec3f d = (point(int(j) + 1) - point(int(j) - 1)) / 2;
                curves.tangents[out] = {d.x(), d.y(), d.z(), 0};
            }
            curves.points[out++] = {p.x(), p.y(), p.z(), radius};
        }
    }
    return curves;
}

/// A sphere about the origin, in triangles that face outward; radius in cm.
inline TriangleMesh sphere_mesh(int around = 96, int down = 48, float radius = 9) {
    TriangleMesh mesh;
    constexpr float kTurn = 2 * kPif;
    for (int y = 0; y <= down; ++y) {
        for (int x = 0; x <= around; ++x) {
            const float a = kTurn * float(x) / float(around),
                        b = kTurn / 2 * float(y) / float(down);
            mesh.positions.push_back(radius * Vec3f(std::sin(b) * std::cos(a),
                                                    std::cos(b),
                                                    std::sin(b) * std::sin(a)));
        }
    }
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < around; ++x) {
            const std::uint32_t a = y * (around + 1) + x, b = a + around + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
    }
    return mesh;
}

/// Strands that stand on that sphere, droop under gravity and curl.
inline Curves hairy_sphere(std::uint32_t strands, float length = 8, float radius = 0.004f,
                           float curl = 0.25f, CurveShape shape = CurveShape::flat) {
    std::vector<std::vector<Vec3f>> rows(strands);
    const float golden = kPif * (3 - std::sqrt(5.0f));
    for (std::uint32_t i = 0; i < strands; ++i) {
        const float y = 1 - 2 * (float(i) + 0.5f) / float(strands);
        const float r = std::sqrt(1 - y * y), a = golden * float(i);
        const Vec3f normal(r * std::cos(a), y, r * std::sin(a));
        const float phase = unit_float(std::uint32_t(mix(i, 1))) * 6.2831853f;
        const float strand_length =
            length * (0.8f + 0.2f * unit_float(std::uint32_t(mix(i, 2))));
        const Vec3f side = normal.unitOrthogonal(), other = normal.cross(side);
        for (int j = 0; j <= 16; ++j) {
            const float s = float(j) / 16, angle = phase + 14 * s;
            Vec3f p = normal * (8.99f + strand_length * (s - 0.45f * s * s));
            p.y() -= 0.55f * strand_length * s * s;
            p += curl * s * (side * std::cos(angle) + other * std::sin(angle));
            // Keep points out of the sphere.
            if (p.norm() < 9.0f + 0.4f * s) p *= (9.0f + 0.4f * s) / p.norm();
            rows[i].push_back(p);
        }
    }
    return curves_through(rows, radius, shape);
}

}  // namespace lancret
