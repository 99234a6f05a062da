#pragma once
// As many strands as a vector has lanes, on their way through the kernels. Arrays are
// [...][lanes], so that a row is a vector.

#include <hwy/aligned_allocator.h>

#include "procedural/kernels/light_child.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

/// An interval may turn by so many radians in a kernel.
inline constexpr float kMostKernelTurn = 2;

/// The cosine between two normals below which they are opposed, for smallest_rotation
/// too.
inline constexpr float kOpposedCosine = -1 + 1e-6f;

/// The longest vector, in floats.
inline constexpr std::size_t kMostLanes = 16;

struct StrandBatch {
    std::size_t intervals, stride, neighbours;
    LightChild children[kMostLanes];
    bool scalar[kMostLanes];  ///< left to the scalar blends: turns or normals too far

    alignas(64) float length[kMostLanes];           ///< cm
    alignas(64) float root[3][kMostLanes];          ///< cm
    alignas(64) float normal[3][kMostLanes];        ///< of the scalp at the root
    alignas(64) float start_normal[3][kMostLanes];  ///< at the heaviest guide's root
    alignas(64) float start[4][kMostLanes];         ///< w x y z: its root frame
    alignas(64) float shares[kMaxNeighbours][kMostLanes];       ///< w L over their sum
    alignas(64) float records[kMaxNeighbours][16][kMostLanes];  ///< GuideRecord
    alignas(64) std::int32_t curvature_row[kMostLanes];         ///< its first float

    hwy::AlignedFreeUniquePtr<float[]> advances;  ///< [lanes][stride], blended
    hwy::AlignedFreeUniquePtr<float[]> rates;     ///< [lanes][3][stride] curvatures of
                                                  ///< blends that make their own, 1/cm
    hwy::AlignedFreeUniquePtr<float[]> frames;    ///< [places][4][lanes] w x y z
    hwy::AlignedFreeUniquePtr<float[]> places;  ///< [places + 4][3][lanes] from the root
                                                ///< in cm; two beyond each end
    hwy::AlignedFreeUniquePtr<float[]> points;  ///< [control points][lanes][4]

    StrandBatch(const KernelInput& in, std::size_t lanes)
        : intervals(in.guides.count),
          stride(in.guides.place_stride),
          neighbours(std::size_t(in.binding.neighbours)),
          advances(hwy::AllocateAligned<float>(lanes * stride)),
          rates(hwy::AllocateAligned<float>(lanes * 3 * stride)),
          frames(hwy::AllocateAligned<float>((intervals + 1) * 4 * lanes)),
          places(hwy::AllocateAligned<float>((intervals + 5) * 3 * lanes)),
          points(hwy::AllocateAligned<float>((intervals + 3) * 4 * lanes)) {}
};

}  // namespace lancret
