#pragma once

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Writes the control points of children, for blends with BlendKernel::curl.
void expand_curls(const KernelInput& in, const KernelOutput& out);

/// Writes their frames and places: see synthesize_strands.
void synthesize_curls(const KernelInput& in, std::size_t first, std::size_t count,
                      std::span<HelixState<float>> states);

}  // namespace lancret
