// Curvature, torsion and root frame, blended and then synthesised [TW99, Sec. 4.3, option
// 1].
//
// As printed, the blended curvature is a quotient that grows without bound where the
// guides' normals cancel, and the torsion one more that fails at inflections. Both are
// kept inside the hull of the guides' values, and both quotients lean on a weighted mean
// where they lose their meaning, so that the result stays continuous.

#include <algorithm>
#include <numbers>

#include "procedural/blend.h"

namespace lancret {

namespace {

/// The share of the guides' mean that steadies a quotient; it shows only where the
/// denominator has fallen to this share of its largest value.
template <class T>
constexpr T kSteady = T(1e-5);

template <class T>
constexpr T kHalfTurn = std::numbers::pi_v<T>;

template <class T>
Vec3T<T> across(const Vec3T<T>& v, const Vec3T<T>& axis) {
    return v - axis * axis.dot(v);
}

/// sum(w_k A_k v_k) made a unit vector; where it vanishes, the heaviest guide's vector.
template <class T, class Vector>
Vec3T<T> mean_direction(const Child<T>& child, Vector&& vector) {
    Vec3T<T> sum = Vec3T<T>::Zero();
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        sum += child.weights[k] * (child.to_space[k] * vector(k));
    }
    const T size = sum.norm();
    if (size > kSteady<T>) return sum / size;
    const std::size_t heaviest =
        std::ranges::max_element(child.weights) - child.weights.begin();
    return child.to_space[heaviest] * vector(heaviest);
}

/// F~(0): the tangent and the curvature-weighted normal of the guides' roots. Where the
/// normals cancel or no guide bends there, the guides' first axis across the tangent
/// serves: the frame is orthonormal whatever comes.
template <class T>
Mat3T<T> root_frame_of(const Child<T>& child, const GuideProfiles<T>& guides) {
    const Vec3T<T> tangent =
        mean_direction<T>(child, [](std::size_t) { return Vec3T<T>::UnitX(); });
    Vec3T<T> bend = Vec3T<T>::Zero();
    T most = 0;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        const std::uint32_t g = child.guides[k];
        const T kappa =
            child.weights[k] * guides.intervals[std::size_t(g) * guides.count].kappa;
        bend += kappa * (child.to_space[k] * guides.root_normals[g]);
        most += std::abs(kappa);
    }
    Vec3T<T> normal = across<T>(bend, tangent);
    if (!(normal.norm() > kSteady<T> * most)) {
        normal = across<T>(
            mean_direction<T>(child, [](std::size_t) { return Vec3T<T>::UnitY(); }),
            tangent);
    }
    if (!(normal.norm() > kSteady<T>)) normal = tangent.unitOrthogonal();
    normal.normalize();
    Mat3T<T> frame;
    frame << tangent, normal, tangent.cross(normal);
    orthonormalize<T>(frame);
    return frame;
}

/// kappa~, tau~ and the turn of N~ on one interval.
template <class T>
struct BlendedInterval {
    T kappa, tau, turn;
};

/// (kappa, N) and (-kappa, -N) are the same bend, and each guide carries its own choice
/// along. Here the choices are brought in line: `flipped` tells, for each guide, whether
/// its pair is turned round to lie on the side of the heaviest guide's N.
struct Sides {
    std::size_t heaviest = 0;
    bool flipped[kMaxNeighbours] = {};
};

