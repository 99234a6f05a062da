#include "guides/strand/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lancret {

namespace {

constexpr double kQuadratureTolerance = 1e-10;  // relative change that ends halving
constexpr int kDeepestHalving = 30;

std::size_t piece_at(const std::vector<double>& ends, double x) {
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
    return std::size_t(above - ends.begin()) - 1;
}

double speed(const std::array<Vec3, 4>& c, double h) {
    return (c[1] + h * (2 * c[2] + h * 3 * c[3])).norm();
}

/// The length of a piece from h = a to b by one 3-point Gauss rule.
double gauss_length(const std::array<Vec3, 4>& c, double a, double b) {
    const double middle = (a + b) / 2, half = (b - a) / 2, x = half * std::sqrt(0.6);
    return half *
           (5 * speed(c, middle - x) + 8 * speed(c, middle) + 5 * speed(c, middle + x)) /
           9;
}

double halved_length(const std::array<Vec3, 4>& c, double a, double b, double whole,
                     double tolerance, int depth) {
    const double middle = (a + b) / 2;
    const double left = gauss_length(c, a, middle), right = gauss_length(c, middle, b);
    // Written so that a length that is NaN ends the recursion.
    const bool halve = depth > 0 && std::abs(left + right - whole) > tolerance;
    if (!halve) return left + right;
    return halved_length(c, a, middle, left, tolerance / 2, depth - 1) +
           halved_length(c, middle, b, right, tolerance / 2, depth - 1);
}

double piece_length(const std::array<Vec3, 4>& c, double a, double b) {
    const double whole = gauss_length(c, a, b);
    return halved_length(c, a, b, whole, kQuadratureTolerance * std::abs(whole),
                         kDeepestHalving);
}

/// The curve with `arc` filled; nullopt if its length is zero or not finite.
std::optional<Curve> with_arc(Curve curve) {
    curve.arc.assign(1, 0.0);
    for (std::size_t k = 0; k < curve.pieces.size(); ++k) {
        curve.arc.push_back(
            curve.arc.back() +
            piece_length(curve.pieces[k], 0, curve.knots[k + 1] - curve.knots[k]));
    }
    const bool has_length = curve.length() > 0 && std::isfinite(curve.length());
    return has_length ? std::optional(std::move(curve)) : std::nullopt;
}

bool all_finite(std::span<const Vec3> points) {
    return std::all_of(points.begin(), points.end(),
                       [](const Vec3& p) { return p.allFinite(); });
}

std::vector<Vec3> to_double(std::span<const Vec3f> points) {
    std::vector<Vec3> out(points.size());
    std::transform(points.begin(), points.end(), out.begin(),
                   [](const Vec3f& p) { return p.cast<double>(); });
    return out;
}

/// The points without those that coincide with their predecessor.
std::vector<Vec3> distinct_points(std::span<const Vec3> points) {
    double chords = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        chords += (points[i] - points[i - 1]).norm();
    }
    const double nearest = 1e-7 * chords;
    std::vector<Vec3> kept{points.front()};
    for (const Vec3& p : points.subspan(1)) {
        if ((p - kept.back()).norm() > nearest) kept.push_back(p);
    }
    if (kept.size() > 1) kept.back() = points.back();
    return kept;
}

/// One row of a tridiagonal system: below d[i-1] + diagonal d[i] + above d[i+1] = right.
struct Row {
    double below, diagonal, above;
    Vec3 right;
};

/// The row of the first slope (not-a-knot), from the first chord h0 and the next, h1,
/// with the mean slopes m0 and m1 over them. The last row is the same, from the tip.
Row end_row(double h0, double h1, const Vec3& m0, const Vec3& m1) {
    const double both = h0 + h1;
    return {0, h1, both, ((h0 + 2 * both) * h1 * m0 + h0 * h0 * m1) / both};
}

/// The slopes at the points of a cubic spline through at least three points, by
/// elimination. It needs no pivoting: below the first row each diagonal stays larger than
/// its neighbour to the right, and the last one positive.
std::vector<Vec3> spline_slopes(const std::vector<double>& h,
                                const std::vector<Vec3>& m) {
    const std::size_t n = h.size();
    std::vector<Row> rows(n + 1);
    rows[0] = end_row(h[0], h[1], m[0], m[1]);
    for (std::size_t i = 1; i < n; ++i) {
        rows[i] = {h[i], 2 * (h[i - 1] + h[i]), h[i - 1],
                   3 * (h[i] * m[i - 1] + h[i - 1] * m[i])};
    }
    rows[n] = end_row(h[n - 1], h[n - 2], m[n - 1], m[n - 2]);
    std::swap(rows[n].below, rows[n].above);
    for (std::size_t i = 1; i <= n; ++i) {
        const double factor = rows[i].below / rows[i - 1].diagonal;
        rows[i].diagonal -= factor * rows[i - 1].above;
        rows[i].right -= factor * rows[i - 1].right;
    }
    std::vector<Vec3> slopes(n + 1);
    slopes[n] = rows[n].right / rows[n].diagonal;
    for (std::size_t i = n; i-- > 0;) {
        slopes[i] = (rows[i].right - rows[i].above * slopes[i + 1]) / rows[i].diagonal;
    }
    return slopes;
}

}  // namespace

