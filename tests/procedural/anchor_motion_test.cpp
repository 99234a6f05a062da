// How far a child of `detail` may move, from how far its guides do. The bound is made
// here from the guides' frames and spines alone; docs/time.md derives it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "procedural/blend.h"
#include "tests/procedural/hard_cases.h"

namespace lancret {
namespace {

using test::MadeChild;

constexpr int kCount = 48;
constexpr double kPi = std::numbers::pi;

/// All that the child is made of at one time.
struct Made {
    std::vector<HelixState<double>> copy{kCount + 1}, child{kCount + 1};
    std::vector<Eigen::Vector4d>
        turn;                 ///< from spine to spine, a quaternion times a size
    std::vector<Vec3> speed;  ///< that tilts the tangent
};

Made made(const Guides& guides, const std::vector<double>& weights) {
    const auto profiles = guide_profiles<double>(guides, kCount);
    const MadeChild<double> made(profiles, weights);
    Made out;
    blend_nearest<double>(made.child(), profiles, out.copy);
    blend_detail<double>(made.child(), profiles, out.child);
    const Spine<double> own = spine_of<double>(
        profiles.basis, made.length, [&](std::size_t i) { return out.copy[i].position; });
    Spine<double> goal;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double share = weights[k] * profiles.lengths[k] / made.length;
        for (int j = 0; j < kSpineTerms; ++j) {
            goal.terms[j] += share * made.to_space[k] * profiles.spines[k].terms[j];
        }
        goal.turns += share * profiles.spines[k].turns;
    }
    const auto taper = spine_taper(goal.turns);
    for (int i = 0; i <= kCount; ++i) {
        const Vec3 from = spine_at(own, taper, profiles.basis.at_places[i]),
                   to = spine_at(goal, taper, profiles.basis.at_places[i]);
        double advance = 0;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            advance += weights[k] * profiles.lengths[k] / made.length *
                       profiles.advances[k * (kCount + 1) + i];
        }
        Eigen::Vector4d turn;
        turn << from.norm() * to.norm() + from.dot(to) + 0.01, from.cross(to);
        out.turn.push_back(turn);
        const double a = std::min(from.norm(), 1.0);
        const double speed =
            std::clamp((advance - a) / (1 - advance * a + 0.05), -0.33, 0.33);
        out.speed.push_back(from * (speed / std::hypot(a, 0.05)));
    }
    return out;
}

/// The farthest that the child's places go, and what bounds it.
struct Motion {
    double child = 0, bound = 0;
};

Motion motion(const Made& a, const Made& b, double length) {
    Motion out;
    for (int i = 0; i <= kCount; ++i) {
        out.child =
            std::max(out.child, (a.child[i].position - b.child[i].position).norm());
        const Mat3 turned = a.copy[i].frame.transpose() * b.copy[i].frame;
        const double copy = rotation_log<double>(turned).norm(),
                     speed = (a.speed[i] - b.speed[i]).norm(),
                     turn = (a.turn[i] - b.turn[i]).norm() /
                            std::max(a.turn[i].norm(), b.turn[i].norm());
        out.bound = std::max(out.bound, 4.9 * copy + 2.4 * speed + kPi * turn);
    }
    // A step of arc length follows the frame at its start and half its two ends' turns.
    out.bound *= 2 * length;
    return out;
}

TEST(AnchorMotion, StaysWithinTheBoundOfItsGuides) {
    double worst = 0;
    const char* name = "";
    for (const test::HardCase& hard : test::kHardCases) {
        for (const double weight : {0.55, 0.9}) {
            constexpr int kSteps = 400;
            std::optional<Made> before;
            for (int i = 0; i <= kSteps; ++i) {
                Guides guides;
                hard.add(double(i) / kSteps, guides);
                Made now = made(guides, {weight, 1 - weight});
                if (before) {
                    const Motion moved = motion(*before, now, 10);
                    ASSERT_LE(moved.child, moved.bound) << hard.name;
                    if (moved.child > worst * moved.bound) {
                        worst = moved.child / moved.bound;
                        name = hard.name;
                    }
                }
                before = std::move(now);
            }
        }
    }
    // A bound that nothing comes near would prove nothing.
    EXPECT_GT(worst, 0.05);
    fmt::print("largest share of the bound: {:.3f}, {}\n", worst, name);
}

TEST(AnchorMotion, StaysWithinTheBoundForGuidesThatMoveAtRandom) {
    double worst = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Guides from = test::random_guides(3, 6, seed, 0.5);
        Guides to = from;
        const Guides other = test::random_guides(3, 6, seed + 1000, 0.5);
        const double share = 1e-3 * (1 + seed % 5);
        for (std::size_t q = 0; q < to.curvatures.size(); ++q) {
            to.curvatures[q] += share * (other.curvatures[q] - from.curvatures[q]);
        }
        for (std::size_t g = 0; g < 3; ++g) {
            const Vec3 turn = share * other.root_frames[g].col(0);
            to.root_frames[g] = helix_step<double>(turn, 1).rotation * to.root_frames[g];
        }
        const std::vector<double> weights{0.5, 0.3, 0.2};
        double length = 0;
        for (int g = 0; g < 3; ++g) length += weights[g] * guide_length(from, g);
        const Motion moved = motion(made(from, weights), made(to, weights), length);
        ASSERT_LE(moved.child, moved.bound) << seed;
        worst = std::max(worst, moved.child / moved.bound);
    }
    EXPECT_GT(worst, 0.05);
    fmt::print("largest share of the bound: {:.3f}\n", worst);
}

}  // namespace
}  // namespace lancret
