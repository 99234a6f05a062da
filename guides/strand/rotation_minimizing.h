#pragma once
// Rotation-minimising (Bishop) frames: carried along a strand without turning about its
// tangent. They exist for straight hair too.

#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// The direction of the part of `normal` across the unit vector `tangent`. If `normal` is
/// zero or along `tangent`, a fixed choice across `tangent`.
Vec3 across_tangent(const Vec3& normal, const Vec3& tangent);

/// The frame [T M T x M], M = across_tangent(normal, tangent). A strand's root frame
/// comes from the scalp's surface tangent in this way.
Mat3 frame_from_normal(const Vec3& normal, const Vec3& tangent);

/// The frames [T, M, T x M] at samples of a strand. The first has M =
/// across_tangent(normal, tangents[0]); the others follow without turning about T. By
/// reflection in the plane between two positions, then between two tangents: the global
/// error is of order 4 in the spacing. `positions` (cm) and `tangents` (unit) have the
/// same size.
std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> positions,
                                             std::span<const Vec3> tangents,
                                             const Vec3& normal);

/// The same from tangents only, by the smallest rotation from each to the next: order 2.
std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> tangents,
                                             const Vec3& normal);

}  // namespace lancret
