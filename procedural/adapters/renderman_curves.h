#pragma once
// A chunk as arguments of RiCurves.

#include <vector>

#include "procedural/adapters/ri.h"
#include "procedural/lancret_procedural.h"

namespace lancret {

/// A primitive variable that does not depend on time.
struct Primvar {
    const char* declaration;  ///< class, type and name, such as "uniform float length"
    std::vector<RtFloat> floats;
    std::vector<RtInt> ints;
};

/// One time of the motion block.
struct CurvesAtTime {
    std::vector<RtFloat> points;   ///< [vertices][3]
    std::vector<RtFloat> widths;   ///< [vertices], or a single one if all are equal
    std::vector<RtFloat> normals;  ///< [vertices][3], Hermite [varying][3], or empty
};

/// A copy of a chunk. Hermite curves have two vertices, a point and a tangent, for each
/// point of lancret_curves, as RiHermiteBasis requires.
struct RiCurvesData {
    int basis = 0;
    std::vector<RtInt> counts;  ///< vertices of each curve
    std::vector<Primvar> primvars;
    std::vector<CurvesAtTime> times;
    int neighbours = 0;
};

RiCurvesData curves_data(const lancret_curves& curves);

/// Emits RiCurves, in a motion block at `motion` if there are several times, between
/// RiAttributeBegin and RiAttributeEnd. No-op if there are no curves.
void emit_curves(const RiCurvesData& data, const std::vector<RtFloat>& motion);

}  // namespace lancret
