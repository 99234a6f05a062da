#pragma once
// The arguments of the kernels that expand strands.

#include <cstddef>

#include "procedural/bind/binding.h"
#include "procedural/curves/control_points.h"
#include "procedural/curves/curves.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

/// The children, guides and settings that a kernel reads. `guides` are made from
/// `profiles`.
struct KernelInput {
    const Binding& binding;
    const GuideProfiles<float>& profiles;
    const KernelGuides& guides;
    Blend blend;
    CurveBasis basis;
    Taper taper;
};

/// The children [first, first + count) to expand, and the destination: `points`, and for
/// Hermite curves `tangents`, have room for control_points_of(basis, intervals) per
/// child.
struct KernelOutput {
    std::size_t first, count;
    Point4f* points;
    Point4f* tangents;
    bool past_caches;  ///< use streaming stores, as the points are not read soon
};

}  // namespace lancret
