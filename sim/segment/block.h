#pragma once
// A linearised segment, as used by the recursion along a rod. Plain numbers only: the
// loops that work on it are compiled once per register width (see loops.h).

namespace lancret {

/// A segment of a RodSystem. Matrices are stored by columns. World axes unless noted;
/// moments and inertia about the segment's start.
struct SegmentBlock {
    double darboux[3], length;
    double frame[9], start[3];   ///< at its start
    double offset[3];            ///< from its start to its end
    double turn[9], move[9];     ///< d(end) / dk: F V, F J
    double gram[9];              ///< w J^T J
    double moment[9], force[9];  ///< w R x J, w J
    double aa[9], al[9], ll[9];  ///< inertia: angular-angular, angular-linear, linear
    double load[3];              ///< w J^T e
    double moment_load[3], force_load[3];
    double factor[9];     ///< lower Cholesky factor of the Schur complement
    double wa[9], wl[9];  ///< U factor^-T, angular and linear
    double z[3];
    double beyond;  ///< padding, for a load of four numbers at the end of z
};

}  // namespace lancret
