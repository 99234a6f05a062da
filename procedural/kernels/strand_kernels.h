#pragma once
// Expansion by vectors: one set of kernels, compiled for every instruction set that
// Highway knows and chosen when the program runs.
//
// A strand's bits depend on the strand alone and on the instruction set: not on the lane
// it falls into, its neighbours, nor on how many are expanded at a time. Between sets
// they differ by round-off: those with a fused multiply-add (AVX2, AVX-512, NEON) round
// once where SSE and plain code round twice.

#include <span>

#include "procedural/kernels/kernel_input.h"

namespace lancret {

/// Whether a kernel writes the control points; if not, the scalar blends do.
bool has_kernel(Blend blend, CurveBasis basis);

/// Frames and places of `count` children from `first` on, as their control points are
/// made of them: intervals + 1 of each in `states`. For blends that go along curvatures.
void synthesize_strands(const KernelInput& in, std::size_t first, std::size_t count,
                        std::span<HelixState<float>> states);

/// Control points of children whose blend has a kernel.
void expand_strands(const KernelInput& in, const KernelOutput& out);

/// The control point that each segment of `count` strands begins with, to `segments`;
/// `first` is the first of these points.
void number_segments(std::size_t first, std::size_t count, std::uint32_t points,
                     std::uint32_t intervals, std::uint32_t* segments, bool past_caches);

}  // namespace lancret
