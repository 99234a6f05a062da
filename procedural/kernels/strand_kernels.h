#pragma once
// Vectorised expansion: kernels that are compiled for every instruction set that Highway
// supports and chosen at run time.
//
// A strand's bits depend only on the strand and on the instruction set, not on its lane,
// its neighbours or the number of strands expanded together. Instruction sets differ by
// round-off: a fused multiply-add (AVX2, AVX-512, NEON) rounds once, SSE and scalar code
// twice.

#include <span>

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Whether a kernel writes the control points; if not, the scalar blends do.
bool has_kernel(Blend blend, CurveBasis basis);

/// Writes frames and places of the children [first, first + count), from which
/// expand_strands makes their control points: intervals + 1 per child in `states`. For
/// blends with BlendKernel::curl.
void synthesize_strands(const KernelInput& in, std::size_t first, std::size_t count,
                        std::span<HelixState<float>> states);

/// Writes the control points of children whose blend has a kernel.
void expand_strands(const KernelInput& in, const KernelOutput& out);

/// Writes to `segments` the index of the first control point of each segment, for `count`
/// strands of `points` control points and `intervals` segments. `first` is the index of
/// their first control point. With `past_caches` the stores bypass the caches.
void number_segments(std::size_t first, std::size_t count, std::uint32_t points,
                     std::uint32_t intervals, std::uint32_t* segments, bool past_caches);

}  // namespace lancret
