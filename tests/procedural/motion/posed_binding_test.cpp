#include "procedural/motion/posed_binding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "procedural/groom/ready_groom.h"
#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// A generated head with 60 strands, 20 guides and 400 children.
const ReadyGroom& small_groom() {
    static const ReadyGroom ready = make_ready_groom(
        test::small_groom({.made = 60, .guides = 20, .segments = 8, .strands = 400}));
    return ready;
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
Curves children(const ReadyGroom& rest, const Guides& guides, const ScalpPose& pose,
                Blend blend) {
    Binding binding = rest.binding;
    pose_binding(binding, rest_places(rest.binding, rest.placed), pose);
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
    const ReadyGroom& g = small_groom();
    const Guides guides = moved(g.placed.guides, kMoved);
    for (const Blend blend : {Blend::detail, Blend::position}) {
        const Curves rest = expand(g.binding, g.profiles, {.blend = blend});
        const Curves posed = children(g, guides, kMoved, blend);
        const double off = distance_from_image(rest, posed, kMoved);
        // Single-precision frames have errors up to 5e-7: four of them (guides and
        // children, at rest and moved) at up to 36 cm from the root, 4 * 5e-7 * 36 cm.
        // Places about 80 cm away round by 2^-24 of that.
        EXPECT_LE(off, 8e-5);
    }
}

TEST(Pose, InDoublePrecisionEveryBlendMovesRigidly) {
    const ReadyGroom& g = small_groom();
    Binding binding = g.binding;
    pose_binding(binding, rest_places(g.binding, g.placed), kMoved);
    const int n = g.profiles.count;
    const auto rest = guide_profiles<double>(g.placed.guides, n);
    const auto posed = guide_profiles<double>(moved(g.placed.guides, kMoved), n);
    std::vector<HelixState<double>> a(n + 1), b(n + 1);
    for (const BlendTraits& entry : blends()) {
        SCOPED_TRACE(entry.name);
        double largest = 0;
        for (std::size_t i = 0; i < binding.size(); ++i) {
            synthesize_child<double>(g.binding, rest, entry.blend, i, a);
            synthesize_child<double>(binding, posed, entry.blend, i, b);
            for (int j = 0; j <= n; ++j) {
                const Vec3 image = kMoved.rotation * a[j].position;
                largest = std::max(largest, (b[j].position - image).norm());
            }
        }
        // The scalp's normals are floats, the child's and each guide's, at rest and
        // moved: 6e-8 each. Their errors rotate a guide's root as a whole. Of the sums
        // in the blends, the guides' mean tangent is never shorter than 0.8 here, and
        // option 1's mean of normals amplifies a root's rotation by at most 8.
        const double once = 4 * 6e-8 / 0.8 * 36;
        EXPECT_LE(largest, entry.rates == BlendRates::blended ? 8 * once : once);
    }
}

TEST(Pose, PosesDoNotAccumulate) {
    const ReadyGroom& g = small_groom();
    const RestPlaces rest = rest_places(g.binding, g.placed);
    Binding binding = g.binding;
    for (int i = 0; i < 3; ++i) pose_binding(binding, rest, kMoved);
    EXPECT_NE(binding.roots.positions, g.binding.roots.positions);
    const std::vector<Vec3> roots = pose_binding(binding, rest, RigidPose{});
    EXPECT_EQ(binding.roots.positions, g.binding.roots.positions);
    EXPECT_EQ(binding.roots.normals, g.binding.roots.normals);
    EXPECT_EQ(binding.guide_normals, g.binding.guide_normals);
    EXPECT_EQ(roots, g.placed.guides.root_positions);
}

TEST(Pose, TheRestMeshIsTheRestPose) {
    const ReadyGroom& g = small_groom();
    Binding binding = g.binding;
    const std::vector<Vec3> roots = pose_binding(
        binding, rest_places(g.binding, g.placed), ScalpPose(g.placed.scalp->mesh));
    EXPECT_EQ(binding.roots.positions, g.binding.roots.positions);
    EXPECT_EQ(binding.roots.normals, g.binding.roots.normals);
    EXPECT_EQ(binding.guide_normals, g.binding.guide_normals);
    // A place stores (u, v) as floats, 6e-8 of an edge shorter than 10 cm, and the
    // closest point is computed in floats.
    ASSERT_EQ(roots.size(), g.placed.guides.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
        EXPECT_LE((roots[i] - g.placed.guides.root_positions[i]).norm(), 1e-5);
    }
}

TEST(Pose, RootsAndNormalsFollowAStretchedMesh) {
    // z = 0.5 x over a square: every root rises by half its x, and normals become
    // (-1, 0, 2).
    const ReadyGroom& g = small_groom();
    TriangleMesh sheared = g.placed.scalp->mesh;
    for (Vec3f& p : sheared.positions) p.z() += 0.5f * p.x();
    Binding binding = g.binding;
    pose_binding(binding, rest_places(g.binding, g.placed), ScalpPose(sheared));
    const Scalp scalp = make_scalp(sheared);
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const Vec3f& rest = g.binding.roots.positions[i];
        const Vec3f expected = rest + Vec3f(0, 0, 0.5f * rest.x());
        // A shear is linear, so it maps places between corners like the corners. What
        // remains is float round-off, about 2^-24 of 20 cm per corner.
        EXPECT_LE((binding.roots.positions[i] - expected).norm(), 1e-5);
        const Vec3 normal = scalp_normal(scalp, g.binding.roots.places[i]);
        EXPECT_LE((binding.roots.normals[i].cast<double>() - normal).norm(), 1e-6);
    }
}

