#pragma once
// How many intervals strands need so that their control points follow them.

#include "procedural/bind/binding.h"
#include "procedural/curves/control_points.h"

namespace lancret {

/// Number of children that are measured: the first ones, which are a fair sample because
/// roots are spread evenly.
inline constexpr std::size_t kSampledChildren = 8192;

/// The fraction of a tolerance that the sample must keep, because a few of the other
/// children are worse.
inline constexpr double kSampleShare = 0.6;

/// The largest turn of an interval, radians: less than half a turn, so that places and
/// frames determine the strand.
inline constexpr double kMaxTurn = 2;

/// The largest number of intervals that a groom chooses by itself.
inline constexpr int kMaxIntervals = 128;

/// The ratio of the children's length to the weighted length of their guides, which is
/// the same for all children.
double length_over_guides(const Binding& binding, const Guides& guides);

/// The largest distance of the emitted curve of a strand from the strand, cm. Measured
/// across the strand in the middle of each interval, where a helix deviates most, and for
/// Catmull-Rom also at 1/5 and 4/5. Infinite if anything is not finite. `states` are
/// places at equal steps `ds` of arc length.
double emission_distance(std::span<const HelixState<float>> states, float ds,
                         CurveBasis basis, Ends ends = Ends::helix);

/// The result of intervals_within.
struct FoundIntervals {
    int count = 0;        ///< per strand, a multiple of the guides' segments
    double distance = 0;  ///< cm, the largest emission_distance of the sample
};

/// The number of intervals at which emitted curves of `basis` stay within `tolerance` cm
/// of the strands and no interval of a guide turns by more than kMaxTurn. The tolerance
/// gives way at `max_count` intervals. The first kSampledChildren are measured and keep
/// kSampleShare of the tolerance; `check_strands` measures all. Above kMaxIntervals the
/// count may be up to a sixteenth larger than necessary. Throws InputError if a segment
/// of a guide turns too far.
FoundIntervals intervals_within(const Binding& binding, const Guides& guides, Blend blend,
                                double tolerance, CurveBasis basis,
                                int max_count = kMaxIntervals);

}  // namespace lancret
