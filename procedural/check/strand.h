#pragma once
// Measurements of one strand, from places, frames and control points only.

#include <span>

#include "guides/helix/helix.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// The helix between two neighbouring places.
struct MeasuredInterval {
    double length;  ///< cm
    double kappa;   ///< 1/cm, >= 0
    double tau;     ///< 1/cm
    Vec3 axis;      ///< unit rotation axis, in the frame at the start
    double angle;   ///< of the rotation, radians
};

/// Arc length, curvature and torsion of the helix from `a` to `b`: axis and angle from
/// the rotation between the frames, the scale from the chord.
MeasuredInterval measured_interval(const HelixState<float>& a,
                                   const HelixState<float>& b);

/// The place at fraction t of the interval that starts at `a`.
Vec3 place_on(const HelixState<float>& a, const MeasuredInterval& interval, double t);

/// max |R^T R - I| over the frames; infinite if a frame is not finite.
double orthogonality_error(std::span<const HelixState<float>> states);

/// The emitted curve of a strand. Evaluated by code that expansion and rendering do not
/// use, so that it can check them.
struct EmittedStrand {
    CurveBasis basis;
    std::span<const Point4f> points, tangents;
    std::span<const Point4f> normals{};  ///< of the face; empty without faces

    std::size_t segments() const;
    Vec3 position(std::size_t segment, double t) const;
    Vec3 derivative(std::size_t segment, double t) const;
    /// Arc length by 4-point Gauss quadrature per segment, cm.
    double length() const;
};
EmittedStrand emitted_strand(const Curves& curves, std::size_t i);

}  // namespace lancret
