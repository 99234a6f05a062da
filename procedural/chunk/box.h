#pragma once
// Bounding boxes of a chunk, available before its strands are grown.

#include "procedural/expand/expand.h"

namespace lancret {

/// A box of strands without their widths, and their largest radius.
struct ChunkBox {
    Eigen::AlignedBox3f places;  ///< cm; empty if there are no strands
    float radius = 0;            ///< cm

    /// The box of the strands with their widths.
    Eigen::AlignedBox3f box() const;
    /// Includes another box, for example of another time. The result also contains
    /// strands that are interpolated linearly between the two times.
    ChunkBox& extend(const ChunkBox& other);
};

/// The tight box of the children of `chunk` at the time of `guides`: the exact boxes of
/// their helices and the Bezier hulls of their emitted curves. The strands are
/// synthesised at their classes, a few at a time, and not kept. The box exceeds the
/// strands by the hulls and by an allowance for round-off: L n 5e-7 cm for n places whose
/// frames are each accurate to 5e-7, which holds for any order of the same arithmetic.
ChunkBox chunk_box(const Binding& chunk, const ClassedGuides& guides,
                   const ExpandSettings& settings);

/// A loose box from the box of the roots only, for strands of at most `longest` cm and at
/// least n intervals. It holds for every blend and at all times at which the roots stay
/// in `roots`, because no place is farther from its root than the strand is long. Control
/// points differ from places by (|outer| + 10 |inner|) / 36 <= 2/3 ds; those beyond an
/// end from that end by at most 4 2/3 ds + 2/3 ds + ds = 13/3 ds (bspline_points; 2.8 ds
/// for Ends::parabola); the inner Bezier points of Hermite curves by ds / 3. Widths are
/// those at `density`.
ChunkBox reach_box(const Eigen::AlignedBox3f& roots, float longest, int n,
                   const ExpandSettings& settings, double density = 1);

}  // namespace lancret