std::optional<Curve> curve_through(std::span<const Vec3> points) {
    if (points.size() < 2 || !all_finite(points)) return std::nullopt;
    const std::vector<Vec3> p = distinct_points(points);
    const std::size_t n = p.size() - 1;
    if (n == 0) return std::nullopt;
    std::vector<double> h(n);
    std::vector<Vec3> m(n);
    Curve curve;
    curve.knots.assign(1, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
        h[k] = (p[k + 1] - p[k]).norm();
        if (!(h[k] > 0)) return std::nullopt;
        m[k] = (p[k + 1] - p[k]) / h[k];
        curve.knots.push_back(curve.knots.back() + h[k]);
    }
    std::vector<Vec3> d(n + 1, m[0]);
    if (n == 2) {  // not-a-knot at both ends is one condition twice: take the parabola
        const Vec3 second = (m[1] - m[0]) / (h[0] + h[1]);
        d = {m[0] - h[0] * second, m[0] + h[0] * second, m[1] + h[1] * second};
    } else if (n > 2) {
        d = spline_slopes(h, m);
    }
    for (std::size_t k = 0; k < n; ++k) {
        curve.pieces.push_back({p[k], d[k], (3 * m[k] - 2 * d[k] - d[k + 1]) / h[k],
                                (d[k] + d[k + 1] - 2 * m[k]) / (h[k] * h[k])});
    }
    return with_arc(std::move(curve));
}

std::optional<Curve> curve_through(std::span<const Vec3f> points) {
    return curve_through(std::span<const Vec3>(to_double(points)));
}

std::optional<Curve> bspline_curve(std::span<const Vec3> p) {
    if (p.size() < 4 || !all_finite(p)) return std::nullopt;
    Curve curve;
    curve.knots.assign(1, 0.0);
    for (std::size_t k = 0; k + 3 < p.size(); ++k) {
        curve.pieces.push_back({(p[k] + 4 * p[k + 1] + p[k + 2]) / 6,
                                (p[k + 2] - p[k]) / 2,
                                (p[k] - 2 * p[k + 1] + p[k + 2]) / 2,
                                (p[k + 3] - p[k] + 3 * (p[k + 1] - p[k + 2])) / 6});
        curve.knots.push_back(double(k + 1));
    }
    return with_arc(std::move(curve));
}

std::optional<Curve> bspline_curve(std::span<const Vec3f> control_points) {
    return bspline_curve(std::span<const Vec3>(to_double(control_points)));
}

std::optional<Curve> strand_curve(const Strands& strands, std::size_t i) {
    return strands.basis == Basis::bspline ? bspline_curve(strands.strand(i))
                                           : curve_through(strands.strand(i));
}

CurvePoint evaluate(const Curve& curve, double t) {
    const std::size_t k = piece_at(curve.knots, t);
    const auto& c = curve.pieces[k];
    const double h = t - curve.knots[k];
    return {c[0] + h * (c[1] + h * (c[2] + h * c[3])),
            c[1] + h * (2 * c[2] + h * 3 * c[3]), 2 * c[2] + h * 6 * c[3], 6 * c[3]};
}

double arc_length(const Curve& curve, double t) {
    if (t <= curve.knots.front()) return 0;
    if (t >= curve.knots.back()) return curve.length();
    const std::size_t k = piece_at(curve.knots, t);
    return curve.arc[k] + piece_length(curve.pieces[k], 0, t - curve.knots[k]);
}

double parameter_at(const Curve& curve, double s) {
    if (s <= 0) return curve.knots.front();
    if (s >= curve.length()) return curve.knots.back();
    const std::size_t k = piece_at(curve.arc, s);
    const auto& c = curve.pieces[k];
    const double close = 1e-13 * curve.length();
    const double size = curve.arc[k + 1] - curve.arc[k];
    // The root of length(h) = s lies in [low, high]; `left` is how far h falls short.
    double low = 0, high = curve.knots[k + 1] - curve.knots[k];
    double h = size > 0 ? high * (s - curve.arc[k]) / size : 0;
    double left = s - curve.arc[k] - piece_length(c, 0, h);
    for (int i = 0; i < 60 && std::abs(left) > close; ++i) {
        (left > 0 ? low : high) = h;
        double next = h + left / speed(c, h);
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (next == h) break;
        left -= piece_length(c, h, next);
        h = next;
    }
    return curve.knots[k] + h;
}

Vec3 unit_tangent(const Curve& curve, double t) {
    const Vec3 d1 = evaluate(curve, t).d1;
    const double length = d1.norm();
    const std::size_t k = piece_at(curve.knots, t);
    const double mean =
        (curve.arc[k + 1] - curve.arc[k]) / (curve.knots[k + 1] - curve.knots[k]);
    if (length > 1e-12 * mean) return d1 / length;
    const Vec3 chord = evaluate(curve, curve.knots[k + 1]).position - curve.pieces[k][0];
    return chord.norm() > 0 ? Vec3(chord.normalized()) : Vec3(Vec3::UnitX());
}

SampledCurve resample(const Curve& curve, int n) {
    if (n < 1) throw std::invalid_argument("resample: expected at least one interval");
    SampledCurve out;
    out.length = curve.length();
    for (int i = 0; i <= n; ++i) {
        const double t = parameter_at(curve, curve.length() * i / n);
        out.parameters.push_back(t);
        out.positions.push_back(evaluate(curve, t).position);
        out.tangents.push_back(unit_tangent(curve, t));
    }
    return out;
}

}  // namespace lancret
