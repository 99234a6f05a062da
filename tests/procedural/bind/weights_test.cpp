#include "procedural/bind/weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace lancret {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

std::vector<float> weights_of(std::vector<double> distances, double reach,
                              std::vector<double> facing, double exponent,
                              bool* faced = nullptr) {
    std::vector<float> weights(distances.size());
    const std::vector<double> shares(distances.size(), 1.0);
    const WeightSource source =
        guide_weights(distances, shares, reach, facing, exponent, weights);
    if (faced) *faced = source == WeightSource::facing;
    return weights;
}

TEST(Weights, SumToOneAndAreNeverNegative) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> distance(1e-3, 10), side(-1, 1), power(0, 16);
    for (int round = 0; round < 2000; ++round) {
        const int k = 1 + round % 8;
        std::vector<double> d(k + 1), facing(k);
        for (double& x : d) x = distance(random);
        for (double& x : facing) x = side(random);
        std::ranges::sort(d);
        const double reach = d.back();
        d.pop_back();
        const auto weights = weights_of(d, reach, facing, power(random));
        // At most 8 floats below 1, each rounded by at most 2^-25.
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 8 * 3e-8);
        for (const float w : weights) EXPECT_GE(w, 0);
    }
}

TEST(Weights, WithoutAReachAreThePaperPowerLaw) {
    // [TW99, Eq. 49] with a = 2: 1, 1/4 and 1/16, times S.T of 1, 0.5 and 1.
    const auto weights = weights_of({1, 2, 4}, kFar, {1, 0.5, 1}, 2);
    const double sum = 1 + 0.125 + 0.0625;
    EXPECT_NEAR(weights[0], 1 / sum, 1e-7);
    EXPECT_NEAR(weights[1], 0.125 / sum, 1e-7);
    EXPECT_NEAR(weights[2], 0.0625 / sum, 1e-7);
}

TEST(Weights, FallToZeroAtTheReach) {
    // ((1/d - 1/4)+)^2: 9/16, 1/16, 0.
    const auto weights = weights_of({1, 2, 4}, 4, {1, 1, 1}, 2);
    EXPECT_NEAR(weights[0], 0.9, 1e-7);
    EXPECT_NEAR(weights[1], 0.1, 1e-7);
    EXPECT_EQ(weights[2], 0);
}

TEST(Weights, ACoincidentGuideHasAllTheWeight) {
    const auto weights = weights_of({0, 1, 2}, 3, {1, 1, 1}, 2);
    EXPECT_EQ(weights, (std::vector<float>{1, 0, 0}));
}

TEST(Weights, ApproachOneAsAGuideIsApproached) {
    // 1 / (1 + (d / 1)^2) at reach infinity: no step at the distance that counts as zero.
    const auto weights = weights_of({1e-6, 1}, kFar, {1, 1}, 2);
    EXPECT_NEAR(weights[0], 1, 1e-7);
}

TEST(Weights, AGuideThatFacesAwayHasNone) {
    bool faced = false;
    const auto weights = weights_of({1, 2, 3}, 4, {-0.5, 1, -1e-9}, 2, &faced);
    EXPECT_TRUE(faced);
    EXPECT_EQ(weights, (std::vector<float>{0, 1, 0}));
}

TEST(Weights, DependOnDistanceOnlyIfNoneFaces) {
    bool faced = true;
    const auto weights = weights_of({1, 2, 4}, 4, {-0.5, -1, 0}, 2, &faced);
    EXPECT_FALSE(faced);
    EXPECT_EQ(weights, weights_of({1, 2, 4}, 4, {1, 1, 1}, 2));
}

TEST(Weights, AreThePapersFromTheMinimumFacingOn) {
    // If only guide 1 faces, the mean facing is its weight by distance, 0.1.
    const auto above = weights_of({1, 2, 4}, 4, {-1, 1, 1}, 2);
    EXPECT_EQ(above, (std::vector<float>{0, 1, 0}));
    // The mean facing is half of kMinFacing, so each guide gets the other half:
    // facing factors 0.025 and 0.25 + 0.025, times 0.9 and 0.1.
    const auto below = weights_of({1, 2, 4}, 4, {-1, 0.25, 1}, 2);
    EXPECT_NEAR(below[0], 0.0225 / (0.0225 + 0.0275), 1e-6);
}

