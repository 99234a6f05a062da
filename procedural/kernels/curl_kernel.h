#pragma once

#include "procedural/kernels/strand_kernels.h"

namespace lancret {

/// Whether the blend goes along curvatures and has a kernel.
bool is_curl(Blend blend);

/// Control points of children, for blends that go along curvatures.
void expand_curls(const KernelInput& in, const KernelOutput& out);

/// Their frames and places: `states` has intervals + 1 for each.
void synthesize_curls(const KernelInput& in, std::size_t first, std::size_t count,
                      std::span<HelixState<float>> states);

}  // namespace lancret
