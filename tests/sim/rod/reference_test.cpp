// The rod against reference values from other methods than a Super-Helix: shooting and
// collocation, which agree to 1e-11. They are given to 8 to 10 digits. The limit of 1e-5
// of a quantity's size is the error of Romberg's scheme from 20, 40 and 80 segments at
// the steepest boundary layer, which is as long as a segment of the coarsest rod.

#include <gtest/gtest.h>

#include "sim/equilibrium/equilibrium.h"
#include "sim/equilibrium/measures.h"
#include "sim/equilibrium/modes.h"
#include "sim/equilibrium/stability.h"
#include "tests/sim/equilibrium/critical_weight.h"
#include "tests/sim/rod/convergence.h"
#include "tests/sim/rod/made_rods.h"

namespace lancret {
namespace {

TEST(SlowRodReference, HeavyElasticaClampedHorizontally) {
    struct Row {
        double gamma, drop, reach, angle, curvature;
    };
    for (const Row& row :
         {Row{0.1, 0.0124984378, 0.9999107322, 0.0166650852, 0.049996876},
          Row{1, 0.1234714020, 0.9912463953, 0.1651155605, 0.496933400},
          Row{10, 0.7001997155, 0.6563537612, 1.0526431172, 3.742191111},
          Row{100, 0.9375239354, 0.1592233826, 1.5641073206, 13.693238736},
          Row{1000, 0.9811412693, 0.0459864548, 1.5707963223, 44.297658387}}) {
        // The boundary layer at the root, 1 / sqrt(Gamma) long, spans at least a segment.
        const int coarsest = row.gamma > 100 ? 40 : 20;
        const auto expect = [&](const char* what, const auto& reference, double limit,
                                auto&& value) {
            const std::string name = fmt::format("elastica {} {}", row.gamma, what);
            expect_second_order(
                name.c_str(), reference, limit,
                [&](int segments) {
                    const HangingRod rod = made_rod(segments, row.gamma);
                    return value(rod, rod_equilibrium(rod).q);
                },
                coarsest);
        };
        expect("tip", Eigen::VectorXd(Vec3(row.reach, 0, -row.drop)), 1e-5,
               [](const HangingRod& r, const Eigen::VectorXd& q) -> Eigen::VectorXd {
                   return tip_of(r, q);
               });
        expect("root curvature", row.curvature, 1e-5 * row.curvature,
               [](const HangingRod& r, const Eigen::VectorXd& q) {
                   return root_darboux(r, q).tail<2>().norm();
               });
        expect("tip angle", row.angle, 1e-5,
               [](const HangingRod& r, const Eigen::VectorXd& q) {
                   return tip_angle(r, q);
               });
    }
}

TEST(SlowRodReference, NaturallyCurvedRodsInSpace) {
    struct Row {
        Vec3 natural;
        double gamma;
        Vec3 tip;
        double lowest;
    };
    for (const Row& row : {
             Row{{0, 0, 2 * kPi}, 1, {0.00305071, 0, -0.00619775}, -0.16249166},
             Row{{0, 0, 2 * kPi}, 100, {0.31627190, 0, -0.80261203}, -0.81654418},
             Row{{0, 0, kPi}, 10, {0.60129739, 0, -0.56387239}, -0.60662999},
             Row{{2 * kPi, 0, 2 * kPi},
                 1,
                 {0.14831405, -0.43645951, -0.56313252},
                 -0.56313252},
             Row{{2 * kPi, 0, 2 * kPi},
                 100,
                 {0.11719160, -0.04802907, -0.87644802},
                 -0.87644802},
             Row{{kPi, 0, 4 * kPi},
                 10,
                 {0.01056155, -0.19758260, -0.18862917},
                 -0.18862917},
         }) {
        // Tip and lowest height as one vector, since the h^2 term of a single value may
        // happen to be near zero.
        const std::string name = fmt::format("({:.2f} {} {:.2f}) at {}", row.natural.x(),
                                             row.natural.y(), row.natural.z(), row.gamma);
        Eigen::Vector4d reference;
        reference << row.tip, row.lowest;
        expect_second_order(
            name.c_str(), reference, 1e-6, [&](int segments) -> Eigen::VectorXd {
                const HangingRod rod = hanging_rod(segments, row.gamma, row.natural);
                const RodEquilibrium hung = rod_equilibrium(rod);
                EXPECT_TRUE(hung.stable && !hung.left_branch);
                Eigen::Vector4d out;
                out << tip_of(rod, hung.q),
                    lowest_point(rod, hung.q, Vec3::UnitZ()).height;
                return out;
            });
    }
}

TEST(SlowRodReference, FrequenciesOfHangingStraightHair) {
    struct Row {
        double gamma, frequency[3];
    };
    for (const Row& row : {Row{0, {3.5160152685, 22.0344915647, 61.6972144135}},
                           Row{10, {5.291783, 23.911999, 63.681554}},
                           Row{100, {12.868742, 36.509167, 78.980329}}}) {
        for (int m = 0; m < 3; ++m) {
            const std::string name = fmt::format("mode {} at {}", m + 1, row.gamma);
            expect_second_order(
                name.c_str(), row.frequency[m], 1e-5 * row.frequency[m],
                [&](int segments) {
                    const HangingRod rod = hanging_rod(segments, row.gamma);
                    const auto all = rod_frequencies(rod, rod_equilibrium(rod).q, 6);
                    // One per plane.
                    EXPECT_NEAR(all[2 * m], all[2 * m + 1], 1e-8 * all[2 * m]);
                    return all[2 * m];
                });
        }
    }
}

TEST(SlowRodReference, BucklingWeights) {
    expect_second_order("self-buckling", 7.83734744, 1e-5, [](int segments) {
        return *critical_weight(
            made_rod(segments, 1, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX()), 1e3);
    });
    // A strip that is rigid in its plane: EI_2 / EI_1 = 1e8 has an effect of 1e-8.
    expect_second_order("lateral buckling", 12.85376332, 1e-5, [](int segments) {
        const Vec3 stiffness(2. / 3, 1, 1e8);
        const HangingRod rod =
            made_rod(segments, 1, {0, 0, 0}, Vec3::UnitX(), Vec3::UnitZ(), stiffness);
        return *critical_weight(rod, 1e3) / std::sqrt(2. / 3);
    });
}

TEST(SlowRodReference, WindowInWhichARingLeavesItsPlane) {
    // The references have about 4 digits.
    const auto change = [](double turns, std::size_t which) {
        return [=](int segments) {
            const HangingRod ring = hanging_rod(segments, 1, {0, 0, turns * kPi});
            const auto changes = stability_changes(ring, 1e3, 5);
            EXPECT_EQ(changes.size(), 2u);
            EXPECT_EQ(changes[which].stable, which == 1);
            EXPECT_FALSE(changes[which].fold);
            return changes[which].weight;
        };
    };
    expect_second_order("ring 2 pi loses its plane", 12.19, 0.005, change(2, 0));
    expect_second_order("ring 2 pi regains it", 48.13, 0.005, change(2, 1));
    expect_second_order("ring 3 pi loses its plane", 26.3, 0.05, change(3, 0));
    expect_second_order("ring 3 pi regains it", 199.7, 0.05, change(3, 1));
    for (const double turns : {1., 1.5}) {
        const HangingRod ring = hanging_rod(40, 1, {0, 0, turns * kPi});
        EXPECT_TRUE(stability_changes(ring, 1e4, 5).empty()) << turns;
    }
}

}  // namespace
}  // namespace lancret
