#include "render_test/scene/smooth_normals.h"

#include <gtest/gtest.h>

#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr float kCrease = 1.05f;

/// A cube from -1 to 1, facing outward.
TriangleMesh cube() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

TEST(SmoothNormals, OfASphereAreRadialAcrossItsSeamToo) {
    const TriangleMesh mesh = sphere_mesh(24, 12);
    const CornerNormals normals = corner_normals(mesh.triangles, mesh.positions, kCrease);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const Vec3f radial = mesh.positions[mesh.triangles[t][k]].normalized();
            // Triangles without area at a pole have no normal.
            if (normals[t][k].isZero()) {
                EXPECT_GT(std::abs(radial.y()), 0.9f);
                continue;
            }
            // The triangles on both sides of a vertex differ slightly, by the square of a
            // cell's angle of 0.26.
            EXPECT_LT((normals[t][k] - radial).norm(), 0.07f) << t;
        }
    }
}

TEST(SmoothNormals, SharpEdgesStay) {
    const TriangleMesh mesh = cube();
    const CornerNormals normals = corner_normals(mesh.triangles, mesh.positions, kCrease);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3f face = (mesh.positions[b] - mesh.positions[a])
                               .cross(mesh.positions[c] - mesh.positions[a])
                               .normalized();
        for (const Vec3f& n : normals[t]) EXPECT_LT((n - face).norm(), 1e-6f);
    }
    // Below the crease angle edges are rounded: the corner of a cube then has the
    // direction of the diagonal, since three right angles meet there however the faces
    // are cut.
    const CornerNormals round = corner_normals(mesh.triangles, mesh.positions, 1.6f);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_LT(
                (round[t][k] - mesh.positions[mesh.triangles[t][k]].normalized()).norm(),
                1e-6f);
        }
    }
}

TEST(SmoothNormals, AFanOfManyTrianglesTakesNoLonger) {
    TriangleMesh fan;
    constexpr std::uint32_t kMany = 200000;
    fan.positions.emplace_back(0, 0, 1);
    for (std::uint32_t i = 0; i < kMany; ++i) {
        const double a = 2 * M_PI * i / kMany;
        fan.positions.emplace_back(float(std::cos(a)), float(std::sin(a)), 0);
        fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % kMany});
    }
    const CornerNormals normals = corner_normals(fan.triangles, fan.positions, kCrease);
    // A cone: at its apex the mean is its axis. Angles of 1e-5 from differences of
    // positions near one are accurate to 6e-8 / 3e-5 each, and the errors average out.
    EXPECT_LT((normals[0][0] - Vec3f::UnitZ()).norm(), 1e-3f);
}

TEST(SmoothNormals, HitsOfASphereHaveItsNormalAndStartOnIt) {
    const TriangleMesh mesh = sphere_mesh(48, 24);
    const Curves none = curves_through({}, 0.1f);
    const HairScene scene(none, &mesh, {.crease = kCrease});
    const HairScene facets(none, &mesh);
    double flat = 0, smooth = 0, below = 0, lifted = 0;
    for (int i = 0; i < 400; ++i) {
        Ray ray;
        ray.origin =
            Vec3f(0.37f * float(i % 20) - 3.5f, 0.35f * float(i / 20) - 3.3f, 40);
        ray.direction = -Vec3f::UnitZ();
        const auto hit = scene.intersect(ray), facet = facets.intersect(ray);
        ASSERT_TRUE(hit && facet);
        const Vec3f radial = hit->position.normalized();
        smooth = std::max<double>(smooth, (hit->shading_normal - radial).norm());
        flat = std::max<double>(flat, (facet->shading_normal - radial).norm());
        EXPECT_EQ(hit->normal, facet->normal);
        EXPECT_EQ(facet->mesh.lift, Vec3f::Zero());
        below += 9 - hit->position.norm();
        lifted += std::abs(9 - (hit->position + hit->mesh.lift).norm());
    }
    // Facets are off by up to the half diagonal of a cell, 0.09 radian; interpolated
    // normals by its square and the error of the vertex normals.
    EXPECT_GT(flat, 0.06);
    EXPECT_LT(smooth, 0.015);
    EXPECT_LT(lifted, 0.3 * below);
}

