#include "sim/rod/energy.h"

#include <stdexcept>

#include "sim/rod/panels.h"
#include "sim/segment/kernel.h"
#include "sim/segment/second_derivative.h"

namespace lancret {

namespace {

/// Of one segment, told in the frame at its start.
struct SegmentIntegrals {
    Vec3 position = Vec3::Zero();  ///< int p du, cm^2
    Mat3 jacobian = Mat3::Zero();  ///< int J du, cm^3
    Mat3 second = Mat3::Zero();    ///< int f . D^2 p [a, b] du
};

SegmentIntegrals segment_integrals(const Vec3& k, double length, const Vec3& force,
                                   Derivatives order) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    SegmentIntegrals out;
    const double turn = k.norm() * length;
    const int halvings = stumpff_halvings(turn * turn);
    over_segment(length, turn, [&](double u, double w) {
        const SegmentPoint<double> at = segment_point<double>(k.data(), u, halvings);
        out.position += w * Vec3::Map(at.p);
        if (order == Derivatives::none) return;
        out.jacobian += w * Eigen::Map<const RowMajor>(&at.j[0][0]);
        if (order == Derivatives::first) return;
        const SegmentSecondDerivative second(k, u);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b <= a; ++b) {
                out.second(a, b) +=
                    w * force.dot(second.position(Vec3::Unit(a), Vec3::Unit(b)));
            }
        }
    });
    return out;
}

/// The second derivatives within a segment: its own points, and the turning of all that
/// lies beyond it, of length `beyond` and first moment `moment` (cm^2) about its end.
/// All in the frame at the segment's start; f is the weight of a unit of length.
Mat3 own_block(const SegmentIntegrals& own, const HelixStepDerivative& step,
               const Vec3& k, double length, double beyond, const Vec3& moment,
               const Vec3& f) {
    const SegmentSecondDerivative end(k, length);
    Mat3 block;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b <= a; ++b) {
            const Vec3 ea = Vec3::Unit(a), eb = Vec3::Unit(b);
            // r = r_end + rho beyond; phi_a = V e_a is its turn for k_a.
            const Vec3 twice =
                end.angular(eb, ea).cross(moment) +
                step.angular.col(a).cross(step.angular.col(b).cross(moment));
            block(a, b) = block(b, a) =
                -own.second(a, b) - f.dot(twice + beyond * end.position(ea, eb));
        }
    }
    return block;
}

}  // namespace

void check_rod(const HangingRod& rod) {
    const auto fail = [](const char* why) { throw std::invalid_argument(why); };
    if (rod.lengths.empty()) fail("HangingRod: has no segment");
    if (rod.natural.size() != rod.lengths.size())
        fail("HangingRod: has not one natural curvature a segment");
    for (const double l : rod.lengths)
        if (!(l > 0 && std::isfinite(l))) fail("HangingRod: a length is above 0");
    for (const Vec3& k : rod.natural)
        if (!k.allFinite()) fail("HangingRod: a natural curvature is not finite");
    const RodSection& section = rod.section;
    if (!(section.stiffness.minCoeff() > 0) || !section.stiffness.allFinite() ||
        !(section.linear_density > 0) || !std::isfinite(section.linear_density))
        fail("HangingRod: a stiffness or the density is not above 0");
    const Mat3& frame = rod.root.frame;
    const Mat3 gram = frame.transpose() * frame - Mat3::Identity();
    if (!(gram.norm() < 1e-9) || !(frame.determinant() > 0))
        fail("HangingRod: the root frame is not a rotation");
    if (!rod.gravity.allFinite() || !rod.root.position.allFinite())
        fail("HangingRod: gravity or the root is not finite");
}

double rod_length(const HangingRod& rod) {
    double sum = 0;
    for (const double l : rod.lengths) sum += l;
    return sum;
}

Eigen::VectorXd natural_curvatures(const HangingRod& rod) {
    Eigen::VectorXd q(3 * rod.segments());
    for (std::size_t i = 0; i < rod.segments(); ++i) q.segment<3>(3 * i) = rod.natural[i];
    return q;
}

