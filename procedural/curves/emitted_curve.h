#pragma once
// One strand as a curve of any basis: its control points, its places and its hull.

#include <span>
#include <vector>

#include "procedural/curves/control_points.h"

namespace lancret {

/// A strand that is ready to emit: n + 1 >= 2 places at equal steps of arc length.
struct SynthesizedStrand {
    std::span<const HelixState<float>> states;  ///< [n + 1], cm, relative to `root`
    float ds;                                   ///< cm, between places
    Vec3f root = Vec3f::Zero();                 ///< cm
    Taper taper{};
    Ends ends = Ends::helix;
};

/// Memory for the control points of one strand, reused from strand to strand.
struct StrandBuffer {
    std::vector<Point4f> points;    ///< [control_points_of(basis, n)]
    std::vector<Point4f> tangents;  ///< [n + 1] of the Hermite curve that is emitted or
                                    ///< derived from; empty for B-splines
    std::vector<Point4f> places;    ///< [n + 1] of the Hermite curve that is derived from
};

/// Writes the control points of a strand in any basis, resizing `out`.
void emit(const SynthesizedStrand& strand, CurveBasis basis, StrandBuffer& out);

/// The same into given memory, for the bases that are not derived. `tangents` is used for
/// Hermite curves only.
void emit(const SynthesizedStrand& strand, CurveBasis basis, std::span<Point4f> points,
          std::span<Point4f> tangents);

/// The control points of a derived basis, from the n + 1 `places` and `tangents` of a
/// Hermite curve. Bezier draws the same curve. Catmull-Rom has the strand's tangents at
/// its ends only. `points` has control_points_of(basis, n).
void points_of_hermite(CurveBasis basis, std::span<const Point4f> places,
                       std::span<const Point4f> tangents, std::span<Point4f> points);

/// The strand's direction at the same control points, or at those of the Hermite curve:
/// unit, w 0.
void directions_of_hermite(CurveBasis basis, std::span<const Point4f> tangents,
                           std::span<Point4f> directions);

/// Face normals at the control points of any basis, from the n + 3 of ribbon_normals: w
/// 0.
void normals_in_basis(CurveBasis basis, std::span<const Point4f> ribbon,
                      std::span<Point4f> normals);

/// The place of an emitted curve at parameter t in [0, 1] of segment j.
Vec3f emitted_place(CurveBasis basis, std::span<const Point4f> points,
                    std::span<const Point4f> tangents, std::size_t j, float t);

/// Extends `box` by the Bezier points of an emitted curve, whose hull contains it. Widths
/// are left out.
void extend_by_hull(Eigen::AlignedBox3d& box, CurveBasis basis,
                    std::span<const Point4f> points, std::span<const Point4f> tangents);

}  // namespace lancret
