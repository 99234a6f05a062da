#include "sim/rod/system.h"

#include <cmath>

#include "sim/segment/end.h"

namespace lancret {

namespace {

/// a x each column of m.
Mat3 crossed(const Vec3& a, const Mat3& m) {
    Mat3 out;
    for (int c = 0; c < 3; ++c) out.col(c) = a.cross(m.col(c));
    return out;
}

/// A SegmentBlock seen as matrices.
template <class Blocks, class Matrix, class Vector>
struct BlocksView {
    using MatrixMap = Eigen::Map<Matrix>;
    using VectorMap = Eigen::Map<Vector>;

    explicit BlocksView(Blocks& b)
        : darboux(b.darboux),
          start(b.start),
          offset(b.offset),
          load(b.load),
          moment_load(b.moment_load),
          force_load(b.force_load),
          frame(b.frame),
          turn(b.turn),
          move(b.move),
          gram(b.gram),
          moment(b.moment),
          force(b.force),
          aa(b.aa),
          al(b.al),
          ll(b.ll) {}

    VectorMap darboux, start, offset, load, moment_load, force_load;
    MatrixMap frame, turn, move, gram, moment, force, aa, al, ll;
};
using View = BlocksView<SegmentBlock, Mat3, Vec3>;
using ConstView = BlocksView<const SegmentBlock, const Mat3, const Vec3>;

/// Everything beyond a joint, as one body held there.
struct Composite {
    Mat3 aa = Mat3::Zero(), al = Mat3::Zero(), ll = Mat3::Zero();
    Vec3 moment = Vec3::Zero(), force = Vec3::Zero();

    /// Moves the reference point by -d: T^t I T and T^t (moment; force).
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
        SegmentBlock& s = segments_[std::size_t(q)];
        quadrature.darboux = curvatures[std::size_t(q)];
        quadrature.length = lengths[std::size_t(q)];
        quadrature.points = layout.points(q);
        quadrature.targets = targets.targets(layout.first(q));
        half_square_ += integrate_segment(quadrature, weight * quadrature.length, s);

        const SegmentEnd end = segment_end(quadrature.darboux, quadrature.length);
        Vec3::Map(s.darboux) = quadrature.darboux;
        s.length = quadrature.length;
        Vec3::Map(s.offset) = quadrature.frame * end.position;
        Mat3::Map(s.turn) = quadrature.frame * end.angular;
        Mat3::Map(s.move) = quadrature.frame * end.jacobian;
        quadrature.start += Vec3::Map(s.offset);
        quadrature.frame = (quadrature.frame * end.rotation).eval();
    }
}

RodSystem::Point RodSystem::point(int segment, double u) const {
    const ConstView s(segments_[std::size_t(segment)]);
    const int halvings = stumpff_halvings(u * u * s.darboux.squaredNorm());
    const auto [p, j] = segment_point<double>(s.darboux.data(), u, halvings);
    const Mat3 local =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&j[0][0]);
    return {segment, s.start + s.frame * Vec3::Map(p), s.frame * local};
}

void RodSystem::add(const Point& point, const Mat3& stiffness, const Vec3& force) {
    View s(segments_[std::size_t(point.segment)]);
    const Vec3 r = point.position - s.start;
    const Mat3 pulled = stiffness * point.jacobian, turned = crossed(r, stiffness);
    s.gram += point.jacobian.transpose() * pulled;
    s.force += pulled;
    s.moment += crossed(r, pulled);
    s.ll += stiffness;
    s.al += turned;
    s.aa += crossed(r, turned.transpose());
    s.load += point.jacobian.transpose() * force;
    s.moment_load += r.cross(force);
    s.force_load += force;
}

void RodSystem::forces(std::span<Vec3> f) const {
    Vec3 moment = Vec3::Zero(), force = Vec3::Zero();
    for (int q = segments(); q-- > 0;) {
        const ConstView s(segments_[std::size_t(q)]);
        f[std::size_t(q)] =
            s.load + s.turn.transpose() * moment + s.move.transpose() * force;
        moment += s.offset.cross(force) + s.moment_load;
        force += s.force_load;
    }
}

void RodSystem::solve(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                      std::span<Vec3> x) {
    solve_recursion(segments_, diagonal.front().data(), load.front().data(),
                    x.front().data());
}

void RodSystem::assemble(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                         Eigen::MatrixXd& matrix, Eigen::VectorXd& force) const {
    const int n = segments();
    matrix.resize(3 * n, 3 * n);
    force.resize(3 * n);
    Composite beyond;
    for (int q = n; q-- > 0;) {
        const ConstView s(segments_[std::size_t(q)]);
        Mat3 angular = beyond.aa * s.turn + beyond.al * s.move;
        Mat3 linear = beyond.al.transpose() * s.turn + beyond.ll * s.move;
        const Mat3 diagonal_block =
            s.gram + s.turn.transpose() * angular + s.move.transpose() * linear;
        matrix.block<3, 3>(3 * q, 3 * q) =
            (diagonal_block + diagonal_block.transpose()) / 2;
        matrix.diagonal().segment<3>(3 * q) += diagonal[q];
        force.segment<3>(3 * q) = s.load + load[q] + s.turn.transpose() * beyond.moment +
                                  s.move.transpose() * beyond.force;
        angular += s.moment + crossed(s.offset, linear);
        linear += s.force;
        // The wrench per dk of this segment, about its start, is carried towards the root
        // and multiplied with the motion that each earlier segment gives to that point.
        for (int p = q; p-- > 0;) {
            const ConstView earlier(segments_[std::size_t(p)]);
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
