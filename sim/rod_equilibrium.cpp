#include "sim/rod_equilibrium.h"

#include <algorithm>
#include <cmath>

#include "sim/rod_branch.h"
#include "sim/rod_minimum.h"

namespace lancret {

namespace {

constexpr int kMostSteps = 5000;

/// Walks to `weight`; false at the end of the branch. Calls after(branch) at each step,
/// which stops the walk by false.
template <class After>
bool walk_to(RodBranch& branch, double weight, double first, double growth,
             After&& after) {
    // A step below this share of the weight is no step: the branch turns back.
    constexpr double kShortest = 1e-8;
    double step = first;
    for (int i = 0; i < kMostSteps && branch.weight() < weight; ++i) {
        step = std::min(step, std::max(first, growth * branch.weight()));
        if (branch.step_to(std::min(weight, branch.weight() + step))) {
            if (branch.iterations() <= 3) step *= 2;
            if (!after(branch)) return true;
        } else {
            step /= 2;
            if (step < kShortest * std::max(first, branch.weight())) return false;
        }
    }
    return branch.weight() >= weight;
}

/// The weight factor at which bending begins to be felt.
double first_step(const HangingRod& rod) { return 0.05 / (1e-30 + weight_number(rod)); }

RodEquilibrium described(const HangingRod& rod, const Eigen::VectorXd& q,
                         double smallest_eigenvalue, bool converged, bool left) {
    RodEquilibrium out;
    out.q = q;
    out.energy = rod_energy(rod, q);
    out.smallest_eigenvalue = smallest_eigenvalue;
    out.left_branch = left;
    out.converged = converged;
    out.stable = converged && smallest_eigenvalue > -neutral_eigenvalue(rod);
    return out;
}

const auto kGoOn = [](const RodBranch&) { return true; };

/// Where the smallest eigenvalue of the branch is zero between `from`, where it is above,
/// and `to`, by false position that halves a side kept twice (Illinois).
double eigenvalue_zero(const RodBranch& from, double to, double at_to) {
    double low = from.weight(), high = to;
    double at_low = from.smallest_eigenvalue(), at_high = at_to;
    int kept = 0;
    for (int i = 0; i < 100 && high - low > 1e-10 * high; ++i) {
        double middle = high - at_high * (high - low) / (at_high - at_low);
        // Beside the guess, so that both ends close in.
        middle = std::clamp(middle, low + 1e-11 * high, high - 1e-11 * high);
        RodBranch branch = from;
        if (!branch.step_to(middle)) break;
        const double at = branch.smallest_eigenvalue();
        if (at > 0) {
            low = middle;
            at_low = at;
            if (kept == 1) at_high /= 2;
            kept = 1;
        } else {
            high = middle;
            at_high = at;
            if (kept == -1) at_low /= 2;
            kept = -1;
        }
    }
    return std::abs(at_low) < std::abs(at_high) ? low : high;
}

}  // namespace

RodEquilibrium rod_equilibrium(const HangingRod& rod) {
    RodBranch branch(rod);
    bool left = false;
    constexpr int kMostFolds = 100;
    for (int folds = 0; !walk_to(branch, 1, first_step(rod), 1e300, kGoOn); ++folds) {
        left = true;
        // Over the fold, or at last straight to the full weight.
        const double over = folds < kMostFolds
                                ? std::min(1., 1.01 * branch.weight() + first_step(rod))
                                : 1;
        HangingRod lighter = rod;
        lighter.gravity *= over;
        const RodMinimum minimum = rod_minimum(lighter, branch.q());
        branch.restart(over, minimum.q);
        if (over == 1) break;
    }
    if (!left) {
        const double smallest = branch.smallest_eigenvalue();
        if (smallest > -neutral_eigenvalue(rod)) {
            return described(rod, branch.q(), smallest, true, false);
        }
    }
    const RodMinimum minimum = rod_minimum(rod, branch.q());
    return described(rod, minimum.q, minimum.smallest_eigenvalue, minimum.converged,
                     left || minimum.escapes > 0);
}

std::optional<RodEquilibrium> rod_branch_equilibrium(const HangingRod& rod) {
    RodBranch branch(rod);
    if (!walk_to(branch, 1, first_step(rod), 1e300, kGoOn)) return std::nullopt;
    return described(rod, branch.q(), branch.smallest_eigenvalue(), true, false);
}

std::optional<double> critical_weight(const HangingRod& rod, double most) {
    if (weight_number(rod) == 0) return std::nullopt;
    RodBranch branch(rod), before = branch;
    bool lost = false;
    const bool ended =
        !walk_to(branch, most, first_step(rod), 0.1, [&](const RodBranch& at) {
            lost = !at.hessian_is_positive();
            if (!lost) before = at;
            return !lost;
        });
    if (lost)
        return eigenvalue_zero(before, branch.weight(), branch.smallest_eigenvalue());
    if (ended) return branch.weight();
    return std::nullopt;
}

}  // namespace lancret
