#include "procedural/blend/anchor.h"

#include <cmath>

#include "procedural/blend/anchor_constants.h"

namespace lancret {

namespace {

/// The smallest rotation from one spine's direction to another's. It passes smoothly to
/// no rotation as a spine vanishes or the two become opposed, for which it is not
/// defined.
template <class T>
Turn<T> turn_of_spine(const Vec3T<T>& from, const Vec3T<T>& to) {
    using anchoring::kNone;
    return {from.norm() * to.norm() + from.dot(to) + kNone<T>, from.cross(to)};
}

/// The speed, along the spine and below 1, that changes its advance from |spine| to
/// `advance`.
///
/// Directions transform as under a change of speed b (relativistic aberration): a
/// direction at an angle of cosine c to the velocity goes to (c + b) / (1 + c b). With
/// b = (a - c) / (1 - a c), a helix of cosine c becomes one of cosine a. The map is
/// conformal and needs no angles.
template <class T>
Vec3T<T> tilt_speed(const Vec3T<T>& spine, T advance) {
    using anchoring::kMaxSpeed, anchoring::kShort, anchoring::kSoft;
    const T size = std::min<T>(spine.norm(), 1);
    const T speed = std::clamp<T>((advance - size) / (1 - advance * size + kSoft<T>),
                                  -kMaxSpeed<T>, kMaxSpeed<T>);
    return spine * (speed / std::sqrt(size * size + kShort<T> * kShort<T>));
}

/// The smallest rotation from a tangent to its image under the speed v.
template <class T>
Turn<T> tilted(const Vec3T<T>& tangent, const Vec3T<T>& v) {
    const T gamma = 1 / std::sqrt(1 - v.squaredNorm()), along = v.dot(tangent);
    const Vec3T<T> to =
        (tangent / gamma + (1 + gamma / (gamma + 1) * along) * v) / (1 + along);
    return {1 + tangent.dot(to), tangent.cross(to)};
}

/// The weighted mean of the guides' spines, in space, and of their turns.
template <class T>
Spine<T> goal_of(const Child<T>& child, const GuideProfiles<T>& guides,
                 std::span<const T> shares) {
    Spine<T> out;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        const Spine<T>& spine = guides.spines[child.guides[k]];
        const Mat3T<T> weighted = shares[k] * child.to_space[k];
        for (int j = 0; j < kSpineTerms; ++j) out.terms[j] += weighted * spine.terms[j];
        out.turns += shares[k] * spine.turns;
    }
    return out;
}

}  // namespace

template <class T>
Anchor<T> anchor_of(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<const HelixState<T>> states) {
    Anchor<T> out;
    T sum = 0;
    const std::size_t count = child.guides.size();
    for (std::size_t k = 0; k < count; ++k) {
        sum += out.shares[k] = child.weights[k] * guides.lengths[child.guides[k]];
    }
    for (std::size_t k = 0; k < count; ++k) out.shares[k] /= sum;
    out.goal = goal_of<T>(child, guides, {out.shares.data(), count});
    out.own =
        spine_of<T>(guides.basis, child.length,
                    [&](std::size_t i) -> const Vec3T<T>& { return states[i].position; });
    out.taper = spine_taper(out.goal.turns);
    return out;
}

template <class T>
AnchorTurns<T> turns_at(const Anchor<T>& anchor, const Child<T>& child,
                        const GuideProfiles<T>& guides, std::size_t place) {
    const auto& basis = guides.basis.at_places[place];
    const Vec3T<T> from = spine_at(anchor.own, anchor.taper, basis);
    T advance = 0;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        advance += anchor.shares[k] * guides.advance(child.guides[k], place);
    }
    return {tilt_speed<T>(from, advance),
            turn_of_spine<T>(from, spine_at(anchor.goal, anchor.taper, basis))};
}

template <class T>
void anchor(const Child<T>& child, const GuideProfiles<T>& guides,
            std::span<HelixState<T>> states) {
    const Anchor<T> anchor = anchor_of<T>(child, guides, states);
    const T ds = child.length / T(guides.count);
    for (std::size_t i = 0; i < states.size(); ++i) {
        Mat3T<T>& frame = states[i].frame;
        const AnchorTurns<T> turns = turns_at(anchor, child, guides, i);
        frame = turns.to_goal * (tilted<T>(frame.col(0), turns.tilt_speed) * frame);
        orthonormalize<T>(frame);
        if (i == 0) continue;
        const HelixState<T>& before = states[i - 1];
        states[i].position =
            before.position +
            before.frame * displacement_between<T>(before.frame, frame, ds);
    }
}

template void anchor(const Child<float>&, const GuideProfiles<float>&,
                     std::span<HelixState<float>>);
template void anchor(const Child<double>&, const GuideProfiles<double>&,
                     std::span<HelixState<double>>);
template Anchor<double> anchor_of(const Child<double>&, const GuideProfiles<double>&,
                                  std::span<const HelixState<double>>);
template AnchorTurns<double> turns_at(const Anchor<double>&, const Child<double>&,
                                      const GuideProfiles<double>&, std::size_t);

}  // namespace lancret
