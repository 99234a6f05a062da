#include "procedural/blend/motion_limit.h"

#include <algorithm>
#include <cmath>

#include "procedural/blend/anchor.h"

namespace lancret {

namespace {

/// The quantities that determine the child's frames at one time.
struct Ingredients {
    std::vector<HelixState<double>> copy;  ///< of the heaviest guide
    std::vector<AnchorTurns<double>> turns;
};

Ingredients ingredients_of(const Child<double>& child,
                           const GuideProfiles<double>& profiles) {
    Ingredients out;
    out.copy.resize(profiles.count + 1);
    blend_nearest<double>(child, profiles, out.copy);
    const Anchor<double> anchor = anchor_of<double>(child, profiles, out.copy);
    for (std::size_t i = 0; i < out.copy.size(); ++i) {
        out.turns.push_back(turns_at(anchor, child, profiles, i));
    }
    return out;
}

}  // namespace

double anchored_motion_limit(const AnchoredTimes& times) {
    const Ingredients a = ingredients_of(times.before, times.profiles_before),
                      b = ingredients_of(times.after, times.profiles_after);
    double largest = 0;
    for (std::size_t i = 0; i < a.copy.size(); ++i) {
        const Mat3 turned = a.copy[i].frame.transpose() * b.copy[i].frame;
        const double alpha = rotation_log<double>(turned).norm(),
                     speed = (a.turns[i].tilt_speed - b.turns[i].tilt_speed).norm();
        const Turn<double>&p = a.turns[i].to_goal, &q = b.turns[i].to_goal;
        const double apart = std::hypot(p.cosine - q.cosine, (p.sine - q.sine).norm()),
                     sizes = std::hypot(p.cosine, p.sine.norm()) +
                             std::hypot(q.cosine, q.sine.norm());
        largest = std::max(largest, 4.9 * alpha + 2.4 * speed + 2 * kPi * apart / sizes);
    }
    // The direction of a step of arc length turns by at most the turn of the frame at its
    // start and half the turns of both ends: 1.5 times the largest.
    return 2 * std::max(times.before.length, times.after.length) * largest;
}

}  // namespace lancret
