#pragma once
// From places on a strand to the control points that Embree draws.

#include <algorithm>
#include <span>
#include <vector>

#include "guides/helix/helix.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// Radii along a strand, cm, linear in s / L.
struct Taper {
    float root = 0.004f, tip = 0.002f;

    Taper times(float width) const { return {root * width, tip * width}; }
    float largest() const { return root > tip ? root : tip; }
};

/// The radius at place i of `intervals`, which may lie beyond either end, cm, >= 0.
inline float radius_of(const Taper& taper, std::ptrdiff_t i, std::size_t intervals) {
    return std::max(0.0f,
                    taper.root + (taper.tip - taper.root) * float(i) / float(intervals));
}

/// How many control points a strand of n intervals has.
constexpr std::uint32_t control_points_of(CurveBasis basis, std::uint32_t intervals) {
    switch (basis) {
        case CurveBasis::bspline:
        case CurveBasis::catmull_rom:
            return intervals + 3;
        case CurveBasis::bezier:
            return 3 * intervals + 1;
        default:
            return intervals + 1;
    }
}

/// Whether control points are made of Hermite's places and derivatives.
constexpr bool is_of_hermite(CurveBasis basis) {
    return basis != CurveBasis::bspline && basis != CurveBasis::hermite;
}

/// How a strand goes on beyond its ends, where control points are made of places there.
enum class Ends {
    helix,     ///< that of its last interval
    parabola,  ///< through its last three places; a line through two: where frames are
               ///< carried along and say nothing of how the strand bends
};

/// Control points of the uniform cubic B-spline that follows a strand, by the five-tap
/// quasi-interpolant (1, -10, 54, -10, 1) / 36 on its places, two beyond each end among
/// them; the outermost points are then such that the curve begins and ends where the
/// strand does. `states` are n + 1 >= 2 places at equal
/// steps of arc length `ds`, from the root at `root`; `points` has n + 3.
void bspline_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    Ends ends = Ends::helix);

/// The face that a strand bends over, and not over its edge: towards where the tip is,
/// seen along the root; of a straight strand along n1. Unit: cosine and sine of its angle
/// from n1 to n2. It flips where a strand swings through straight: to be asked of one
/// pose.
Vec2f bent_face(std::span<const HelixState<float>> states);

/// The direction of that curve where each of its points has the most weight: unit, w 0;
/// the outermost have those of the ends.
void bspline_directions(std::span<const Point4f> points, std::span<Point4f> directions);

/// A strand's face along that B-spline: control points of its normal. It lies at the
/// angle `face` (bent_face's) in the strand's own frame, and so turns with the strand.
/// `normals` has n + 3.
void ribbon_normals(std::span<const HelixState<float>> states, const Vec2f& face,
                    std::span<Point4f> normals);

/// The same as cubic Hermite: the places and their tangents times `ds`; both spans have n
/// + 1.
void hermite_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    std::span<Point4f> tangents);

/// A Hermite strand of n + 1 `places` and `tangents` in a basis that is made of them. The
/// Bezier curve is the same curve; Catmull-Rom's has its own tangents but for those at
/// the ends, which are the strand's; `points` has control_points_of(basis, n).
void points_of_hermite(CurveBasis basis, std::span<const Point4f> places,
                       std::span<const Point4f> tangents, std::span<Point4f> points);

/// The strand's direction at the same control points, or at those of Hermite: unit, w 0.
void directions_of_hermite(CurveBasis basis, std::span<const Point4f> tangents,
                           std::span<Point4f> directions);

/// Normals for the control points of any basis, from ribbon_normals' n + 3: w 0.
void normals_in_basis(CurveBasis basis, std::span<const Point4f> ribbon,
                      std::span<Point4f> normals);

}  // namespace lancret
