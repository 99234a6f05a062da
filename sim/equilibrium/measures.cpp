#include "sim/equilibrium/measures.h"

#include <algorithm>
#include <cmath>

#include "sim/rod/panels.h"
#include "sim/segment/kernel.h"

namespace lancret {

LowestPoint lowest_point(const HangingRod& rod, const Eigen::VectorXd& q,
                         const Vec3& up) {
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    LowestPoint out{up.dot(joints[0].position), 0};
    double start = 0;
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        const Vec3 k = q.segment<3>(3 * i);
        const auto state_of = [&](double u) {
            HelixState<double> state = joints[i];
            advance<double>(state, k, u);
            return state;
        };
        const auto take = [&](double u, const HelixState<double>& state) {
            const double height = up.dot(state.position);
            if (height < out.height) out = {height, start + u};
        };
        // The tangent's height is a sine of the turn. Steps of a sixteenth of a turn
        // separate its zeros, unless two are so close that the curve is level between
        // them.
        const double length = rod.lengths[i], turns = k.norm() * length / (2 * kPi);
        const int parts = int(std::clamp(std::ceil(16 * turns), 4., 1e5));
        double before = up.dot(joints[i].frame.col(0));
        for (int p = 1; p <= parts; ++p) {
            double low = length * (p - 1) / parts, high = length * p / parts;
            const HelixState<double> end = state_of(high);
            const double after = up.dot(end.frame.col(0));
            take(high, end);
            if (before < 0 && after > 0) {
                for (int round = 0; round < 60; ++round) {
                    const double middle = (low + high) / 2;
                    const bool falls = up.dot(state_of(middle).frame.col(0)) < 0;
                    (falls ? low : high) = middle;
                }
                take(low, state_of(low));
            }
            before = after;
        }
        start += length;
    }
    return out;
}

Vec3 root_darboux(const HangingRod& rod, const Eigen::VectorXd& q) {
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    Vec3 arm = Vec3::Zero();  // int (r - r_root) ds
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        const Vec3 k = q.segment<3>(3 * i);
        const double length = rod.lengths[i], turn = k.norm() * length;
        over_segment(length, turn, [&](double u, double w) {
            const auto point =
                segment_point<double>(k.data(), u, stumpff_halvings(turn * turn));
            arm += w * (joints[i].position - rod.root.position +
                        joints[i].frame * Vec3::Map(point.p));
        });
    }
    const Vec3 moment = arm.cross(rod.section.linear_density * rod.gravity);
    return rod.natural[0] +
           (rod.root.frame.transpose() * moment).cwiseQuotient(rod.section.stiffness);
}

double tip_angle(const HangingRod& rod, const Eigen::VectorXd& q) {
    const Vec3 tip = rod_joints(rod, q).back().frame.col(0);
    const Vec3 root = rod.root.frame.col(0);
    return std::atan2(root.cross(tip).norm(), root.dot(tip));
}

}  // namespace lancret
