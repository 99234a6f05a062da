#include "sim/equilibrium/minimum.h"

#include <algorithm>
#include <cmath>

#include "sim/equilibrium/branch.h"

namespace lancret {

namespace {

constexpr int kMaxIterations = 2000, kMaxEscapes = 50;

/// The search, in x = D^(1/2) q, in which the elastic Hessian is I.
class Search {
  public:
    Search(const HangingRod& rod, const Eigen::VectorXd& start)
        : rod_(rod),
          q_(start),
          scale_(stiffness_diagonal(rod).cwiseSqrt().cwiseInverse()) {
        const double length = rod_length(rod);
        unit_ = std::sqrt(rod.section.stiffness.tail<2>().minCoeff() / length);
        weight_ = weight_number(rod);
        evaluate();
    }

    /// Descends; true if it ends at a stationary point.
    bool descend(int& iterations) {
        const double small = unit_ * (1e-11 + 1e-15 * weight_);
        for (; iterations < kMaxIterations; ++iterations) {
            if (gradient_.norm() < small) return true;
            if (!step_down()) return gradient_.norm() < 1e4 * small;
        }
        return false;
    }

    /// Eigenvalues, in ascending order, and eigenvectors of the scaled Hessian.
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum() const {
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian_);
    }

    /// Leaves a stationary point along a unit vector of negative curvature `lambda`;
    /// false if the energy does not decrease.
    bool leave(const Eigen::VectorXd& direction, double lambda) {
        for (double t = unit_; t > 1e-9 * unit_; t /= 2) {
            // Half of the decrease that the quadratic model predicts.
            if (try_step(t * direction, lambda * t * t / 4)) return true;
        }
        return false;
    }

    const Eigen::VectorXd& q() const { return q_; }
    const Eigen::VectorXd& scale() const { return scale_; }

  private:
    void evaluate() {
        GravityTerms gravity;
        gravity_terms(rod_, q_, Derivatives::second, gravity);
        const Eigen::VectorXd bent = q_ - natural_curvatures(rod_);
        energy_ = gravity.energy + bent.cwiseQuotient(scale_).squaredNorm() / 2;
        gradient_ = bent.cwiseQuotient(scale_) + scale_.cwiseProduct(gravity.gradient);
        hessian_ = scale_.asDiagonal() * gravity.hessian * scale_.asDiagonal();
        hessian_.diagonal().array() += 1;
    }

    /// Takes the step if the energy changes by less than `predicted`, up to round-off.
    bool try_step(const Eigen::VectorXd& step, double predicted) {
        const Eigen::VectorXd q = q_ + scale_.cwiseProduct(step);
        // Round-off of the energy, whose terms are of the size of weight and bending.
        const double noise = 1e-14 * unit_ * unit_ * (1 + weight_);
        if (!(rod_energy(rod_, q).total() < energy_ + predicted + noise)) return false;
        q_ = q;
        evaluate();
        return true;
    }

    Eigen::VectorXd direction() const {
        const Eigen::LLT<Eigen::MatrixXd> factor(hessian_);
        if (factor.info() == Eigen::Success) return -factor.solve(gradient_);
        // Negative curvature: uses the absolute values of the eigenvalues, so that the
        // step still descends. A gradient that is only round-off along such a direction,
        // as on a plane of symmetry, counts as zero.
        const auto spectrum = this->spectrum();
        const Eigen::VectorXd& rates = spectrum.eigenvalues();
        Eigen::VectorXd parts = spectrum.eigenvectors().transpose() * gradient_;
        const double noise = 1e-7 * gradient_.norm();
        for (Eigen::Index i = 0; i < parts.size(); ++i) {
            if (rates(i) < 0 && std::abs(parts(i)) < noise) parts(i) = 0;
            parts(i) /= std::max(std::abs(rates(i)), 1e-3);
        }
        return -(spectrum.eigenvectors() * parts);
    }

    bool step_down() {
        const Eigen::VectorXd step = direction();
        const double slope = step.dot(gradient_);
        if (!step.allFinite() || !(slope < 0)) return false;
        const double longest = 4 * unit_ * (1 + std::sqrt(std::sqrt(weight_)));
        double t = std::min(1., longest / step.norm());
        for (; t > 1e-12; t /= 2) {
            if (try_step(t * step, 1e-4 * t * slope)) return true;
        }
        return false;
    }

    const HangingRod& rod_;
    Eigen::VectorXd q_, scale_, gradient_;
    Eigen::MatrixXd hessian_;
    double energy_ = 0, unit_ = 1, weight_ = 0;
};

/// The direction in which to leave a saddle: of the eigenvectors that share the smallest
/// eigenvalue, the combination described at rod_minimum.
Eigen::VectorXd escape_direction(
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>& spectrum,
    const Eigen::VectorXd& scale) {
    const Eigen::VectorXd& values = spectrum.eigenvalues();
    Eigen::Index shared = 1;
    while (shared < values.size() && values(shared) < values(0) + 1e-6 * -values(0)) {
        ++shared;
    }
    const auto space = spectrum.eigenvectors().leftCols(shared);
    // T' = k2 n1 - k1 n2.
    for (const Vec3& bend : {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(1, 0, 0)}) {
        const Eigen::VectorXd wanted =
            bend.replicate(values.size() / 3, 1).cwiseQuotient(scale);
        const Eigen::VectorXd inside = space * (space.transpose() * wanted);
        if (inside.norm() > 1e-6 * wanted.norm()) return inside.normalized();
    }
    return space.col(0);
}

}  // namespace

RodMinimum rod_minimum(const HangingRod& rod, const Eigen::VectorXd& start,
                       Saddles saddles) {
    Search search(rod, start);
    RodMinimum out;
    for (int iterations = 0;;) {
        out.converged = search.descend(iterations);
        const auto spectrum = search.spectrum();
        out.smallest_eigenvalue = spectrum.eigenvalues()(0);
        if (!out.converged || saddles == Saddles::keep ||
            out.smallest_eigenvalue > -neutral_eigenvalue(rod)) {
            break;
        }
        if (out.escapes == kMaxEscapes ||
            !search.leave(escape_direction(spectrum, search.scale()),
                          out.smallest_eigenvalue)) {
            out.converged = false;
            break;
        }
        ++out.escapes;
    }
    out.q = search.q();
    return out;
}

}  // namespace lancret
