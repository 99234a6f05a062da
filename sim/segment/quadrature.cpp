#include "sim/segment/quadrature.h"

#include "sim/segment/gauss_legendre.h"
#include "sim/segment/loops.h"
#include "sim/segment/stumpff.h"

namespace lancret {

namespace {

/// The widest loops that this machine can run.
const SegmentLoops& loops() {
#if defined(__x86_64__)
    static const bool wide = __builtin_cpu_supports("avx2");
    return wide ? kWideLoops : kPlainLoops;
#else
    return kPlainLoops;
#endif
}

SegmentLoop loop_of(const SegmentQuadrature& s) {
    const GaussRule rule = gauss_rule(s.points);
    const int halvings = stumpff_halvings(s.length * s.length * s.darboux.squaredNorm());
    return {s.darboux.data(), s.frame.data(),    s.start.data(),      s.length, s.points,
            halvings,         rule.nodes.data(), rule.weights.data(), s.targets};
}

void store(const Vec3& v, double* to) { Vec3::Map(to) = v; }

RateVectors rate_vectors(const Vec3& k, const Vec3& rate) {
    const Vec3 e0 = Vec3::UnitX();
    RateVectors out;
    out.along = k.dot(rate);
    out.speed = rate.squaredNorm();
    store(k.cross(e0), out.turn);
    store(rate.cross(e0), out.turn_rate);
    store(k.x() * k - k.squaredNorm() * e0, out.square);
    store(k.x() * rate + rate.x() * k - 2 * out.along * e0, out.square_rate);
    store(2 * (rate.x() * rate - out.speed * e0), out.rates);
    return out;
}

}  // namespace

double integrate_segment(const SegmentQuadrature& segment, double weight,
                         SegmentBlock& block) {
    double sums[kSegmentSums + 1];  // padding, for a load of four numbers
    loops().sums(loop_of(segment), sums);
    Mat3::Map(block.frame) = segment.frame;
    Vec3::Map(block.start) = segment.start;
    loops().to_space(sums, weight, block);
    return weight * sums[kSquareSum] / 2;
}

void solve_recursion(std::span<SegmentBlock> segments, const double* diagonal,
                     const double* load, double* x) {
    loops().solve(segments.data(), int(segments.size()), diagonal, load, x);
}

void segment_positions(const SegmentQuadrature& segment, double* positions,
                       std::size_t stride) {
    loops().positions(loop_of(segment), rate_vectors(segment.darboux, Vec3::Zero()),
                      positions, stride);
}

void segment_velocities(const SegmentQuadrature& segment, const SegmentMotion& motion,
                        double* velocities, std::size_t stride) {
    const StartMotion start{motion.velocity.data(), motion.angular_velocity.data(),
                            nullptr, nullptr};
    loops().velocities(loop_of(segment), rate_vectors(segment.darboux, motion.rates),
                       start, velocities, stride);
}

void segment_bias(const SegmentQuadrature& segment, const SegmentMotion& motion,
                  const Vec3& acceleration, const Vec3& angular_acceleration,
                  double* bias, std::size_t stride) {
    const StartMotion start{motion.velocity.data(), motion.angular_velocity.data(),
                            acceleration.data(), angular_acceleration.data()};
    loops().bias(loop_of(segment), rate_vectors(segment.darboux, motion.rates), start,
                 bias, stride);
}

}  // namespace lancret
