#pragma once
// Guides as the kernels read them: structures of arrays, in space where that saves a
// rotation for each child.

#include <cstdint>
#include <span>
#include <vector>

#include "procedural/blend/blend.h"
#include "procedural/curves/buffer.h"

namespace lancret {

/// What one cache line tells of a guide: what anchoring needs of it.
struct alignas(64) GuideRecord {
    float normal[3];              ///< of the scalp at its root
    float turns;                  ///< of its spine
    float spine[kSpineTerms][3];  ///< in space, as the guide stands
};

/// Guides of one pose. Rows are aligned, and padded with zeros to a whole number of
/// the longest vectors: those of guide g begin at g * 3 * stride (three coordinates, one
/// row each) or at g * stride.
struct KernelGuides {
    std::size_t count = 0;         ///< intervals of each
    std::size_t place_stride = 0;  ///< of rows of count + 1 places or count intervals

    // For `position`.
    std::size_t point_stride = 0;  ///< of rows of count + 3 control points
    Buffer<float> points;          ///< [guides][3][point_stride] B-spline control points
                                   ///< from the root, in space, cm

    // For what goes along curvatures.
    Buffer<float> curvatures;        ///< [guides][3][place_stride] Darboux vectors, 1/cm
    Buffer<float> advances;          ///< [guides][place_stride] of their spines
    std::vector<float> most_curved;  ///< [guides] 1/cm: the longest Darboux vector
    std::vector<GuideRecord> records;             ///< [guides]
    std::vector<Eigen::Quaternionf> root_frames;  ///< [guides]

    // For option 1.
    Buffer<float> frenet;  ///< [guides][8][place_stride] of intervals: kappa, tau,
                           ///< T, N in the middle, in space
    std::vector<std::uint32_t> joint_places;  ///< the root, and where N may jump
    std::size_t joint_stride = 0;             ///< of rows of joint_places
    Buffer<float> joints;  ///< [guides][11][joint_stride]: T; N and kappa before the
                           ///< joint, 0 at the root; N and kappa after it

    std::size_t size = 0;  ///< guides
    std::size_t bytes() const;
};

/// What the kernel of `blend` reads; nothing where it has none. `normals` are the scalp's
/// at the guides' roots, in the pose of `profiles`. Throws std::invalid_argument where
/// their number is another.
KernelGuides kernel_guides(const GuideProfiles<float>& profiles,
                           std::span<const Vec3f> normals, Blend blend);

}  // namespace lancret
