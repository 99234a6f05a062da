#pragma once
// A groom prepared for expansion.

#include "procedural/groom/placed_guides.h"

namespace lancret {

/// A groom that is ready to expand. Its guides are at rest. To expand it at another time,
/// keep the binding and make profiles from the guides of that time.
struct ReadyGroom {
    GroomSettings groom;
    PlacedGuides placed;            ///< guides, scalp and their report
    GuideProfiles<float> profiles;  ///< of the guides, at the finest count
    StrandClasses classes;          ///< interval counts of the strands
    Binding binding;                ///< in_class_order
    Binding sample;  ///< sample_of_children; interval counts are chosen from it
    StageSeconds seconds;
};

/// The guides at rest, in the form that `expand` takes.
ClassedGuides rest_guides(const ReadyGroom& ready);

/// The bounding box of the guides at rest. Stray children do not affect it.
Eigen::AlignedBox3f guide_box(const ReadyGroom& ready);

/// Loads, selects and fits guides, then places and binds children. Throws InputError.
ReadyGroom make_ready_groom(const GroomSettings& groom, const StageCallback& stage = {});

}  // namespace lancret
