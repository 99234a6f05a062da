#pragma once
// What expansion makes and Embree reads: the same bytes, shared without a copy.

#include <cstdint>
#include <vector>

#include "guides/types.h"
#include "procedural/buffer.h"

namespace lancret {

enum class CurveBasis {
    bspline,  ///< uniform cubic B-spline control points, segments + 3 a strand
    hermite,  ///< points with derivatives, segments + 1 a strand
    // For hosts that draw neither: made of Hermite's.
    linear,       ///< points on the strand, segments + 1
    catmull_rom,  ///< the same, and one beyond each end: segments + 3
    bezier,       ///< cubics that share their ends: 3 segments + 1
};
enum class CurveShape {
    flat,    ///< ribbons that face the ray: strands near or below a pixel
    round,   ///< swept circles: close-ups
    ribbon,  ///< bands with a face of their own, B-splines alone: grass, feathers
};

/// Strands as control points, every strand with the same number of segments. Segment j of
/// strand i has the primitive id i * segments_per_strand + j and starts at control point
/// i * points_per_strand + j.
struct Curves {
    CurveBasis basis = CurveBasis::bspline;
    CurveShape shape = CurveShape::flat;
    std::uint32_t strands = 0;
    std::uint32_t segments_per_strand = 0;
    std::uint32_t points_per_strand = 0;
    Buffer<Point4f> points;    ///< [strands * points_per_strand], cm, w is the radius
    Buffer<Point4f> tangents;  ///< of Hermite curves: [points], cm a segment, w is dr/dt;
                               ///< of others none, or directions: unit, w 0
    Buffer<Point4f> normals;   ///< ribbons, and elliptic strands: [points], control
                               ///< points of the face's normal, of any length; else none
    Buffer<std::uint32_t> segments;  ///< [strands * segments_per_strand], first control
                                     ///< point; of B-splines and Hermite curves alone

    std::vector<std::uint32_t> ids;  ///< [strands], of those that are grown of all;
                                     ///< empty: their numbers

    std::uint32_t strand_of(std::uint32_t segment) const {
        return segment / segments_per_strand;
    }
    std::uint32_t id_of(std::uint32_t strand) const {
        return ids.empty() ? strand : ids[strand];
    }
    std::size_t bytes() const {
        return points.bytes() + tangents.bytes() + normals.bytes() + segments.bytes() +
               ids.size() * sizeof(std::uint32_t);
    }
};

/// A box that holds every curve with its width, cm: that of the control points, whose
/// hull holds the curves.
Eigen::AlignedBox3f bounds(const Curves& curves);

}  // namespace lancret
