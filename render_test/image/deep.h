#pragma once
// The surfaces that cover a pixel, near to far.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// One strand (or the mesh) as seen in a pixel. Radiance and coverage are its
/// contribution to the pixel's rgba, less what is hidden by surfaces in front.
struct DeepSample {
    std::uint32_t id = 0;            ///< strand or kMeshId
    float depth = 0;                 ///< along the viewing direction, cm
    float coverage = 0;              ///< share of the pixel
    Vec3f radiance = Vec3f::Zero();  ///< times coverage
};

/// Joins samples of one id that are at most `gap` times their depth behind one another:
/// sums of coverage and radiance, mean depth weighted by coverage. The result is sorted
/// by id, then depth, and depends on the input order only for equal keys.
void merge(std::vector<DeepSample>& samples, float gap);

/// A sample for compositing: its own colour, not reduced by what is in front.
struct DeepPoint {
    std::uint32_t id = 0;
    float depth = 0;
    Eigen::Vector4f rgba = Eigen::Vector4f::Zero();  ///< exact in half precision
};

/// Converts deep samples for "over" from near to far. There a sample contributes its own
/// values times the product of 1 - alpha of those before it, so
///   alpha_i = coverage_i / T_i, rgb_i = radiance_i / T_i, T_i = prod_(j<i) (1 -
///   alpha_j).
/// T uses the rounded alphas, so errors of half precision do not accumulate: "over" of
/// all points equals the sums of radiance and coverage within 2^-11 of each. The result,
/// which overwrites `points`, is sorted by depth, without equal depths.
void composited(std::span<const DeepSample> samples, std::vector<DeepPoint>& points);

}  // namespace lancret
