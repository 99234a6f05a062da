#include "render_test/trace/render.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <vector>

#include "tests/render_test/trace/hairy_ball.h"

namespace lancret {
namespace {

struct SmallBall : HairyBall {
    SmallBall() : HairyBall(50, 41, 4) {}
};

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Render, SameBitsForAnyNumberOfThreads) {
    const SmallBall groom;
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          threads);
        return groom.image();
    };
    const Image one = with_threads(1), two = with_threads(2), four = with_threads(4);
    for (const Image* other : {&two, &four}) {
        EXPECT_TRUE(same_bits(one.rgba, other->rgba));
        EXPECT_TRUE(same_bits(one.depth, other->depth));
        EXPECT_TRUE(same_bits(one.normal, other->normal));
        EXPECT_TRUE(same_bits(one.tangent, other->tangent));
        EXPECT_TRUE(same_bits(one.id, other->id));
    }
}

TEST(Render, SeedChangesThePicture) {
    SmallBall groom;
    const Image first = groom.image();
    groom.settings.seed = 1;
    EXPECT_FALSE(same_bits(first.rgba, groom.image().rgba));
}

TEST(Render, LayersDescribeThePixel) {
    const SmallBall groom;
    const Image image = groom.image();
    const float nearest =
        (groom.geometry.bounds().center() - groom.camera.position).norm() - 25;
    int strands = 0, meshes = 0, nothing = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        ASSERT_TRUE(image.rgba[i].allFinite());
        ASSERT_GE(image.rgba[i].minCoeff(), 0);
        ASSERT_LE(image.rgba[i].w(), 1);
        if (image.rgba[i].w() == 0) {
            EXPECT_EQ(image.id[i], kNothingId);
            EXPECT_EQ(image.depth[i], 0);
            EXPECT_EQ(image.rgba[i].head<3>(), Eigen::Vector3f::Zero());
            continue;
        }
        EXPECT_GT(image.depth[i], nearest);
        EXPECT_LT(image.normal[i].norm(), 1.0001f);
        EXPECT_LT(image.tangent[i].norm(), 1.0001f);
        nothing += image.id[i] == kNothingId;
        meshes += image.id[i] == kMeshId;
        strands += image.id[i] < 1500;
        EXPECT_TRUE(image.id[i] < 1500 || image.id[i] >= kMeshId);
    }
    EXPECT_GT(strands, 200);
    EXPECT_GT(meshes, 20);
    EXPECT_GT(nothing, 20);  // the first sample of a pixel at the edge
}

TEST(Render, BrokenStrandsNeitherCrashNorSpoilThePicture) {
    SmallBall groom;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const std::uint32_t per = groom.curves.points_of(0);
    const auto spoil = [&](std::uint32_t strand, const auto& change) {
        for (std::uint32_t j = 0; j < per; ++j) {
            change(groom.curves.points[std::size_t(strand) * per + j], j);
        }
    };
    // The strands in front, and one of each fault per six strands.
    for (std::uint32_t i = 0; i < 1500; ++i) {
        spoil(i, [&](Point4f& p, std::uint32_t j) {
            if (i % 6 == 0 && j == 7) p.x = nan;
            if (i % 6 == 1 && j == 7) p.w = nan;
            if (i % 6 == 2 && j == 7) p.y = infinity;
            if (i % 6 == 3) p.w = 0;
            if (i % 6 == 4) p = groom.curves.points[std::size_t(i) * per];
        });
    }
    groom.geometry = HairScene(groom.curves, &groom.mesh);
    const Image image = groom.image();
    int strands = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        EXPECT_TRUE(image.rgba[i].allFinite() && image.normal[i].allFinite() &&
                    image.tangent[i].allFinite() && std::isfinite(image.depth[i]));
        if (image.id[i] >= kMeshId) continue;
        ++strands;
        EXPECT_NE(image.id[i] % 6, 3u);  // no radius, nothing to hit
    }
    EXPECT_GT(strands, 100);
}

