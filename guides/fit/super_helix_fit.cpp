#include "guides/fit/super_helix_fit.h"

#include <Eigen/Cholesky>
#include <complex>
#include <limits>

#include "guides/helix/super_helix.h"
#include "guides/strand/rotation_minimizing.h"

namespace lancret {

namespace {

/// A stage of a fit: the share of the strand, from its root, that is fitted, and the cost
/// of twist, as a share of the squared length per squared radian. A fit proceeds from the
/// root, because an error in an early segment displaces all the rest. The centreline
/// hardly determines the twist of a segment that hardly bends, and a fit with free twist
/// invents torsion that the strand does not have: twist starts expensive and ends cheap.
struct Stage {
    double share, twist_cost;
    int iterations;
};
constexpr Stage kStages[] = {
    {0.3, 1e-5, 10}, {0.6, 1e-5, 10}, {1, 1e-5, 15}, {1, 1e-7, 40}};

/// Maximum turn of a segment, radian: beyond half a turn there are too few segments.
constexpr double kMaxTurn = 3.2;

/// RMS distance over length below which a fit needs no second start.
constexpr double kGoodFit = 2e-3;

/// The first guess: in a rotation-minimising frame the bending vector is a complex number
/// kappa exp(i theta); a segment's twist is the mean rate of theta, and its bending the
/// mean in the frame with that twist.
std::vector<Vec3> first_guess(const SampledCurve& target, const Mat3& root, int segments,
                              bool with_twist) {
    const std::size_t n = target.tangents.size() - 1, per_segment = n / segments;
    const double ds = target.length / double(n);
    std::vector<std::complex<double>> bend(n);
    Vec3 normal = root.col(1);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &t0 = target.tangents[i], &t1 = target.tangents[i + 1];
        const Vec3 turn = rotation_log<double>(smallest_rotation<double>(t0, t1));
        // T' = k2 n1 - k1 n2 with the turn k1 n1 + k2 n2.
        bend[i] = {turn.dot(t0.cross(normal)) / ds, -turn.dot(normal) / ds};
        normal = smallest_rotation<double>(t0, t1) * normal;
        normal = (normal - t1 * t1.dot(normal)).normalized();
    }
    std::vector<Vec3> guess;
    double twist = 0;  // the angle of the material frame about the tangent, so far
    for (int q = 0; q < segments; ++q) {
        const auto row = std::span(bend).subspan(q * per_segment, per_segment);
        std::complex<double> step = 0, mean = 0;
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            step += std::conj(row[i]) * row[i + 1];
        }
        const double rate = with_twist && std::abs(step) > 0 ? std::arg(step) : 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            mean += row[i] * std::polar(1.0, -(twist + rate * (double(i) + 0.5)));
        }
        mean /= double(row.size());
        twist += rate * double(row.size());
        guess.emplace_back(rate / ds, -mean.imag(), mean.real());
    }
    return guess;
}

/// The fit of one strand as a least-squares problem. The unknowns are in radians: the
/// curvatures times the segment's length, then two angles that tilt the root tangent.
class Problem {
  public:
    double twist_cost = 0;    ///< in the current stage
    std::size_t samples = 0;  ///< from the root, in the current stage

