// Deep images, read back from their file and composited as by other software.

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineInputFile.h>
#include <ImfHeader.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <bit>
#include <cmath>

#include "guides/base/errors.h"
#include "render_test/files/deep_exr.h"
#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

struct DeepBall {
    Curves curves = hairy_sphere(1500, 8, 0.03f);
    TriangleMesh mesh = sphere_mesh(32, 16);
    std::vector<float> true_radii;
    HairScene geometry{curves, &mesh};
    RenderScene scene;
    Camera camera = framed(geometry.bounds(), {});
    /// A depth within the groom, in front of the ball.
    float cut = camera.focus_distance - 10;
    RenderSettings settings;

    DeepBall() {
        scene.geometry = &geometry;
        scene.lights = default_lights(camera.view(), Vec3f::UnitY());
        settings.width = 40, settings.height = 31, settings.samples = 16;
        settings.channels.deep = true;
    }
    /// Strands a third as wide as drawn, which cover by a third.
    void thin() {
        true_radii.assign(curves.points.size(), 0.01f);
        geometry = HairScene(curves, &mesh, {.true_radii = true_radii});
    }
    Image image() const { return render(scene, camera, settings); }
};

/// "Over" of points from near to far.
Eigen::Vector4f flattened(std::span<const DeepPoint> points) {
    Eigen::Vector4f out = Eigen::Vector4f::Zero();
    for (const DeepPoint& point : points) out += (1 - out.w()) * point.rgba;
    return out;
}

fs::path written_deep(const Image& image) {
    const fs::path path = fs::path(testing::TempDir()) / "lancret_deep.exr";
    write_deep_exr(path, image);
    return path;
}

/// The samples of every pixel of a file, near to far; checks that ZBack equals Z.
std::vector<std::vector<DeepPoint>> read_deep(const fs::path& path) {
    Imf::DeepScanLineInputFile file(path.c_str());
    const auto& box = file.header().dataWindow();
    const int width = box.max.x + 1, height = box.max.y + 1;
    const std::size_t pixels = std::size_t(width) * height;
    std::vector<unsigned> counts(pixels);
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), 4, 4 * width));
    const char* const names[] = {"R", "G", "B", "A", "Z", "ZBack", "id"};
    std::array<std::vector<char*>, 7> pointers;
    for (std::size_t c = 0; c < 7; ++c) {
        pointers[c].resize(pixels);
        frame.insert(names[c], Imf::DeepSlice(c < 6 ? Imf::FLOAT : Imf::UINT,
                                              reinterpret_cast<char*>(pointers[c].data()),
                                              sizeof(char*), sizeof(char*) * width, 4));
    }
    file.setFrameBuffer(frame);
    file.readPixelSampleCounts(0, height - 1);
    std::array<std::vector<std::vector<float>>, 7> values;
    for (std::size_t c = 0; c < 7; ++c) {
        values[c].resize(pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            values[c][i].resize(counts[i]);
            pointers[c][i] = reinterpret_cast<char*>(values[c][i].data());
        }
    }
    file.readPixels(0, height - 1);
    std::vector<std::vector<DeepPoint>> out(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (unsigned s = 0; s < counts[i]; ++s) {
            DeepPoint point;
            point.rgba << values[0][i][s], values[1][i][s], values[2][i][s],
                values[3][i][s];
            point.depth = values[4][i][s];
            EXPECT_EQ(values[5][i][s], point.depth);
            point.id = std::bit_cast<std::uint32_t>(values[6][i][s]);
            out[i].push_back(point);
        }
    }
    return out;
}

/// The light of each sample is rounded to half precision, by at most 2^-11 of it, and so
/// is its coverage; below the normal halves the step is 2^-25. The rounded coverage is
/// taken into account when samples behind are rounded.
float half_bound(float value, std::size_t samples) {
    return value * 0x1p-11f * 1.01f + float(samples) * 0x1p-25f + 1e-6f;
}

void expect_flat(const Image& image, std::size_t least_of_most) {
    const auto deep = read_deep(written_deep(image));
    std::size_t most = 0;
    for (std::size_t i = 0; i < deep.size(); ++i) {
        const Eigen::Vector4f flat = flattened(deep[i]);
        for (int c = 0; c < 4; ++c) {
            EXPECT_NEAR(flat[c], image.rgba[i][c],
                        half_bound(image.rgba[i][c], deep[i].size()));
        }
        most = std::max(most, deep[i].size());
    }
    EXPECT_GE(most, least_of_most);
}

TEST(ImageDeep, FlattensToThePicture) { expect_flat(DeepBall().image(), 5); }

TEST(ImageDeep, FlattensToThePictureOfThinStrands) {
    DeepBall ball;
    ball.thin();
    const Image image = ball.image();
    int partly = 0;
    for (const auto& pixel : image.rgba) partly += pixel.w() > 0.2f && pixel.w() < 0.8f;
    EXPECT_GT(partly, 50);
    expect_flat(image, 5);
}

