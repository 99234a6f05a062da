#include "procedural/check/groom_check.h"
#include "tests/procedural/small_groom.h"

#include <gtest/gtest.h>

#include <vector>

namespace lancret {
namespace {

GroomSettings groom_to_check() {
    return test::small_groom({.made = 40, .guides = 12, .segments = 6, .strands = 500});
}

TEST(GroomCheck, MeasuresChildrenAndChunksOfAGroomAtRest) {
    ReadyGroom ready = make_ready_groom(groom_to_check());
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
    ReadyGroom ready = make_ready_groom(groom_to_check());
    const std::vector<double> frames{0};
    EXPECT_FALSE(check_groom(ready, {}, frames, {.distance = 0}).pass);
}

}  // namespace
}  // namespace lancret
