#pragma once
// What expansion makes and Embree reads: the same bytes, shared without a copy.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"
#include "procedural/curves/buffer.h"

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

/// Strands that stand together and have the same number of segments.
struct CurveClass {
    std::uint32_t strand = 0, segment = 0, point = 0;  ///< the first of each
    std::uint32_t strands = 0;                         ///< >= 1
    std::uint32_t segments = 0, points = 0;            ///< a strand; control points

    bool operator==(const CurveClass&) const = default;
};

/// Where a segment is.
struct SegmentPlace {
    std::uint32_t strand, in_strand;  ///< its number among the strand's own
    std::uint32_t of;                 ///< so many does the strand have
    std::uint32_t point;              ///< the first control point
};

/// Strands as control points, class after class. A segment's primitive id is its place in
/// `segments`; those of a strand follow each other, and so do its control points.
struct Curves {
    CurveBasis basis = CurveBasis::bspline;
    CurveShape shape = CurveShape::flat;
    std::uint32_t strands = 0;
    std::vector<CurveClass> classes;  ///< of all strands
    Buffer<Point4f> points;           ///< of all strands, cm, w is the radius
    Buffer<Point4f> tangents;  ///< of Hermite curves: [points], cm a segment, w is dr/dt;
                               ///< of others none, or directions: unit, w 0
    Buffer<Point4f> normals;   ///< ribbons, and elliptic strands: [points], control
                               ///< points of the face's normal, of any length; else none
    Buffer<std::uint32_t> segments;  ///< of all strands, the first control point; of
                                     ///< B-splines and Hermite curves alone

    std::vector<std::uint32_t> ids;  ///< [strands], of those that are grown of all;
                                     ///< empty: their numbers

    /// Adds `count` strands of `intervals` segments to the table after those that are
    /// there, nothing where there are none; the buffers stay as they are. Throws
    /// std::invalid_argument where there are more control points than 32 bits can
    /// count.
    void add_class(std::uint32_t count, std::uint32_t intervals);
    /// How many segments and control points the classes have together.
    std::size_t segment_count() const;
    std::size_t point_count() const;

    const CurveClass& class_of(std::uint32_t strand) const {
        return last_from(&CurveClass::strand, strand);
    }
    SegmentPlace place_of(std::uint32_t segment) const {
        const CurveClass& own = last_from(&CurveClass::segment, segment);
        const std::uint32_t at = segment - own.segment, strand = at / own.segments,
                            in_strand = at - strand * own.segments;
        return {own.strand + strand, in_strand, own.segments,
                own.point + strand * own.points + in_strand};
    }
    std::uint32_t strand_of(std::uint32_t segment) const {
        return place_of(segment).strand;
    }
    std::uint32_t points_of(std::uint32_t strand) const {
        return class_of(strand).points;
    }
    std::uint32_t first_point(std::uint32_t strand) const {
        const CurveClass& own = class_of(strand);
        return own.point + (strand - own.strand) * own.points;
    }
    /// A strand's part of points, tangents or normals; nothing of an empty buffer.
    std::span<const Point4f> of_strand(const Buffer<Point4f>& buffer,
                                       std::uint32_t strand) const {
        if (buffer.size() == 0) return {};
        return buffer.span().subspan(first_point(strand), points_of(strand));
    }
    std::uint32_t id_of(std::uint32_t strand) const {
        return ids.empty() ? strand : ids[strand];
    }
    std::size_t bytes() const {
        return points.bytes() + tangents.bytes() + normals.bytes() + segments.bytes() +
               ids.size() * sizeof(std::uint32_t);
    }

  private:
    /// The last class whose first is not beyond `i`.
    const CurveClass& last_from(std::uint32_t CurveClass::*first, std::uint32_t i) const {
        const auto beyond = std::ranges::upper_bound(classes, i, {}, first);
        return beyond[-1];
    }
};

/// A box that holds every curve with its width, cm: that of the control points, whose
/// hull holds the curves.
Eigen::AlignedBox3f bounds(const Curves& curves);

}  // namespace lancret
