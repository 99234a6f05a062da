#include "procedural/evaluate/evaluation.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>

#include "guides/helix/super_helix.h"
#include "procedural/expand/expand.h"
#include "tests/procedural/made_strands.h"

namespace lancret {
namespace {

using test::curly_strands;

/// 100 strands on a square, translated copies of one strand.
Strands same_strands(double turns) {
    const Strands one = curly_strands(1, 1, turns);
    Strands out;
    for (int i = 0; i < 100; ++i) {
        const Vec3f move = Vec3f(float(i % 10), float(i / 10), 0) - one.points[0];
        for (const Vec3f& p : one.points) out.points.push_back(p + move);
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

GuideProfiles<float> profiles_of(const HoldOut& holdout) {
    return guide_profiles<float>(holdout.guides, evaluation_intervals(holdout.guides));
}

TEST(Evaluation, EveryBlendPredictsStrandsThatAreAllTheSame) {
    for (const double turns : {0.0, 3.0}) {
        const HoldOut holdout =
            hold_out(same_strands(turns), nullptr, {.guides = {.number = 9}}, "g");
        const auto profiles = profiles_of(holdout);
        for (const BlendTraits& entry : blends()) {
            const BlendEvaluation found = evaluate_blend(holdout, profiles, entry.blend);
            // The remaining error is that of the guide's fit and float round-off: 6e-8
            // per step over at most 128 steps, and 4 * 6e-8 for places up to 20 cm away
            // on strands of at least 5 cm.
            const double off = holdout.fit.rms.p95 + 128 * 6e-8 + 4 * 6e-8;
            EXPECT_LE(found.figures.rms.p95, off) << entry.name << " " << turns;
            EXPECT_LE(found.figures.place.p95, off) << entry.name << " " << turns;
            EXPECT_LE(found.length_error_max, 1e-5) << entry.name << " " << turns;
        }
    }
}

TEST(Evaluation, PositionShortensBetweenGuidesThatPointApart) {
    // Two guides lean 45 degrees to either side. The strand between them is upright and,
    // blended by position, has cos 45 degrees times their length.
    Strands strands;
    for (const float side : {-1.0f, 0.0f, 1.0f}) {
        for (int j = 0; j < 20; ++j) {
            const float s = 10 * float(j) / 19;
            strands.points.push_back(Vec3f(side, 0, 0) +
                                     s * Vec3f(side, 0, 1).normalized());
        }
        strands.first.push_back(std::uint32_t(strands.points.size()));
    }
    // The first guide is an outer strand, and the farthest from it is the other one.
    const HoldOut holdout =
        hold_out(strands, nullptr,
                 {.guides = {.number = 2}, .bind = {.neighbours = 2}, .seed = 0}, "g");
    ASSERT_EQ(holdout.child_strands, std::vector<std::uint32_t>{1});
    const auto profiles = profiles_of(holdout);
    const BlendEvaluation by_place = evaluate_blend(holdout, profiles, Blend::position);
    EXPECT_NEAR(by_place.length_error_max, 1 - std::sqrt(0.5), 1e-5);
    // At the fraction s of its length it is too low by s (1 - sqrt(1/2)) of the length.
    // The mean of s^2 over the 65 samples s = j / 64 is 64 * 65 * 129 / 6 / 64^2 / 65 =
    // 129 / (6 * 64).
    EXPECT_NEAR(by_place.figures.tip.median, 1 - std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(by_place.figures.rms.median,
                (1 - std::sqrt(0.5)) * std::sqrt(129.0 / (6 * 64)), 1e-5);
    const BlendEvaluation by_curvature =
        evaluate_blend(holdout, profiles, Blend::option1);
    EXPECT_LE(by_curvature.length_error_max, 1e-5);
    EXPECT_LE(by_curvature.figures.rms.median, 1e-5);
}

TEST(Evaluation, PredictionsAreTheSameForAnyThreadCount) {
    const Strands strands = curly_strands(200, 3);
    const auto run = [&] {
        const HoldOut holdout = hold_out(strands, nullptr, {}, "g");
        return predict(holdout, profiles_of(holdout), Blend::option1);
    };
    const Prediction all = run();
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    const Prediction one = run();
    EXPECT_EQ(std::memcmp(all.strands.points.data(), one.strands.points.data(),
                          all.strands.points.size() * sizeof(Vec3)),
              0);
    EXPECT_EQ(all.length_errors, one.length_errors);
}

TEST(Evaluation, PlacesBetweenStatesLieOnTheStrand) {
    // Children with one guide are copies of it, and 48 or 96 intervals have no state at
    // every 64th of the length.
    const HoldOut holdout = hold_out(
        curly_strands(60, 4), nullptr,
        {.guides = {.share = 0.2}, .segments = 48, .bind = {.neighbours = 1}}, "g");
    const int n = evaluation_intervals(holdout.guides);
    ASSERT_NE(n % kCompareSteps, 0);
    const Prediction made =
        predict(holdout, guide_profiles<float>(holdout.guides, n), Blend::option1);
    for (std::size_t c = 0; c < holdout.binding.size(); ++c) {
        const std::uint32_t g = holdout.binding.guides[c];
        const SuperHelix guide = super_helix(holdout.guides, g);
        const double length = guide_length(holdout.guides, g);
        const Vec3 move = holdout.truth.strand(c)[0] - guide.root.position;
        for (int j = 0; j <= kCompareSteps; ++j) {
            const HelixState<double> exact = state_at(guide, length * j / kCompareSteps);
            // Float round-off of 96 steps, each of which rotates the rest of the strand.
            const double off = 96 * 1.2e-7 * length;
            EXPECT_LT((exact.position + move - made.strands.strand(c)[j]).norm(), off);
            const Vec3f tangent = made.tangents[c * (kCompareSteps + 1) + j];
            EXPECT_LT((exact.frame.col(0).cast<float>() - tangent).norm(),
                      96 * 1.2e-7 * 4);
        }
    }
}

TEST(Evaluation, IntervalsAreAMultipleOfTheSegmentsAndTurnLittle) {
    for (const int segments : {1, 6, 7, 64, 200}) {
        for (const double curvature : {0.0, 0.5, 5.0}) {
            Guides guides;
            guides.segments = segments;
            guides.root_positions = {Vec3::Zero()};
            guides.root_frames = {Mat3::Identity()};
            guides.segment_lengths.assign(segments, 20.0 / segments);
            guides.curvatures.assign(segments, Vec3(0, 0, curvature));
            const int n = evaluation_intervals(guides);
            EXPECT_EQ(n % segments, 0);
            EXPECT_GE(n, kCompareSteps);
            EXPECT_LE(curvature * 20 / n, 0.5 + 1e-12) << segments << " " << curvature;
        }
    }
}

}  // namespace
}  // namespace lancret
