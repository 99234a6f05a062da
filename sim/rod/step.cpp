#include "sim/rod/step.h"

#include <algorithm>
#include <cmath>

#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// Half of sum l (at - zero)^2 stiffness.
double half_square(const Rod& rod, std::span<const Vec3> at, std::span<const Vec3> zero,
                   const Vec3& stiffness) {
    double sum = 0;
    for (int q = 0; q < rod.segments(); ++q) {
        const Vec3 away = at[q] - zero[q];
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

/// out = a x + b y + c z, for points.
void combine(double a, const PointVectors& x, double b, const PointVectors& y, double c,
             const PointVectors& z, PointVectors& out) {
    out.resize(int(x.stride()));
    for (int axis = 0; axis < 3; ++axis) {
        const double *xs = x.axis(axis), *ys = y.axis(axis), *zs = z.axis(axis);
        double* to = out.axis(axis);
        for (std::size_t i = 0; i < x.stride(); ++i) {
            to[i] = a * xs[i] + b * ys[i] + c * zs[i];
        }
    }
}

void combine(double a, const PointVectors& x, double b, const PointVectors& y,
             PointVectors& out) {
    combine(a, x, b, y, 0, y, out);
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

void RodStepper::places_of(const Rod& rod, const RodPose& pose, Motion& motion) {
    point_places(rod.lengths, pose.root, pose.curvatures, layout_, motion.places,
                 motion.joints);
}

/// Where the rod is and how it moves now. A velocity is the difference of places that the
/// step which led there took for it, also at BDF2's start: others are of first order.
void RodStepper::recall(const Rod& rod, const RootMotion& from,
                        std::span<const Vec3> curvatures, std::span<const Vec3> rates,
                        const RodPast& past, bool of_bdf2) {
    // Points enough for the pose that velocities are told by, too.
    std::ranges::copy(curvatures, tried_.begin());
    for (std::size_t q = 0; past.size > 0 && q < tried_.size(); ++q) {
        const Vec3& last = past.poses[0].curvatures[q];
        if (last.squaredNorm() > tried_[q].squaredNorm()) tried_[q] = last;
    }
    layout_.lay_out(rod.lengths, tried_);
    point_places(rod.lengths, from.pose, curvatures, layout_, now_.places, now_.joints);
    if (past.size == 0) {
        point_velocities(rod, {from, curvatures, rates}, layout_, now_.velocities,
                         now_.joint_velocities);
        return;
    }
    places_of(rod, past.poses[0], before_);
    if (const double rate = 1 / past.eps; of_bdf2 && past.size > 2) {
        places_of(rod, past.poses[1], earlier_);
        combine(1.5 * rate, now_.places, -2 * rate, before_.places, 0.5 * rate,
                earlier_.places, now_.velocities);
    } else {
        combine(rate, now_.places, -rate, before_.places, now_.velocities);
    }
    now_.joint_velocities.resize(now_.joints.size());
    for (std::size_t q = 0; q < now_.joints.size(); ++q) {
        now_.joint_velocities[q] = (now_.joints[q] - before_.joints[q]) / past.eps;
    }
}

/// Puts BDF2's places, velocities and curvatures for those of implicit Euler; gives h.
double RodStepper::begin_bdf2(const Rod& rod, const RodPast& past) {
    const double eps = past.eps;
    places_of(rod, past.poses[1], earlier_);
    if (past.size < 4) {
        combine(1 / eps, before_.places, -1 / eps, earlier_.places, before_.velocities);
    } else {
        combine(1.5 / eps, before_.places, -2 / eps, earlier_.places, before_.velocities);
        places_of(rod, past.poses[2], earlier_);
        combine(1, before_.velocities, 0.5 / eps, earlier_.places, before_.velocities);
    }
    combine(4. / 3, now_.places, -1. / 3, before_.places, now_.places);
    combine(4. / 3, now_.velocities, -1. / 3, before_.velocities, now_.velocities);
    for (std::size_t q = 0; q < middle_.size(); ++q) {
        middle_[q] = (4 * start_[q] - past.poses[0].curvatures[q]) / 3;
    }
    return 2 * eps / 3;
}

/// Where the points are drawn to: inertia, gravity and air together.
void RodStepper::aim(const Rod& rod, const RodForces& forces, double h) {
    const double inertia = rod.section.linear_density, air = h * forces.drag;
    weight_ = inertia + air;
    const double a = inertia / weight_, b = air / weight_;
    combine(1, now_.places, a * h, now_.velocities, targets_);
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < layout_.size(); ++i) {
            targets_.axis(c)[i] += a * h * h * forces.gravity[c];
        }
    }
    if (air == 0 || !forces.wind) return;
    for (int i = 0; i < layout_.size(); ++i) {
        // Where inertia takes the point: of second order, as BDF2 asks.
        const Vec3 place = now_.places.get(i) + h * now_.velocities.get(i);
        targets_.set(i, targets_.get(i) + b * h * forces.wind(place));
    }
}

/// Linearises about `curvatures` and gives what is minimised.
double RodStepper::linearize(const Rod& rod, const HelixState<double>& root,
                             std::span<const Vec3> curvatures, double h,
                             RodPotential* potential) {
    system_.linearize(root, rod.lengths, curvatures, layout_, targets_, weight_);
    return system_.half_square() +
           h * h * half_square(rod, curvatures, rod.natural, rod.section.stiffness) +
           h * half_square(rod, curvatures, middle_, rod.section.damping) +
           (potential ? potential->add_to(system_, h * h) : 0);
}

StepReport RodStepper::minimize(const Rod& rod, const StepSettings& settings,
                                const HelixState<double>& to, double h,
                                std::span<Vec3> curvatures, RodPotential* potential) {
    const auto& [stiffness, damping, density] = rod.section;
    for (int q = 0; q < rod.segments(); ++q) {
        diagonal_[q] = rod.lengths[q] * (h * h * stiffness + h * damping);
    }
    StepReport report;
    report.converged = false;
    double value = linearize(rod, to, curvatures, h, potential);
    report.solved = std::isfinite(value);
    while (report.solved && report.iterations < settings.most_iterations) {
        ++report.iterations;
        for (int q = 0; q < rod.segments(); ++q) {
            load_[q] = rod.lengths[q] *
                       (h * h * stiffness.cwiseProduct(rod.natural[q] - curvatures[q]) +
                        h * damping.cwiseProduct(middle_[q] - curvatures[q]));
        }
        last_solve_ = solve(system_, settings.solver, diagonal_, load_, change_, dense_);
        report.solved = last_solve_.solved && is_finite(change_);
        if (!report.solved) break;
        // Half as far as long as the energy would rise by more than round-off.
        constexpr int kMaxHalvings = 12;
        const double allowed = value + 1e-13 * std::abs(value);
        double share = 1, next = 0;
        int halvings = 0;
        for (;; ++halvings, share /= 2) {
            for (int q = 0; q < rod.segments(); ++q) {
                tried_[q] = curvatures[q] + share * change_[q];
            }
            next = linearize(rod, to, tried_, h, potential);
            if (next <= allowed || halvings == kMaxHalvings) break;
        }
        report.shortened += halvings > 0;
        if (!(next <= allowed)) {
            // No way down along this direction: the minimum, as far as numbers tell.
            report.converged = largest_turn(rod, change_) < 1e-3;
            linearize(rod, to, curvatures, h, potential);
            break;
        }
        const double turn = largest_turn(rod, change_) * share;
        std::ranges::copy(tried_, curvatures.begin());
        value = next;
        if ((turn <= settings.tolerance &&
             report.iterations >= settings.fewest_iterations) ||
            turn <= 1e-12) {
            report.converged = true;
            break;
        }
    }
    return report;
}

/// The places that the semi-implicit step's forces at the points come to, about the pose
/// at hand: b = eps (M q' + eps (f + K (q_n - q))), where M q' + eps f is the integral of
/// J^t rho S (J q' + eps (g - bias)), with the drag of the air on all but J q' explicit.
void RodStepper::aim_semi_implicit(const Rod& rod, const RodForces& forces,
                                   bool velocity_terms, const RodState& state,
                                   double eps) {
    RodState still = state;
    zero_.assign(state.curvatures.size(), Vec3::Zero());
    still.rates = zero_;
    PointVectors &bias = earlier_.velocities, &carried = before_.velocities;
    point_velocities(rod, still, layout_, carried, joint_starts_);
    point_bias(rod, velocity_terms ? state : still, layout_, bias);
    const double inertia = rod.section.linear_density, air = eps * forces.drag;
    weight_ = inertia + air;
    targets_.resize(layout_.size());
    for (int i = 0; i < layout_.size(); ++i) {
        const Vec3 place = now_.places.get(i), carry = carried.get(i);
        const Vec3 wind = air > 0 && forces.wind ? forces.wind(place) : Vec3::Zero();
        const Vec3 push = inertia * (now_.velocities.get(i) - carry +
                                     eps * (forces.gravity - bias.get(i))) +
                          air * (wind - carry);
        targets_.set(i, place + eps / weight_ * push);
    }
}

/// Error and kinetic energy of a step that has been taken.
void RodStepper::measure(const Rod& rod, const HelixState<double>& root,
                         std::span<const Vec3> curvatures, double eps, double h,
                         StepReport& report) {
    PointVectors& places = earlier_.places;
    point_places(rod.lengths, root, curvatures, layout_, places, joint_starts_);
    for (int q = 0; q < rod.segments(); ++q) {
        const Vec3 away = joint_starts_[q] - now_.joints[q];
        report.local_error = std::max(report.local_error,
                                      (away - eps * now_.joint_velocities[q]).norm() / 2);
        const GaussRule rule = gauss_rule(layout_.points(q));
        for (int i = 0; i < layout_.points(q); ++i) {
            const int point = layout_.first(q) + i;
            const Vec3 velocity = (places.get(point) - now_.places.get(point)) / h;
            report.kinetic += rod.section.linear_density * rod.lengths[q] *
                              rule.weights[i] * velocity.squaredNorm() / 2;
        }
    }
}

StepReport RodStepper::step(const Rod& rod, const RodForces& forces,
                            const StepSettings& settings, const RootMotion& from,
                            const HelixState<double>& to, double eps,
                            std::span<Vec3> curvatures, std::span<Vec3> rates,
                            RodPast& past, RodPotential* potential) {
    for (auto* room : {&tried_, &diagonal_, &load_, &change_}) {
        room->resize(curvatures.size());
    }
    start_.assign(curvatures.begin(), curvatures.end());
    middle_ = start_;
    double h = eps;
    StepReport report;
    if (settings.integrator == Integrator::semi_implicit) {
        recall(rod, from, curvatures, rates, {}, false);
        aim_semi_implicit(rod, forces, settings.velocity_terms, {from, curvatures, rates},
                          eps);
        const auto& [stiffness, damping, density] = rod.section;
        for (int q = 0; q < rod.segments(); ++q) {
            diagonal_[q] = rod.lengths[q] * (eps * eps * stiffness + eps * damping);
            load_[q] = eps * eps * rod.lengths[q] *
                       stiffness.cwiseProduct(rod.natural[q] - curvatures[q]);
        }
        system_.linearize(from.pose, rod.lengths, curvatures, layout_, targets_, weight_);
        if (potential) potential->add_to(system_, eps * eps);
        last_solve_ = solve(system_, settings.solver, diagonal_, load_, change_, dense_);
        report.iterations = 1;
        report.solved = last_solve_.solved && is_finite(change_);
        if (!report.solved) return report;
        for (int q = 0; q < rod.segments(); ++q) curvatures[q] += change_[q];
        system_.linearize(to, rod.lengths, curvatures, layout_, targets_, weight_);
    } else {
        const bool bdf2 = settings.integrator == Integrator::bdf2;
        recall(rod, from, curvatures, rates, past, bdf2);
        if (bdf2 && past.size >= 2 && past.eps == eps) {
            h = begin_bdf2(rod, past);
        }
        aim(rod, forces, h);
        report = minimize(rod, settings, to, h, curvatures, potential);
        if (!report.solved) {
            std::ranges::copy(start_, curvatures.begin());
            return report;
        }
    }
    for (std::size_t q = 0; q < rates.size(); ++q) {
        rates[q] = (curvatures[q] - middle_[q]) / h;
    }
    measure(rod, to, curvatures, eps, h, report);
    past.push(from.pose, start_, eps);
    return report;
}

}  // namespace lancret