    Problem(const SampledCurve& target, const Mat3& root, const FitSettings& settings)
        : target_(target),
          root_(root),
          turns_root_(settings.fit_root_frame),
          lengths_(settings.segments, target.length / settings.segments) {
        const std::size_t n = target.positions.size() - 1;
        s_.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            s_[i] = target.length * double(i + 1) / double(n);
        }
    }

    int unknowns() const { return 3 * int(lengths_.size()) + (turns_root_ ? 2 : 0); }

    Mat3 root(const Eigen::VectorXd& x) const {
        if (!turns_root_) return root_;
        Mat3 frame = root_ * helix_step<double>(tilt(x), 1).rotation;
        orthonormalize<double>(frame);
        return frame;
    }

    std::vector<Vec3> curvatures(const Eigen::VectorXd& x) const {
        std::vector<Vec3> out(lengths_.size());
        for (std::size_t q = 0; q < out.size(); ++q) {
            out[q] = x.segment<3>(3 * q) / lengths_[q];
        }
        return out;
    }

    Eigen::VectorXd unknowns_of(const std::vector<Vec3>& curvatures) const {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns());
        for (std::size_t q = 0; q < curvatures.size(); ++q) {
            x.segment<3>(3 * q) = curvatures[q] * lengths_[q];
        }
        return kept_in_range(std::move(x));
    }

    /// x with the turn of every segment limited to kMaxTurn.
    Eigen::VectorXd kept_in_range(Eigen::VectorXd x) const {
        for (std::size_t q = 0; q < lengths_.size(); ++q) {
            const double turn = x.segment<3>(3 * q).norm();
            if (turn > kMaxTurn) x.segment<3>(3 * q) *= kMaxTurn / turn;
        }
        return x;
    }

    /// Squared distance plus the cost of twist, cm^2; fills the residual.
    double cost(const Eigen::VectorXd& x) {
        const std::vector<Vec3> curvatures = this->curvatures(x);
        residual_.resize(3 * samples);
        sample(SuperHelix{{root(x), target_.positions[0]}, lengths_, curvatures}, seen(),
               [&](std::size_t i, auto, const HelixState<double>& state) {
                   residual_.segment<3>(3 * i) =
                       state.position - target_.positions[i + 1];
               });
        return residual_.squaredNorm() + total_twist_cost(x);
    }

    /// The normal equations at x: half the cost's gradient and its Gauss-Newton matrix.
    void linearize(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                   Eigen::MatrixXd& matrix) {
        const std::vector<Vec3> curvatures = this->curvatures(x);
        const Mat3 frame = root(x);
        const SuperHelix helix{{frame, target_.positions[0]}, lengths_, curvatures};
        positions_with_jacobian(helix, seen(), residual_, by_curvature_);
        jacobian_.resize(residual_.size(), unknowns());
        jacobian_.leftCols(by_curvature_.cols()) = by_curvature_ / lengths_[0];
        for (std::size_t i = 0; i < samples; ++i) {
            const Vec3 arm = residual_.segment<3>(3 * i) - target_.positions[0];
            if (turns_root_) {
                // The angles turn the frame about its own axes: dr = (R0 V da) x arm.
                const Mat3 axes = root_ * helix_step_derivative(tilt(x), 1).angular;
                for (int c = 0; c < 2; ++c) {
                    jacobian_.block<3, 1>(3 * i, by_curvature_.cols() + c) =
                        axes.col(c + 1).cross(arm);
                }
            }
            residual_.segment<3>(3 * i) -= target_.positions[i + 1];
        }
        gradient = jacobian_.transpose() * residual_;
        matrix = jacobian_.transpose() * jacobian_;
        const double weight = twist_weight();
        for (std::size_t q = 0; q < lengths_.size(); ++q) {
            gradient[3 * q] += weight * x[3 * q];
            matrix(3 * q, 3 * q) += weight;
        }
    }

    /// Measured over the whole strand.
    FitReport report(const Eigen::VectorXd& x) {
        samples = s_.size();
        cost(x);
        FitReport out;
        out.length = target_.length;
        out.rms = std::sqrt(residual_.squaredNorm() / double(s_.size()));
        for (std::size_t i = 0; i < s_.size(); ++i) {
            out.max = std::max(out.max, residual_.segment<3>(3 * i).norm());
        }
        return out;
    }

  private:
    std::span<const double> seen() const { return std::span(s_).first(samples); }
    static Vec3 tilt(const Eigen::VectorXd& x) {
        return {0, x[x.size() - 2], x[x.size() - 1]};
    }
    double twist_weight() const {
        return twist_cost * target_.length * target_.length * double(samples);
    }
    double total_twist_cost(const Eigen::VectorXd& x) const {
        double sum = 0;
        for (std::size_t q = 0; q < lengths_.size(); ++q) sum += x[3 * q] * x[3 * q];
        return twist_weight() * sum;
    }

    const SampledCurve& target_;
    Mat3 root_;
    bool turns_root_;
    std::vector<double> lengths_, s_;
    Eigen::VectorXd residual_;
    Eigen::MatrixXd by_curvature_, jacobian_;
};

/// Levenberg-Marquardt from x; returns the iterations used.
int minimize(Problem& problem, Eigen::VectorXd& x, double floor, int max_iterations) {
    double cost = problem.cost(x), damping = 1e-3;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd matrix;
    int iteration = 0;
    while (iteration < max_iterations && cost > floor) {
        problem.linearize(x, gradient, matrix);
        const double scale = matrix.diagonal().maxCoeff();
        bool lower = false;
        double drop = 0;
        for (; !lower && damping < 1e8 && iteration < max_iterations; ++iteration) {
            Eigen::MatrixXd damped = matrix;
            damped.diagonal() +=
                damping * (matrix.diagonal().array() + 1e-6 * scale).matrix();
            const Eigen::VectorXd trial =
                problem.kept_in_range(x - damped.ldlt().solve(gradient));
            const double trial_cost = problem.cost(trial);
            if (trial_cost < cost) {
                drop = (cost - trial_cost) / cost;
                cost = trial_cost;
                x = trial;
                damping = std::max(damping * 0.2, 1e-12);
                lower = true;
            } else {
                damping *= 5;
            }
        }
        if (!lower || drop < 1e-3) break;
    }
    return iteration;
}

}  // namespace

FittedGuide fit_super_helix(const SampledCurve& target, const Vec3& surface_tangent,
                            const FitSettings& settings) {
    const Mat3 root = frame_from_normal(surface_tangent, target.tangents[0]);
    Problem problem(target, root, settings);
    // Files in single precision do not resolve a distance below 1e-8 of the length.
    const double floor =
        1e-16 * target.length * target.length * double(target.positions.size());
    const double n = double(fit_samples(settings));
    FittedGuide out;
    out.report.rms = std::numeric_limits<double>::infinity();
    int iterations = 0;
    for (const bool with_twist : {false, true}) {
        Eigen::VectorXd x =
            problem.unknowns_of(first_guess(target, root, settings.segments, with_twist));
        for (const Stage& stage : kStages) {
            problem.samples = std::size_t(std::ceil(stage.share * n));
            problem.twist_cost = stage.twist_cost;
            iterations += minimize(problem, x, floor, stage.iterations);
        }
        const FitReport report = problem.report(x);
        if (report.rms < out.report.rms) {
            out = {problem.root(x), problem.curvatures(x), report};
        }
        if (out.report.rms < kGoodFit * target.length) break;
    }
    out.report.iterations = iterations;
    return out;
}

FittedGuides fit_guides(const Strands& strands, std::span<const std::uint32_t> which,
                        std::span<const Vec3> surface_tangents,
                        const FitSettings& settings) {
    return guides_of_strands(strands, which, surface_tangents, settings.segments,
                             fit_samples(settings),
                             [&](const SampledCurve& target, const Vec3& hint) {
                                 return fit_super_helix(target, hint, settings);
                             });
}

}  // namespace lancret
