#pragma once
// Expansion: child i = f(guides, binding, i), the same bits for any grain, number of
// threads or order.

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
    std::optional<CurveShape> shape{};  ///< unset: flat, and a renderer may choose
                                        ///< otherwise
    bool faces = false;    ///< fill `Curves::normals` also for shapes other than ribbons
    bool segments = true;  ///< fill `Curves::segments`, which ray tracers need
    bool directions = false;  ///< fill `Curves::tangents` of bases without derivatives
    Taper taper{};
    std::uint32_t grain = 256;  ///< strands per task, >= 1

    bool has_faces() const { return faces || shape == CurveShape::ribbon; }
};

/// Expands all children to control points, each at the intervals of its class. Reuses the
/// memory of `out` if its sizes fit, as they do from frame to frame. Throws
/// std::invalid_argument if the children are not in_class_order, or if faces are
/// requested and the binding has none.
void expand(const Binding& binding, const ClassedGuides& guides,
            const ExpandSettings& settings, Curves& out);
Curves expand(const Binding& binding, const ClassedGuides& guides,
              const ExpandSettings& settings);

/// The same in one class, at the intervals of `profiles`.
Curves expand(const Binding& binding, const GuideProfiles<float>& profiles,
              const ExpandSettings& settings);

/// The same with `guides`, the kernel_guides of the same profiles and blend, made once
/// per pose. If they are empty, the scalar blends are used.
void expand(const Binding& binding, const GuideProfiles<float>& profiles,
            const KernelGuides& guides, const ExpandSettings& settings, Curves& out);

}  // namespace lancret