TEST(Weights, AreContinuousAsTheLastGuideTurnsAway) {
    // Facing factors change by at most 1 / kMinFacing times the change of a facing, and
    // weights by twice that: 4e-4 in steps of 1e-5. The paper's last weight jumps from 1
    // to 0.
    std::vector<float> before = weights_of({1, 2, 3}, 4, {-1, 0.3, -1}, 2);
    for (double facing = 0.3; facing > -0.01; facing -= 1e-5) {
        const auto now = weights_of({1, 2, 3}, 4, {-1, facing, -1}, 2);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(now[k], before[k], 4.1e-4) << facing;
        before = now;
    }
}

TEST(Weights, OfNoShareAreZeroAndSourceIsNone) {
    std::vector<float> weights(2, 5);
    const std::vector<double> distances{0, 1}, none{0, 0}, last{0, 1}, facing{1, 1};
    EXPECT_EQ(guide_weights(distances, none, 2, facing, 2, weights), WeightSource::none);
    EXPECT_EQ(weights, (std::vector<float>{0, 0}));
    // A guide without a share has no weight, even at the child's root.
    EXPECT_EQ(guide_weights(distances, last, 2, facing, 2, weights),
              WeightSource::facing);
    EXPECT_EQ(weights, (std::vector<float>{0, 1}));
}

TEST(Reach, OfWholeSharesIsTheDistanceOfTheNextGuide) {
    const std::vector<double> distances{1, 2, 3, 5, 8}, shares(5, 1.0);
    for (std::size_t k = 1; k < 5; ++k) {
        // Rounded by two divisions.
        EXPECT_NEAR(neighbour_reach(distances, shares, k), distances[k], 2e-15);
    }
    EXPECT_EQ(neighbour_reach(distances, shares, 5), kFar);
    EXPECT_EQ(neighbour_reach(distances, shares, 5, 10), 10);
    EXPECT_EQ(neighbour_reach(distances, shares, 4, 6), 6);
}

TEST(Reach, OfPartialSharesIsBetweenThoseOfNoneAndOfAll) {
    // With half of guide 2, the range from 2 to 3 is filled by guides 3 and 4, half each.
    const std::vector<double> distances{1, 2, 3, 5, 8};
    const double reach =
        neighbour_reach(distances, std::vector<double>{1, 0.5, 1, 1, 1}, 2);
    EXPECT_NEAR(reach, 1 / (0.5 / 3 + 0.5 / 5), 1e-14);
}

TEST(Reach, IsContinuousInDistancesAndShares) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.5, 4), share(-0.5, 1.5);
    const auto reach_of = [](std::vector<std::pair<double, double>> guides) {
        std::ranges::sort(guides);
        std::vector<double> distances, shares;
        for (const auto& [d, e] : guides) {
            distances.push_back(d);
            shares.push_back(std::clamp(e, 0.0, 1.0));
        }
        return neighbour_reach(distances, shares, 3, 4.0);
    };
    for (int round = 0; round < 30; ++round) {
        // From one set of guides to another: the order changes, and guides come and go.
        std::vector<std::pair<double, double>> from(8), to(8), now(8);
        for (auto* set : {&from, &to}) {
            for (auto& [d, e] : *set) d = place(random), e = share(random);
        }
        constexpr int kSteps = 20000;
        double before = reach_of(from);
        for (int i = 1; i <= kSteps; ++i) {
            const double t = double(i) / kSteps;
            for (std::size_t g = 0; g < 8; ++g) {
                now[g] = {from[g].first + t * (to[g].first - from[g].first),
                          from[g].second + t * (to[g].second - from[g].second)};
            }
            // 1 / Q changes by at most the step of the distances over Q^2, 3.5 / 0.25,
            // and by the change of eight shares, at most 2 in all, over the range of 1 /
            // Q, 2; times reach^2, 16.
            const double bound = 16 * (3.5 / 0.25 + 8 * 2 * 2.0) / kSteps;
            const double reach = reach_of(now);
            ASSERT_NEAR(reach, before, bound) << "round " << round << ", step " << i;
            before = reach;
        }
    }
}

