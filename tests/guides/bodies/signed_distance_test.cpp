#include "guides/bodies/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/guides/bodies/box_mesh.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

Vec3 random_place(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

/// The winding number of a mesh about a place: the sum of the triangles' solid angles
/// over 4 pi (Van Oosterom and Strackee 1983). 1 inside, 0 outside.
double winding(const TriangleMesh& mesh, const Vec3& x) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]].cast<double>() - x,
                   b = mesh.positions[t[1]].cast<double>() - x,
                   c = mesh.positions[t[2]].cast<double>() - x;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc +
                                                     b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * kPi);
}

TEST(SignedDistance, BoxIsItsClosedForm) {
    const Vec3 half(1, 2, 0.5);
    const SignedDistance box(box_mesh(half.cast<float>()));
    EXPECT_TRUE(box.closed());
    std::mt19937 random(1);
    int inside = 0, at_edges = 0;
    for (int i = 0; i < 5000; ++i) {
        Vec3 x = random_place(random, i % 2 ? 1.2 : 4);
        const double expected = box_distance(half, x);
        const MeshDistance found = box.at(x);
        EXPECT_NEAR(found.distance, expected, 1e-14);
        EXPECT_NEAR((x - found.point).norm(), std::abs(expected), 1e-14);
        EXPECT_NEAR(found.normal.norm(), 1, 1e-15);
        EXPECT_LT((found.point + found.distance * found.normal - x).norm(), 1e-14);
        inside += expected < 0;
        at_edges += ((x.cwiseAbs() - half).array() > 0).count() > 1;
    }
    EXPECT_GT(inside, 200);
    EXPECT_GT(at_edges, 1000);
}

TEST(SignedDistance, NormalOnTheSurfaceIsThePseudoNormal) {
    const SignedDistance box(box_mesh({1, 1, 1}));
    const struct {
        Vec3 place, normal;
    } cases[] = {
        {{1, 0.3, 0.1}, Vec3::UnitX()},
        {{-0.2, 0.3, -1}, -Vec3::UnitZ()},
        {{0.4, 0.4, 1}, Vec3::UnitZ()},  // on a face's diagonal
        {{1, 1, 0.25}, Vec3(1, 1, 0).normalized()},
        {{-1, 0.5, 1}, Vec3(-1, 0, 1).normalized()},
        // However a corner's faces are triangulated, each has a right angle there.
        {{1, 1, 1}, Vec3(1, 1, 1).normalized()},
        {{-1, 1, -1}, Vec3(-1, 1, -1).normalized()},
    };
    for (const auto& [place, normal] : cases) {
        const MeshDistance found = box.at(place);
        // The point is a sum of products of size 2: a few ulps.
        EXPECT_LT(std::abs(found.distance), 1e-15);
        EXPECT_LT((found.normal - normal).norm(), 1e-14) << place.transpose();
    }
}

TEST(SignedDistance, AFineSphereIsNearTheSphere) {
    const std::uint32_t cells = 48;
    const SignedDistance sphere(
        sphere_mesh(cells));  // with a seam, and needles at the poles
    EXPECT_TRUE(sphere.closed());
    // A facet of angle pi / cells in both directions deviates from the sphere by at most
    // 1 - cos of half its diagonal.
    const double half = kPi / cells / std::sqrt(2), sagitta = 1 - std::cos(half);
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        Vec3 x = random_place(random, 2);
        if (i < 50) x = {0, i * 0.04, 0};  // on the axis, where the poles are
        const double expected = x.norm() - 1;
        const MeshDistance found = sphere.at(x);
        EXPECT_GE(found.distance,
                  expected - 1e-6);  // vertices are on it up to float rounding
        EXPECT_LE(found.distance, expected + sagitta + 1e-6);
    }
}

TEST(SignedDistance, SignIsThatOfTheWindingNumberOnASpikyMesh) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> radius(0.3f, 2);
    TriangleMesh mesh = sphere_mesh(9);
    std::vector<float> radii(mesh.positions.size());
    for (std::size_t i = 0; i < radii.size(); ++i) {
        radii[i] = radius(random);
        // Vertices at equal positions stay at equal positions.
        for (std::size_t j = 0; j < i; ++j) {
            if (mesh.positions[j] == mesh.positions[i]) {
                radii[i] = radii[j];
                break;
            }
        }
    }
    for (std::size_t i = 0; i < radii.size(); ++i) mesh.positions[i] *= radii[i];
    const SignedDistance distance(mesh);
    EXPECT_TRUE(distance.closed());
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 x = random_place(random, 1.5);
        const MeshDistance found = distance.at(x);
        if (std::abs(found.distance) < 1e-9) continue;
        const double turns = winding(mesh, x);
        EXPECT_NEAR(turns, std::round(turns), 1e-9);
        EXPECT_EQ(found.distance<0, turns> 0.5) << x.transpose();
        inside += found.distance < 0;
    }
    EXPECT_GT(inside, 300);
}

TEST(SignedDistance, AnOpenMeshHasABackButNoInsideAroundItsBorder) {
    const SignedDistance sheet(square_mesh(1, 4));  // facing +Z
    EXPECT_FALSE(sheet.closed());
    EXPECT_NEAR(sheet.at({0.3, 0.4, 0.2}).distance, 0.2, 1e-15);
    EXPECT_NEAR(sheet.at({0.3, 0.4, -0.2}).distance, -0.2, 1e-15);
    EXPECT_EQ(sheet.at({0.3, 0.4, -0.2}).normal, Vec3::UnitZ());
    EXPECT_NEAR(sheet.at({1.3, 0.5, -0.4}).distance, 0.5, 1e-15);
    EXPECT_LT((sheet.at({1.3, 0.5, -0.4}).normal - Vec3(0.6, 0, -0.8)).norm(), 1e-15);
    EXPECT_NEAR(sheet.at({-0.3, -0.4, -1.2}).distance, 1.3, 1e-15);
}

TEST(SignedDistance, FindsNothingBeyondItsReach) {
    const SignedDistance box(box_mesh({1, 1, 1}));
    EXPECT_TRUE(std::isinf(box.at({1.6, 0, 0}, 0.5).distance));
    EXPECT_NEAR(box.at({1.4, 0, 0}, 0.5).distance, 0.4, 1e-15);
    EXPECT_TRUE(std::isinf(box.at({0, 0, 0}, 0.5).distance));
    EXPECT_EQ(box.at({0, 0, 0}).distance, -1);
}

TEST(SignedDistance, RejectsInvalidMeshes) {
    EXPECT_THROW(SignedDistance(TriangleMesh{}), std::invalid_argument);
    TriangleMesh mesh = square_mesh(1, 1);
    mesh.triangles[0][2] = 4;
    EXPECT_THROW(SignedDistance{mesh}, std::invalid_argument);
    mesh = square_mesh(1, 1);
    mesh.positions[0].x() = std::nanf("");
    EXPECT_THROW(SignedDistance{mesh}, std::invalid_argument);
}

}  // namespace
}  // namespace lancret
