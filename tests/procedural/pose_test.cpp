#include "procedural/pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "procedural/generator.h"
#include "tests/guides/meshes.h"
#include "tests/guides/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// A made head of 60 strands, 20 guides and 400 children.
const Generator& small_groom() {
    static const Generator generator = [] {
        Groom groom;
        groom.name = "small";
        groom.made.strands = 60;
        groom.guides.number = 20;
        groom.fit.segments = 8;
        groom.strands = 400;
        return make_generator(groom);
    }();
    return generator;
}

const RigidPose kMoved{
    Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(),
    Vec3(40, -7, 12)};

Guides moved(Guides guides, const RigidPose& pose) {
    for (Vec3& root : guides.root_positions) root = pose * root;
    for (Mat3& frame : guides.root_frames) frame = pose.rotation * frame;
    return guides;
}

/// The children of guides at a pose.
Curves children(const Generator& rest, const Guides& guides, const ScalpPose& pose,
                Blend blend) {
    Binding binding = rest.binding;
    pose_binding(binding, rest_places(rest.binding, rest.source), pose);
    return expand(binding, guide_profiles<float>(guides, rest.profiles.count),
                  {.blend = blend});
}

/// The largest distance of `posed` from the image of `rest`.
double distance_from_image(const Curves& rest, const Curves& posed,
                           const RigidPose& pose) {
    double largest = 0;
    for (std::size_t i = 0; i < rest.points.size(); ++i) {
        const Vec3 image = pose * rest.points[i].xyz().cast<double>();
        largest =
            std::max(largest, (posed.points[i].xyz().cast<double>() - image).norm());
    }
    return largest;
}

TEST(Pose, RigidMotionOfEverythingMovesTheChildrenRigidly) {
    const Generator& g = small_groom();
    const Guides guides = moved(g.source.guides, kMoved);
    for (const Blend blend : {Blend::option1, Blend::position}) {
        const Curves rest = expand(g.binding, g.profiles, {.blend = blend});
        const Curves posed = children(g, guides, kMoved, blend);
        const double off = distance_from_image(rest, posed, kMoved);
        // Single-precision frames are good to 5e-7, those of the guides at rest and
        // turned as those of the children: up to 36 cm from the root, 4 * 5e-7 * 36 cm.
        // Places some 80 cm away round by 2^-24 of that.
        EXPECT_LE(off, 8e-5);
    }
}

TEST(Pose, PosesDoNotAddUp) {
    const Generator& g = small_groom();
    const RestPlaces rest = rest_places(g.binding, g.source);
    Binding binding = g.binding;
    for (int i = 0; i < 3; ++i) pose_binding(binding, rest, kMoved);
    EXPECT_NE(binding.roots.positions, g.binding.roots.positions);
    const std::vector<Vec3> roots = pose_binding(binding, rest, RigidPose{});
    EXPECT_EQ(binding.roots.positions, g.binding.roots.positions);
    EXPECT_EQ(binding.roots.normals, g.binding.roots.normals);
    EXPECT_EQ(binding.guide_normals, g.binding.guide_normals);
    EXPECT_EQ(roots, g.source.guides.root_positions);
}

TEST(Pose, TheRestMeshIsTheRestPose) {
    const Generator& g = small_groom();
    Binding binding = g.binding;
    const std::vector<Vec3> roots = pose_binding(
        binding, rest_places(g.binding, g.source), ScalpPose(g.source.scalp->mesh));
    EXPECT_EQ(binding.roots.positions, g.binding.roots.positions);
    EXPECT_EQ(binding.roots.normals, g.binding.roots.normals);
    EXPECT_EQ(binding.guide_normals, g.binding.guide_normals);
    // A place keeps its (u, v) in floats, 6e-8 of an edge of less than 10 cm, and the
    // closest point is found in them.
    ASSERT_EQ(roots.size(), g.source.guides.size());
    for (std::size_t i = 0; i < roots.size(); ++i)
        EXPECT_LE((roots[i] - g.source.guides.root_positions[i]).norm(), 1e-5);
}

