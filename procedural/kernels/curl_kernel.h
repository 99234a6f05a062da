#pragma once

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Control points of children, for blends that go along curvatures.
void expand_curls(const KernelInput& in, const KernelOutput& out);

/// Their frames and places: synthesize_strands.
void synthesize_curls(const KernelInput& in, std::size_t first, std::size_t count,
                      std::span<HelixState<float>> states);

}  // namespace lancret