Image even_sky(const TriangleMesh& mesh, const HairSceneOptions& options,
               const std::optional<Camera>& camera = {}) {
    const Curves none = curves_through({}, 0.1f);
    const HairScene geometry(none, &mesh, options);
    RenderScene scene;
    scene.geometry = &geometry;
    scene.mesh.colour = Vec3f::Ones();
    scene.lights = Lights(Environment(Vec3f::Ones()));
    RenderSettings settings;
    settings.width = settings.height = 40;
    settings.samples = 32;
    settings.path.max_depth = 100000;
    return render(scene, camera ? *camera : framed(geometry.bounds(), {}), settings);
}

TEST(SmoothNormals, AWhiteBallOfFewFacetsInAnEvenSkyLosesNothing) {
    // Light that a smooth normal sends into the facets hits them again and is scattered.
    const TriangleMesh mesh = sphere_mesh(10, 6);
    const Image image = even_sky(mesh, {.crease = kCrease});
    Mean mean;
    for (const Eigen::Vector4f& pixel : image.rgba) {
        if (pixel.w() == 1) mean.add(pixel.x());
    }
    EXPECT_GT(mean.count, 500);
    EXPECT_LT(mean.error(), 2e-3);
    EXPECT_NEAR(mean.value(), 1, kSigmas * mean.error() + 1e-5);
}

TEST(SmoothNormals, NoLightLeaksIntoAClosedMesh) {
    // A camera inside a ball, where the sky is invisible.
    const TriangleMesh mesh = sphere_mesh(10, 6);
    Camera camera;
    camera.position = Vec3f(1, 2, 0);
    const Curves none = curves_through({}, 0.1f);
    const HairScene geometry(none, &mesh, {.crease = kCrease});
    RenderScene scene;
    scene.geometry = &geometry;
    scene.mesh.colour = Vec3f::Constant(0.8f);
    scene.lights = Lights(Environment(Vec3f::Ones()));
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samples = 16;
    const Image image = render(scene, camera, settings);
    double sum = 0;
    for (const Eigen::Vector4f& pixel : image.rgba) {
        EXPECT_EQ(pixel.w(), 1);
        sum += pixel.x();
    }
    // A ray that starts within a rounding of an edge may pass between two triangles.
    EXPECT_LT(sum / double(image.rgba.size()), 1e-4);
}

TEST(SmoothNormals, TheTerminatorIsThatOfASphere) {
    // A ball of 24 x 12 facets, lit from the right by a small distant light: it shows the
    // cosine of the smooth normal up to the terminator, without dark facets before it. On
    // a sphere of that radius the irradiance at the visible point is cos+.
    const TriangleMesh mesh = sphere_mesh(24, 12);
    const Curves none = curves_through({}, 0.1f);
    const HairScene geometry(none, &mesh, {.crease = kCrease});
    for (int i = 0; i < 200; ++i) {
        Ray ray;
        const float a = 1.3f + 0.26f * float(i % 20) / 20;  // from the light's direction
        const float b = 2 * float(i / 20) / 10 - 1;
        const Vec3f d(std::cos(a), std::sin(a) * std::sin(b), std::sin(a) * std::cos(b));
        ray.origin = 30 * d, ray.direction = -d;
        const auto hit = geometry.intersect(ray);
        ASSERT_TRUE(hit);
        if (hit->shading_normal.x() < 0.03f) continue;
        const Ray shadow = ray_from(*hit, hit->shading_normal, Vec3f::UnitX(), 0);
        EXPECT_FALSE(geometry.occluded(shadow)) << a << ' ' << b;
    }
}

}  // namespace
}  // namespace lancret