TEST(Heaviest, KeepAllTheWeight) {
    std::vector<float> weights{0.1f, 0.4f, 0.2f, 0.3f};
    keep_heaviest(weights, 2);
    // 0.4 - 0.2 and 0.3 - 0.2.
    EXPECT_NEAR(weights[1], 2.0 / 3, 1e-6);
    EXPECT_NEAR(weights[3], 1.0 / 3, 1e-6);
    EXPECT_EQ(weights[0], 0);
    EXPECT_EQ(weights[2], 0);
}

TEST(Heaviest, AreUnchangedIfFew) {
    std::vector<float> weights{0.25f, 0, 0.75f, 0};
    keep_heaviest(weights, 2);
    EXPECT_EQ(weights, (std::vector<float>{0.25f, 0, 0.75f, 0}));
}

TEST(Heaviest, OfEqualsTheFirstHasAllTheWeight) {
    std::vector<float> weights{0.25f, 0.25f, 0.25f, 0.25f};
    keep_heaviest(weights, 2);
    EXPECT_EQ(weights, (std::vector<float>{1, 0, 0, 0}));
}

TEST(Weights, SurvivePowersThatOverflow) {
    // (1e-6)^-16 is 1e96, and 1e96^4 overflows; only ratios matter.
    const auto weights = weights_of({2e-7, 4e-7, 1e6}, 1e7, {1, 1, 1}, 16);
    EXPECT_NEAR(weights[0], 1 / (1 + std::pow(0.5, 16)), 1e-6);
    EXPECT_EQ(weights[2], 0);
}

/// Guides on a plane and the weights of a position among them: Lancret's, or with `hard`
/// the plain power law cut off at the k nearest.
struct Field {
    std::vector<Vec3> guides;
    int k = 4;
    bool hard = false;

    explicit Field(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(0, 10);
        for (int i = 0; i < 60; ++i) {
            const double x = place(random), y = place(random);
            guides.emplace_back(x, y, 0);
        }
    }

    std::vector<float> weights_at(const Vec3& x) const {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t g = 0; g < guides.size(); ++g) {
            order.emplace_back((guides[g] - x).norm(), g);
        }
        std::ranges::sort(order);
        std::vector<double> distances, facing(k, 1.0);
        for (int j = 0; j < k; ++j) distances.push_back(order[j].first);
        const double reach = hard ? kFar : order[k].first;
        const auto near = weights_of(distances, reach, facing, 2);
        std::vector<float> all(guides.size());
        for (int j = 0; j < k; ++j) all[order[j].second] = near[j];
        return all;
    }

    /// The largest change of any weight in one of `steps` even steps across the plane.
    double largest_jump(int steps) const {
        double worst = 0;
        std::vector<float> before = weights_at({0, 2.1, 0});
        for (int i = 1; i <= steps; ++i) {
            const double t = double(i) / steps;
            const std::vector<float> now = weights_at({10 * t, 2.1 + 5.3 * t, 0});
            for (std::size_t g = 0; g < now.size(); ++g) {
                worst = std::max(worst, std::abs(double(now[g]) - before[g]));
            }
            before = now;
        }
        return worst;
    }
};

TEST(Weights, ChangeByNoMoreThanTheStepThroughChangesOfNeighbours) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        Field field(seed);
        // Lipschitz weights change by at most L h in a step of h: a sixteenth of the step
        // gives a sixteenth of the change, up to the curvature of the weights.
        const double coarse = field.largest_jump(400), fine = field.largest_jump(6400);
        EXPECT_LT(fine, coarse / 12) << "seed " << seed;
        // A plain cut at the fourth neighbour jumps by the same amount for any step.
        field.hard = true;
        EXPECT_GT(field.largest_jump(6400), 4 * fine) << "seed " << seed;
        EXPECT_GT(field.largest_jump(6400), 0.5 * field.largest_jump(400))
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace lancret
