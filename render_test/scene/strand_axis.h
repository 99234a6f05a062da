#pragma once
// The axis of a strand between its control points, by the same splines as Embree's.

#include <cstdint>

#include "procedural/curves/curves.h"

namespace lancret {

/// Axis and radius at a place of a segment, and how they change.
struct AxisPoint {
    Eigen::Vector4f value;       ///< position, radius; cm
    Eigen::Vector4f derivative;  ///< by u, cm
};

/// The axis at `u` (0..1) of a segment (counted over all strands, as Curves says).
AxisPoint axis_point(const Curves& curves, std::uint32_t segment, float u);

/// The normal of a strand's face there, of any length; needs `curves.normals`.
Vec3f face_normal(const Curves& curves, std::uint32_t segment, float u);

/// The same `share` (0..1) of the way from one time's control points to another's.
AxisPoint axis_point(const Curves& from, const Curves& to, float share,
                     std::uint32_t segment, float u);

}  // namespace lancret
