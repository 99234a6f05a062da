#include "sim/rod_system.h"

#include <cmath>

#include "sim/segment_end.h"

namespace lancret {

namespace {

/// a x each column of m.
Mat3 crossed(const Vec3& a, const Mat3& m) {
    Mat3 out;
    for (int c = 0; c < 3; ++c) out.col(c) = a.cross(m.col(c));
    return out;
}

/// The lower Cholesky factor of a symmetric, positive definite matrix.
Mat3 cholesky(const Mat3& m) {
    Mat3 l = Mat3::Zero();
    l(0, 0) = std::sqrt(m(0, 0));
    l(1, 0) = m(1, 0) / l(0, 0);
    l(2, 0) = m(2, 0) / l(0, 0);
    l(1, 1) = std::sqrt(m(1, 1) - l(1, 0) * l(1, 0));
    l(2, 1) = (m(2, 1) - l(2, 0) * l(1, 0)) / l(1, 1);
    l(2, 2) = std::sqrt(m(2, 2) - l(2, 0) * l(2, 0) - l(2, 1) * l(2, 1));
    return l;
}

/// u l^-T.
Mat3 right_solve(const Mat3& u, const Mat3& l) {
    Mat3 w;
    w.col(0) = u.col(0) / l(0, 0);
    w.col(1) = (u.col(1) - w.col(0) * l(1, 0)) / l(1, 1);
    w.col(2) = (u.col(2) - w.col(0) * l(2, 0) - w.col(1) * l(2, 1)) / l(2, 2);
    return w;
}

Vec3 forward_solve(const Mat3& l, const Vec3& b) {
    Vec3 z;
    z[0] = b[0] / l(0, 0);
    z[1] = (b[1] - l(1, 0) * z[0]) / l(1, 1);
    z[2] = (b[2] - l(2, 0) * z[0] - l(2, 1) * z[1]) / l(2, 2);
    return z;
}

Vec3 backward_solve(const Mat3& l, const Vec3& z) {
    Vec3 x;
    x[2] = z[2] / l(2, 2);
    x[1] = (z[1] - l(2, 1) * x[2]) / l(1, 1);
    x[0] = (z[0] - l(1, 0) * x[1] - l(2, 0) * x[2]) / l(0, 0);
    return x;
}

/// What follows a joint, seen as a body that is held there.
struct Composite {
    Mat3 aa = Mat3::Zero(), al = Mat3::Zero(), ll = Mat3::Zero();
    Vec3 moment = Vec3::Zero(), force = Vec3::Zero();

    /// Tells it about a point that lies -d away: T^t I T and T^t (moment; force).
    void shift(const Vec3& d) {
        const Mat3 turned = crossed(d, ll);
        const Mat3 coupling = crossed(d, al.transpose());
        const Mat3 twice = crossed(d, turned.transpose());  // [d] ll [d]^t
        aa += coupling + coupling.transpose() + (twice + twice.transpose()) / 2;
        al += turned;
        moment += d.cross(force);
    }
};

}  // namespace

void RodSystem::linearize(const HelixState<double>& root, std::span<const double> lengths,
                          std::span<const Vec3> curvatures, const PointLayout& layout,
                          const PointVectors& targets, double weight) {
    segments_.resize(lengths.size());
    half_square_ = 0;
    SegmentQuadrature quadrature;
    quadrature.frame = root.frame;
    quadrature.start = root.position;
    for (int q = 0; q < segments(); ++q) {
        Segment& s = segments_[q];
        s.darboux = quadrature.darboux = curvatures[q];
        s.length = quadrature.length = lengths[q];
        s.frame = quadrature.frame;
        s.start = quadrature.start;
        quadrature.points = layout.points(q);
        quadrature.targets = targets.targets(layout.first(q));
        const SegmentSums sums = segment_sums(quadrature);
        const double w = weight * s.length;
        s.gram = w * sums.gram;
        s.moment = w * (s.frame * sums.turned_jacobian);
        s.force = w * (s.frame * sums.jacobian);
        s.aa = -w * (s.frame * sums.second * s.frame.transpose());
        s.aa.diagonal().array() += w * sums.second.trace();
        s.al = hat<double>(w * (s.frame * sums.first));
        s.ll = w * Mat3::Identity();
        s.load = w * sums.load;
        s.moment_load = w * (s.frame * sums.moment);
        s.force_load = w * (s.frame * sums.force);
        half_square_ += w * sums.half_square;

        const SegmentEnd end = segment_end(s.darboux, s.length);
        s.offset = s.frame * end.place;
        s.turn = s.frame * end.angular;
        s.move = s.frame * end.jacobian;
        quadrature.start += s.offset;
        quadrature.frame = s.frame * end.rotation;
    }
}

void RodSystem::add_point(int segment, double u, const Mat3& stiffness,
                          const Vec3& force) {
    Segment& s = segments_[segment];
    const auto [p, j] = segment_point<double>(
        s.darboux.data(), u, stumpff_halvings(u * u * s.darboux.squaredNorm()));
    const Mat3 jacobian =
        s.frame *
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&j[0][0]);
    const Vec3 r = s.frame * Vec3::Map(p);
    const Mat3 pulled = stiffness * jacobian, turned = crossed(r, stiffness);
    s.gram += jacobian.transpose() * pulled;
    s.force += pulled;
    s.moment += crossed(r, pulled);
    s.ll += stiffness;
    s.al += turned;
    s.aa += crossed(r, turned.transpose());
    s.load += jacobian.transpose() * force;
    s.moment_load += r.cross(force);
    s.force_load += force;
}

