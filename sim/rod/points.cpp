#include "sim/rod/points.h"

#include "sim/segment/end.h"
#include "sim/segment/gauss_legendre.h"
#include "sim/segment/second_derivative.h"

namespace lancret {

namespace {

/// The start of a segment and its motion.
struct Joint {
    RootMotion motion;

    SegmentMotion segment_motion(const Vec3& rates) const {
        return {rates, motion.velocity, motion.angular_velocity};
    }

    /// Moves on to the end of the segment.
    void advance(const SegmentEnd& end, const Vec3& rates) {
        const Mat3& frame = motion.pose.frame;
        motion.pose.position += move_velocity(end, rates);
        motion.angular_velocity += frame * (end.angular * rates);
        motion.pose.frame = (frame * end.rotation).eval();
    }
    /// The same, including accelerations, with q'' = 0.
    void advance_with_bias(const SegmentEnd& end, const Vec3& rates, const Vec3& k,
                           double length) {
        const Mat3& frame = motion.pose.frame;
        const SegmentSecondDerivative second(k, length);
        const Vec3 omega = motion.angular_velocity, d = frame * end.position;
        const Vec3 relative = frame * (end.jacobian * rates);
        motion.acceleration += motion.angular_acceleration.cross(d) +
                               omega.cross(omega.cross(d) + 2 * relative) +
                               frame * second.position(rates, rates);
        motion.angular_acceleration += omega.cross(frame * (end.angular * rates)) +
                                       frame * second.angular(rates, rates);
        advance(end, rates);
    }

  private:
    /// Moves the velocity on to the end and returns the displacement.
    Vec3 move_velocity(const SegmentEnd& end, const Vec3& rates) {
        const Vec3 d = motion.pose.frame * end.position;
        motion.velocity +=
            motion.angular_velocity.cross(d) + motion.pose.frame * (end.jacobian * rates);
        return d;
    }
};

SegmentQuadrature quadrature(double length, const Vec3& darboux,
                             const PointLayout& layout, const HelixState<double>& start,
                             int q) {
    SegmentQuadrature out;
    out.darboux = darboux;
    out.length = length;
    out.points = layout.points(q);
    out.frame = start.frame;
    out.start = start.position;
    return out;
}

}  // namespace

void PointLayout::lay_out(std::span<const double> lengths,
                          std::span<const Vec3> curvatures) {
    first_.resize(lengths.size() + 1);
    first_[0] = 0;
    for (std::size_t q = 0; q < lengths.size(); ++q) {
        first_[q + 1] = first_[q] + gauss_points(lengths[q] * curvatures[q].norm());
    }
}

void point_positions(std::span<const double> lengths, const HelixState<double>& root,
                     std::span<const Vec3> curvatures, const PointLayout& layout,
                     PointVectors& positions, std::vector<Vec3>& joints) {
    positions.resize(layout.size());
    joints.resize(lengths.size());
    HelixState<double> joint = root;
    for (int q = 0; q < layout.segments(); ++q) {
        segment_positions(quadrature(lengths[q], curvatures[q], layout, joint, q),
                          positions.at(layout.first(q)), positions.stride());
        advance<double>(joint, curvatures[q], lengths[q]);
        joints[q] = joint.position;
    }
}

void point_velocities(const Rod& rod, const RodState& state, const PointLayout& layout,
                      PointVectors& velocities, std::vector<Vec3>& joints) {
    velocities.resize(layout.size());
    joints.resize(rod.lengths.size());
    Joint joint{state.root};
    for (int q = 0; q < rod.segments(); ++q) {
        segment_velocities(
            quadrature(rod.lengths[q], state.curvatures[q], layout, joint.motion.pose, q),
            joint.segment_motion(state.rates[q]), velocities.at(layout.first(q)),
            velocities.stride());
        joint.advance(segment_end(state.curvatures[q], rod.lengths[q]), state.rates[q]);
        joints[q] = joint.motion.velocity;
    }
}

void point_bias(const Rod& rod, const RodState& state, const PointLayout& layout,
                PointVectors& bias) {
    bias.resize(layout.size());
    Joint joint{state.root};
    for (int q = 0; q < rod.segments(); ++q) {
        segment_bias(
            quadrature(rod.lengths[q], state.curvatures[q], layout, joint.motion.pose, q),
            joint.segment_motion(state.rates[q]), joint.motion.acceleration,
            joint.motion.angular_acceleration, bias.at(layout.first(q)), bias.stride());
        joint.advance_with_bias(segment_end(state.curvatures[q], rod.lengths[q]),
                                state.rates[q], state.curvatures[q], rod.lengths[q]);
    }
}

}  // namespace lancret
