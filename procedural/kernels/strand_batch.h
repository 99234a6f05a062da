#pragma once
// As many strands as a vector has lanes, on their way through the kernels. Arrays are
// [...][lanes], so that a row is a vector.

#include <hwy/aligned_allocator.h>

#include "procedural/bind/child.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

/// An interval may turn by so many radians in a kernel: as far as lane_math.inl has a
/// step. Where frames are turned once more after it, the blends themselves take the helix
/// of less than half a turn between two; where they are not, only up to half a turn is
/// that one the guide's.
inline constexpr float kMaxTurnAnchored = 6.28f, kMaxTurnAlone = 3.1f;

/// The cosine between two normals below which they are opposed, for smallest_rotation
/// too.
inline constexpr float kOpposedCosine = -1 + 1e-6f;

/// The longest vector, in floats.
inline constexpr std::size_t kMaxLanes = 16;

struct StrandBatch {
    std::size_t intervals, stride, neighbours;
    LightChild children[kMaxLanes];
    const float* record_rows[kMaxNeighbours][kMaxLanes];  ///< to be `records`
    bool scalar[kMaxLanes];  ///< left to the scalar blends: turns or normals too far

    alignas(64) float length[kMaxLanes];           ///< cm
    alignas(64) float width[kMaxLanes];            ///< over the strand's own
    alignas(64) float root[3][kMaxLanes];          ///< cm
    alignas(64) float normal[3][kMaxLanes];        ///< of the scalp at the root
    alignas(64) float start_normal[3][kMaxLanes];  ///< at the heaviest guide's root
    alignas(64) float start[4][kMaxLanes];         ///< w x y z: its root frame
    alignas(64) float shares[kMaxNeighbours][kMaxLanes];       ///< w L over their sum
    alignas(64) float records[kMaxNeighbours][16][kMaxLanes];  ///< GuideRecord

    hwy::AlignedFreeUniquePtr<float[]> rows;  ///< [3][lanes][stride]: kappa and tau of
                                              ///< blends that make their own, advances
    hwy::AlignedFreeUniquePtr<float[]> joint_rows;     ///< [2][lanes][joint_stride]:
                                                       ///< cosines, sines of turns
    hwy::AlignedFreeUniquePtr<float[]> joint_columns;  ///< [2][joint_stride][lanes]
    hwy::AlignedFreeUniquePtr<float[]> curvatures;     ///< [3][stride][lanes] 1/cm
    hwy::AlignedFreeUniquePtr<float[]> advances;       ///< [stride][lanes]
    hwy::AlignedFreeUniquePtr<float[]> frames;         ///< [places][4][lanes] w x y z
    hwy::AlignedFreeUniquePtr<float[]> places;  ///< [places + 4][3][lanes] from the root
                                                ///< in cm; two beyond each end
    hwy::AlignedFreeUniquePtr<float[]> points;  ///< [control points][lanes][4]

    StrandBatch(const KernelInput& in, std::size_t lanes)
        : intervals(in.guides.count),
          stride(in.guides.place_stride),
          neighbours(std::size_t(in.binding.neighbours)),
          rows(hwy::AllocateAligned<float>(3 * lanes * stride)),
          joint_rows(hwy::AllocateAligned<float>(2 * lanes * in.guides.joint_stride + 1)),
          joint_columns(
              hwy::AllocateAligned<float>(2 * lanes * in.guides.joint_stride + 1)),
          curvatures(hwy::AllocateAligned<float>(3 * lanes * stride)),
          advances(hwy::AllocateAligned<float>(lanes * stride)),
          frames(hwy::AllocateAligned<float>((intervals + 1) * 4 * lanes)),
          places(hwy::AllocateAligned<float>((intervals + 5) * 3 * lanes)),
          points(hwy::AllocateAligned<float>((intervals + 3) * 4 * lanes)) {}
};

}  // namespace lancret
