#include "render_test/scene/strand_axis.h"

namespace lancret {
namespace {

using Vec4f = Eigen::Vector4f;

Eigen::Map<const Vec4f, Eigen::Aligned16> as_vector(const Point4f& p) {
    return Eigen::Map<const Vec4f, Eigen::Aligned16>(&p.x);
}

}  // namespace

AxisPoint axis_point(const Curves& curves, std::uint32_t segment, float u) {
    // By counting instead of from `segments`, to save a memory access.
    const std::uint32_t first = curves.place_of(segment).point;
    const float t = 1 - u;
    if (curves.basis == CurveBasis::bspline) {
        const Point4f* p = curves.points.data() + first;
        const auto a = as_vector(p[0]), b = as_vector(p[1]), c = as_vector(p[2]),
                   d = as_vector(p[3]);
        return {(t * t * t * a + (4 - 3 * u * u * (2 - u)) * b +
                 (4 - 3 * t * t * (2 - t)) * c + u * u * u * d) /
                    6,
                (-t * t * a + u * (3 * u - 4) * b + t * (4 - 3 * t) * c + u * u * d) / 2};
    }
    const auto a = as_vector(curves.points[first]),
               b = as_vector(curves.points[first + 1]);
    const auto da = as_vector(curves.tangents[first]),
               db = as_vector(curves.tangents[first + 1]);
    return {t * t * (1 + 2 * u) * a + u * u * (1 + 2 * t) * b + t * t * u * da -
                u * u * t * db,
            6 * u * t * (b - a) + t * (t - 2 * u) * da + u * (u - 2 * t) * db};
}

Vec3f face_normal(const Curves& curves, std::uint32_t segment, float u) {
    const Point4f* n = curves.normals.data() + curves.segments[segment];
    const float t = 1 - u;
    return (t * t * t * n[0].xyz() + (4 - 3 * u * u * (2 - u)) * n[1].xyz() +
            (4 - 3 * t * t * (2 - t)) * n[2].xyz() + u * u * u * n[3].xyz()) /
           6;
}

// The axis is linear in its control points, and so blending it blends them.
AxisPoint axis_point(const Curves& from, const Curves& to, float share,
                     std::uint32_t segment, float u) {
    const AxisPoint a = axis_point(from, segment, u), b = axis_point(to, segment, u);
    return {(1 - share) * a.value + share * b.value,
            (1 - share) * a.derivative + share * b.derivative};
}

}  // namespace lancret
