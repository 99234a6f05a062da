#include "guides/frenet/ordered_exponential.h"
#include "tests/guides/frenet/frenet_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace lancret {
namespace {

/// The paper's Q [TW99, Eq. 11].
Mat3 q_matrix(const FrenetRates& r) {
    Mat3 q;
    q << 0, r.curvature, 0, -r.curvature, 0, r.torsion, 0, -r.torsion, 0;
    return q;
}

FrenetProfile wavy_profile(int n) {
    FrenetProfile profile{skew_root(), {}, {}};
    for (int i = 0; i < n; ++i) {
        profile.steps.push_back(0.2 + 0.1 * std::sin(3.0 * i));
        profile.rates.push_back({1.5 * std::cos(0.7 * i), 2 * std::sin(0.4 * i)});
    }
    return profile;
}

TEST(OrderedExponential, IsTheProductOfExponentialsInOrder) {
    const FrenetProfile profile = wavy_profile(40);
    const OrderedExponential shape = ordered_exponential(profile);
    Mat3 u = Mat3::Identity(), r = Mat3::Zero();
    for (std::size_t i = 0; i < profile.size(); ++i) {
        // exp of [Q I; 0 0] ds has exp(Q ds) and its integral in its first rows.
        Eigen::Matrix<double, 6, 6> block = Eigen::Matrix<double, 6, 6>::Zero();
        block.topLeftCorner<3, 3>() = q_matrix(profile.rates[i]) * profile.steps[i];
        block.topRightCorner<3, 3>() = Mat3::Identity() * profile.steps[i];
        const Eigen::Matrix<double, 6, 6> e = block.exp();
        r += (e.topRightCorner<3, 3>() * u).eval();
        u = (e.topLeftCorner<3, 3>() * u).eval();  // later factors on the left
        // 40 steps of a few units of round-off.
        EXPECT_LT((shape.rotations[i + 1] - u).norm(), 1e-14 * 40);
        EXPECT_LT((shape.integrals[i + 1] - r).norm(), 1e-14 * 40);
    }
}

TEST(OrderedExponential, AgreesWithItsSeriesToTheOrderKept) {
    // Q(s) = A + B s. The first three terms of the series [TW99, after Eq. 13] are
    // A s + B s^2/2, then A A s^2/2 + A B s^3/6 + B A s^3/3 + B B s^4/8, then A A A s^3/6
    // and higher; the omitted terms start at s^4. 4000 midpoint steps add 1e-9 s^3.
    const auto rates_at = [](double s) {
        return FrenetRates{1.2 - 0.9 * s, 0.5 + 1.4 * s};
    };
    const Mat3 a = q_matrix(rates_at(0)), b = q_matrix(rates_at(1)) - a;
    const auto left = [&](double s) {
        const int n = 4000;
        FrenetProfile profile{{}, std::vector(n, s / n), {}};
        for (int i = 0; i < n; ++i) profile.rates.push_back(rates_at(s * (i + 0.5) / n));
        const Mat3 series = Mat3::Identity() + a * s + b * s * s / 2 + a * a * s * s / 2 +
                            (a * b / 6 + b * a / 3 + a * a * a / 6) * s * s * s;
        return (ordered_exponential(profile).rotations.back() - series).norm();
    };
    for (double s : {0.2, 0.1, 0.05}) {
        const double order = std::log2(left(s) / left(s / 2));
        std::printf("s = %g: left out %.3g, order %.2f\n", s, left(s), order);
        // The next term changes the ratio by a factor 1 + O(s).
        EXPECT_NEAR(order, 4.0, s);
    }
    // With A B and B A swapped it does not agree beyond s^3.
    const double s = 0.05;
    EXPECT_GT((a * b - b * a).norm() / 6 * s * s * s, 10 * left(s));
}

TEST(OrderedExponential, IsOrthogonalAfterAnyNumberOfSteps) {
    for (const Mat3& u : ordered_exponential(wavy_profile(20000)).rotations) {
        ASSERT_LT((u.transpose() * u - Mat3::Identity()).cwiseAbs().maxCoeff(), 2e-15);
    }
}

TEST(OrderedExponential, PlacedOnARootIsTheSynthesizedStrand) {
    FrenetProfile profile = wavy_profile(300);
    const OrderedExponential shape = ordered_exponential(profile);
    for (const HelixState<double>& root :
         {skew_root(), HelixState<double>{},
          HelixState<double>{Mat3::Identity(), {5, 6, 7}}}) {
        profile.root = root;
        const auto strand = synthesize(profile), same = placed(shape, root);
        ASSERT_EQ(strand.size(), same.size());
        for (std::size_t i = 0; i < strand.size(); ++i) {
            // Round-off of 300 steps in frames, multiplied by 60 cm of strand.
            EXPECT_LT((strand[i].frame - same[i].frame).norm(), 300 * 1e-15);
            EXPECT_LT((strand[i].position - same[i].position).norm(), 300 * 1e-15 * 60);
        }
    }
}

TEST(OrderedExponential, IntegralOfAStraightShapeIsItsLength) {
    const FrenetProfile line{{}, {1.0, 0.5}, {{}, {}}};
    const OrderedExponential shape = ordered_exponential(line);
    EXPECT_EQ(shape.integrals.back(), 1.5 * Mat3::Identity());
    EXPECT_EQ(shape.arc_lengths.back(), 1.5);
}

}  // namespace
}  // namespace lancret
