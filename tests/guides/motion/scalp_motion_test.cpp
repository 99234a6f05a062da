#include "guides/motion/scalp_motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "guides/files/obj_file.h"
#include "tests/guides/base/finite_difference.h"
#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

constexpr double kFps = 24;

TriangleMesh head() {
    TriangleMesh mesh = sphere_mesh(8);
    for (Vec3f& p : mesh.positions) p = 9 * p + Vec3f(0, 150, 0);
    return mesh;
}

/// The head, turned and enlarged a little more in each frame.
TriangleMesh head_at(int frame) {
    TriangleMesh mesh = head();
    const Eigen::AngleAxisf turn(0.1f * float(frame), Vec3f(1, 2, 0.5f).normalized());
    for (Vec3f& p : mesh.positions) {
        const Vec3f d = p - Vec3f(0, 150, 0);
        p = turn * Vec3f(d * (1 + 0.02f * float(frame) * std::sin(d.y()))) +
            Vec3f(0.3f * float(frame * frame), 150, 0);
    }
    return mesh;
}

ScalpMotion deforming(const TemporaryFolder& folder) {
    for (int f = 0; f <= 6; ++f) {
        write_obj(folder / fmt::format("h{}.obj", f), head_at(f));
    }
    return MeshSequence({(folder / "h#.obj").string(), 0, 6, 1, kFps}, head());
}

ScalpMotion nodding() {
    return make_rigid_path({{0, {0, 0, 0}, {0, 0, 0}},
                            {40, {1, -2, 5}, {30, -20, 70}},
                            {60, {2, -1, 5}, {40, 10, 90}}},
                           {0, 140, 0}, kFps);
}

Vec3 barycentric(const std::array<Vec3, 3>& p, const MeshPoint& at) {
    return p[0] + double(at.u) * (p[1] - p[0]) + double(at.v) * (p[2] - p[0]);
}

RestRoot root_on(const TriangleMesh& mesh, const MeshPoint& at) {
    const auto& t = mesh.triangles[at.triangle];
    RestRoot root;
    root.point = at;
    root.pose.position = barycentric(
        {mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
         mesh.positions[t[2]].cast<double>()},
        at);
    root.pose.frame =
        Eigen::Quaterniond(0.3 + at.u, 0.5, -0.2, 0.7).normalized().toRotationMatrix();
    return root;
}

/// Some triangles with an area, none at the poles.
std::vector<MeshPoint> places() {
    return {{40, 0.2f, 0.3f}, {77, 0.5f, 0.1f}, {150, 0, 1}};
}

void expect_rates_of_pose(const ScalpMotion& motion, const RestRoot& root, double frame) {
    const RootMotion at = root_motion(scalp_at(motion, frame), root);
    const auto derivative = [&](auto&& of) {
        return (kFps *
                finite_difference(
                    [&](double f) { return of(root_motion(scalp_at(motion, f), root)); },
                    frame, 0.02))
            .eval();
    };
    // Turns are below 0.1 rad per frame and arms below 20 cm, so a fifth derivative is
    // about 2e-4 cm per frame^5 (the mesh's path is a cubic and has none) and truncation
    // at h = 0.02 is 1e-13 cm per frame. Round-off of 150 cm is 3 x 3e-14 / 0.02 cm per
    // frame: 1e-10 cm/s, and for speeds and rates at least 24 times that.
    EXPECT_LT(
        (derivative([](const RootMotion& m) { return m.pose.position; }) - at.velocity)
            .norm(),
        1e-8);
    EXPECT_LT(
        (derivative([](const RootMotion& m) { return m.velocity; }) - at.acceleration)
            .norm(),
        2e-7);
    EXPECT_LT((derivative([](const RootMotion& m) { return m.pose.frame; }) -
               hat<double>(at.angular_velocity) * at.pose.frame)
                  .norm(),
              1e-8);
    EXPECT_LT((derivative([](const RootMotion& m) { return m.angular_velocity; }) -
               at.angular_acceleration)
                  .norm(),
              2e-7);
    EXPECT_LT((at.pose.frame.transpose() * at.pose.frame - Mat3::Identity()).norm(),
              1e-14);
    EXPECT_NEAR(at.pose.frame.determinant(), 1, 1e-14);
    EXPECT_GT(at.velocity.norm(), 0.1);
    EXPECT_GT(at.angular_velocity.norm(), 0.01);
}

TEST(ScalpMotion, RatesOfARootMatchFiniteDifferencesOnARigidPath) {
    const ScalpMotion motion = nodding();
    for (const MeshPoint& at : places()) {
        for (const double f : {5.0, 20.0, 39.0, 53.0}) {
            expect_rates_of_pose(motion, root_on(head(), at), f);
        }
    }
}

TEST(ScalpMotion, RatesOfARootMatchFiniteDifferencesOnADeformingMesh) {
    const TemporaryFolder folder;
    const ScalpMotion motion = deforming(folder);
    for (const MeshPoint& at : places()) {
        for (const double f : {0.5, 2.3, 3.9, 5.3}) {
            expect_rates_of_pose(motion, root_on(head(), at), f);
        }
    }
}

