#pragma once
// Measurements on one strand, from places, frames and control points alone.

#include <span>

#include "guides/helix/helix.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// One interval between two places, as a helix that has these ends.
struct MeasuredInterval {
    double length;  ///< cm
    double kappa;   ///< 1/cm, >= 0
    double tau;     ///< 1/cm
    Vec3 axis;      ///< unit rotation axis in the frame at its start
    double angle;   ///< of the rotation, radians
};

/// The arc length, curvature and torsion of the helix from `a` to `b`: the rotation
/// between the frames gives axis and angle, the chord the scale.
MeasuredInterval measured_interval(const HelixState<float>& a,
                                   const HelixState<float>& b);

/// The place at share t of the interval that starts at `a`.
Vec3 place_on(const HelixState<float>& a, const MeasuredInterval& interval, double t);

/// max |R^T R - 1| over the frames; infinity where one is not finite.
double orthogonality_error(std::span<const HelixState<float>> states);

/// The emitted curve of strand i of `curves`.
struct EmittedStrand {
    CurveBasis basis;
    std::span<const Point4f> points, tangents;
    std::span<const Point4f> normals{};  ///< of faces, if any

    std::size_t segments() const;
    Vec3 position(std::size_t segment, double t) const;
    Vec3 derivative(std::size_t segment, double t) const;
    /// By 4-point Gauss quadrature on each segment, cm.
    double length() const;
};
EmittedStrand emitted_strand(const Curves& curves, std::size_t i);

}  // namespace lancret
