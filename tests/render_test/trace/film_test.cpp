#include "render_test/trace/film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render_test/trace/render.h"
#include "tests/render_test/statistics.h"
#include "tests/render_test/trace/hairy_ball.h"

namespace lancret {
namespace {

PathResult path_of(float radiance, float coverage) {
    PathResult path;
    path.radiance = Vec3f(radiance, 2 * radiance, 0);
    path.coverage = coverage;
    return path;
}

void add(Film& film, const PathResult& path) { add_sample(film, 0, {.path = path}); }

TEST(Film, VarianceOfTheMeanIsThatOfItsSamplesOverTheirNumber) {
    Film film(1, 1, {.variance = true});
    // Far from zero relative to their spread: in float, the sum of squares less the
    // square of the sum would lose all digits.
    const float values[] = {1000, 1001, 1003, 1000};
    for (int s = 0; s < 4; ++s) add(film, path_of(values[s], s < 2));
    // Mean 1001, squares 1 + 0 + 4 + 1 = 6, over n (n - 1) = 12; coverage: mean 1/2,
    // squares 1. All sums and their differences are exact, except for quotients by 6 and
    // 12: three roundings.
    const Eigen::Vector4f variance = variance_of_mean(film, 0);
    EXPECT_NEAR(variance.x(), 0.5f, 3 * 6e-8f * 0.5f);
    EXPECT_NEAR(variance.y(), 2.0f, 3 * 6e-8f * 2.0f);
    EXPECT_EQ(variance.z(), 0);
    EXPECT_NEAR(variance.w(), 1 / 12.0f, 3 * 6e-8f / 12);
}

TEST(Film, OneSampleHasNoVariance) {
    Film film(1, 1, {.variance = true});
    add(film, path_of(3, 1));
    EXPECT_EQ(variance_of_mean(film, 0), Eigen::Vector4f::Zero());
}

TEST(Film, DepthIsTheNearest) {
    Film film(1, 1, {});
    const float depths[] = {7, 4, 5};
    for (const float depth : depths) {
        PathResult path = path_of(1, 1);
        path.first = Hit{};
        add_sample(film, 0, {.path = path, .depth = depth});
    }
    EXPECT_EQ(film.sums.depth[0], 4);
}

struct FilmBall : HairyBall {
    FilmBall() : HairyBall(16, 16, 1) { settings.channels.variance = true; }
};

TEST(Film, VarianceBoundsThatOfPicturesOfOtherSeeds) {
    FilmBall ball;
    ball.settings.samples = 8;
    constexpr int kPictures = 40;
    std::vector<Mean> green(16 * 16);
    double estimated = 0;
    for (int seed = 0; seed < kPictures; ++seed) {
        ball.settings.seed = std::uint64_t(seed);
        const Image image = render(ball.scene, ball.camera, ball.settings);
        for (std::size_t i = 0; i < green.size(); ++i) {
            green[i].add(double(image.rgba[i].y()));
            estimated += double(image.variance[i].y()) / kPictures;
        }
    }
    double found = 0;
    for (const Mean& pixel : green) {
        found += pixel.error() * pixel.error() * kPictures * kPictures / (kPictures - 1);
    }
    // The sum has about 150 pixels of 39 degrees of freedom each: a relative standard
    // error of sqrt(2 / 39 / 150) = 2 %, with heavy tails three times that.
    // Stratification reduces the true variance: pictures agree better than estimated, but
    // not ten times.
    EXPECT_LT(found, 1.25 * estimated);
    EXPECT_GT(found, 0.1 * estimated);
}

TEST(Film, VarianceIsTheSameProgressively) {
    FilmBall ball;
    ball.settings.samples = 6;
    const Image whole = render(ball.scene, ball.camera, ball.settings);
    Image last;
    render_progressively(ball.scene, ball.camera, ball.settings,
                         [&](const Image& image, int) { last = image; });
    EXPECT_EQ(whole.variance, last.variance);
}

TEST(Film, VarianceIsKeptOnlyOnRequest) {
    FilmBall ball;
    ball.settings.samples = 2;
    ball.settings.channels.variance = false;
    EXPECT_TRUE(render(ball.scene, ball.camera, ball.settings).variance.empty());
}

}  // namespace
}  // namespace lancret
