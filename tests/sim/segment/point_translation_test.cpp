#include "sim/segment/point_translation.h"

#include <gtest/gtest.h>

#include "tests/sim/rod/rods.h"

namespace lancret {
namespace {

SuperHelix helix_of(const TestRod& rod) {
    return {rod.root.pose, rod.lengths, rod.curvatures};
}

TEST(PointTranslation, MovesAnyPointToItsTarget) {
    std::mt19937_64 random(1);
    for (const double s : {0.3, 0.71, 1.}) {
        for (const double turn : {0., 0.4, 2.}) {
            const TestRod rod = random_rod(8, turn, random);
            const Vec3 root = rod.root.pose.position;
            const Vec3 from = state_at(helix_of(rod), s).position;
            // A quarter of the way to the root, and sideways: within reach.
            const Vec3 target =
                from + 0.25 * (root - from) + random_vector(random, 0.1 * s);
            std::vector<Vec3> bent;
            const TranslationReport report =
                translate_point(helix_of(rod), s, target, {}, bent);
            EXPECT_TRUE(report.reached) << s << " " << turn << " " << report.distance;
            const SuperHelix after{rod.root.pose, rod.lengths, bent};
            EXPECT_LE((state_at(after, s).position - target).norm(), 1e-6);
        }
    }
}

TEST(PointTranslation, SmallStepCostsTheLeastBending) {
    // To first order the change is W J^T (J W J^T)^-1 d, the smallest |dq|_K that moves
    // the point by d; the second-order error is d^2 / L.
    std::mt19937_64 random(2);
    const TestRod rod = random_rod(5, 0.5, random);
    const double s = 1;
    Eigen::VectorXd position;
    Eigen::MatrixXd j;
    positions_with_jacobian(helix_of(rod), std::span(&s, 1), position, j);
    const Vec3 d = random_vector(random, 1e-5);
    TranslationSettings settings;
    Eigen::VectorXd w(15);
    for (int q = 0; q < 5; ++q) {
        w.segment<3>(3 * q) = (rod.lengths[q] * settings.stiffness).cwiseInverse();
    }
    const Eigen::MatrixXd wj = w.asDiagonal() * j.transpose();
    const Eigen::VectorXd want = wj * (j * wj).inverse() * d;
    settings.tolerance = 1e-9;
    std::vector<Vec3> bent;
    translate_point(helix_of(rod), s, position.head<3>() + d, settings, bent);
    for (int q = 0; q < 5; ++q) {
        EXPECT_LT((bent[q] - rod.curvatures[q] - want.segment<3>(3 * q)).norm(),
                  1e-3 * want.norm());
    }
}

TEST(PointTranslation, OnlyTheNamedSegmentsBend) {
    std::mt19937_64 random(3);
    const TestRod rod = random_rod(6, 0.5, random);
    TranslationSettings settings;
    settings.first_segment = 2;
    settings.last_segment = 3;
    const double s = rod.lengths[0] + rod.lengths[1] + rod.lengths[2] + rod.lengths[3];
    const Vec3 target = state_at(helix_of(rod), s).position + random_vector(random, 0.02);
    std::vector<Vec3> bent;
    translate_point(helix_of(rod), s, target, settings, bent);
    for (const int q : {0, 1, 4, 5}) EXPECT_EQ(bent[q], rod.curvatures[q]);
    EXPECT_NE(bent[2], rod.curvatures[2]);
}

TEST(PointTranslation, StretchesTowardsAnUnreachableTarget) {
    // A strand of length 1 can approach a target at distance 3 to 2.
    std::mt19937_64 random(4);
    TestRod rod = random_rod(6, 0.3, random);
    const Vec3 target = rod.root.pose.position + 3 * rod.root.pose.frame.col(0);
    std::vector<Vec3> bent;
    const TranslationReport report = translate_point(helix_of(rod), 1, target, {}, bent);
    EXPECT_FALSE(report.reached);
    EXPECT_NEAR(report.distance, 2, 1e-3);
    // The root itself cannot move.
    EXPECT_FALSE(translate_point(helix_of(rod), 0, target, {}, bent).reached);
}

TEST(PointTranslation, StraightStrandBendsSideways) {
    const TestRod rod = straight_rod(6);
    std::vector<Vec3> bent;
    const Vec3 target(0.8, 0.3, -0.2);
    EXPECT_TRUE(translate_point(helix_of(rod), 1, target, {}, bent).reached);
}

TEST(PointTranslation, RejectsInvalidArguments) {
    const TestRod rod = straight_rod(3);
    std::vector<Vec3> bent;
    const auto refuses = [&](double s, const Vec3& target, TranslationSettings settings) {
        EXPECT_THROW(translate_point(helix_of(rod), s, target, settings, bent),
                     std::invalid_argument);
    };
    refuses(-0.1, Vec3::Zero(), {});
    refuses(1.1, Vec3::Zero(), {});
    refuses(1, Vec3::Constant(NAN), {});
    refuses(1, Vec3::Zero(), {.first_segment = 3});
    refuses(1, Vec3::Zero(), {.first_segment = 2, .last_segment = 1});
}

}  // namespace
}  // namespace lancret
