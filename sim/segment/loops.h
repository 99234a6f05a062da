#pragma once
// The loops over quadrature points, compiled once per register width. Plain numbers only:
// nothing here may be an inline function that other code shares, or the linker could keep
// the wide version on a machine without such registers.

#include "sim/segment/block.h"
#include "sim/segment/quadrature.h"

namespace lancret {

/// A segment as input of the loops; matrices by columns.
struct SegmentLoop {
    const double *darboux, *frame, *start;
    double length;
    int points, halvings;
    const double *nodes, *weights;  ///< [points]
    PointTargets targets;
};

/// Index of each sum. Symmetric matrices are stored by their lower halves, others by
/// columns.
enum SegmentSum {
    kGramSum = 0,
    kSecondSum = 6,
    kTurnedSum = 12,
    kJacobianSum = 21,
    kFirstSum = 30,
    kLoadSum = 33,
    kMomentSum = 36,
    kForceSum = 39,
    kSquareSum = 42,
    kSegmentSums = 44
};

/// The vectors that p, p' and p'' are linear combinations of, with factors that depend
/// only on u.
struct RateVectors {
    double turn[3], turn_rate[3];                ///< K e0, k' x e0
    double square[3], square_rate[3], rates[3];  ///< K^2 e0 and its derivatives by k'
    double along, speed;                         ///< k . k', |k'|^2
};

/// Motion of the start of a segment; see SegmentMotion.
struct StartMotion {
    const double *velocity, *angular_velocity;
    const double *acceleration, *angular_acceleration;
};

struct SegmentLoops {
    void (*sums)(const SegmentLoop&, double* sums);
    /// Inertia and loads of a segment in world axes, from its sums and its frame.
    void (*to_space)(const double* sums, double weight, SegmentBlock&);
    /// The recursion from tip to root and back; `diagonal`, `load` and `x` are
    /// [segments][3].
    void (*solve)(SegmentBlock*, int segments, const double* diagonal, const double* load,
                  double* x);
    void (*positions)(const SegmentLoop&, const RateVectors&, double* out,
                      std::size_t stride);
    void (*velocities)(const SegmentLoop&, const RateVectors&, const StartMotion&,
                       double* out, std::size_t stride);
    void (*bias)(const SegmentLoop&, const RateVectors&, const StartMotion&, double* out,
                 std::size_t stride);
};

/// For any machine, and for one with AVX2. Both give the same bits.
extern const SegmentLoops kPlainLoops;
extern const SegmentLoops kWideLoops;

}  // namespace lancret
