#include "procedural/check/frames_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// A report of two strands; the second has this length error.
CheckReport report_of(float length_error) {
    CheckReport out;
    out.strands.resize(2);
    out.strands[1].strand = 1;
    out.strands[1].length_error = length_error;
    return out;
}

TEST(CheckFrames, ReportsTheWorstValueAndItsFrame) {
    FramesReport report;
    add_frame(report, 7, report_of(2e-6f), {});
    add_frame(report, 8, report_of(-8e-6f), {});
    add_frame(report, 9, report_of(4e-6f), {});
    EXPECT_TRUE(report.pass());
    EXPECT_EQ(report.worst_frame, 8);
    EXPECT_EQ(report.worst.strands[1].length_error, -8e-6f);
    const nlohmann::json json = frames_json(report);
    const auto& length = json["worst_over_frames"]["length"];
    EXPECT_EQ(length["frame"], 8);
    EXPECT_EQ(length["max_relative_error"], double(8e-6f));
    EXPECT_EQ(json["frames"][2]["length"]["max_relative_error"], double(4e-6f));
}

TEST(CheckFrames, OneStrandOfOneFrameFailsTheRun) {
    FramesReport report;
    add_frame(report, 1, report_of(0), {});
    add_frame(report, 2, report_of(2e-5f), {});  // twice the tolerance
    EXPECT_FALSE(report.pass());
    EXPECT_EQ(report.frames[1].failed, 1u);
    EXPECT_THAT(frames_table(report),
                HasSubstr("FAIL: 1 of 2 frames exceed a tolerance, the first is 2"));
}

TEST(CheckFrames, NaNFailsAndBecomesNull) {
    FramesReport report;
    add_frame(report, 1, report_of(std::numeric_limits<float>::quiet_NaN()), {});
    EXPECT_FALSE(report.pass());
    EXPECT_TRUE(frames_json(report)["worst_over_frames"]["length"]["max_relative_error"]
                    .is_null());
}

TEST(CheckFrames, GuidesOffTheScalpFailOnlyIfThatApplies) {
    GuideCheck guides;
    guides.root_distance = 1;
    guides.root_applies = false;
    FramesReport lenient, strict;
    add_frame(lenient, 1, report_of(0), guides);
    EXPECT_TRUE(lenient.pass());
    guides.root_applies = true;
    add_frame(strict, 1, report_of(0), guides);
    EXPECT_FALSE(strict.pass());
}

TEST(CheckFrames, AStepBeyondTheBlendsLimitFailsTheRun) {
    const auto run = [](double share, std::optional<double> limit) {
        FramesReport report;
        add_frame(report, 3, report_of(0), {});
        add_frame(report, 3.5, report_of(0), {});
        MotionReport motion;
        motion.amplification = 35;
        motion.child = 1;
        motion.motion = {35, 1, limit};
        motion.share_of_limit = share;
        add_step(report, 3, 3.5, motion);
        return report;
    };
    EXPECT_TRUE(run(1, 35).pass());
    EXPECT_TRUE(run(0, std::nullopt).pass());
    const FramesReport beyond = run(1.01, 34.65);
    EXPECT_FALSE(beyond.pass());
    EXPECT_THAT(frames_table(beyond), HasSubstr("FAIL: 1 of 1 steps exceed the "
                                                "blend's limit, the first is 3 to 3.5"));
    const nlohmann::json json = frames_json(beyond)["motion"];
    EXPECT_EQ(json["amplification"], 35);
    EXPECT_EQ(json["share_of_limit"], 1.01);
    EXPECT_EQ(json["to"], 3.5);
    const auto free = frames_json(run(0, std::nullopt))["motion"];
    EXPECT_TRUE(free["share_of_limit"].is_null());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(run(nan, 35).pass());
}

TEST(CheckGuides, MeasuresEveryError) {
    const Guides rest = test::random_guides(5, 3, 1);
    const auto check_of = [&](auto change) {
        Guides now = rest;
        change(now);
        return check_guides(now, rest, rest.root_positions);
    };
    const CheckTolerances tolerances;
    const GuideCheck same = check_of([](Guides&) {});
    EXPECT_TRUE(passes(same, tolerances));
    EXPECT_EQ(same.root_distance, 0);
    const GuideCheck off = check_of([](Guides& g) { g.root_positions[3].x() += 0.25; });
    // Coordinates below 8 are rounded by 2^-50.
    EXPECT_NEAR(off.root_distance, 0.25, 1e-14);
    EXPECT_EQ(off.worst_root, 3u);
    EXPECT_FALSE(passes(off, tolerances));
    // (1 + x)^2 - 1 = 2 x, up to x^2 and round-off.
    const GuideCheck large = check_of([](Guides& g) { g.root_frames[2] *= 1 + 1e-4; });
    EXPECT_NEAR(large.orthogonality, 2e-4, 2e-8);
    EXPECT_FALSE(passes(large, tolerances));
    const GuideCheck longer = check_of([](Guides& g) { g.segment_lengths[4] *= 1.5; });
    EXPECT_NEAR(longer.length_change, 0.5, 1e-15);
    EXPECT_FALSE(passes(longer, tolerances));
    const GuideCheck nan = check_of([](Guides& g) {
        g.curvatures[1].x() = std::numeric_limits<double>::quiet_NaN();
    });
    EXPECT_FALSE(passes(nan, tolerances));
    EXPECT_THROW(check_guides(test::random_guides(4, 3, 1), rest, rest.root_positions),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
