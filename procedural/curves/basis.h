#pragma once
// The curve bases: how the control points of a strand are laid out along it.

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace lancret {

/// Expansion emits B-splines and Hermite curves. The other bases are derived from Hermite
/// curves, for hosts that draw neither.
enum class CurveBasis {
    bspline,      ///< uniform cubic B-spline
    hermite,      ///< places and derivatives
    linear,       ///< polyline through the places
    catmull_rom,  ///< through the places, one control point beyond each end
    bezier,       ///< cubics that share their end points
};

/// The control points of a strand of n intervals. A place is an end of an interval; curve
/// segment i runs from place i to place i + 1.
struct BasisLayout {
    CurveBasis basis;
    const char* name;
    std::uint32_t step;     ///< control points from one place to the next
    std::uint32_t before;   ///< control points before that of the first place
    std::uint32_t extra;    ///< control points in addition to step * n
    bool has_tangents;      ///< stores a derivative with every control point
    CurveBasis source;      ///< the basis that is emitted first; itself if not derived
    CurveBasis same_curve;  ///< the basis that is emitted first if it draws the same
                            ///< curve exactly, else `basis`

    constexpr std::uint32_t points(std::uint32_t intervals) const {
        return step * intervals + extra;
    }
    constexpr std::uint32_t segments(std::uint32_t points) const {
        return (points - extra) / step;
    }
};

/// One row per CurveBasis, in the order of the enumerators.
inline constexpr BasisLayout kBasisLayouts[] = {
    {CurveBasis::bspline, "bspline", 1, 1, 3, false, CurveBasis::bspline,
     CurveBasis::bspline},
    {CurveBasis::hermite, "hermite", 1, 0, 1, true, CurveBasis::hermite,
     CurveBasis::hermite},
    {CurveBasis::linear, "linear", 1, 0, 1, false, CurveBasis::hermite,
     CurveBasis::linear},
    {CurveBasis::catmull_rom, "catmull-rom", 1, 1, 3, false, CurveBasis::hermite,
     CurveBasis::catmull_rom},
    {CurveBasis::bezier, "bezier", 3, 0, 1, false, CurveBasis::hermite,
     CurveBasis::hermite},
};

static_assert([] {
    for (std::size_t i = 0; i < std::size(kBasisLayouts); ++i) {
        if (kBasisLayouts[i].basis != CurveBasis(i)) return false;
    }
    return true;
}());

constexpr const BasisLayout& layout_of(CurveBasis basis) {
    return kBasisLayouts[std::size_t(basis)];
}

/// Number of control points of a strand of `intervals` intervals.
constexpr std::uint32_t control_points_of(CurveBasis basis, std::uint32_t intervals) {
    return layout_of(basis).points(intervals);
}

/// Whether control points are derived from those of another basis.
constexpr bool is_derived(CurveBasis basis) { return layout_of(basis).source != basis; }

}  // namespace lancret
