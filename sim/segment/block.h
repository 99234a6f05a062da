#pragma once
// What a linearised segment is to the recursion along a rod. Numbers only: the loops that
// work on it are compiled once for each width of registers (see segment_loops.h).

namespace lancret {

/// A segment of a RodSystem. Matrices by columns, in space where nothing else is said;
/// moments and inertia about the segment's start.
struct SegmentBlock {
    double darboux[3], length;
    double frame[9], start[3];   ///< at its start
    double offset[3];            ///< from its start to its end
    double turn[9], move[9];     ///< what dk does to its end: F V, F J
    double gram[9];              ///< w J^T J
    double moment[9], force[9];  ///< w R x J, w J
    double aa[9], al[9], ll[9];  ///< inertia: angular-angular, angular-linear, linear
    double load[3];              ///< w J^T e
    double moment_load[3], force_load[3];
    double factor[9];     ///< lower Cholesky factor of the Schur complement
    double wa[9], wl[9];  ///< U factor^-T, angular and linear
    double z[3];
    double beyond;  ///< room for a load of four numbers from the end of z
};

}  // namespace lancret
