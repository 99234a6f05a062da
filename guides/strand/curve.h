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

/// A place on a curve, with its derivatives in the curve's own parameter.
struct CurvePoint {
    Vec3 position;    ///< cm
    Vec3 d1, d2, d3;  ///< first to third derivative; d3 jumps at knots
};

/// The cubic spline through `points` (cm), parametrised by chord length. Ends are
/// not-a-knot: the error is of order 4 up to the ends, where natural ends have order 2
/// (on jagged points they overshoot about twice as far). Points nearer to the one before
/// than 1e-7 of the strand's chord length (round-off of float) are left out, the last one
/// never. Two points give a straight line, three a parabola. Nothing where all points
/// coincide, there are fewer than two, one is not finite, or the length overflows. Linear
/// in time.
std::optional<Curve> curve_through(std::span<const Vec3> points);
std::optional<Curve> curve_through(std::span<const Vec3f> points);

/// The uniform cubic B-spline of control points p0, p1, ... (cm), one unit of the
/// parameter a piece. Ends are plain: it starts at (p0 + 4 p1 + p2) / 6 and stops
/// likewise, short of the outer control points. Nothing with fewer than four points,
/// where all coincide, or where one is not finite.
std::optional<Curve> bspline_curve(std::span<const Vec3> control_points);
std::optional<Curve> bspline_curve(std::span<const Vec3f> control_points);

/// The curve of strand i, as the strands' basis says.
std::optional<Curve> strand_curve(const Strands& strands, std::size_t i);

/// The curve at parameter `t`; the outer pieces go on past the ends.
CurvePoint evaluate(const Curve& curve, double t);

/// The arc length from the start to parameter `t`, clamped to the ends, cm. By 3-point
/// Gauss quadrature, halved until halving changes a piece by less than 1e-10 of its size
/// (the error left is about 1/64 of the change) [TW99, Eq. 38 and 42, corrected].
double arc_length(const Curve& curve, double t);

/// The parameter at arc length `s` (cm, clamped to the ends): Newton's steps kept in a
/// bracket, to 1e-13 of the length.
double parameter_at(const Curve& curve, double s);

/// The unit tangent at parameter `t`; that of the piece's chord where the speed vanishes.
Vec3 unit_tangent(const Curve& curve, double t);

/// A curve at places equally spaced in arc length.
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
