#pragma once
// The axis of a strand between its control points, by the same splines as in Embree.

#include <cstdint>

#include "procedural/curves/curves.h"

namespace lancret {

/// Axis and radius at a point of a segment, and their derivatives.
struct AxisPoint {
    Eigen::Vector4f value;       ///< position, radius; cm
    Eigen::Vector4f derivative;  ///< by u, cm
};

/// The axis at `u` (0..1) of a segment, counted over all strands as in Curves.
AxisPoint axis_point(const Curves& curves, std::uint32_t segment, float u);

/// The normal of a strand's face, of any length; needs `curves.normals`.
Vec3f face_normal(const Curves& curves, std::uint32_t segment, float u);

/// The axis of control points interpolated from one time to another by `share` (0..1).
AxisPoint axis_point(const Curves& from, const Curves& to, float share,
                     std::uint32_t segment, float u);

}  // namespace lancret
