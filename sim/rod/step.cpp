#include "sim/rod/step.h"

#include <algorithm>
#include <cmath>

#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// Half of sum l (q - base)^2 stiffness.
double half_square(const Rod& rod, std::span<const Vec3> curvatures,
                   std::span<const Vec3> base, const Vec3& stiffness) {
    double sum = 0;
    for (int q = 0; q < rod.segments(); ++q) {
        const Vec3 away = curvatures[q] - base[q];
        sum += rod.lengths[q] / 2 * away.cwiseAbs2().dot(stiffness);
    }
    return sum;
}

/// The largest angle by which a change of curvature turns a segment.
double largest_turn(const Rod& rod, std::span<const Vec3> change) {
    double turn = 0;
    for (int q = 0; q < rod.segments(); ++q) {
        turn = std::max(turn, rod.lengths[q] * change[q].norm());
    }
    return turn;
}

bool is_finite(std::span<const Vec3> values) {
    return std::ranges::all_of(values, [](const Vec3& v) { return v.allFinite(); });
}

/// A term of a linear combination of point vectors.
struct Term {
    double factor;
    const PointVectors& vectors;
};

/// out = the sum of the terms.
void combine(const Term& a, const Term& b, const Term& c, PointVectors& out) {
    out.resize(int(a.vectors.stride()));
    for (int axis = 0; axis < 3; ++axis) {
        const double* x = a.vectors.axis(axis);
        const double* y = b.vectors.axis(axis);
        const double* z = c.vectors.axis(axis);
        double* to = out.axis(axis);
        for (std::size_t i = 0; i < out.stride(); ++i) {
            to[i] = a.factor * x[i] + b.factor * y[i] + c.factor * z[i];
        }
    }
}

void combine(const Term& a, const Term& b, PointVectors& out) {
    combine(a, b, {0, b.vectors}, out);
}

}  // namespace

void RodPast::push(const HelixState<double>& root, std::span<const Vec3> curvatures,
                   double step) {
    if (step != eps) size = 0;
    eps = step;
    std::rotate(poses, poses + kMax - 1, poses + kMax);
    poses[0].root = root;
    poses[0].curvatures.assign(curvatures.begin(), curvatures.end());
    size = std::min(size + 1, kMax);
}

void RodStepper::find_positions(const Rod& rod, const RodPose& pose, Motion& motion) {
    point_positions(rod.lengths, pose.root, pose.curvatures, layout_, motion.positions,
                    motion.joints);
}

/// Finds the rod's current positions and velocities. A velocity is the difference of
/// positions that the previous step used for it, also at BDF2's start: others are of
/// first order.
void RodStepper::recall(const Rod& rod, const RodMotionStep& step, const RodPast& past,
                        bool of_bdf2) {
    // Enough points for the previous pose too, since velocities are differenced from it.
    std::ranges::copy(step.curvatures, tried_curvatures_.begin());
    for (std::size_t q = 0; past.size > 0 && q < tried_curvatures_.size(); ++q) {
        const Vec3& last = past.poses[0].curvatures[q];
        if (last.squaredNorm() > tried_curvatures_[q].squaredNorm()) {
            tried_curvatures_[q] = last;
        }
    }
    layout_.lay_out(rod.lengths, tried_curvatures_);
    point_positions(rod.lengths, step.from.pose, step.curvatures, layout_, now_.positions,
                    now_.joints);
    if (past.size == 0) {
        point_velocities(rod, {step.from, step.curvatures, step.rates}, layout_,
                         now_.velocities, now_.joint_velocities);
        return;
    }
    find_positions(rod, past.poses[0], before_);
    if (const double rate = 1 / past.eps; of_bdf2 && past.size > 2) {
        find_positions(rod, past.poses[1], earlier_);
        combine({1.5 * rate, now_.positions}, {-2 * rate, before_.positions},
                {0.5 * rate, earlier_.positions}, now_.velocities);
    } else {
        combine({rate, now_.positions}, {-rate, before_.positions}, now_.velocities);
    }
    now_.joint_velocities.resize(now_.joints.size());
    for (std::size_t q = 0; q < now_.joints.size(); ++q) {
        now_.joint_velocities[q] = (now_.joints[q] - before_.joints[q]) / past.eps;
    }
}

