#include "guides/helix/helix_box.h"

#include <gtest/gtest.h>

#include <random>

namespace lancret {
namespace {

HelixState<double> random_state(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double a = normal(random), b = normal(random), c = normal(random),
                 d = normal(random);
    const double x = normal(random), y = normal(random), z = normal(random);
    return {Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix(),
            Vec3(x, y, z)};
}

TEST(HelixBox, IsTheBoxOfDenseSamples) {
    // Samples every h along a curve miss an extreme by at most |r''| h^2 / 8.
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, 2);
    for (int trial = 0; trial < 300; ++trial) {
        const HelixState<double> from = random_state(random);
        const double k0 = normal(random), k1 = normal(random), k2 = normal(random);
        const Vec3 u(k0, k1, k2);
        const double ds = 0.1 + 0.02 * trial;  // up to about six turns
        Eigen::AlignedBox3d box, sampled;
        extend(box, from, u, ds);
        constexpr int kPlaces = 4000;
        for (int i = 0; i <= kPlaces; ++i) {
            HelixState<double> state = from;
            advance<double>(state, u, ds * i / kPlaces);
            sampled.extend(state.position);
        }
        const double h = ds / kPlaces, missed = std::hypot(k1, k2) * h * h / 8 + 1e-12;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(box.min()[axis], sampled.min()[axis], missed) << trial;
            EXPECT_NEAR(box.max()[axis], sampled.max()[axis], missed) << trial;
        }
    }
}

TEST(HelixBox, OfACircleInAPlaneIsItsSquare) {
    // A radius of 2 about (0, 2, 0), one full turn.
    Eigen::AlignedBox3d box;
    extend(box, {}, Vec3(0, 0, 0.5), 4 * kPi);
    EXPECT_LT((box.min() - Vec3(-2, 0, 0)).norm(), 1e-12);
    EXPECT_LT((box.max() - Vec3(2, 4, 0)).norm(), 1e-12);
}

TEST(HelixBox, OfAStraightLineIsThatOfItsEnds) {
    Eigen::AlignedBox3d box;
    extend(box, {}, Vec3::Zero(), 3);
    EXPECT_EQ(box.min(), Vec3::Zero());
    EXPECT_EQ(box.max(), Vec3(3, 0, 0));
}

TEST(HelixBox, GrowsABoxAsIfItWereEmpty) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const HelixState<double> first = random_state(random),
                                 second = random_state(random);
        const Vec3 u = Vec3::Constant(0.1 * trial);
        Eigen::AlignedBox3d one, other, both;
        extend(one, first, u, 2);
        extend(other, second, -u, 1);
        extend(both, first, u, 2);
        extend(both, second, -u, 1);
        EXPECT_LT((both.min() - one.merged(other).min()).norm(), 1e-12);
        EXPECT_LT((both.max() - one.merged(other).max()).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace lancret