TEST(Render, ProgressiveEndsInTheSameBitsAfterDoublings) {
    SmallBall groom;
    groom.settings.samples = 6;
    const Image at_once = groom.image();
    std::vector<int> shown;
    Image last;
    render_progressively(groom.scene, groom.camera, groom.settings,
                         [&](const Image& image, int samples) {
                             shown.push_back(samples);
                             last = image;
                             RenderSettings so_far = groom.settings;
                             so_far.samples = samples;
                             const Image same = render(groom.scene, groom.camera, so_far);
                             EXPECT_TRUE(same_bits(image.rgba, same.rgba)) << samples;
                         });
    EXPECT_EQ(shown, (std::vector<int>{1, 2, 4, 6}));
    EXPECT_TRUE(same_bits(last.rgba, at_once.rgba));
    EXPECT_TRUE(same_bits(last.depth, at_once.depth));
    EXPECT_TRUE(same_bits(last.normal, at_once.normal));
    EXPECT_TRUE(same_bits(last.tangent, at_once.tangent));
    EXPECT_TRUE(same_bits(last.id, at_once.id));
}

TEST(Render, ProgressCountsTheRays) {
    SmallBall groom;
    groom.scene.lights = Lights();  // nothing shines: no shadow rays
    groom.settings.path.max_depth = 1;
    std::uint64_t rays = 0;
    const Image image =
        render(groom.scene, groom.camera, groom.settings,
               [&](const RenderProgress& progress) { rays = progress.rays; });
    // One from the camera, and one more for every path that hits something.
    double paths = 50 * 41 * 4;
    for (const Eigen::Vector4f& pixel : image.rgba) paths += 4 * double(pixel.w());
    // A Lambert direction of density zero would end a path early: none occurs here.
    EXPECT_EQ(double(rays), paths);
}

TEST(Render, RougherLaterHairLeavesTheFirstScatteringUnchanged) {
    SmallBall groom;
    const Image plain = groom.image();
    groom.scene.later_hair = HairModel(roughened(HairMaterial{}, 0.5f));
    EXPECT_FALSE(same_bits(plain.rgba, groom.image().rgba));
    groom.settings.path.max_depth = 1;
    const Image wide = groom.image();
    groom.scene.later_hair.reset();
    EXPECT_TRUE(same_bits(wide.rgba, groom.image().rgba));
}

TEST(Render, EnvironmentIsShownOnRequestAndThenCoversAll) {
    SmallBall groom;
    groom.scene.lights = Lights(Environment(Vec3f(0.25f, 0.5f, 0.75f)));
    groom.settings.path.show_environment = true;
    const Image image = groom.image();
    for (const Eigen::Vector4f& pixel : image.rgba) EXPECT_EQ(pixel.w(), 1);
    EXPECT_EQ(image.rgba[0].head<3>(), Eigen::Vector3f(0.25f, 0.5f, 0.75f));
}

TEST(Render, ProgressEndsAtOneAndNeverFalls) {
    const SmallBall groom;
    double last = 0;
    int calls = 0;
    render(groom.scene, groom.camera, groom.settings, [&](const RenderProgress& p) {
        EXPECT_GT(p.done, last);
        last = p.done;
        ++calls;
    });
    EXPECT_EQ(last, 1);
    EXPECT_EQ(calls, 4 * 3);  // tiles of 16 x 16 over 50 x 41
}

TEST(Render, RefusesSettingsOutOfRange) {
    SmallBall groom;
    groom.settings.samples = 0;
    EXPECT_THROW(groom.image(), std::invalid_argument);
    groom.settings.samples = 1;
    groom.settings.width = 0;
    EXPECT_THROW(groom.image(), std::invalid_argument);
    groom.settings.width = 8;
    groom.scene.geometry = nullptr;
    EXPECT_THROW(groom.image(), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
