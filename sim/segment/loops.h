#pragma once
// The loops over quadrature points, compiled once for each width of registers. Numbers
// only: nothing here may be an inline function that other code shares, lest the linker
// take the wide one for a machine that has no such registers.

#include "sim/segment/block.h"
#include "sim/segment/quadrature.h"

namespace lancret {

/// A segment; matrices by columns.
struct SegmentLoop {
    const double *darboux, *frame, *start;
    double length;
    int points, halvings;
    const double *nodes, *weights;  ///< [points]
    PointTargets targets;
};

/// Where each sum is: symmetric matrices by their lower halves, others by columns.
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

/// The vectors that p, p' and p'' are sums of, with factors that depend on u alone.
struct RateVectors {
    double turn[3], turn_rate[3];                ///< K e0, k' x e0
    double square[3], square_rate[3], rates[3];  ///< K^2 e0 and its derivatives by k'
    double along, speed;                         ///< k . k', |k'|^2
};

/// How the start of a segment moves; see SegmentMotion.
struct StartMotion {
    const double *velocity, *angular_velocity;
    const double *acceleration, *angular_acceleration;
};

struct SegmentLoops {
    void (*sums)(const SegmentLoop&, double* sums);
    /// Inertia and loads of a segment in space, from its sums and its frame.
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

/// For any machine, and for one with AVX2: the same bits.
extern const SegmentLoops kPlainLoops;
extern const SegmentLoops kWideLoops;

}  // namespace lancret