/// Replaces positions, velocities and curvatures of implicit Euler by those of BDF2;
/// returns h.
double RodStepper::begin_bdf2(const Rod& rod, const RodPast& past) {
    const double eps = past.eps;
    find_positions(rod, past.poses[1], earlier_);
    if (past.size < 4) {
        combine({1 / eps, before_.positions}, {-1 / eps, earlier_.positions},
                before_.velocities);
    } else {
        combine({1.5 / eps, before_.positions}, {-2 / eps, earlier_.positions},
                before_.velocities);
        find_positions(rod, past.poses[2], earlier_);
        combine({1, before_.velocities}, {0.5 / eps, earlier_.positions},
                before_.velocities);
    }
    combine({4. / 3, now_.positions}, {-1. / 3, before_.positions}, now_.positions);
    combine({4. / 3, now_.velocities}, {-1. / 3, before_.velocities}, now_.velocities);
    for (std::size_t q = 0; q < base_curvatures_.size(); ++q) {
        base_curvatures_[q] =
            (4 * start_curvatures_[q] - past.poses[0].curvatures[q]) / 3;
    }
    return 2 * eps / 3;
}

/// Sets the targets of the points from inertia, gravity and air.
void RodStepper::aim(const Rod& rod, const RodForces& forces, double h) {
    const double inertia = rod.section.linear_density, air = h * forces.drag;
    weight_ = inertia + air;
    const double a = inertia / weight_, b = air / weight_;
    combine({1, now_.positions}, {a * h, now_.velocities}, targets_);
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < layout_.size(); ++i) {
            targets_.axis(c)[i] += a * h * h * forces.gravity[c];
        }
    }
    if (air == 0 || !forces.wind) return;
    for (int i = 0; i < layout_.size(); ++i) {
        // The wind where inertia takes the point: of second order, as BDF2 requires.
        const Vec3 position = now_.positions.get(i) + h * now_.velocities.get(i);
        targets_.set(i, targets_.get(i) + b * h * forces.wind(position));
    }
}

/// Linearises about `curvatures` and returns the value of what is minimised.
double RodStepper::linearize(const Rod& rod, const HelixState<double>& root,
                             std::span<const Vec3> curvatures, double h,
                             RodPotential* potential) {
    system_.linearize(root, rod.lengths, curvatures, layout_, targets_, weight_);
    return system_.half_square() +
           h * h * half_square(rod, curvatures, rod.natural, rod.section.stiffness) +
           h * half_square(rod, curvatures, base_curvatures_, rod.section.damping) +
           (potential ? potential->add_to(system_, h * h) : 0);
}

/// Solves for the change of curvatures.
void RodStepper::solve_change(const StepSettings& settings, StepReport& report) {
    const SolveReport solution =
        solve(system_, settings.solver, diagonal_, load_, change_, dense_);
    report.solved = solution.solved && is_finite(change_);
}

StepReport RodStepper::minimize(const Rod& rod, const StepSettings& settings,
                                const RodMotionStep& step, double h,
                                RodPotential* potential) {
    const std::span<Vec3> curvatures = step.curvatures;
    const auto& [stiffness, damping, density] = rod.section;
    for (int q = 0; q < rod.segments(); ++q) {
        diagonal_[q] = rod.lengths[q] * (h * h * stiffness + h * damping);
    }
    StepReport report;
    report.converged = false;
    double value = linearize(rod, step.to, curvatures, h, potential);
    report.solved = std::isfinite(value);
    while (report.solved && report.iterations < settings.max_iterations) {
        ++report.iterations;
        for (int q = 0; q < rod.segments(); ++q) {
            load_[q] = rod.lengths[q] *
                       (h * h * stiffness.cwiseProduct(rod.natural[q] - curvatures[q]) +
                        h * damping.cwiseProduct(base_curvatures_[q] - curvatures[q]));
        }
        solve_change(settings, report);
        if (!report.solved) break;
        // Halves the change while the value would rise by more than round-off.
        constexpr int kMaxHalvings = 12;
        const double allowed = value + 1e-13 * std::abs(value);
        double share = 1, next = 0;
        int halvings = 0;
        for (;; ++halvings, share /= 2) {
            for (int q = 0; q < rod.segments(); ++q) {
                tried_curvatures_[q] = curvatures[q] + share * change_[q];
            }
            next = linearize(rod, step.to, tried_curvatures_, h, potential);
            if (next <= allowed || halvings == kMaxHalvings) break;
        }
        report.shortened += halvings > 0;
        if (!(next <= allowed)) {
            // No descent along this direction: the minimum, to within round-off.
            report.converged = largest_turn(rod, change_) < 1e-3;
            linearize(rod, step.to, curvatures, h, potential);
            break;
        }
        const double turn = largest_turn(rod, change_) * share;
        std::ranges::copy(tried_curvatures_, curvatures.begin());
        value = next;
        if ((turn <= settings.tolerance &&
             report.iterations >= settings.min_iterations) ||
            turn <= 1e-12) {
            report.converged = true;
            break;
        }
    }
    return report;
}

