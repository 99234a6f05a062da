#pragma once
// The generated groom with any number of children, for benchmarks. Its guides are fitted
// once per run.

#include <limits>

#include "procedural/expand/intervals.h"
#include "procedural/groom/ready_groom.h"
#include "procedural/roots/child_roots.h"

namespace lancret::bench {

inline const PlacedGuides& made_guides() {
    static const PlacedGuides guides = [] {
        GroomSettings groom;
        groom.name = "made groom";
        groom.fit.segments = 24;
        return place_guides(groom);
    }();
    return guides;
}

inline Roots made_roots(std::uint32_t children) {
    const PlacedGuides& guides = made_guides();
    return roots_at(&*guides.scalp, {.on_scalp = places_on_scalp(
                                         *guides.scalp, guides.grown.roots, children, 0,
                                         std::numeric_limits<double>::infinity()),
                                     .on_strands = {}});
}

/// Cached between calls, because a benchmark is set up again for every trial of its
/// length.
inline const Binding& made_binding(std::uint32_t children) {
    static Binding binding;
    if (binding.size() != children) {
        const PlacedGuides& guides = made_guides();
        binding = {};
        binding = bind(made_roots(children), guides.guides, guides.normals, {});
    }
    return binding;
}

/// The intervals per strand that a groom of these guides uses by default.
inline int made_intervals() {
    static const int intervals =
        intervals_within(made_binding(10'000), made_guides().guides, Blend::option1,
                         GroomSettings().tolerance, CurveBasis::bspline)
            .count;
    return intervals;
}

}  // namespace lancret::bench