TEST(ScalpMotion, RootsStayOnThePosedScalp) {
    const TemporaryFolder folder;
    const TriangleMesh rest = head();
    const ScalpMotion rigid = nodding(), deformed = deforming(folder);
    double worst = 0;
    for (const MeshPoint& at : places()) {
        const RestRoot root = root_on(rest, at);
        const auto& t = rest.triangles[at.triangle];
        for (double f = -1; f < 8; f += 0.37) {
            const ScalpTime r = scalp_at(rigid, 10 * f), d = scalp_at(deformed, f);
            std::array<Vec3, 3> rigid_corners, mesh_corners;
            for (std::size_t c = 0; c < 3; ++c) {
                rigid_corners[c] =
                    std::get<RigidMotion>(r).pose * rest.positions[t[c]].cast<double>();
                mesh_corners[c] = vertex_motion(std::get<MeshMotion>(d), t[c]).position;
            }
            worst = std::max(
                {worst,
                 (root_motion(r, root).pose.position - barycentric(rigid_corners, at))
                     .norm(),
                 (root_motion(d, root).pose.position - barycentric(mesh_corners, at))
                     .norm()});
            // The rendered mesh has these places rounded to float: half an ulp of 160 cm
            // in each coordinate.
            const TriangleMesh drawn = posed(r, rest);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_LT((drawn.positions[t[c]].cast<double>() - rigid_corners[c])
                              .cwiseAbs()
                              .maxCoeff(),
                          8e-6);
                EXPECT_LT(
                    (posed(d, rest).positions[t[c]].cast<double>() - mesh_corners[c])
                        .cwiseAbs()
                        .maxCoeff(),
                    8e-6);
            }
        }
    }
    EXPECT_LT(worst, 1e-12);
    RecordProperty("worst_distance_cm", fmt::format("{:g}", worst));
}

TEST(ScalpMotion, FrameTurnsWithItsTriangle) {
    // Relative to its triangle a root frame never changes. Tested on a rigidly turned
    // mesh by the angles of its tangent to both edges.
    const TemporaryFolder folder;
    const TriangleMesh rest = head();
    const Eigen::AngleAxisf turn(1.1f, Vec3f(1, 1, -1).normalized());
    TriangleMesh turned = rest;
    for (Vec3f& p : turned.positions) p = turn * p;
    write_obj(folder / "h0.obj", turned);
    const ScalpMotion motion =
        MeshSequence({(folder / "h#.obj").string(), 0, 0, 1, kFps}, rest);
    for (const MeshPoint& at : places()) {
        const RestRoot root = root_on(rest, at);
        const RootMotion now = root_motion(scalp_at(motion, 0), root);
        // Vertices rounded to float at 150 cm, 1.6e-5 in total, over edges of at least 1
        // cm.
        const Mat3 expected = turn.toRotationMatrix().cast<double>() * root.pose.frame;
        EXPECT_LT((now.pose.frame - expected).norm(), 1e-4);
    }
}

TEST(ScalpMotion, AtRestNothingMoves) {
    const TemporaryFolder folder;
    write_obj(folder / "h0.obj", head());
    const ScalpMotion still[] = {
        make_rigid_path({{0}}, {0, 140, 0}, kFps),
        MeshSequence({(folder / "h#.obj").string(), 0, 0, 1, kFps}, head())};
    for (const ScalpMotion& motion : still) {
        for (const MeshPoint& at : places()) {
            const RestRoot root = root_on(head(), at);
            const RootMotion now = root_motion(scalp_at(motion, 3.5), root);
            EXPECT_LT((now.pose.position - root.pose.position).norm(), 1e-13);
            EXPECT_LT((now.pose.frame - root.pose.frame).norm(), 1e-15);
            EXPECT_EQ(now.velocity, Vec3::Zero());
            EXPECT_EQ(now.angular_velocity, Vec3::Zero());
        }
        EXPECT_EQ(posed(scalp_at(motion, 0), head()).positions, head().positions);
    }
}

TEST(ScalpMotion, NamesATriangleWithoutArea) {
    const TemporaryFolder folder;
    TriangleMesh mesh = head_at(1);
    mesh.positions[mesh.triangles[40][1]] = mesh.positions[mesh.triangles[40][0]];
    write_obj(folder / "h0.obj", mesh);
    const ObjSequence files{(folder / "h#.obj").string(), 0, 0, 1, kFps};
    const ScalpTime now = scalp_at(MeshSequence(files, head()), 0);
    const std::string error =
        input_error([&] { root_motion(now, root_on(head(), places()[0])); });
    EXPECT_NE(error.find("h#.obj at frame 0: triangle 40"), std::string::npos) << error;
    const ScalpTime rest = scalp_at(MeshSequence(files, mesh), 0);
    EXPECT_NE(input_error([&] { root_motion(rest, root_on(head(), places()[0])); }), "");
}

TEST(ScalpMotion, RejectsRootsOffTheMesh) {
    const TemporaryFolder folder;
    const ScalpTime now = scalp_at(deforming(folder), 1);
    EXPECT_THROW(root_motion(now, {}), std::invalid_argument);
    EXPECT_THROW(root_motion(now, {{}, MeshPoint{999999, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(posed(now, square_mesh(1, 1)), std::invalid_argument);
    EXPECT_NO_THROW(root_motion(scalp_at(nodding(), 1), {}));
}

}  // namespace
}  // namespace lancret
