#include "sim/rod/energy.h"

#include <cmath>

#include "guides/base/errors.h"
#include "sim/rod/panels.h"
#include "sim/segment/kernel.h"
#include "sim/segment/second_derivative.h"

namespace lancret {

namespace {

/// Integrals over one segment, in the frame at its start.
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
        const SegmentPoint<double> point = segment_point<double>(k.data(), u, halvings);
        out.position += w * Vec3::Map(point.p);
        if (order == Derivatives::none) return;
        out.jacobian += w * Eigen::Map<const RowMajor>(&point.j[0][0]);
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

/// The part of a rod beyond a segment, relative to the segment's end.
struct Beyond {
    double length = 0;           ///< cm
    Vec3 moment = Vec3::Zero();  ///< first moment, cm^2
};

/// The second derivatives with respect to one segment's curvatures: from its own points
/// and from the turning of everything beyond it. All in the frame at the segment's
/// start; f is the weight per unit of length.
Mat3 diagonal_block(const SegmentIntegrals& integrals, const HelixStepDerivative& step,
                    const Vec3& k, double length, const Beyond& beyond, const Vec3& f) {
    const SegmentSecondDerivative end(k, length);
    Mat3 block;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b <= a; ++b) {
            const Vec3 ea = Vec3::Unit(a), eb = Vec3::Unit(b);
            // r = r_end + rho beyond the end; phi_a = V e_a is the turn of the end with
            // k_a.
            const Vec3 twice =
                end.angular(eb, ea).cross(beyond.moment) +
                step.angular.col(a).cross(step.angular.col(b).cross(beyond.moment));
            block(a, b) = block(b, a) =
                -integrals.second(a, b) -
                f.dot(twice + beyond.length * end.position(ea, eb));
        }
    }
    return block;
}

}  // namespace

void validate_rod(const HangingRod& rod) {
    require(!rod.lengths.empty(), "HangingRod: expected at least one segment");
    require(rod.natural.size() == rod.lengths.size(),
            "HangingRod: expected one natural curvature per segment");
    for (const double l : rod.lengths) {
        require(l > 0 && std::isfinite(l),
                "HangingRod: lengths must be finite and above 0");
    }
    for (const Vec3& k : rod.natural) {
        require(k.allFinite(), "HangingRod: natural curvatures must be finite");
    }
    const RodSection& section = rod.section;
    require(section.stiffness.minCoeff() > 0 && section.stiffness.allFinite() &&
                section.linear_density > 0 && std::isfinite(section.linear_density),
            "HangingRod: stiffness and density must be finite and above 0");
    const Mat3& frame = rod.root.frame;
    const Mat3 gram = frame.transpose() * frame - Mat3::Identity();
    require(gram.norm() < 1e-9 && frame.determinant() > 0,
            "HangingRod: the root frame must be a rotation");
    require(rod.gravity.allFinite() && rod.root.position.allFinite(),
            "HangingRod: gravity and the root must be finite");
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

    // From tip to root, with the length beyond the joint and its first moment about it. A
    // curvature of an earlier segment turns everything beyond it by phi_a: d2r = phi_a x
    // J_b, so what is downstream enters only through g_b = int J_b ds, world axes.
    double beyond = 0;
    Vec3 moment = Vec3::Zero();
    Eigen::Matrix3Xd pulls(3, order == Derivatives::second ? 3 * segments : 0);
    for (std::size_t i = segments; i-- > 0;) {
        const Mat3& frame = joints[i].frame;
        const Vec3 k = q.segment<3>(3 * i), f = frame.transpose() * force;
        const double length = rod.lengths[i];
        const SegmentIntegrals integrals = segment_integrals(k, length, f, order);
        if (order != Derivatives::none) {
            const HelixStepDerivative step = helix_step_derivative(k, length);
            const Vec3 arm = frame.transpose() * moment;
            Mat3 pull = integrals.jacobian + beyond * step.position;
            for (int a = 0; a < 3; ++a) pull.col(a) += step.angular.col(a).cross(arm);
            out.gradient.segment<3>(3 * i) = -pull.transpose() * f;
            if (order == Derivatives::second) {
                out.hessian.block<3, 3>(3 * i, 3 * i) =
                    diagonal_block(integrals, step, k, length, {beyond, arm}, f);
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
        moment += frame * integrals.position + beyond * chord;
        beyond += length;
    }
    out.energy = -force.dot(moment);
}

Eigen::MatrixXd rod_hessian(const HangingRod& rod, const Eigen::VectorXd& q) {
    GravityTerms gravity;
    gravity_terms(rod, q, Derivatives::second, gravity);
    gravity.hessian.diagonal() += stiffness_diagonal(rod);
    return gravity.hessian;
}

}  // namespace lancret
