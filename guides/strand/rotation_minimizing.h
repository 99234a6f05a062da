#pragma once
// Rotation-minimising (Bishop) frames: carried along a strand without turning about its
// tangent. Defined on straight hair too.

#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// The unit vector of `normal` across the unit vector `tangent`; where they are parallel,
/// or `normal` is zero, any across `tangent` (always the same one).
Vec3 across_tangent(const Vec3& normal, const Vec3& tangent);

/// The frame [T M T x M], M = across_tangent(normal, tangent): how a strand's root frame
/// comes from the scalp's surface tangent.
Mat3 frame_from_normal(const Vec3& normal, const Vec3& tangent);

/// The frames [T, M, T x M] at samples of a strand, of which the first has M =
/// across_tangent(normal, tangents[0]) and the rest do not turn about T. By reflection in
/// the plane between two positions, then between two tangents: a global error of order 4
/// in the spacing. `positions` (cm) and `tangents` (unit) have one size.
std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> positions,
                                             std::span<const Vec3> tangents,
                                             const Vec3& normal);

/// The same from tangents alone, by the smallest rotation from each to the next: order 2.
std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> tangents,
                                             const Vec3& normal);

}  // namespace lancret
