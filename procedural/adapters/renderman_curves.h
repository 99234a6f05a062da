#pragma once
// A chunk as RiCurves.

#include <vector>

#include "procedural/adapters/ri.h"
#include "procedural/lancret_procedural.h"

namespace lancret {

/// Values of a primitive variable that are the same at all times.
struct Primvar {
    const char* declaration;  ///< class, type and name
    std::vector<RtFloat> floats;
    std::vector<RtInt> ints;
};

/// One time of the motion block.
struct CurvesAtTime {
    std::vector<RtFloat> points;  ///< [vertices][3]
    std::vector<RtFloat> widths;  ///< [vertices], or one where all are the same
    std::vector<RtFloat>
        normals;  ///< [vertices][3], of Hermite curves [varying][3], or none
};

/// What is left of a chunk when Lancret has taken its memory back. Cubic Hermite curves
/// have a point and a tangent for each of Lancret's points, as RiHermiteBasis wants them.
struct RiCurvesData {
    int basis = 0;
    std::vector<RtInt> counts;  ///< vertices of each curve
    std::vector<Primvar> primvars;
    std::vector<CurvesAtTime> times;
    int neighbours = 0;
};

RiCurvesData curves_data(const lancret_curves& curves);

/// One RiCurves, or a motion block of them at `motion`, in attributes of their own.
/// Nothing where there are no curves.
void emit_curves(const RiCurvesData& data, const std::vector<RtFloat>& motion);

}  // namespace lancret
