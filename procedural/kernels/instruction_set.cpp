// The name of the instruction set that Highway chooses at run time.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/instruction_set.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "procedural/kernels/instruction_set.h"

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

const char* InstructionSet() { return hwy::TargetName(HWY_TARGET); }

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lancret {

HWY_EXPORT(InstructionSet);

const char* kernel_instruction_set() { return HWY_DYNAMIC_DISPATCH(InstructionSet)(); }

}  // namespace lancret
#endif