Eigen::VectorXd stiffness_diagonal(const HangingRod& rod) {
    Eigen::VectorXd out(3 * rod.segments());
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        out.segment<3>(3 * i) = rod.lengths[i] * rod.section.stiffness;
    }
    return out;
}

std::vector<HelixState<double>> rod_joints(const HangingRod& rod,
                                           const Eigen::VectorXd& q) {
    std::vector<HelixState<double>> out(rod.segments() + 1);
    out[0] = rod.root;
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        out[i + 1] = out[i];
        advance<double>(out[i + 1], q.segment<3>(3 * i), rod.lengths[i]);
    }
    return out;
}

HangingEnergy rod_energy(const HangingRod& rod, const Eigen::VectorXd& q) {
    GravityTerms gravity;
    gravity_terms(rod, q, Derivatives::none, gravity);
    const Eigen::VectorXd bent = q - natural_curvatures(rod);
    return {bent.cwiseAbs2().dot(stiffness_diagonal(rod)) / 2, gravity.energy};
}

void gravity_terms(const HangingRod& rod, const Eigen::VectorXd& q, Derivatives order,
                   GravityTerms& out) {
    const std::size_t segments = rod.segments();
    const Vec3 force = rod.section.linear_density * rod.gravity;
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    out.energy = 0;
    if (order != Derivatives::none) out.gradient.resize(3 * segments);
    if (order == Derivatives::second) out.hessian.resize(3 * segments, 3 * segments);

    // From tip to root, with the length beyond and its first moment about the joint. A
    // curvature of an earlier segment turns all beyond it by phi_a: d2r = phi_a x J_b,
    // so what is downstream enters only by g_b = int J_b ds, world axes.
    double beyond = 0;
    Vec3 moment = Vec3::Zero();
    Eigen::Matrix3Xd pulls(3, order == Derivatives::second ? 3 * segments : 0);
    for (std::size_t i = segments; i-- > 0;) {
        const Mat3& frame = joints[i].frame;
        const Vec3 k = q.segment<3>(3 * i), f = frame.transpose() * force;
        const double length = rod.lengths[i];
        const SegmentIntegrals own = segment_integrals(k, length, f, order);
        if (order != Derivatives::none) {
            const HelixStepDerivative step = helix_step_derivative(k, length);
            const Vec3 arm = frame.transpose() * moment;
            Mat3 pull = own.jacobian + beyond * step.position;
            for (int a = 0; a < 3; ++a) pull.col(a) += step.angular.col(a).cross(arm);
            out.gradient.segment<3>(3 * i) = -pull.transpose() * f;
            if (order == Derivatives::second) {
                out.hessian.block<3, 3>(3 * i, 3 * i) =
                    own_block(own, step, k, length, beyond, arm, f);
                const auto later = Eigen::seqN(3 * (i + 1), 3 * (segments - i - 1));
                for (int a = 0; a < 3; ++a) {
                    const Vec3 turned = frame * f.cross(step.angular.col(a));
                    out.hessian(3 * i + a, later) =
                        -turned.transpose() * pulls(Eigen::all, later);
                }
                out.hessian(later, Eigen::seqN(3 * i, 3)) =
                    out.hessian(Eigen::seqN(3 * i, 3), later).transpose();
                pulls.middleCols<3>(3 * i) = frame * pull;
            }
        }
        const Vec3 chord = joints[i + 1].position - joints[i].position;
        moment += frame * own.position + beyond * chord;
        beyond += length;
    }
    out.energy = -force.dot(moment);
}

Eigen::VectorXd rod_gradient(const HangingRod& rod, const Eigen::VectorXd& q) {
    GravityTerms gravity;
    gravity_terms(rod, q, Derivatives::first, gravity);
    return stiffness_diagonal(rod).cwiseProduct(q - natural_curvatures(rod)) +
           gravity.gradient;
}

Eigen::MatrixXd rod_hessian(const HangingRod& rod, const Eigen::VectorXd& q) {
    GravityTerms gravity;
    gravity_terms(rod, q, Derivatives::second, gravity);
    gravity.hessian.diagonal() += stiffness_diagonal(rod);
    return gravity.hessian;
}

}  // namespace lancret
