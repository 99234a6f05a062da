#pragma once
// A batch of strands, one per vector lane. Arrays are [...][lanes], so that a row is a
// vector.

#include <hwy/aligned_allocator.h>

#include "procedural/bind/child.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

/// Maximum turn of an interval in the kernel, radian. Anchored frames are connected by
/// the helix of less than half a turn in any case, so the limit is that of lanes_step;
/// without anchoring that helix is the guide's only up to half a turn.
inline constexpr float kMaxTurnAnchored = 6.28f, kMaxTurnAlone = 3.1f;

/// Normals with a smaller cosine are opposed, as in smallest_rotation.
inline constexpr float kOpposedCosine = -1 + 1e-6f;

struct StrandBatch {
    std::size_t intervals, stride, neighbours;
    LightChild children[kMaxLanes];
    const float* record_rows[kMaxNeighbours][kMaxLanes];  ///< transposed: `records`
    bool
        scalar[kMaxLanes];  ///< needs the scalar blend: turns too far, or opposed normals

    alignas(64) float length[kMaxLanes];           ///< cm
    alignas(64) float width[kMaxLanes];            ///< Roots::width
    alignas(64) float root[3][kMaxLanes];          ///< cm
    alignas(64) float normal[3][kMaxLanes];        ///< of the scalp at the root
    alignas(64) float start_normal[3][kMaxLanes];  ///< of the scalp at the heaviest
                                                   ///< guide's root
    alignas(64) float start[4][kMaxLanes];  ///< w x y z: the root frame, see lanes_start
    alignas(64) float shares[kMaxNeighbours][kMaxLanes];       ///< w L over their sum
    alignas(64) float records[kMaxNeighbours][16][kMaxLanes];  ///< GuideRecord

    hwy::AlignedFreeUniquePtr<float[]> rows;  ///< [3][lanes][stride]: blended kappa and
                                              ///< tau, advances
    hwy::AlignedFreeUniquePtr<float[]> joint_rows;     ///< [2][lanes][joint_stride]:
                                                       ///< cosines, sines of N~'s turns
    hwy::AlignedFreeUniquePtr<float[]> joint_columns;  ///< [2][joint_stride][lanes]
    hwy::AlignedFreeUniquePtr<float[]> curvatures;     ///< [3][stride][lanes] 1/cm
    hwy::AlignedFreeUniquePtr<float[]> advances;       ///< [stride][lanes]
    hwy::AlignedFreeUniquePtr<float[]> frames;         ///< [places][4][lanes] w x y z
    hwy::AlignedFreeUniquePtr<float[]> places;  ///< [places + 4][3][lanes], relative to
                                                ///< the root, cm; two beyond each end
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
