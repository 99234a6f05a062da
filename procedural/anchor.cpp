#include "procedural/anchor.h"

#include <cmath>

namespace lancret {

namespace {

/// A rotation as a quaternion of any length but zero.
template <class T>
struct Turn {
    T cosine;       ///< times any number
    Vec3T<T> sine;  ///< times the same number

    Mat3T<T> operator*(const Mat3T<T>& m) const {
        const T factor = 2 / (cosine * cosine + sine.squaredNorm());
        Mat3T<T> out;
        for (int c = 0; c < 3; ++c) {
            const Vec3T<T> across = sine.cross(m.col(c));
            out.col(c) = m.col(c) + factor * (cosine * across + sine.cross(across));
        }
        return out;
    }
};

/// From one spine's direction to another's, by the smallest rotation. Where a spine all
/// but vanishes, or the two are opposed, there is no such thing, and the rotation goes to
/// none smoothly.
template <class T>
Turn<T> turn_of_spine(const Vec3T<T>& from, const Vec3T<T>& to) {
    constexpr T kNone = T(0.01);
    return {from.norm() * to.norm() + from.dot(to) + kNone, from.cross(to)};
}

/// The change of tilt about a spine that brings its advance from |spine| to `advance`.
///
/// Directions move as they do under a change of speed along the spine (relativistic
/// aberration): (c + b) / (1 + c b) is the cosine c of the angle to it. That takes a
/// helix of cosine c to the one of cosine a with b = (a - c) / (1 - a c), is conformal,
/// and has no angle in it.
template <class T>
Turn<T> tilt_about_spine(const Vec3T<T>& tangent, const Vec3T<T>& spine, T advance) {
    constexpr T kSoft = T(0.05);   // of a straight strand, which has no tilt to change
    constexpr T kMost = T(0.33);   // a tilt half changes by a factor of 1.4 at most
    constexpr T kShort = T(0.05);  // of a spine too short to have a direction
    const T own = std::min<T>(spine.norm(), 1);
    const T speed =
        std::clamp<T>((advance - own) / (1 - advance * own + kSoft), -kMost, kMost);
    const Vec3T<T> v = spine * (speed / std::sqrt(own * own + kShort * kShort));
    const T gamma = 1 / std::sqrt(1 - v.squaredNorm()), along = v.dot(tangent);
    const Vec3T<T> to =
        (tangent / gamma + (1 + gamma / (gamma + 1) * along) * v) / (1 + along);
    return {1 + tangent.dot(to), tangent.cross(to)};
}

/// The spine that the guides ask for, in space, and its number of turns.
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
void anchor(const Child<T>& child, const GuideProfiles<T>& guides,
            std::span<HelixState<T>> states) {
    // Places blended at equal s / L move by w L T ds: a longer guide has more to say.
    T shares[kMaxNeighbours], sum = 0;
    const std::size_t count = child.guides.size(), places = guides.count + 1;
    for (std::size_t k = 0; k < count; ++k) {
        sum += shares[k] = child.weights[k] * guides.lengths[child.guides[k]];
    }
    for (std::size_t k = 0; k < count; ++k) shares[k] /= sum;

    const Spine<T> goal = goal_of<T>(child, guides, {shares, count});
    const Spine<T> own =
        spine_of<T>(guides.basis, child.length,
                    [&](std::size_t i) -> const Vec3T<T>& { return states[i].position; });
    const auto taper = spine_taper(goal.turns);
    const T ds = child.length / T(guides.count);
    for (std::size_t i = 0; i < places; ++i) {
        const auto& basis = guides.basis.at_places[i];
        const Vec3T<T> from = spine_at(own, taper, basis);
        T advance = 0;
        for (std::size_t k = 0; k < count; ++k) {
            advance += shares[k] * guides.advances[child.guides[k] * places + i];
        }
        Mat3T<T>& frame = states[i].frame;
        const Turn<T> tilt = tilt_about_spine<T>(frame.col(0), from, advance);
        const Turn<T> turn = turn_of_spine<T>(from, spine_at(goal, taper, basis));
        frame = turn * (tilt * frame);
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

}  // namespace lancret
