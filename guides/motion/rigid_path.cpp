#include "guides/motion/rigid_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "guides/base/coordinates.h"
#include "guides/helix/helix.h"
#include "guides/motion/monotone_cubic.h"

namespace lancret {

namespace {

/// The largest number and the smallest distance of keys: no derivative overflows.
constexpr double kLargest = kLargestCoordinate, kMinStep = 1e-6;

void check_size(const Vec3& x) {
    // Written so that a NaN fails.
    if (!(x.cwiseAbs().maxCoeff() <= kLargest && x.allFinite())) {
        throw std::invalid_argument("make_rigid_path: a number is beyond 1e9");
    }
}

/// d/dt of the left Jacobian V(theta), times theta': the terms of V' that survive, since
/// hat(theta') theta' = 0.
Vec3 jacobian_rate(const Vec3& theta, const Vec3& rate) {
    const double x = theta.squaredNorm(), x_rate = 2 * theta.dot(rate);
    const KernelSlope slope = kernel_slope(x);
    const Vec3 turned = theta.cross(rate);
    return x_rate * (slope.c2 * turned + slope.c3 * theta.cross(turned)) +
           step_kernel(x).c3 * rate.cross(turned);
}

}  // namespace

RigidPath make_rigid_path(std::vector<PoseKey> keys, const Vec3& pivot,
                          double frames_per_second) {
    if (keys.empty()) {
        throw std::invalid_argument("make_rigid_path: expected at least one key");
    }
    if (!(frames_per_second > 0 && frames_per_second <= kLargest)) {
        throw std::invalid_argument(
            "make_rigid_path: the frames per second must be above 0");
    }
    check_size(pivot);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const PoseKey& key = keys[i];
        check_size(Vec3::Constant(key.frame));
        check_size(key.translation);
        check_size(key.rotation);
        if (i > 0 && !(key.frame - keys[i - 1].frame >= kMinStep)) {
            throw std::invalid_argument(
                "make_rigid_path: frames must increase from key to key");
        }
    }

    RigidPath path;
    path.pivot = pivot;
    path.frames_per_second = frames_per_second;
    for (const PoseKey& key : keys) {
        path.frames.push_back(key.frame);
        const Vec3 radians = key.rotation * (kPi / 180);
        for (int c = 0; c < 3; ++c) {
            path.values[c].push_back(key.translation[c]);
            path.values[3 + c].push_back(radians[c]);
        }
    }
    for (int c = 0; c < 6; ++c) {
        path.slopes[c] = monotone_slopes(path.frames, path.values[c]);
    }
    return path;
}

RigidMotion rigid_motion(const RigidPath& path, double frame) {
    if (!std::isfinite(frame)) {
        throw std::invalid_argument("rigid_motion: the frame must be finite");
    }
    // Value and derivatives per second of translation and rotation vector.
    Eigen::Matrix<double, 6, 3> at = Eigen::Matrix<double, 6, 3>::Zero();
    const auto& x = path.frames;
    const double fps = path.frames_per_second;
    if (frame < x.front() || frame > x.back() || x.size() == 1) {
        const std::size_t end = frame < x.front() ? 0 : x.size() - 1;
        for (int c = 0; c < 6; ++c) at(c, 0) = path.values[c][end];
    } else {
        const std::size_t after = std::ranges::upper_bound(x, frame) - x.begin();
        const std::size_t j = std::min(after, x.size() - 1), i = j - 1;
        for (int c = 0; c < 6; ++c) {
            const auto& y = path.values[c];
            const auto& m = path.slopes[c];
            const CubicValue v = hermite_cubic(x[i], x[j], y[i], y[j], m[i], m[j], frame);
            at.row(c) << v.value, v.slope * fps, v.bend * fps * fps;
        }
    }
    const Vec3 theta = at.block<3, 1>(3, 0), rate = at.block<3, 1>(3, 1);
    const Mat3 jacobian = helix_step_derivative(theta, 1).angular;
    RigidMotion motion;
    motion.pose.rotation = helix_step<double>(theta, 1.0).rotation;
    motion.pivot = path.pivot + at.block<3, 1>(0, 0);
    motion.pose.translation = motion.pivot - motion.pose.rotation * path.pivot;
    motion.velocity = at.block<3, 1>(0, 1);
    motion.acceleration = at.block<3, 1>(0, 2);
    motion.angular_velocity = jacobian * rate;
    motion.angular_acceleration =
        jacobian * at.block<3, 1>(3, 2) + jacobian_rate(theta, rate);
    return motion;
}

}  // namespace lancret
