#pragma once
// How finely strands must be cut for their control points to follow them.

#include "procedural/bind/binding.h"
#include "procedural/curves/control_points.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// The first children are measured, a fair sample since roots are spread evenly.
inline constexpr std::size_t kSampledChildren = 8192;

/// The emitted curve of one strand at parameter t in [0, 1] of segment j.
Vec3f emitted_place(CurveBasis basis, std::span<const Point4f> points,
                    std::span<const Point4f> tangents, std::size_t j, float t);

/// How much longer children are than the weighted length of their guides: the same for
/// all.
double length_over_guides(const Binding& binding, const Guides& guides);

/// The farthest that the emitted curve of a strand lies from the strand, cm, as seen in
/// the middle of each interval, where a helix strays most (of Catmull-Rom at 1/5 and 4/5
/// too); infinity where something is
/// not finite. `states` are places at equal steps `ds` of arc length.
double emission_distance(std::span<const HelixState<float>> states, float ds,
                         CurveBasis basis, Ends ends = Ends::helix);

/// Where the search for a groom's own intervals ends.
inline constexpr int kMaxIntervals = 128;

/// The number of intervals a strand, a multiple of the guides' segments, at which emitted
/// curves stay within `tolerance` cm of the strands, and no interval of a guide turns by
/// more than 2 radians; the first gives way beyond `most`. Measured on the first
/// kSampledChildren, which must keep 0.6 of the tolerance; `check` measures all. Beyond
/// kMaxIntervals it may be a sixteenth more than it takes. `reached`, where it is not
/// null, becomes the farthest of the sample, cm.
int intervals_within(const Binding& binding, const Guides& guides, Blend blend,
                     double tolerance, CurveBasis basis, int most = kMaxIntervals,
                     double* reached = nullptr);

}  // namespace lancret
