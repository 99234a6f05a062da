#pragma once
// Strands as curves: what expansion writes and Embree reads, without a copy.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/named.h"
#include "guides/base/types.h"
#include "procedural/curves/basis.h"
#include "procedural/curves/buffer.h"

namespace lancret {

enum class CurveShape {
    flat,    ///< ribbons that face the ray: for strands near or below a pixel's width
    round,   ///< swept circles: for close-ups
    ribbon,  ///< bands with a face of their own, B-splines only: for grass and feathers
};
inline constexpr Named<CurveShape> kCurveShapeNames[] = {{CurveShape::flat, "flat"},
                                                         {CurveShape::round, "round"},
                                                         {CurveShape::ribbon, "ribbon"}};

/// Consecutive strands with the same number of segments.
struct CurveClass {
    std::uint32_t strand = 0, segment = 0, point = 0;  ///< index of the first of each
    std::uint32_t strands = 0;                         ///< >= 1
    std::uint32_t segments = 0, points = 0;  ///< per strand; `points` are control points

    bool operator==(const CurveClass&) const = default;
};

/// The strand of a curve segment, and where on it the segment lies.
struct SegmentPlace {
    std::uint32_t strand, in_strand;  ///< index of the segment on its strand
    std::uint32_t of;                 ///< number of segments of the strand
    std::uint32_t point;              ///< index of its first control point
};

/// Strands as control points, class after class. A segment's primitive id is its index in
/// `segments`. The segments of a strand are consecutive, and so are its control points.
struct Curves {
    CurveBasis basis = CurveBasis::bspline;
    CurveShape shape = CurveShape::flat;
    std::uint32_t strands = 0;
    std::vector<CurveClass> classes;
    Buffer<Point4f> points;          ///< cm, w is the radius
    Buffer<Point4f> tangents;        ///< Hermite: [points], cm per segment, w is dr/dt.
                                     ///< Others: empty, or [points] unit directions, w 0
    Buffer<Point4f> normals;         ///< ribbons and elliptic strands: [points], control
                                     ///< points of the face normal, not unit; else empty
    Buffer<std::uint32_t> segments;  ///< [segments], index of the first control point;
                                     ///< B-splines and Hermite curves only

    std::vector<std::uint32_t>
        ids;  ///< [strands]; empty: the id of a strand is its index

    /// Appends `count` strands of `intervals` segments to `classes`; no-op if `count` is
    /// 0. Does not touch the buffers. Throws std::invalid_argument if the number of
    /// control points exceeds 32 bits.
    void add_class(std::uint32_t count, std::uint32_t intervals);
    /// Number of segments, of all classes.
    std::size_t segment_count() const;
    /// Number of control points, of all classes.
    std::size_t point_count() const;

    const CurveClass& class_of(std::uint32_t strand) const {
        return last_from(&CurveClass::strand, strand);
    }
    SegmentPlace place_of(std::uint32_t segment) const {
        const CurveClass& c = last_from(&CurveClass::segment, segment);
        const std::uint32_t in_class = segment - c.segment,
                            strand = in_class / c.segments,
                            in_strand = in_class - strand * c.segments;
        return {c.strand + strand, in_strand, c.segments,
                c.point + strand * c.points + in_strand};
    }
    std::uint32_t points_of(std::uint32_t strand) const {
        return class_of(strand).points;
    }
    std::uint32_t first_point(std::uint32_t strand) const {
        const CurveClass& c = class_of(strand);
        return c.point + (strand - c.strand) * c.points;
    }
    /// A strand's part of points, tangents or normals; empty if the buffer is empty.
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
    /// The last class whose member `first` is at most `i`.
    const CurveClass& last_from(std::uint32_t CurveClass::*first, std::uint32_t i) const {
        const auto beyond = std::ranges::upper_bound(classes, i, {}, first);
        return beyond[-1];
    }
};

}  // namespace lancret
