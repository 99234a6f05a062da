#pragma once
// The arguments of every kernel.

#include <cstddef>

#include "procedural/bind/binding.h"
#include "procedural/curves/control_points.h"
#include "procedural/curves/curves.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

/// What the kernels read. `guides` are those of `profiles`.
struct KernelInput {
    const Binding& binding;
    const GuideProfiles<float>& profiles;
    const KernelGuides& guides;
    Blend blend;
    CurveBasis basis;
    Taper taper;
};

/// Children from `first` on that are expanded together, and where their control points
/// go: `points` (and for Hermite `tangents`) hold control_points_of(basis, count) of
/// each.
struct KernelOutput {
    std::size_t first, count;
    Point4f* points;
    Point4f* tangents;
    bool past_caches;  ///< by streaming stores: nobody reads them soon
};

}  // namespace lancret