void RodSystem::solve(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                      std::span<Vec3> x) {
    Composite beyond;
    for (int q = segments(); q-- > 0;) {
        Segment& s = segments_[q];
        const Mat3 angular = beyond.aa * s.turn + beyond.al * s.move;
        const Mat3 linear = beyond.al.transpose() * s.turn + beyond.ll * s.move;
        Mat3 schur = s.gram + s.turn.transpose() * angular + s.move.transpose() * linear;
        schur.diagonal() += diagonal[q];
        const Vec3 y = s.load + load[q] + s.turn.transpose() * beyond.moment +
                       s.move.transpose() * beyond.force;
        s.factor = cholesky(schur);
        s.wl = right_solve(s.force + linear, s.factor);
        s.wa = right_solve(s.moment + angular + crossed(s.offset, linear), s.factor);
        s.z = forward_solve(s.factor, y);
        beyond.shift(s.offset);
        // Subtracting a product with its own transpose keeps the inertia symmetric; an
        // asymmetry would grow along the strand.
        beyond.aa += s.aa - s.wa * s.wa.transpose();
        beyond.al += s.al - s.wa * s.wl.transpose();
        beyond.ll += s.ll - s.wl * s.wl.transpose();
        beyond.moment += s.moment_load - s.wa * s.z;
        beyond.force += s.force_load - s.wl * s.z;
    }
    Vec3 angular = Vec3::Zero(), linear = Vec3::Zero();
    for (int q = 0; q < segments(); ++q) {
        const Segment& s = segments_[q];
        const Vec3 z = s.z - s.wa.transpose() * angular - s.wl.transpose() * linear;
        x[q] = backward_solve(s.factor, z);
        linear += angular.cross(s.offset) + s.move * x[q];
        angular += s.turn * x[q];
    }
}

void RodSystem::assemble(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                         Eigen::MatrixXd& matrix, Eigen::VectorXd& force) const {
    const int n = segments();
    matrix.resize(3 * n, 3 * n);
    force.resize(3 * n);
    Composite beyond;
    for (int q = n; q-- > 0;) {
        const Segment& s = segments_[q];
        Mat3 angular = beyond.aa * s.turn + beyond.al * s.move;
        Mat3 linear = beyond.al.transpose() * s.turn + beyond.ll * s.move;
        const Mat3 own =
            s.gram + s.turn.transpose() * angular + s.move.transpose() * linear;
        matrix.block<3, 3>(3 * q, 3 * q) = (own + own.transpose()) / 2;
        matrix.diagonal().segment<3>(3 * q) += diagonal[q];
        force.segment<3>(3 * q) = s.load + load[q] + s.turn.transpose() * beyond.moment +
                                  s.move.transpose() * beyond.force;
        angular += s.moment + crossed(s.offset, linear);
        linear += s.force;
        // What dk of this segment costs in wrench at the start of it, carried towards the
        // root, meets the motion that every earlier segment gives to that place.
        for (int p = q; p-- > 0;) {
            const Segment& earlier = segments_[p];
            matrix.block<3, 3>(3 * p, 3 * q) =
                earlier.turn.transpose() * angular + earlier.move.transpose() * linear;
            matrix.block<3, 3>(3 * q, 3 * p) =
                matrix.block<3, 3>(3 * p, 3 * q).transpose();
            angular += crossed(earlier.offset, linear);
        }
        beyond.shift(s.offset);
        beyond.aa += s.aa;
        beyond.al += s.al;
        beyond.ll += s.ll;
        beyond.moment += s.moment_load;
        beyond.force += s.force_load;
    }
}

}  // namespace lancret
