#pragma once
// The segment integrals of the dynamics, by Gauss quadrature.

#include <cstddef>
#include <span>

#include "guides/base/types.h"
#include "sim/segment/block.h"

namespace lancret {

/// Target positions of the points of a segment, cm, world axes: structure of arrays.
struct PointTargets {
    const double *x, *y, *z;  ///< [points]
};

/// A segment as input of the quadrature.
struct SegmentQuadrature {
    Vec3 darboux;       ///< k, 1/cm
    double length = 0;  ///< cm
    int points = 0;     ///< of the Gauss rule, a multiple of four
    Mat3 frame;         ///< at its start, world axes
    Vec3 start;         ///< cm, world axes
    PointTargets targets{};
};

/// Sets the integrals of `block`, in world axes; `darboux`, `length`, `offset`, `turn`
/// and `move` are left alone. `weight` is that of the whole segment. Returns weight
/// |target - position|^2 / 2, averaged over the segment.
double integrate_segment(const SegmentQuadrature& segment, double weight,
                         SegmentBlock& block);

/// The recursion of RodSystem::solve; `diagonal`, `load` and `x` are [segments][3].
void solve_recursion(std::span<SegmentBlock> segments, const double* diagonal,
                     const double* load, double* x);

/// World positions of the points, cm, [3][points]: structure of arrays with `stride`
/// between x, y and z.
void segment_positions(const SegmentQuadrature& segment, double* positions,
                       std::size_t stride);

/// Motion of a segment at an instant.
struct SegmentMotion {
    Vec3 rates;             ///< k', 1/(cm s)
    Vec3 velocity;          ///< of the segment's start, cm/s
    Vec3 angular_velocity;  ///< of its frame, rad/s
};

/// World velocities of the points, cm/s, laid out as the positions.
void segment_velocities(const SegmentQuadrature& segment, const SegmentMotion& motion,
                        double* velocities, std::size_t stride);

/// The points' acceleration without the term of k'', [3][points], cm/s^2: a + alpha x d +
/// omega x (omega x d) + 2 omega x F p' + F p'', with p' = J k', p'' = D^2 p [k', k']
/// [Bergbom07, Eq. 4.36, corrected]. `acceleration` and `angular_acceleration` are those
/// of the segment's start.
void segment_bias(const SegmentQuadrature& segment, const SegmentMotion& motion,
                  const Vec3& acceleration, const Vec3& angular_acceleration,
                  double* bias, std::size_t stride);

}  // namespace lancret
