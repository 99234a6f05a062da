#include "guides/mesh/scalp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

double rotation_error(const Mat3& r) {
    return std::max((r.transpose() * r - Mat3::Identity()).cwiseAbs().maxCoeff(),
                    std::abs(r.determinant() - 1));
}

TEST(Scalp, AreaOfASquareIsItsArea) {
    const Scalp scalp = make_scalp(square_mesh(2, 4));
    EXPECT_EQ(scalp.area, 4);
    EXPECT_EQ(scalp.areas[5], 4.0 / 32);
}

TEST(Scalp, EvaluatesAffinelyInEachTriangle) {
    // The square's UV is its position divided by its side.
    const Scalp scalp = make_scalp(square_mesh(2, 4));
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 0.5f);
    for (std::uint32_t i = 0; i < scalp.mesh.triangles.size(); ++i) {
        const MeshPoint point{i, uniform(random), uniform(random)};
        const Vec3 p = scalp_position(scalp, point);
        const Vec2 uv = scalp_uv(scalp, point);
        EXPECT_NEAR(p.x(), 2 * uv.x(), 1e-15);
        EXPECT_NEAR(p.y(), 2 * uv.y(), 1e-15);
        EXPECT_EQ(scalp_normal(scalp, point), Vec3::UnitZ());
        EXPECT_LT((surface_frame(scalp, point).col(1) - Vec3::UnitX()).norm(), 1e-15);
    }
}

TEST(Scalp, NormalsOfASphereAreRadial) {
    const Scalp scalp = make_scalp(sphere_mesh(64));
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0, 0.5f);
    for (int i = 0; i < 1000; ++i) {
        const MeshPoint point{std::uint32_t(random() % scalp.mesh.triangles.size()),
                              uniform(random), uniform(random)};
        const Vec3 p = scalp_position(scalp, point);
        // Facets of 2 pi / 128 = 0.05 rad: a vertex's normal deviates from the radius by
        // at most the turn over half a facet; where facets are even, by a constant times
        // its square.
        EXPECT_LT((scalp_normal(scalp, point) - p.normalized()).norm(), 0.025);
        EXPECT_NEAR(scalp_normal(scalp, point).norm(), 1, 1e-15);
    }
}

TEST(Scalp, SeamOfEqualPositionsDoesNotBreakNormals) {
    const TriangleMesh whole = sphere_mesh(16);
    // The same sphere as loose triangles: every vertex is a seam.
    TriangleMesh loose;
    for (const auto& t : whole.triangles) {
        const auto first = std::uint32_t(loose.positions.size());
        for (const auto v : t) loose.positions.push_back(whole.positions[v]);
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    const Scalp a = make_scalp(whole), b = make_scalp(loose);
    for (std::uint32_t i = 0; i < whole.triangles.size(); ++i) {
        const MeshPoint point{i, 0.2f, 0.7f};
        EXPECT_LT((scalp_normal(a, point) - scalp_normal(b, point)).norm(), 1e-14);
    }
}

TEST(Scalp, TangentIsTheDerivativeOfPositionByU) {
    const Scalp scalp = make_scalp(sphere_mesh(24));
    for (std::uint32_t i = 0; i < scalp.mesh.triangles.size(); ++i) {
        const MeshPoint point{i, 0.3f, 0.3f};
        const Mat3 frame = surface_frame(scalp, point);
        EXPECT_LT(rotation_error(frame), 1e-14);
        EXPECT_LT((frame.col(0) - scalp_normal(scalp, point)).norm(), 1e-14);
        if (scalp.areas[i] < 1e-3) continue;
        // The step in the triangle's (u, v) that moves the texture by (h, 0).
        const auto& t = scalp.mesh.uvs[i];
        Eigen::Matrix2d d;
        d << (t[1] - t[0]).cast<double>(), (t[2] - t[0]).cast<double>();
        const Vec2 step = d.inverse() * Vec2(1, 0);
        const Vec3 origin = scalp_position(scalp, {i, 0, 0});
        const Vec3 by_u = step.x() * (scalp_position(scalp, {i, 1, 0}) - origin) +
                          step.y() * (scalp_position(scalp, {i, 0, 1}) - origin);
        const Vec3 n = frame.col(0), across = by_u - n * n.dot(by_u);
        EXPECT_LT((frame.col(1) - across.normalized()).norm(), 1e-12);
    }
}

TEST(Scalp, MirroredUvsStillGiveARotationAlongU) {
    TriangleMesh mesh = square_mesh(1, 1);
    for (auto& t : mesh.uvs) {
        for (Vec2f& uv : t) uv.x() = -uv.x();
    }
    const Mat3 frame = surface_frame(make_scalp(mesh), {0, 0.2f, 0.2f});
    EXPECT_LT((frame.col(1) + Vec3::UnitX()).norm(), 1e-15);
    EXPECT_LT(rotation_error(frame), 1e-15);
}

TEST(Scalp, HasAFrameWithoutUvsAndWithoutArea) {
    TriangleMesh mesh = square_mesh(1, 2);
    mesh.uvs.clear();
    Scalp scalp = make_scalp(mesh);
    EXPECT_EQ(scalp_uv(scalp, {0, 0.1f, 0.1f}), Vec2::Zero());
    const auto& t = mesh.triangles[0];
    const Vec3 edge = (mesh.positions[t[1]] - mesh.positions[t[0]]).cast<double>();
    EXPECT_LT((surface_frame(scalp, {0, 0.1f, 0.1f}).col(1) - edge.normalized()).norm(),
              1e-15);

    // A point, a needle, a needle along the normal of its neighbours, one isolated;
    // with UVs that collapse as well.
    mesh.positions.insert(mesh.positions.end(),
                          {Vec3f(0, 0, 1), Vec3f(9, 9, 9), Vec3f(9, 9, 8)});
    const auto n = std::uint32_t(mesh.positions.size());
    mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 0},
                                                 {0, 1, 1},
                                                 {0, n - 3, 0},
                                                 {n - 1, n - 2, n - 1},
                                                 {n - 1, n - 1, n - 1}});
    mesh.uvs.assign(mesh.triangles.size(),
                    {Vec2f(0.5f, 0.5f), Vec2f(0.5f, 0.5f), Vec2f(0.5f, 0.5f)});
    scalp = make_scalp(mesh);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Mat3 frame = surface_frame(scalp, {i, 0.3f, 0.4f});
        EXPECT_LT(rotation_error(frame), 1e-14) << i;
    }
}

TEST(Scalp, NormalsThatCancelFallBackToTheTriangle) {
    // Two sheets, face to face on the same vertices: every vertex normal is +Z by
    // default, or the sum is zero.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    const Scalp scalp = make_scalp(mesh);
    EXPECT_LT(rotation_error(surface_frame(scalp, {0, 0.3f, 0.3f})), 1e-14);
    EXPECT_EQ(scalp.normals[0], Vec3::UnitZ());
}

TEST(Scalp, RejectsIndicesOutOfRange) {
    TriangleMesh mesh = square_mesh(1, 1);
    mesh.triangles[0][2] = 4;
    EXPECT_THROW(make_scalp(mesh), std::invalid_argument);
    mesh = square_mesh(1, 1);
    mesh.uvs.pop_back();
    EXPECT_THROW(make_scalp(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
