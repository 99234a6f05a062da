#pragma once
// Control points of the two bases that Embree draws, from the places of a strand.

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

/// The radius at place i of a strand of `intervals` intervals, cm, >= 0. Extrapolates
/// beyond either end.
inline float radius_of(const Taper& taper, std::ptrdiff_t i, std::size_t intervals) {
    return std::max(0.0f,
                    taper.root + (taper.tip - taper.root) * float(i) / float(intervals));
}

/// How a strand is continued beyond its ends, for the B-spline's outer places.
enum class Ends {
    helix,     ///< as the helix of its last interval
    parabola,  ///< as the parabola through its last three places, or the line through
               ///< two: for frames that are transported and do not follow the bend
};

/// Control points of the uniform cubic B-spline along a strand: the five-tap
/// quasi-interpolant (1, -10, 54, -10, 1) / 36 of its places and of two places beyond
/// each end. The outermost control points are chosen so that the curve starts and ends
/// where the strand does. `states` are n + 1 >= 2 places at equal steps of arc length
/// `ds`, relative to `root`; `points` has n + 3.
void bspline_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    Ends ends = Ends::helix);

/// The side that a strand bends towards, as cosine and sine of its angle from n1 to n2 of
/// the root frame: the direction of the tip across the root's tangent. (1, 0) for a
/// straight strand. It flips when a strand swings through straight, so evaluate it in one
/// pose only.
Vec2f bent_face(std::span<const HelixState<float>> states);

/// Directions of that B-spline, one per control point, where the control point has the
/// largest weight: unit, w 0. The outermost ones repeat their neighbours.
void bspline_directions(std::span<const Point4f> points, std::span<Point4f> directions);

/// B-spline control points of a strand's face normal, [n + 3]. The normal lies at the
/// angle `face` (see bent_face) in the strand's own frame and so turns with the strand.
void ribbon_normals(std::span<const HelixState<float>> states, const Vec2f& face,
                    std::span<Point4f> normals);

/// The strand as cubic Hermite segments: places, and unit tangents times `ds`. Both spans
/// have n + 1.
void hermite_points(std::span<const HelixState<float>> states, float ds,
                    const Vec3f& root, const Taper& taper, std::span<Point4f> points,
                    std::span<Point4f> tangents);

}  // namespace lancret