/// Sets the targets that represent the forces of the semi-implicit step, about the
/// current pose: b = eps (M q' + eps (f + K (q_n - q))), where M q' + eps f is the
/// integral of J^t rho S (J q' + eps (g - bias)), with the drag of the air on all but
/// J q' explicit.
void RodStepper::aim_semi_implicit(const Rod& rod, const RodForces& forces,
                                   bool velocity_terms, const RodState& state,
                                   double eps) {
    RodState still = state;
    zero_rates_.assign(state.curvatures.size(), Vec3::Zero());
    still.rates = zero_rates_;
    point_velocities(rod, still, layout_, carried_velocities_, carried_joints_);
    point_bias(rod, velocity_terms ? state : still, layout_, bias_);
    const double inertia = rod.section.linear_density, air = eps * forces.drag;
    weight_ = inertia + air;
    targets_.resize(layout_.size());
    for (int i = 0; i < layout_.size(); ++i) {
        const Vec3 position = now_.positions.get(i);
        const Vec3 carried = carried_velocities_.get(i);
        const Vec3 wind = air > 0 && forces.wind ? forces.wind(position) : Vec3::Zero();
        const Vec3 push = inertia * (now_.velocities.get(i) - carried +
                                     eps * (forces.gravity - bias_.get(i))) +
                          air * (wind - carried);
        targets_.set(i, position + eps / weight_ * push);
    }
}

StepReport RodStepper::solve_semi_implicit(const Rod& rod, const RodForces& forces,
                                           const StepSettings& settings,
                                           const RodMotionStep& step,
                                           RodPotential* potential) {
    const double eps = step.eps;
    recall(rod, step, {}, false);
    aim_semi_implicit(rod, forces, settings.velocity_terms,
                      {step.from, step.curvatures, step.rates}, eps);
    const auto& [stiffness, damping, density] = rod.section;
    for (int q = 0; q < rod.segments(); ++q) {
        diagonal_[q] = rod.lengths[q] * (eps * eps * stiffness + eps * damping);
        load_[q] = eps * eps * rod.lengths[q] *
                   stiffness.cwiseProduct(rod.natural[q] - step.curvatures[q]);
    }
    system_.linearize(step.from.pose, rod.lengths, step.curvatures, layout_, targets_,
                      weight_);
    if (potential) potential->add_to(system_, eps * eps);
    StepReport report;
    report.iterations = 1;
    solve_change(settings, report);
    if (!report.solved) return report;
    for (int q = 0; q < rod.segments(); ++q) step.curvatures[q] += change_[q];
    system_.linearize(step.to, rod.lengths, step.curvatures, layout_, targets_, weight_);
    return report;
}

/// Measures the error and the kinetic energy of a step that has been taken.
void RodStepper::measure(const Rod& rod, const RodMotionStep& step, double h,
                         StepReport& report) {
    point_positions(rod.lengths, step.to, step.curvatures, layout_, end_positions_,
                    end_joints_);
    for (int q = 0; q < rod.segments(); ++q) {
        const Vec3 moved = end_joints_[q] - now_.joints[q];
        report.local_error = std::max(
            report.local_error, (moved - step.eps * now_.joint_velocities[q]).norm() / 2);
        const GaussRule rule = gauss_rule(layout_.points(q));
        for (int i = 0; i < layout_.points(q); ++i) {
            const int point = layout_.first(q) + i;
            const Vec3 velocity =
                (end_positions_.get(point) - now_.positions.get(point)) / h;
            report.kinetic += rod.section.linear_density * rod.lengths[q] *
                              rule.weights[i] * velocity.squaredNorm() / 2;
        }
    }
}

StepReport RodStepper::step(const Rod& rod, const RodForces& forces,
                            const StepSettings& settings, const RodMotionStep& step,
                            RodPotential* potential) {
    const std::span<Vec3> curvatures = step.curvatures;
    for (auto* buffer : {&tried_curvatures_, &diagonal_, &load_, &change_}) {
        buffer->resize(curvatures.size());
    }
    start_curvatures_.assign(curvatures.begin(), curvatures.end());
    base_curvatures_ = start_curvatures_;
    double h = step.eps;
    StepReport report;
    if (settings.integrator == Integrator::semi_implicit) {
        report = solve_semi_implicit(rod, forces, settings, step, potential);
    } else {
        const bool bdf2 = settings.integrator == Integrator::bdf2;
        recall(rod, step, step.past, bdf2);
        if (bdf2 && step.past.size >= 2 && step.past.eps == step.eps) {
            h = begin_bdf2(rod, step.past);
        }
        aim(rod, forces, h);
        report = minimize(rod, settings, step, h, potential);
    }
    if (!report.solved) {
        std::ranges::copy(start_curvatures_, curvatures.begin());
        return report;
    }
    for (std::size_t q = 0; q < step.rates.size(); ++q) {
        step.rates[q] = (curvatures[q] - base_curvatures_[q]) / h;
    }
    measure(rod, step, h, report);
    step.past.push(step.from.pose, start_curvatures_, step.eps);
    return report;
}

}  // namespace lancret