template <class T>
BlendedInterval<T> blended_interval(const Child<T>& child, const GuideProfiles<T>& guides,
                                    std::size_t i, Sides& sides) {
    const std::size_t k_count = child.guides.size();
    const ProfileInterval<T>* at[kMaxNeighbours];
    for (std::size_t k = 0; k < k_count; ++k) {
        at[k] = &guides.intervals[std::size_t(child.guides[k]) * guides.count + i];
    }
    const Vec3T<T> tangent = mean_direction<T>(
        child, [&](std::size_t k) -> const Vec3T<T>& { return at[k]->tangent; });

    // Every guide's bend on the heaviest guide's side. A guide that changes sides between
    // two intervals turns by half a turn less or more.
    Vec3T<T> normal[kMaxNeighbours];
    T kappa_of[kMaxNeighbours], turn_of[kMaxNeighbours];
    const Vec3T<T> side =
        across<T>(child.to_space[sides.heaviest] * at[sides.heaviest]->normal, tangent);
    for (std::size_t k = 0; k < k_count; ++k) {
        normal[k] = child.to_space[k] * at[k]->normal;
        const bool flip = normal[k].dot(side) < 0;
        const T sign = flip ? T(-1) : T(1);
        normal[k] *= sign;
        kappa_of[k] = sign * at[k]->kappa;
        turn_of[k] = at[k]->turn;
        if (i > 0 && flip != sides.flipped[k]) {
            turn_of[k] +=
                turn_of[k] < at[sides.heaviest]->turn ? kHalfTurn<T> : -kHalfTurn<T>;
        }
        sides.flipped[k] = flip;
    }

    // Sums over the guides: of w kappa N and w N across T~, and the means that steady
    // them.
    Vec3T<T> bend = Vec3T<T>::Zero(), normals = Vec3T<T>::Zero();
    T bending = 0, torsion = 0, turning = 0, plain_tau = 0, plain_turn = 0;
    T kappa_low = kappa_of[0], kappa_high = kappa_of[0];
    T tau_low = at[0]->tau, tau_high = at[0]->tau;
    for (std::size_t k = 0; k < k_count; ++k) {
        const T w = child.weights[k], share = w * std::abs(kappa_of[k]);
        const Vec3T<T> flat = across<T>(normal[k], tangent);
        bend += w * kappa_of[k] * flat;
        normals += w * flat;
        bending += share;
        torsion += share * at[k]->tau;
        turning += share * turn_of[k];
        plain_tau += w * at[k]->tau;
        plain_turn += w * turn_of[k];
        kappa_low = std::min(kappa_low, kappa_of[k]);
        kappa_high = std::max(kappa_high, kappa_of[k]);
        tau_low = std::min(tau_low, at[k]->tau);
        tau_high = std::max(tau_high, at[k]->tau);
    }
    // Guides that do not bend have no say in torsion; where none bends, all have.
    constexpr T kNone = T(1e-12);
    const T mean_tau = (torsion + kNone * plain_tau) / (bending + kNone);
    const T mean_turn = (turning + kNone * plain_turn) / (bending + kNone);

    // |kappa~| = |sum w kappa P N| / |sum w P N|. kappa~ is negative where N~, carried on
    // as the guides' normals are, points away from the bend.
    const T size = bend.norm();
    T kappa = (size + kSteady<T> * bending) / (normals.norm() + kSteady<T>);
    const bool away = kappa_low < 0 && (kappa_high <= 0 || bend.dot(normals) < 0);
    kappa = std::clamp(away ? -kappa : kappa, kappa_low, kappa_high);

    // kappa~ tau~ = sum w kappa tau (B.B~) / |sum w (B.B~)|, with N~ along the bend.
    T tau = mean_tau;
    if (size > 0) {
        const Vec3T<T> n = away ? Vec3T<T>(bend / -size) : Vec3T<T>(bend / size);
        const Vec3T<T> binormal = tangent.cross(n);
        T product = 0, binormals = 0;
        for (std::size_t k = 0; k < k_count; ++k) {
            const Vec3T<T> own = (child.to_space[k] * at[k]->tangent).cross(normal[k]);
            const T along = child.weights[k] * own.dot(binormal);
            product += along * kappa_of[k] * at[k]->tau;
            binormals += along;
        }
        const T kappa_tau = (product + kSteady<T> * kappa * mean_tau) /
                            (std::abs(binormals) + kSteady<T>);
        // A quotient by kappa~ that leans on the mean as kappa~ goes to zero.
        const T floor = T(1e-3) * bending, weight = floor * floor + kNone * kNone;
        tau = (kappa_tau * kappa + weight * mean_tau) / (kappa * kappa + weight);
    }
    return {kappa, std::clamp(tau, tau_low, tau_high), mean_turn};
}

}  // namespace

template <class T>
void blend_option1(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    const T ds = child.length / T(guides.count);
    HelixState<T> state{root_frame_of(child, guides), Vec3T<T>::Zero()};
    states[0] = state;
    T angle = 0;  // of N~ from n1: the turns so far
    Sides sides;
    sides.heaviest = std::ranges::max_element(child.weights) - child.weights.begin();
    for (int i = 0; i < guides.count; ++i) {
        const BlendedInterval<T> blended = blended_interval(child, guides, i, sides);
        angle += blended.turn;
        const Vec3T<T> u(blended.tau, -blended.kappa * std::sin(angle),
                         blended.kappa * std::cos(angle));
        advance<T>(state, u, ds);
        orthonormalize<T>(state.frame);
        states[i + 1] = state;
    }
}

template void blend_option1(const Child<float>&, const GuideProfiles<float>&,
                            std::span<HelixState<float>>);
template void blend_option1(const Child<double>&, const GuideProfiles<double>&,
                            std::span<HelixState<double>>);

}  // namespace lancret
