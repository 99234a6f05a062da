#pragma once

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Writes the control points of children, for blends with BlendKernel::position.
void expand_positions(const KernelInput& in, const KernelOutput& out);

}  // namespace lancret
