#pragma once
// Piecewise cubic curves through or near the points of a strand, and their arc length.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "guides/base/types.h"
#include "guides/strand/strands.h"

namespace lancret {

/// A C2 piecewise cubic. On piece k, with h = t - knots[k],
///     x(t) = c0 + c1 h + c2 h^2 + c3 h^3,   c = pieces[k].
struct Curve {
    std::vector<double> knots;  ///< [pieces + 1], increasing
    std::vector<std::array<Vec3, 4>>
        pieces;  ///< c0 .. c3, cm over powers of the parameter
    std::vector<double>
        arc;  ///< [pieces + 1], arc length from the start at each knot, cm

    double length() const { return arc.back(); }
};

/// A point of a curve and the derivatives with respect to the curve's parameter.
struct CurvePoint {
    Vec3 position;    ///< cm
    Vec3 d1, d2, d3;  ///< first to third derivative; d3 jumps at knots
};

/// The cubic spline through `points` (cm), parametrised by chord length. Ends are
/// not-a-knot: the error is of order 4 up to the ends, where natural ends have order 2
/// (on jagged points they overshoot about twice as far). A point nearer to its
/// predecessor than 1e-7 of the strand's chord length (round-off of float) is left out,
/// except for the last one. Two points give a straight line, three a parabola. nullopt if
/// all points coincide, there are fewer than two, one is not finite, or the length
/// overflows. Takes linear time.
std::optional<Curve> curve_through(std::span<const Vec3> points);
std::optional<Curve> curve_through(std::span<const Vec3f> points);

/// The uniform cubic B-spline of control points p0, p1, ... (cm), with one unit of the
/// parameter per piece. It starts at (p0 + 4 p1 + p2) / 6 and ends likewise, short of the
/// outer control points. nullopt if there are fewer than four points, all coincide, or
/// one is not finite.
std::optional<Curve> bspline_curve(std::span<const Vec3> control_points);
std::optional<Curve> bspline_curve(std::span<const Vec3f> control_points);

/// The curve of strand i in the basis of `strands`; nullopt as above.
std::optional<Curve> strand_curve(const Strands& strands, std::size_t i);

/// The curve at parameter `t`; beyond the ends the outer pieces are extended.
CurvePoint evaluate(const Curve& curve, double t);

/// The arc length from the start to parameter `t`, clamped to the ends, cm. By 3-point
/// Gauss quadrature, halved until halving changes a piece by less than 1e-10 of its
/// length (the remaining error is about 1/64 of the change) [TW99, Eq. 38 and 42,
/// corrected].
double arc_length(const Curve& curve, double t);

/// The parameter at arc length `s` (cm, clamped to the ends), to 1e-13 of the length, by
/// Newton steps within a bracket.
double parameter_at(const Curve& curve, double s);

/// The unit tangent at parameter `t`; the direction of the piece's chord if the speed is
/// zero there.
Vec3 unit_tangent(const Curve& curve, double t);

/// Samples of a curve at equal steps of arc length.
struct SampledCurve {
    double length = 0;               ///< cm
    std::vector<double> parameters;  ///< [n + 1]
    std::vector<Vec3> positions;     ///< [n + 1], cm
    std::vector<Vec3> tangents;      ///< [n + 1], unit

    double step() const { return length / double(positions.size() - 1); }
};

/// The curve at s = i length / n, i = 0 .. n. Throws std::invalid_argument for n < 1.
SampledCurve resample(const Curve& curve, int n);

}  // namespace lancret
