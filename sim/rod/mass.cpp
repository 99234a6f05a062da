#include "sim/rod/mass.h"

#include "sim/rod/panels.h"
#include "sim/segment/kernel.h"

namespace lancret {

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat63 = Eigen::Matrix<double, 6, 3>;

/// The velocity, at `arm` from the root, of each unit twist (omega; v at the root).
Eigen::Matrix<double, 3, 6> velocity_of_twist(const Vec3& arm) {
    Eigen::Matrix<double, 3, 6> out;
    out << -hat<double>(arm), Mat3::Identity();
    return out;
}

}  // namespace

Eigen::MatrixXd rod_mass(const HangingRod& rod, const Eigen::VectorXd& q) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const std::size_t segments = rod.segments();
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    Eigen::MatrixXd mass(3 * segments, 3 * segments);
    // From tip to root, with the inertia of everything beyond as of one rigid body about
    // the root, and `momenta`, the momentum per later curvature, [6, 3 segments].
    Mat6 beyond = Mat6::Zero();
    Eigen::Matrix<double, 6, Eigen::Dynamic> momenta(6, 3 * segments);
    for (std::size_t i = segments; i-- > 0;) {
        const Vec3 k = q.segment<3>(3 * i);
        const double length = rod.lengths[i], turn = k.norm() * length;
        const int halvings = stumpff_halvings(turn * turn);
        const HelixState<double>& start = joints[i];
        Mat3 diagonal = Mat3::Zero();
        Mat63 coupling = Mat63::Zero();
        Mat6 inertia = Mat6::Zero();
        over_segment(length, turn, [&](double u, double w) {
            const SegmentPoint<double> point =
                segment_point<double>(k.data(), u, halvings);
            const Mat3 jacobian =
                start.frame * Eigen::Map<const RowMajor>(&point.j[0][0]);
            const auto rigid = velocity_of_twist(
                start.position + start.frame * Vec3::Map(point.p) - rod.root.position);
            diagonal += w * jacobian.transpose() * jacobian;
            coupling += w * rigid.transpose() * jacobian;
            inertia += w * rigid.transpose() * rigid;
        });
        const HelixStepDerivative step = helix_step_derivative(k, length);
        const Vec3 end = joints[i + 1].position - rod.root.position;
        Mat63 twist;
        twist.topRows<3>() = start.frame * step.angular;
        twist.bottomRows<3>() =
            start.frame * step.position + hat<double>(end) * twist.topRows<3>();
        const Mat63 pushed = beyond * twist;
        mass.block<3, 3>(3 * i, 3 * i) = diagonal + twist.transpose() * pushed;
        const auto here = Eigen::seqN(3 * i, 3);
        const auto later = Eigen::seqN(3 * (i + 1), 3 * (segments - i - 1));
        mass(here, later) = twist.transpose() * momenta(Eigen::all, later);
        mass(later, here) = mass(here, later).transpose();
        momenta.middleCols<3>(3 * i) = coupling + pushed;
        beyond += inertia;
    }
    return rod.section.linear_density * mass;
}

}  // namespace lancret