TEST(ImageDeep, SamplesAreTidy) {
    const Image image = DeepBall().image();
    for (const auto& pixel : read_deep(written_deep(image))) {
        for (std::size_t s = 0; s < pixel.size(); ++s) {
            EXPECT_TRUE(pixel[s].rgba.allFinite());
            EXPECT_GT(pixel[s].depth, s > 0 ? pixel[s - 1].depth : 0.0f);
            EXPECT_GE(pixel[s].rgba.minCoeff(), 0);
            EXPECT_LE(pixel[s].rgba.w(), 1);
            EXPECT_TRUE(pixel[s].id < 1500 || pixel[s].id == kMeshId);
        }
    }
}

TEST(ImageDeep, TwoHalvesAtADepthComposeToTheWhole) {
    const DeepBall ball;
    const Image image = ball.image();
    int parted = 0;
    for (const auto& pixel : read_deep(written_deep(image))) {
        std::vector<DeepPoint> near, far;
        for (const DeepPoint& p : pixel) (p.depth < ball.cut ? near : far).push_back(p);
        parted += !near.empty() && !far.empty();
        const Eigen::Vector4f front = flattened(near);
        const Eigen::Vector4f composed = front + (1 - front.w()) * flattened(far);
        // The same product in another order: a few roundings of a float.
        EXPECT_LT((composed - flattened(pixel)).cwiseAbs().maxCoeff(),
                  1e-6f * (1 + composed.maxCoeff()));
    }
    EXPECT_GT(parted, 50);
}

TEST(ImageDeep, PointsInFrontOfACardKeepTheirCoverage) {
    const DeepBall ball;
    const Image image = ball.image();
    const auto deep = read_deep(written_deep(image));
    for (std::size_t i = 0; i < deep.size(); ++i) {
        float before = 0;
        for (const DeepSample& s : image.deep[i]) {
            before += s.depth < ball.cut ? s.coverage : 0;
        }
        std::vector<DeepPoint> near;
        for (const DeepPoint& p : deep[i]) {
            if (p.depth < ball.cut) near.push_back(p);
        }
        EXPECT_NEAR(flattened(near).w(), before, half_bound(before, near.size()));
    }
}

TEST(ImageDeep, SameBitsForAnyNumberOfThreads) {
    const DeepBall ball;
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          threads);
        return ball.image();
    };
    const Image one = with_threads(1), four = with_threads(4);
    for (std::size_t i = 0; i < one.deep.size(); ++i) {
        ASSERT_EQ(one.deep[i].size(), four.deep[i].size());
        for (std::size_t s = 0; s < one.deep[i].size(); ++s) {
            EXPECT_EQ(one.deep[i][s].id, four.deep[i][s].id);
            EXPECT_EQ(one.deep[i][s].depth, four.deep[i][s].depth);
            EXPECT_EQ(one.deep[i][s].radiance, four.deep[i][s].radiance);
        }
    }
}

TEST(Deep, SamplesOfOneStrandAreJoinedOnlyAcrossSmallGaps) {
    std::vector<DeepSample> samples{{5, 10.3f, 0.25f, Vec3f(1, 0, 0)},
                                    {5, 10.0f, 0.25f, Vec3f(2, 0, 0)},
                                    {6, 10.1f, 0.25f, Vec3f(4, 0, 0)},
                                    {5, 12.0f, 0.25f, Vec3f(8, 0, 0)}};
    merge(samples, 0.05f);
    ASSERT_EQ(samples.size(), 3u);
    EXPECT_EQ(samples[0].coverage, 0.5f);
    EXPECT_EQ(samples[0].radiance.x(), 3);
    EXPECT_NEAR(samples[0].depth, 10.15f, 2e-6f);
    EXPECT_EQ(samples[1].depth, 12.0f);
    EXPECT_EQ(samples[2].id, 6u);
}

TEST(Deep, ABrightSampleBehindAnAlmostFullPixelIsNotLost) {
    // The remainder of the front's coverage is less than a step of half precision.
    const std::vector<DeepSample> samples{{1, 5, 0.9999f, Vec3f(1, 1, 1)},
                                          {2, 9, 0.0001f, Vec3f(5, 5, 5)}};
    std::vector<DeepPoint> points;
    composited(samples, points);
    EXPECT_NEAR(flattened(points).x(), 6, 6 * 0x1p-11f);
}

TEST(Deep, EqualDepthsAreSetApart) {
    std::vector<DeepPoint> points;
    composited(std::vector<DeepSample>(3, {1, 5, 0.2f, Vec3f(1, 1, 1)}), points);
    EXPECT_LT(points[0].depth, points[1].depth);
    EXPECT_LT(points[1].depth, points[2].depth);
}

TEST(ImageDeep, RefusesOtherExtensionsAndPicturesWithoutSamples) {
    EXPECT_THROW(write_deep_exr("a.png", Image(2, 2)), InputError);
    EXPECT_THROW(write_deep_exr("a.exr", Image(2, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
