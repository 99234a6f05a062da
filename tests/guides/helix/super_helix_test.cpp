#include "guides/helix/super_helix.h"

#include <gtest/gtest.h>

#include <random>

namespace lancret {
namespace {

struct Made {
    std::vector<double> lengths;
    std::vector<Vec3> curvatures;
    SuperHelix helix(const HelixState<double>& root = {}) const {
        return {root, lengths, curvatures};
    }
};

Made random_helix(int segments, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Made made;
    for (int i = 0; i < segments; ++i) {
        made.lengths.push_back(1 + 0.5 * i);
        made.curvatures.emplace_back(normal(random), normal(random), normal(random));
    }
    return made;
}

TEST(SuperHelix, SamplesAreTheProductOfWholeSteps) {
    const Made made = random_helix(5, 1);
    HelixState<double> state;
    double s = 0;
    for (int i = 0; i < 5; ++i) {
        advance<double>(state, made.curvatures[i], made.lengths[i]);
        s += made.lengths[i];
        const HelixState<double> at = state_at(made.helix(), s);
        EXPECT_LT((at.position - state.position).norm(), 1e-14 * s);
        EXPECT_LT((at.frame - state.frame).cwiseAbs().maxCoeff(), 1e-14);
    }
}

TEST(SuperHelix, SamplingManyPlacesEqualsSamplingEach) {
    const Made made = random_helix(4, 2);
    std::vector<double> s;
    for (int i = -3; i < 60; ++i) s.push_back(0.15 * i);
    sample(made.helix(), s,
           [&](std::size_t i, std::size_t, const HelixState<double>& state) {
               EXPECT_EQ(state.position, state_at(made.helix(), s[i]).position);
           });
}

TEST(SuperHelix, ExtendsTheEndHelices) {
    const Made made = random_helix(3, 3);
    HelixState<double> before;
    advance<double>(before, made.curvatures[0], -0.5);
    EXPECT_LT((state_at(made.helix(), -0.5).position - before.position).norm(), 1e-15);
}

TEST(SuperHelix, JacobianMatchesFiniteDifferences) {
    Made made = random_helix(4, 4);
    made.curvatures[1].setZero();  // a straight segment is not a special case
    HelixState<double> root;
    root.frame = helix_step<double>(Vec3(0.3, -1, 0.4), 1).rotation;
    root.position = Vec3(3, -2, 5);
    const std::vector<double> s{0, 0.4, 1.0, 1.7, 2.9, 4.5, 7.0};
    Eigen::VectorXd positions, up, down;
    Eigen::MatrixXd jacobian, unused;
    positions_with_jacobian(made.helix(root), s, positions, jacobian);
    const double h = 1e-5;
    for (int k = 0; k < 12; ++k) {
        Made plus = made, minus = made;
        plus.curvatures[k / 3][k % 3] += h;
        minus.curvatures[k / 3][k % 3] -= h;
        positions_with_jacobian(plus.helix(root), s, up, unused);
        positions_with_jacobian(minus.helix(root), s, down, unused);
        // Central differences: h^2 / 6 times a third derivative of at most s^4 = 2400.
        EXPECT_LT(((up - down) / (2 * h) - jacobian.col(k)).cwiseAbs().maxCoeff(), 5e-8)
            << k;
    }
}

}  // namespace
}  // namespace lancret
