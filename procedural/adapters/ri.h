#pragma once
// Own declarations of the types and calls of the RenderMan Interface that the adapter
// needs, with the names of the RenderMan Interface Specification 3.2. The renderer that
// loads the DSO defines them.

extern "C" {

using RtInt = int;
using RtFloat = float;
using RtToken = const char*;
using RtPointer = void*;
using RtBasis = RtFloat[4][4];
using RtBound = RtFloat[6];  ///< minimum and maximum x, then y, then z

/// `detail` is the area of the procedural's bound on the screen, in pixels.
using RtProcSubdivFunc = void (*)(RtPointer data, RtFloat detail);
using RtProcFreeFunc = void (*)(RtPointer data);

extern RtBasis RiBSplineBasis, RiCatmullRomBasis, RiBezierBasis, RiHermiteBasis;

void RiAttributeBegin(void);
void RiAttributeEnd(void);
void RiMotionBeginV(RtInt n, RtFloat times[]);
void RiMotionEnd(void);
void RiBasis(RtBasis u, RtInt u_step, RtBasis v, RtInt v_step);
void RiCurvesV(RtToken type, RtInt curves, RtInt vertices[], RtToken wrap, RtInt n,
               RtToken tokens[], RtPointer values[]);
void RiProcedural(RtPointer data, RtBound bound, RtProcSubdivFunc subdivide,
                  RtProcFreeFunc release);
void RiErrorPrint(RtInt code, RtInt severity, const char* message);

}  // extern "C"

namespace lancret {

/// A larger `detail` means that the renderer has none (RI_INFINITY is 1e38): grow all
/// strands.
inline constexpr RtFloat kNoDetail = 1e37f;

// RIE_...
inline constexpr RtInt kRiSystem = 2, kRiBadFile = 4, kRiBug = 14;
inline constexpr RtInt kRiInfo = 0, kRiWarning = 1, kRiError = 2;

}  // namespace lancret
