#include "guides/mesh/closest_point.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "guides/mesh/scalp.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

/// The distance to a triangle by geometry: the height above the plane if the foot is on
/// the inner side of all three edges, otherwise the distance to the nearest edge.
double distance_to_triangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const Vec3 corners[] = {a, b, c};
    bool inside = normal.norm() > 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Vec3 from = corners[i], to = corners[(i + 1) % 3], along = to - from;
        inside = inside && normal.dot(along.cross(q - from)) >= 0;
        const double length = along.norm();
        const Vec3 unit = length > 0 ? Vec3(along / length) : Vec3::Zero();
        const double t = std::min(std::max(unit.dot(q - from), 0.0), length);
        nearest = std::min(nearest, (from + t * unit - q).norm());
    }
    return inside ? std::abs(normal.normalized().dot(q - a)) : nearest;
}

double brute_force(const TriangleMesh& mesh, const Vec3& q) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
        nearest =
            std::min(nearest, distance_to_triangle(q, mesh.positions[t[0]].cast<double>(),
                                                   mesh.positions[t[1]].cast<double>(),
                                                   mesh.positions[t[2]].cast<double>()));
    }
    return nearest;
}

void expect_closest(const ClosestPoint& closest, const Scalp& scalp, const Vec3& place) {
    const ClosestResult result = closest.closest(place);
    const double size = 1 + place.norm();
    EXPECT_NEAR(result.distance, brute_force(scalp.mesh, place), 1e-12 * size);
    EXPECT_NEAR((result.position - place).norm(), result.distance, 1e-12 * size);
    // MeshPoint holds floats: an edge length times half an ulp of each coordinate.
    EXPECT_LT((scalp_position(scalp, result.point) - result.position).norm(),
              1e-6 * size);
    EXPECT_GE(result.point.u, 0);
    EXPECT_GE(result.point.v, 0);
    EXPECT_LE(result.point.u + result.point.v, 1);
}

TEST(ClosestPoint, AgreesWithBruteForceOnRandomTriangles) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (const float size : {0.01f, 0.3f, 3.0f}) {
        TriangleMesh mesh;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const Vec3f centre(normal(random), normal(random), normal(random));
            for (int c = 0; c < 3; ++c) {
                mesh.positions.push_back(centre + size * Vec3f(normal(random),
                                                               normal(random),
                                                               normal(random)));
            }
            mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        // Without area: a point and a needle.
        mesh.triangles.push_back({0, 0, 0});
        mesh.triangles.push_back({1, 10, 10});
        const ClosestPoint closest(mesh);
        const Scalp scalp = make_scalp(mesh);
        for (int i = 0; i < 500; ++i) {
            expect_closest(closest, scalp,
                           (i % 2 ? 1.0 : 5.0) *
                               Vec3(normal(random), normal(random), normal(random)));
        }
    }
}

TEST(ClosestPoint, AgreesWithBruteForceFarFromTheOrigin) {
    // Millimetre triangles a metre and a half away, as on a figure that stands upright.
    TriangleMesh mesh = sphere_mesh(16);
    for (Vec3f& p : mesh.positions) p = 2 * p + Vec3f(0, 150, 30);
    const ClosestPoint closest(mesh);
    const Scalp scalp = make_scalp(mesh);
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
        const Vec3 d(normal(random), normal(random), normal(random));
        expect_closest(closest, scalp, Vec3(0, 150, 30) + d);
    }
    expect_closest(closest, scalp, Vec3(0, 150, 30));
    expect_closest(closest, scalp, Vec3(1e6, -1e6, 3));
}

TEST(ClosestPoint, APointOfTheMeshIsClosestToItself) {
    const Scalp scalp = make_scalp(sphere_mesh(20));
    const ClosestPoint closest(scalp.mesh);
    for (std::uint32_t i = 0; i < scalp.mesh.triangles.size(); ++i) {
        if (scalp.areas[i] < 1e-6) continue;
        const ClosestResult result =
            closest.closest(scalp_position(scalp, {i, 0.25f, 0.25f}));
        EXPECT_EQ(result.point.triangle, i);
        EXPECT_LT(result.distance, 1e-15);
        EXPECT_NEAR(result.point.u, 0.25f, 1e-6);
    }
}

TEST(ClosestPoint, TiesGoToTheLowestTriangle) {
    const TriangleMesh mesh = square_mesh(1, 8);
    const ClosestPoint closest(mesh);
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        std::uint32_t lowest = 0;
        while (mesh.triangles[lowest][0] != v && mesh.triangles[lowest][1] != v &&
               mesh.triangles[lowest][2] != v) {
            ++lowest;
        }
        const Vec3 above = mesh.positions[v].cast<double>() + Vec3(0, 0, 0.5);
        EXPECT_EQ(closest.closest(above).point.triangle, lowest);
    }
}

TEST(ClosestPoint, WithinADistanceFindsTheSameOrNothing) {
    const ClosestPoint closest(sphere_mesh(16));
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 place(normal(random), normal(random), normal(random));
        const ClosestResult any = closest.closest(place);
        for (const double within : {0.0, 0.1, 0.5, any.distance}) {
            const ClosestResult near = closest.closest(place, within);
            // The square of a root has an error of an ulp: exactly at the limit either
            // result is right.
            if (std::abs(any.distance - within) <= 1e-15 * within) continue;
            EXPECT_EQ(std::isfinite(near.distance), any.distance < within);
            if (!(any.distance < within)) continue;
            ++found;
            EXPECT_EQ(near.distance, any.distance);
            EXPECT_EQ(near.position, any.position);
            EXPECT_EQ(near.point.triangle, any.point.triangle);
        }
    }
    EXPECT_GT(found, 500);
}

TEST(ClosestPoint, IsTheSameFromManyThreads) {
    const ClosestPoint closest(sphere_mesh(32));
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<Vec3> places(2000);
    for (Vec3& p : places) p = {normal(random), normal(random), normal(random)};
    std::vector<Vec3> parallel(places.size());
    tbb::parallel_for(std::size_t(0), places.size(), [&](std::size_t i) {
        parallel[i] = closest.closest(places[i]).position;
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(parallel[i], closest.closest(places[i]).position);
    }
}

TEST(ClosestPoint, RejectsMeshesWithoutTriangles) {
    EXPECT_THROW(ClosestPoint(TriangleMesh{}), std::invalid_argument);
    TriangleMesh mesh = square_mesh(1, 1);
    mesh.triangles[1][0] = 99;
    EXPECT_THROW(ClosestPoint{mesh}, std::invalid_argument);
}

}  // namespace
}  // namespace lancret
