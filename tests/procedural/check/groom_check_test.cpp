#include "procedural/check/groom_check.h"

#include <gtest/gtest.h>

#include <vector>

namespace lancret {
namespace {

GroomSettings small_groom() {
    GroomSettings groom;
    groom.name = "small";
    groom.made.strands = 40;
    groom.guides.number = 12;
    groom.fit.segments = 6;
    groom.strands = 500;
    return groom;
}

TEST(GroomCheck, MeasuresChildrenAndChunksOfAGroomAtRest) {
    ReadyGroom ready = make_ready_groom(small_groom());
    CheckTolerances tolerances;
    tolerances.distance = ready.groom.tolerance;
    std::vector<double> progress;
    const std::vector<double> frames{0};
    const GroomCheck check = check_groom(ready, {}, frames, tolerances,
                                         [&](double done) { progress.push_back(done); });
    EXPECT_TRUE(check.chunks.pass());
    EXPECT_EQ(check.chunks.strands, 500u);
    EXPECT_EQ(check.curves.strands, 500u);
    EXPECT_EQ(check.frames.worst.strands.size(), 500u);
    EXPECT_EQ(check.pass, check.frames.worst.pass());
    EXPECT_EQ(check.frames.frames.size(), 1u);
    EXPECT_TRUE(check.frames.steps.empty());
    EXPECT_EQ(progress, std::vector<double>{1});
}

TEST(GroomCheck, FailsIfAToleranceIsExceeded) {
    ReadyGroom ready = make_ready_groom(small_groom());
    const std::vector<double> frames{0};
    EXPECT_FALSE(check_groom(ready, {}, frames, {.distance = 0}).pass);
}

}  // namespace
}  // namespace lancret
