#pragma once
// From a groom to all that expansion needs.

#include "procedural/groom/placed_guides.h"

namespace lancret {

/// A groom that is ready to expand. Its guides are at rest; for another time, make other
/// profiles from the guides of that time and keep the binding.
struct ReadyGroom {
    GroomSettings groom;
    PlacedGuides placed;            ///< guides, scalp, and how they came about
    GuideProfiles<float> profiles;  ///< of the guides
    StrandClasses classes;          ///< how finely each strand is cut
    Binding binding;                ///< in_class_order
    Binding sample;  ///< sample_of_children: says how many intervals strands have
    StageSeconds seconds;
};

/// The guides at rest as `expand` reads them.
ClassedGuides rest_guides(const ReadyGroom& ready);

/// The box of the guides at rest: what a groom means to be, whatever a stray child does.
Eigen::AlignedBox3f guide_box(const ReadyGroom& ready);

/// Loads, chooses and fits guides, places and binds children. Throws InputError.
ReadyGroom make_ready_groom(const GroomSettings& groom, const StageCallback& stage = {});

}  // namespace lancret