TEST(Pose, ARigidlyMovedMeshIsARigidPose) {
    const ReadyGroom& g = small_groom();
    const Guides guides = moved(g.placed.guides, kMoved);
    const TriangleMesh mesh = posed_mesh(g.placed.scalp->mesh, kMoved);
    const RestPlaces rest = rest_places(g.binding, g.placed);
    Binding rigid = g.binding, meshed = g.binding;
    pose_binding(rigid, rest, kMoved);
    pose_binding(meshed, rest, ScalpPose(mesh));
    for (std::size_t i = 0; i < rigid.size(); ++i) {
        // Corners up to 60 cm away have errors of 2^-24 of that; normals are computed
        // from edges of about a centimetre.
        EXPECT_LE((rigid.roots.positions[i] - meshed.roots.positions[i]).norm(), 2e-5);
        EXPECT_LE((rigid.roots.normals[i] - meshed.roots.normals[i]).norm(), 1e-4);
    }
    for (std::size_t i = 0; i < guides.size(); ++i) {
        EXPECT_LE((rigid.guide_normals[i] - meshed.guide_normals[i]).norm(), 1e-4);
    }
}

TEST(Pose, FollowsAHeadOnAPathOfKeys) {
    const RigidPath path =
        make_rigid_path({{1, Vec3::Zero(), Vec3::Zero()}, {5, {3, 0, 1}, {0, 80, 0}}},
                        Vec3(0, -10, 0), 24);
    const ScalpMotion motion = path;
    const ScalpPose pose = scalp_pose(scalp_at(motion, 4));
    const RigidPose& rigid = std::get<RigidPose>(pose);
    const ReadyGroom& g = small_groom();
    Binding binding = g.binding;
    pose_binding(binding, rest_places(g.binding, g.placed), pose);
    const RestRoot rest{{Mat3::Identity(), g.binding.roots.positions[5].cast<double>()},
                        {}};
    const RootMotion moved_root = root_motion(scalp_at(motion, 4), rest);
    // Float round-off of at most 20 cm.
    EXPECT_LE(
        (binding.roots.positions[5].cast<double>() - moved_root.pose.position).norm(),
        2e-6);
    EXPECT_GT((rigid.rotation - Mat3::Identity()).norm(), 0.5);
}

TEST(Pose, RefusesAMeshOfAnotherShape) {
    const ReadyGroom& g = small_groom();
    Binding binding = g.binding;
    RestPlaces rest = rest_places(g.binding, g.placed);
    const auto error = [&](const TriangleMesh& mesh) {
        return input_error([&] { pose_binding(binding, rest, ScalpPose(mesh)); });
    };
    EXPECT_THAT(error(square_mesh(4, 3)),
                HasSubstr("the posed scalp has 16 vertices and 18 triangles"));
    TriangleMesh mesh = g.placed.scalp->mesh;
    mesh.positions[3].y() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(error(mesh), HasSubstr("not finite"));
    rest.triangles = 0;
    EXPECT_THAT(error(mesh), HasSubstr("needs a scalp at rest"));
}

}  // namespace
}  // namespace lancret
