#include "guides/frenet/frenet_serret.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lancret {

namespace {

/// The helix nearest to `expected` of those with the same end frame, whose turns differ
/// by whole ones.
FrenetRates unwrapped(const FrenetRates& rates, double ds, const FrenetRates& expected) {
    const Vec2 w = ds * Vec2(rates.curvature, rates.torsion);
    const Vec2 target = ds * Vec2(expected.curvature, expected.torsion);
    // An interval without a turn may make whole turns about any axis.
    const double turn = w.norm();
    const double size = turn > 0 ? turn : target.norm();
    if (size == 0) return rates;
    const Vec2 axis = (turn > 0 ? w : target) / size;
    const double whole = 2 * kPi;
    const double full = turn + whole * std::round((target.dot(axis) - turn) / whole);
    return {full * axis.x() / ds, full * axis.y() / ds};
}

}  // namespace

std::vector<HelixState<double>> synthesize(const FrenetProfile& profile) {
    std::vector<HelixState<double>> states{profile.root};
    states.reserve(profile.size() + 1);
    HelixState<double> state = profile.root;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        advance<double>(state, profile.rates[i].darboux(), profile.steps[i]);
        orthonormalize<double>(state.frame);
        states.push_back(state);
    }
    return states;
}

FrenetRates frenet_step(const Mat3& rotation, double ds,
                        const std::optional<FrenetRates>& expected) {
    // The paper's letters; b and e occur twice in the matrix, and the mean is used.
    const double a = rotation(0, 0), d = rotation(1, 1), f = rotation(2, 2);
    const double b = (rotation(1, 0) - rotation(0, 1)) / 2;
    const double e = (rotation(2, 1) - rotation(1, 2)) / 2;
    const double sine = std::hypot(b, e);
    const double rho = std::atan2(sine, d) / ds;  // [TW99, Eq. 46]
    FrenetRates rates;
    if (d < 0) {
        // [TW99, Eq. 47 and 48]: near half a turn b and e vanish, but a and f do not. The
        // printed root loses half its digits where it is small, so the smaller rate comes
        // from c = (1 - d) kappa tau / rho^2 [TW99, Eq. 30], with its sign.
        const double c = (rotation(2, 0) + rotation(0, 2)) / 2;
        const bool bends = a < f;
        const double root = std::sqrt((1 - (bends ? a : f)) / (1 - d));
        const double larger = std::copysign(root, bends ? b : e);
        const double smaller = c / ((1 - d) * larger);
        rates = {rho * (bends ? larger : smaller), rho * (bends ? smaller : larger)};
    } else if (sine > 0) {
        // [TW99, Eq. 47 and 48, corrected]: rho b / sine tends to b / ds by itself, so
        // the printed small-angle branch is not needed.
        rates = {rho * (b / sine), rho * (e / sine)};
    }
    return expected ? unwrapped(rates, ds, *expected) : rates;
}

FrenetProfile profile_of_frames(std::span<const HelixState<double>> states,
                                std::span<const double> steps,
                                std::span<const FrenetRates> expected) {
    if (states.size() != steps.size() + 1) {
        throw std::invalid_argument(
            "profile_of_frames: expected one state more than steps");
    }
    if (!expected.empty() && expected.size() != steps.size()) {
        throw std::invalid_argument(
            "profile_of_frames: expected one rate per step or none");
    }
    FrenetProfile profile;
    profile.root = states[0];
    profile.steps.assign(steps.begin(), steps.end());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Mat3 turn = states[i].frame.transpose() * states[i + 1].frame;
        profile.rates.push_back(
            frenet_step(turn, steps[i],
                        expected.empty() ? std::nullopt : std::optional(expected[i])));
    }
    return profile;
}

double largest_turn(const FrenetProfile& profile) {
    double largest = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        largest = std::max(largest, profile.rates[i].darboux().norm() * profile.steps[i]);
    }
    return largest;
}

}  // namespace lancret
