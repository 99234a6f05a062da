#pragma once
// What covers a pixel, near to far.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// One strand (or the mesh) where it is seen in a pixel. Radiance and coverage are as of
/// rgba: what it adds to the pixel, with all that hides it in front already taken off.
struct DeepSample {
    std::uint32_t id = 0;            ///< strand or kMeshId
    float depth = 0;                 ///< along the direction of sight, cm
    float coverage = 0;              ///< share of the pixel
    Vec3f radiance = Vec3f::Zero();  ///< times coverage
};

/// Joins samples of one id that are no further than `gap` times their depth behind one
/// another: sums of coverage and radiance, the mean depth by coverage. Sorted by id, then
/// depth; what comes out depends on the order of equals alone.
void merge(std::vector<DeepSample>& samples, float gap);

/// One that compositors take: alone, not as seen behind those in front.
struct DeepPoint {
    std::uint32_t id = 0;
    float depth = 0;
    Eigen::Vector4f rgba = Eigen::Vector4f::Zero();  ///< exact in half precision
};

/// Deep samples for "over" from near to far: sample i adds what it does times the product
/// of 1 - alpha of those before it, so its own values are
///   alpha_i = coverage_i / T_i, rgb_i = radiance_i / T_i, T_i = prod_(j<i) (1 -
///   alpha_j).
/// T is that of the rounded alphas, so that errors of half precision do not add up: the
/// whole comes to the sums of radiance and coverage within 2^-11 of each. Sorted by
/// depth, no two at the same; `points` is overwritten.
void composited(std::span<const DeepSample> samples, std::vector<DeepPoint>& points);

/// "Over" of points from near to far.
Eigen::Vector4f flattened(std::span<const DeepPoint> points);

}  // namespace lancret
