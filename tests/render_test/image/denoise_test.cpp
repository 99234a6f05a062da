#include "render_test/image/denoise.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <stdexcept>

#include "render_test/trace/render.h"
#include "tests/render_test/trace/hairy_ball.h"

namespace lancret {
namespace {

struct NoisyBall : HairyBall {
    NoisyBall() : HairyBall(48, 48, 1, 6000, 0.02f) { settings.channels.variance = true; }
    Image image(int samples, std::uint64_t seed) {
        settings.samples = samples, settings.seed = seed;
        return HairyBall::image();
    }
};

double colour_error(const Image& image, const Image& reference) {
    double squares = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        squares +=
            double((image.rgba[i] - reference.rgba[i]).head<3>().squaredNorm()) / 3;
    }
    return std::sqrt(squares / double(image.rgba.size()));
}

double light(const Image& image) {
    double sum = 0;
    for (const auto& pixel : image.rgba) sum += double(pixel.head<3>().sum());
    return sum;
}

TEST(Denoise, ReducesTheErrorOfAFewSamplesAndKeepsTheLight) {
    NoisyBall ball;
    const Image reference = ball.image(256, 1000);
    double noisy = 0, cleaned = 0, before = 0, after = 0;
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        Image image = ball.image(8, seed);
        noisy += colour_error(image, reference) / 3;
        before += light(image);
        denoise(image);
        cleaned += colour_error(image, reference) / 3;
        after += light(image);
    }
    RecordProperty("noisy", std::to_string(noisy));
    RecordProperty("cleaned", std::to_string(cleaned));
    RecordProperty("light", std::to_string(after / before));
    // Errors of the filter and its gain are means over 3 x 2304 pixels: their ratio
    // varies randomly by a few hundredths.
    EXPECT_LT(cleaned, 0.5 * noisy);
    EXPECT_NEAR(after / before, 1, 0.01);
}

TEST(Denoise, AlmostKeepsPicturesOfManySamples) {
    // Little noise leaves little to remove: the error added by the filter is at most that
    // of the given noise.
    NoisyBall ball;
    Image image = ball.image(128, 0);
    const Image before = image;
    double estimated = 0;
    for (const auto& variance : image.variance) {
        estimated += double(variance.head<3>().sum());
    }
    denoise(image);
    const double change = colour_error(image, before);
    EXPECT_LT(change, std::sqrt(estimated / 3 / double(image.rgba.size())));
    EXPECT_GT(change, 0);
}

/// A fully covered picture whose colour is a linear function of its guides.
Image linear_picture() {
    Image image(50, 40);
    image.variance.resize(image.rgba.size(), Eigen::Vector4f::Constant(1));
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 50; ++x) {
            const std::size_t i = std::size_t(y) * 50 + x;
            const float a = 0.3f * float(x), b = 0.2f * float(y);
            image.normal[i] = Vec3f(std::cos(a), std::sin(a), 0);
            image.tangent[i] = Vec3f(0, std::cos(b), std::sin(b));
            image.depth[i] = 10;
            image.rgba[i] << 2 + image.normal[i].x(), 2 + image.tangent[i].z(),
                3 - image.normal[i].y(), 1;
        }
    }
    return image;
}

TEST(Denoise, KeepsWhatTheGuidesExplain) {
    Image image = linear_picture();
    const Image before = image;
    denoise(image, {.ridge = 1e-6f});
    // Everything is declared noise, so nothing is added back. Least squares find the
    // function, except for the ridge, 1e-6 of slopes whose guides have a spread of some
    // hundredths in a window, and for single precision times the condition, which is as
    // large.
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        EXPECT_LT((image.rgba[i] - before.rgba[i]).cwiseAbs().maxCoeff(), 2e-3f);
    }
}

TEST(Denoise, NoNoiseIsNoChange) {
    NoisyBall ball;
    Image image = ball.image(2, 0);
    for (auto& variance : image.variance) variance.setZero();
    const Image before = image;
    denoise(image);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        // filtered + (colour - filtered): two roundings.
        EXPECT_LT((image.rgba[i] - before.rgba[i]).cwiseAbs().maxCoeff(),
                  1e-6f * (1 + before.rgba[i].maxCoeff()));
    }
}

TEST(Denoise, KeepsCoverageAndAddsNoLightWithoutIt) {
    NoisyBall ball;
    Image image = ball.image(4, 3);
    const Image before = image;
    denoise(image);
    int empty = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        ASSERT_TRUE(image.rgba[i].allFinite());
        EXPECT_GE(image.rgba[i].minCoeff(), 0);
        EXPECT_EQ(image.rgba[i].w(), before.rgba[i].w());
        if (image.rgba[i].w() > 0) continue;
        ++empty;
        EXPECT_EQ(image.rgba[i].head<3>(), Eigen::Vector3f::Zero());
    }
    EXPECT_GT(empty, 100);
}

TEST(Denoise, SameBitsForAnyNumberOfThreads) {
    NoisyBall ball;
    const Image noisy = ball.image(2, 0);
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          threads);
        Image image = noisy;
        denoise(image);
        return image.rgba;
    };
    EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(Denoise, NeedsTheVariance) {
    Image image(2, 2);
    EXPECT_THROW(denoise(image), std::invalid_argument);
}

TEST(Denoise, OnePixelIsAPicture) {
    Image image(1, 1);
    image.variance.resize(1, Eigen::Vector4f::Zero());
    image.rgba[0] << 0.5f, 0.25f, 0, 1;
    denoise(image);
    EXPECT_NEAR(image.rgba[0].x(), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace lancret
