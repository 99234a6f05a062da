#include "procedural/check/strand.h"

#include <algorithm>
#include <limits>

namespace lancret {

namespace {

double sinc(double x) { return std::abs(x) < 1e-6 ? 1 - x * x / 6 : std::sin(x) / x; }

/// A cubic Bezier curve at t.
Vec3 bezier(const std::array<Vec3, 4>& p, double t) {
    const double r = 1 - t;
    return r * r * r * p[0] + 3 * t * r * r * p[1] + 3 * t * t * r * p[2] +
           t * t * t * p[3];
}

Vec3 bezier_derivative(const std::array<Vec3, 4>& p, double t) {
    const double r = 1 - t;
    return 3 *
           (r * r * (p[1] - p[0]) + 2 * t * r * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

Vec3 wide(const Point4f& p) { return {p.x, p.y, p.z}; }

/// Segment j in any basis as Bezier points, so that one evaluation serves all bases.
std::array<Vec3, 4> bezier_points(const EmittedStrand& strand, std::size_t j) {
    if (strand.basis == CurveBasis::bezier) {
        const auto* p = &strand.points[3 * j];
        return {wide(p[0]), wide(p[1]), wide(p[2]), wide(p[3])};
    }
    if (strand.basis == CurveBasis::linear) {
        const Vec3 a = wide(strand.points[j]), b = wide(strand.points[j + 1]);
        return {a, (2 * a + b) / 3, (a + 2 * b) / 3, b};
    }
    if (strand.basis == CurveBasis::hermite) {
        const Vec3 a = wide(strand.points[j]), b = wide(strand.points[j + 1]);
        return {a, a + wide(strand.tangents[j]) / 3, b - wide(strand.tangents[j + 1]) / 3,
                b};
    }
    const Vec3 a = wide(strand.points[j]), b = wide(strand.points[j + 1]);
    const Vec3 c = wide(strand.points[j + 2]), d = wide(strand.points[j + 3]);
    if (strand.basis == CurveBasis::catmull_rom) {
        return {b, b + (c - a) / 6, c - (d - b) / 6, c};
    }
    return {(a + 4 * b + c) / 6, (2 * b + c) / 3, (b + 2 * c) / 3, (b + 4 * c + d) / 6};
}

}  // namespace

MeasuredInterval measured_interval(const HelixState<float>& a,
                                   const HelixState<float>& b) {
    const Mat3 turn = a.frame.cast<double>().transpose() * b.frame.cast<double>();
    const Eigen::AngleAxisd rotation(turn);
    MeasuredInterval out;
    out.axis = rotation.axis();
    out.angle = rotation.angle();
    // A helix of turn w about an axis at cosine p to its tangent: the chord is
    // length * sqrt(p^2 + (1 - p^2) sinc^2(w / 2)).
    const double p = out.axis.x(), across = sinc(out.angle / 2);
    const double chord = (b.position.cast<double>() - a.position.cast<double>()).norm();
    out.length = chord / std::sqrt(p * p + (1 - p * p) * across * across);
    const double rate = out.length > 0 ? out.angle / out.length : 0;
    out.tau = p * rate;
    out.kappa = std::sqrt(std::max(0.0, 1 - p * p)) * std::abs(rate);
    return out;
}

Vec3 place_on(const HelixState<float>& a, const MeasuredInterval& interval, double t) {
    // Constant speed along the axis, a circle around it.
    const double w = interval.angle * t, s = interval.length * t, p = interval.axis.x();
    const Vec3 along = p * interval.axis, round = Vec3::UnitX() - along;
    const Vec3 side = interval.axis.cross(Vec3::UnitX());
    const double half = sinc(w / 2);
    const Vec3 local = s * (along + sinc(w) * round + 0.5 * w * half * half * side);
    return a.position.cast<double>() + a.frame.cast<double>() * local;
}

double orthogonality_error(std::span<const HelixState<float>> states) {
    double worst = 0;
    for (const HelixState<float>& state : states) {
        const Mat3 r = state.frame.cast<double>();
        const Mat3 off = r.transpose() * r - Mat3::Identity();
        // maxCoeff would miss a NaN.
        if (!off.allFinite()) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, off.cwiseAbs().maxCoeff());
    }
    return worst;
}

std::size_t EmittedStrand::segments() const {
    return layout_of(basis).segments(std::uint32_t(points.size()));
}

Vec3 EmittedStrand::position(std::size_t segment, double t) const {
    return bezier(bezier_points(*this, segment), t);
}

Vec3 EmittedStrand::derivative(std::size_t segment, double t) const {
    return bezier_derivative(bezier_points(*this, segment), t);
}

double EmittedStrand::length() const {
    constexpr double kNode[] = {0.33998104358485626, 0.86113631159405258};
    constexpr double kWeight[] = {0.65214515486254614, 0.34785484513745386};
    double sum = 0;
    for (std::size_t j = 0; j < segments(); ++j) {
        for (int q = 0; q < 2; ++q) {
            for (const double side : {-1.0, 1.0}) {
                sum +=
                    0.5 * kWeight[q] * derivative(j, 0.5 + 0.5 * side * kNode[q]).norm();
            }
        }
    }
    return sum;
}

EmittedStrand emitted_strand(const Curves& curves, std::size_t i) {
    const auto part = [&](const Buffer<Point4f>& buffer) {
        return curves.of_strand(buffer, std::uint32_t(i));
    };
    return {curves.basis, part(curves.points), part(curves.tangents),
            part(curves.normals)};
}

}  // namespace lancret
