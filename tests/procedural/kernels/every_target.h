#pragma once
// Runs a test on every instruction set that is compiled in and supported by this
// processor.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace lancret::test {

/// Half a unit in the last place of a float in [1, 2): the relative error of one
/// rounding.
inline constexpr double kHalfUlp = 0x1p-24;

/// Calls test() once per instruction set, including the one with a single lane.
template <class Test>
void on_every_target(Test&& test) {
    struct Restore {
        ~Restore() { hwy::SetSupportedTargetsForTest(0); }
    } restore;
    bool plain = false;
    int targets = 0;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        SCOPED_TRACE(hwy::TargetName(target));
        test();
        plain = plain || target == HWY_SCALAR || target == HWY_EMU128;
        ++targets;
    }
    EXPECT_TRUE(plain);
    EXPECT_GE(targets, 2);  // every supported processor has vectors
}

}  // namespace lancret::test
