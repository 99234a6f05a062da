#pragma once
// Boxes that hold a chunk's strands, to be told to a host before they are there.

#include "procedural/expand/expand.h"

namespace lancret {

/// Where strands are, without their width, and the largest radius on them.
struct ChunkBox {
    Eigen::AlignedBox3f places;  ///< cm; empty where there are no strands
    float radius = 0;            ///< cm

    /// What holds them with their width.
    Eigen::AlignedBox3f box() const;
    /// What holds them at times that the other bound is of as well, and between: curves
    /// that go straight from one time to the next stay within the hull.
    ChunkBox& extend(const ChunkBox& other);
};

/// The bound of the children of `chunk` at the time of `guides`: the exact boxes of
/// their helices, joined with the Bezier hulls of their emitted curves. Strands are
/// synthesised, each at its class, a few at a time and nothing is kept of them. It is
/// larger than what is there by the hulls and by round-off alone: L n 5e-7 cm, n places
/// whose frames are each good to 5e-7, which any other order of the same arithmetic stays
/// within.
ChunkBox chunk_box(const Binding& chunk, const ClassedGuides& guides,
                   const ExpandSettings& settings);

/// A bound from the box of the roots alone, for strands no longer than `longest` cm of n
/// intervals or more, whatever the blend and the time, as long as roots stay: no place is
/// farther from its root than the strand is long. Control points stray from places by
/// (|outer| + 10 |inner|) / 36 <= 2/3 ds, and those beyond an end from that end by at
/// most 4 2/3 ds + 2/3 ds + ds = 13/3 ds (control_points.h; with parabolas 2.8 ds),
/// Hermite's inner ones by ds / 3. Widths are those at a density.
ChunkBox reach_box(const Eigen::AlignedBox3f& roots, float longest, int n,
                   const ExpandSettings& settings, double density = 1);

}  // namespace lancret
