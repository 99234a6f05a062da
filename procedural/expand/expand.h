#pragma once
// Expansion: child i = f(guides, binding, i), the same bits for any chunk size, thread
// count or order.

#include <optional>
#include <span>

#include "procedural/bind/binding.h"
#include "procedural/curves/control_points.h"
#include "procedural/curves/curves.h"
#include "procedural/expand/strand_classes.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

struct ExpandSettings {
    Blend blend = Blend::detail;
    CurveBasis basis = CurveBasis::bspline;
    std::optional<CurveShape> shape{};  ///< none: flat, for who draws them to change
    bool faces = false;    ///< whether to give the normals of strands that are no ribbons
    bool segments = true;  ///< whether to number the segments of who traces rays
    bool directions = false;  ///< whether to give the tangents of bases without them
    Taper taper{};
    std::uint32_t chunk = 256;  ///< strands that one task expands at a time, >= 1

    bool has_faces() const { return faces || shape == CurveShape::ribbon; }
};

/// All children as control points, each at the intervals of its class, into `out`, whose
/// memory is used again where its sizes fit: the next frame, the next chunk. Throws
/// std::invalid_argument where children do not stand in the order of their classes, and
/// where faces are asked for and the binding has none.
void expand(const Binding& binding, const ClassedGuides& guides,
            const ExpandSettings& settings, Curves& out);
Curves expand(const Binding& binding, const ClassedGuides& guides,
              const ExpandSettings& settings);

/// The same, all strands alike: the guides' profiles say at how many intervals.
Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings);

/// `guides` are kernel_guides of the same profiles and blend, made once a pose; without
/// any the scalar blends serve, to compare with.
void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out);

}  // namespace lancret
