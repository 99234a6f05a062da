#pragma once
// Guides as the kernels read them: structures of arrays, in space where that saves a
// rotation for each child.

#include <cstdint>
#include <span>
#include <vector>

#include "procedural/guide_profiles.h"

namespace lancret {

/// What one cache line tells of a guide: what anchoring needs of it.
struct alignas(64) GuideRecord {
    float normal[3];              ///< of the scalp at its root
    float turns;                  ///< of its spine
    float spine[kSpineTerms][3];  ///< in space, as the guide stands
};

/// Guides of one pose. Rows are padded with zeros to a whole number of the longest
/// vectors: those of guide g begin at g * 3 * stride (three coordinates, one row each) or
/// at g * stride.
struct KernelGuides {
    std::size_t count = 0;          ///< intervals of each
    std::size_t point_stride = 0;   ///< of rows of count + 3 control points
    std::size_t place_stride = 0;   ///< of rows of count + 1 places or count intervals
    std::vector<float> points;      ///< [guides][3][point_stride] B-spline control points
                                    ///< from the root, in space, cm
    std::vector<float> curvatures;  ///< [guides][3][place_stride] Darboux vectors, 1/cm
    std::vector<float> advances;    ///< [guides][place_stride] of their spines
    std::vector<float> most_curved;    ///< [guides] 1/cm: the longest Darboux vector
    std::vector<GuideRecord> records;  ///< [guides]
    std::vector<Eigen::Quaternionf> root_frames;  ///< [guides]

    std::size_t size() const { return most_curved.size(); }
    std::size_t bytes() const;
};

/// `normals` are the scalp's at the guides' roots, in the pose of `profiles`.
KernelGuides kernel_guides(const GuideProfiles<float>& profiles,
                           std::span<const Vec3f> normals);

}  // namespace lancret
