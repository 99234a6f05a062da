// Properties that all blends share.

#include <gtest/gtest.h>

#include "guides/helix/super_helix.h"
#include "procedural/blend/blend.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::MadeChild;

constexpr int kBlendIntervals = 24;

/// Whether a blend returns places at equal steps of arc length.
bool keeps_length(Blend blend) {
    return blend != Blend::position && blend != Blend::option3;
}

std::vector<Blend> all_blends() {
    std::vector<Blend> out;
    for (const BlendTraits& traits : blends()) out.push_back(traits.blend);
    return out;
}

class EveryBlend : public testing::TestWithParam<Blend> {
  protected:
    Blend blend() const { return GetParam(); }

    template <class T>
    std::vector<HelixState<T>> states_of(const MadeChild<T>& made,
                                         const GuideProfiles<T>& profiles) const {
        std::vector<HelixState<T>> states(profiles.count + 1);
        blend_function<T>(blend())(made.child(), profiles, states);
        return states;
    }
};

TEST_P(EveryBlend, WithAllWeightOnAGuideIsThatGuide) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Guides guides = test::random_guides(1, 8, seed);
        const auto profiles = guide_profiles<double>(guides, kBlendIntervals);
        const auto states = states_of<double>({profiles, {1.0}}, profiles);
        const double length = guide_length(guides, 0);
        for (int i = 0; i <= kBlendIntervals; ++i) {
            const HelixState<double> exact =
                state_at(super_helix(guides, 0), length * i / kBlendIntervals);
            const Vec3 place = states[i].position + guides.root_positions[0];
            // Option 3 measures its length between places by circular arcs.
            const double slack = blend() == Blend::option3 ? 0.02 : 1e-9;
            EXPECT_LT((place - exact.position).norm(), slack * length);
        }
    }
}

TEST_P(EveryBlend, KeepsLengthAndFrames) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.1, 1);
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Guides guides = test::random_guides(4, 8, seed, 0.3);
        const auto profiles = guide_profiles<double>(guides, kBlendIntervals);
        std::vector<double> weights(4);
        double sum = 0;
        for (double& w : weights) sum += w = uniform(random);
        for (double& w : weights) w /= sum;
        const MadeChild<double> made(profiles, weights);
        const auto states = states_of<double>(made, profiles);
        const double ds = made.length / kBlendIntervals;
        for (int i = 0; i <= kBlendIntervals; ++i) {
            const Mat3& frame = states[i].frame;
            EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), 1e-12);
            EXPECT_GT(frame.determinant(), 0);
            if (i == 0 || !keeps_length(blend())) continue;
            const Vec3 step =
                displacement_between<double>(states[i - 1].frame, frame, ds);
            const Vec3 chord = states[i].position - states[i - 1].position;
            EXPECT_LT((states[i - 1].frame * step - chord).norm(), 1e-11);
        }
    }
}

TEST_P(EveryBlend, TurnsWithItsGuides) {
    std::mt19937 random(8);
    const Mat3 turn = test::random_rotation(random);
    const Guides guides = test::random_guides(3, 6, 2);
    const auto profiles = guide_profiles<double>(guides, kBlendIntervals);
    MadeChild<double> made(profiles, {0.5, 0.3, 0.2});
    const auto before = states_of<double>(made, profiles);
    for (Mat3& to_space : made.to_space) to_space = (turn * to_space).eval();
    auto turned = profiles;  // blend position reads root frames in space
    for (Mat3& frame : turned.root_frames) frame = (turn * frame).eval();
    const auto after = states_of<double>(made, turned);
    for (int i = 0; i <= kBlendIntervals; ++i) {
        EXPECT_LT((after[i].position - turn * before[i].position).norm(), 1e-9);
    }
}

TEST_P(EveryBlend, IsFiniteAndExactIfGuidesCancel) {
    // Opposed guides, straight and curled, at equal weights.
    for (const Vec3& u : {Vec3(0, 0, 0), Vec3(0, 0, 0.4), Vec3(0.8, 0, 0.6)}) {
        Guides guides;
        const std::vector<Vec3> curvatures(4, u);
        test::add_guide(guides, curvatures, 10);
        test::add_guide(guides, curvatures, 10,
                        Vec3(-1, -1, 1).asDiagonal().toDenseMatrix());
        const auto profiles = guide_profiles<float>(guides, kBlendIntervals);
        const auto states = states_of<float>({profiles, {0.5f, 0.5f}}, profiles);
        for (std::size_t i = 0; i < states.size(); ++i) {
            EXPECT_TRUE(states[i].position.allFinite());
            const Mat3f& frame = states[i].frame;
            EXPECT_LT((frame.transpose() * frame - Mat3f::Identity()).norm(), 2e-6f);
            if (i == 0 || !keeps_length(blend())) continue;
            const Vec3f chord = states[i].position - states[i - 1].position;
            const Vec3f step = displacement_between<float>(states[i - 1].frame, frame,
                                                           10.0f / kBlendIntervals);
            // Places up to 10 cm away are rounded by 6e-7, frames are accurate to 5e-7.
            EXPECT_LT((states[i - 1].frame * step - chord).norm(), 4e-6f);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Blends, EveryBlend, testing::ValuesIn(all_blends()),
                         [](const auto& blend) {
                             std::string name(blend_name(blend.param));
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(Blend, TableHasARowForEachNameAndValue) {
    for (const BlendTraits& traits : blends()) {
        EXPECT_EQ(&traits_of(traits.blend), &traits) << traits.name;
        EXPECT_EQ(blend_named(blend_name(traits.blend)), traits.blend);
    }
    EXPECT_EQ(blend_named("nothing"), std::nullopt);
}

}  // namespace
}  // namespace lancret
