#pragma once

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Control points of children, blend `position`: the weighted sum of their guides'.
void expand_positions(const KernelInput& in, const KernelOutput& out);

}  // namespace lancret
