#include "guides/motion/scalp_pose.h"

#include <gtest/gtest.h>

#include "guides/base/errors.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

const RigidPose kMoved{
    Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(),
    Vec3(40, -7, 12)};

/// A wavy sheet of edges near 1 cm.
TriangleMesh sheet() {
    return grid_mesh(8, 8, [](float u, float v) {
        return Vec3f(8 * u, 8 * v, std::sin(3 * u) * std::cos(2 * v));
    });
}

/// One place inside each triangle.
std::vector<MeshPoint> places_on(const TriangleMesh& mesh) {
    std::vector<MeshPoint> out;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        out.push_back({t, 0.25f, 0.5f});
    }
    return out;
}

TEST(ScalpPose, CarriersMoveWithTheMesh) {
    const TriangleMesh mesh = sheet();
    const std::vector<MeshPoint> places = places_on(mesh);
    const auto before = carriers(ScalpPose(mesh), places, places.size());
    const auto after =
        carriers(ScalpPose(posed_mesh(mesh, kMoved)), places, places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        // Corners are floats of up to some 50 cm, 3e-6 each, on edges of about 1 cm.
        EXPECT_LE((after[i].rotation - kMoved.rotation * before[i].rotation).norm(),
                  1e-4);
        EXPECT_LE((after[i].translation - kMoved * before[i].translation).norm(), 2e-5);
        const Mat3 gram = after[i].rotation.transpose() * after[i].rotation;
        EXPECT_LE((gram - Mat3::Identity()).norm(), 1e-14);
    }
}

TEST(ScalpPose, ACarrierHasItsPlaceAsOriginAndTheFrameOfItsTriangle) {
    TriangleMesh mesh;
    mesh.positions = {{1, 2, 3}, {1, 4, 3}, {1, 2, 7}};
    mesh.triangles = {{0, 1, 2}};
    const MeshPoint place{0, 0.5f, 0.25f};
    const auto carried = carriers(ScalpPose(mesh), std::span(&place, 1), 1);
    // 0.5 of the edge (0, 2, 0) and 0.25 of the edge (0, 0, 4) from the first corner.
    EXPECT_EQ(carried[0].translation, Vec3(1, 3, 4));
    // The first edge, across, and the normal: y, z, x.
    Mat3 expected;
    expected << Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX();
    EXPECT_EQ(carried[0].rotation, expected);
}

TEST(ScalpPose, ARigidPoseCarriesEveryPlaceAlike) {
    const auto carried = carriers(kMoved, {}, 3);
    ASSERT_EQ(carried.size(), 3u);
    for (const RigidPose& pose : carried) {
        EXPECT_EQ(pose.rotation, kMoved.rotation);
        EXPECT_EQ(pose.translation, kMoved.translation);
    }
}

TEST(ScalpPose, RejectsPlacesThatItCannotCarry) {
    const TriangleMesh mesh = sheet();
    const std::vector<MeshPoint> places = places_on(mesh);
    EXPECT_THROW(carriers(ScalpPose(mesh), {}, 3), InputError);
    const MeshPoint beyond{std::uint32_t(mesh.triangles.size()), 0.25f, 0.25f};
    EXPECT_THROW(carriers(ScalpPose(mesh), std::span(&beyond, 1), 1),
                 std::invalid_argument);
    TriangleMesh flat = mesh;
    for (Vec3f& p : flat.positions) p = Vec3f::Zero();
    EXPECT_THROW(carriers(ScalpPose(flat), places, places.size()), InputError);
}

TEST(ScalpPose, APosedMeshReplacesTheRestMesh) {
    const TriangleMesh mesh = sheet();
    TriangleMesh other = mesh;
    for (Vec3f& p : other.positions) p.z() += 1;
    EXPECT_EQ(posed_mesh(mesh, ScalpPose(other)).positions, other.positions);
    const TriangleMesh moved = posed_mesh(mesh, kMoved);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 image = kMoved * mesh.positions[i].cast<double>();
        EXPECT_EQ(moved.positions[i], Vec3f(image.cast<float>()));
    }
}

}  // namespace
}  // namespace lancret
