#pragma once
// The integrals over a segment that the dynamics is made of, by Gauss quadrature.

#include <cstddef>
#include <span>

#include "guides/base/types.h"
#include "sim/segment/block.h"

namespace lancret {

/// Places that the points of a segment are drawn to, cm, in space: structure of arrays.
struct PointTargets {
    const double *x, *y, *z;  ///< [points]
};

/// A segment as quadrature sees it.
struct SegmentQuadrature {
    Vec3 darboux;       ///< k, 1/cm
    double length = 0;  ///< cm
    int points = 0;     ///< of its Gauss rule, a multiple of four
    Mat3 frame;         ///< at its start, in space
    Vec3 start;         ///< cm, in space
    PointTargets targets{};
};

/// The integrals over a segment as blocks in space, without darboux, length and what the
/// segment does to its end. `weight` is that of the whole segment. Gives
/// weight |target - place|^2 / 2, averaged over the segment.
double integrate_segment(const SegmentQuadrature& segment, double weight,
                         SegmentBlock& blocks);

/// The recursion of RodSystem::solve; `diagonal`, `load` and `x` are [segments][3].
void solve_recursion(std::span<SegmentBlock> segments, const double* diagonal,
                     const double* load, double* x);

/// Places of the points in space, cm, [3][points]: structure of arrays with the given
/// stride between x, y and z.
void segment_positions(const SegmentQuadrature& segment, double* positions,
                       std::size_t stride);

/// How the points of a segment move at an instant.
struct SegmentMotion {
    Vec3 rates;             ///< k', 1/(cm s)
    Vec3 velocity;          ///< of the segment's start, cm/s
    Vec3 angular_velocity;  ///< of its frame, rad/s
};

/// Velocities of the points, cm/s.
void segment_velocities(const SegmentQuadrature& segment, const SegmentMotion& motion,
                        double* velocities, std::size_t stride);

/// What the points' acceleration is without k'', [3][points], cm/s^2: a + alpha x d +
/// omega x (omega x d) + 2 omega x F p' + F p'', with p' = J k', p'' = D^2 p [k', k']
/// [Bergbom07, Eq. 4.36, corrected]. `acceleration` and `angular_acceleration` are those
/// of the segment's start.
void segment_bias(const SegmentQuadrature& segment, const SegmentMotion& motion,
                  const Vec3& acceleration, const Vec3& angular_acceleration,
                  double* bias, std::size_t stride);

}  // namespace lancret