TEST(Pose, AMeshThatStretchesTakesRootsAndNormalsAlong) {
    // z = 0.5 x over a square: every root rises by half its x, normals lean by (-1, 0,
    // 2).
    const Generator& g = small_groom();
    TriangleMesh sheared = g.source.scalp->mesh;
    for (Vec3f& p : sheared.positions) p.z() += 0.5f * p.x();
    Binding binding = g.binding;
    pose_binding(binding, rest_places(g.binding, g.source), ScalpPose(sheared));
    const Scalp scalp = make_scalp(sheared);
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const Vec3f& rest = g.binding.roots.positions[i];
        const Vec3f expected = rest + Vec3f(0, 0, 0.5f * rest.x());
        // A shear is linear: it acts on a place between corners as on the corners. What
        // is left is the floats' round-off, some 2^-24 of 20 cm for each corner.
        EXPECT_LE((binding.roots.positions[i] - expected).norm(), 1e-5);
        const Vec3 normal = scalp_normal(scalp, g.binding.roots.places[i]);
        EXPECT_LE((binding.roots.normals[i].cast<double>() - normal).norm(), 1e-6);
    }
}

TEST(Pose, ARigidlyMovedMeshIsARigidPose) {
    const Generator& g = small_groom();
    const Guides guides = moved(g.source.guides, kMoved);
    const TriangleMesh mesh = posed_mesh(g.source.scalp->mesh, kMoved);
    const RestPlaces rest = rest_places(g.binding, g.source);
    Binding rigid = g.binding, meshed = g.binding;
    pose_binding(rigid, rest, kMoved);
    pose_binding(meshed, rest, ScalpPose(mesh));
    for (std::size_t i = 0; i < rigid.size(); ++i) {
        // Corners up to 60 cm away are good to 2^-24 of that; normals follow edges of
        // about a centimetre.
        EXPECT_LE((rigid.roots.positions[i] - meshed.roots.positions[i]).norm(), 2e-5);
        EXPECT_LE((rigid.roots.normals[i] - meshed.roots.normals[i]).norm(), 1e-4);
    }
    for (std::size_t i = 0; i < guides.size(); ++i)
        EXPECT_LE((rigid.guide_normals[i] - meshed.guide_normals[i]).norm(), 1e-4);
}

TEST(Pose, FollowsAHeadOnAPathOfKeys) {
    const RigidPath path =
        make_rigid_path({{1, Vec3::Zero(), Vec3::Zero()}, {5, {3, 0, 1}, {0, 80, 0}}},
                        Vec3(0, -10, 0), 24);
    const ScalpMotion motion = path;
    const ScalpPose pose = scalp_pose(scalp_at(motion, 4));
    const RigidPose& rigid = std::get<RigidPose>(pose);
    const Generator& g = small_groom();
    Binding binding = g.binding;
    pose_binding(binding, rest_places(g.binding, g.source), pose);
    const RestRoot rest{{Mat3::Identity(), g.binding.roots.positions[5].cast<double>()},
                        {}};
    const RootMotion moved_root = root_motion(scalp_at(motion, 4), rest);
    // Rounded to floats of at most 20 cm.
    EXPECT_LE(
        (binding.roots.positions[5].cast<double>() - moved_root.pose.position).norm(),
        2e-6);
    EXPECT_GT((rigid.rotation - Mat3::Identity()).norm(), 0.5);
}

TEST(Pose, RefusesAMeshOfAnotherShape) {
    const Generator& g = small_groom();
    Binding binding = g.binding;
    RestPlaces rest = rest_places(g.binding, g.source);
    const auto error = [&](const TriangleMesh& mesh) {
        return input_error([&] { pose_binding(binding, rest, ScalpPose(mesh)); });
    };
    EXPECT_THAT(error(square_mesh(4, 3)),
                HasSubstr("the posed scalp has 16 vertices and 18 triangles"));
    TriangleMesh mesh = g.source.scalp->mesh;
    mesh.positions[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(error(mesh), HasSubstr("nowhere"));
    rest.triangles = 0;
    EXPECT_THAT(error(mesh), HasSubstr("needs a scalp at rest"));
}

}  // namespace
}  // namespace lancret
