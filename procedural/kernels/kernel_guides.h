#pragma once
// Guides as the kernels read them: structures of arrays, with vectors in space if that
// saves a rotation per child.

#include <cstdint>
#include <span>
#include <vector>

#include "procedural/blend/blend.h"
#include "procedural/curves/buffer.h"

namespace lancret {

/// Floats in the longest vector that a kernel may use.
inline constexpr std::size_t kMaxLanes = 16;

/// The data of a guide that anchoring needs, in one cache line.
struct alignas(64) GuideRecord {
    float normal[3];              ///< of the scalp at its root
    float turns;                  ///< Spine::turns
    float spine[kSpineTerms][3];  ///< Spine::terms, turned from the root frame to space
};

/// Guides of one pose. Rows are aligned, and padded with zeros to a multiple of the
/// longest vector. With k rows per guide, those of guide g begin at g * k * stride. Only
/// the arrays that the blend's kernel reads are filled.
struct KernelGuides {
    std::size_t count = 0;         ///< intervals per guide
    std::size_t place_stride = 0;  ///< for rows of count + 1 places or count intervals

    // For BlendKernel::position.
    std::size_t point_stride = 0;  ///< for rows of count + 3 control points
    Buffer<float> points;          ///< [guides][3][point_stride] B-spline control points
                                   ///< relative to the root, in space, cm

    // For BlendKernel::curl.
    Buffer<float> curvatures;        ///< [guides][3][place_stride] Darboux vectors, 1/cm
    Buffer<float> advances;          ///< [guides][place_stride] of the spines
    std::vector<float> most_curved;  ///< [guides] 1/cm: the longest Darboux vector
    std::vector<GuideRecord> records;             ///< [guides]
    std::vector<Eigen::Quaternionf> root_frames;  ///< [guides]

    // For BlendRates::blended.
    Buffer<float> frenet;  ///< [guides][8][place_stride] of intervals: kappa, tau,
                           ///< T, N in the middle, in space
    std::vector<std::uint32_t> joint_places;  ///< the root, and places where N may jump
    std::size_t joint_stride = 0;             ///< for rows of joint_places
    Buffer<float> joints;  ///< [guides][11][joint_stride]: T; N and kappa before the
                           ///< joint, 0 at the root; N and kappa after it

    std::size_t size = 0;  ///< guides
    std::size_t bytes() const;
};

/// The guides for the kernel of `blend`; empty if it has none. `normals` are the scalp's
/// at the guides' roots, in the pose of `profiles`. Throws std::invalid_argument if there
/// is not one per guide.
KernelGuides kernel_guides(const GuideProfiles<float>& profiles,
                           std::span<const Vec3f> normals, Blend blend);

}  // namespace lancret
