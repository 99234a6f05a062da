// Curvature, torsion and root frame, blended and then synthesised [TW99, Sec. 4.3, option
// 1].
//
// As printed, the blended curvature is a quotient that grows without bound where the
// guides' normals cancel, and the torsion one more that fails at inflections. Both are
// kept inside the hull of the guides' values, and both quotients lean on a weighted mean
// where they lose their meaning. What is left of their jumps stays inside that hull.

#include <algorithm>
#include <array>
#include <cmath>

#include "procedural/blend/blend.h"

namespace lancret {

namespace {

/// The share of the guides' mean that steadies a quotient; it shows only where the
/// denominator has fallen to this share of its largest value.
template <class T>
constexpr T kSteady = T(1e-5);

/// A bend of this size (1/cm) has no direction.
template <class T>
constexpr T kNothing = T(1e-12);

template <class T>
Vec3T<T> across(const Vec3T<T>& v, const Vec3T<T>& axis) {
    return v - axis * axis.dot(v);
}

/// A vector of each guide.
template <class T>
using GuideVectors = std::array<Vec3T<T>, kMaxNeighbours>;

/// vector(k) of each guide, turned from its root frame to space.
template <class T, class Vector>
GuideVectors<T> in_space(const Child<T>& child, Vector&& vector) {
    GuideVectors<T> out;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        out[k] = child.to_space[k] * vector(k);
    }
    return out;
}

/// sum(w_k v_k) made a unit vector; where it vanishes, the heaviest guide's vector.
template <class T>
Vec3T<T> mean_direction(const Child<T>& child, const GuideVectors<T>& vectors) {
    Vec3T<T> sum = Vec3T<T>::Zero();
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        sum += child.weights[k] * vectors[k];
    }
    const T size = sum.norm();
    if (size > kSteady<T>) return sum / size;
    return vectors[std::ranges::max_element(child.weights) - child.weights.begin()];
}

/// The guides' interval i.
template <class T>
struct Row {
    const ProfileInterval<T>* at[kMaxNeighbours] = {};

    Row(const Child<T>& child, const GuideProfiles<T>& guides, std::size_t i) {
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            at[k] = &guides.intervals[std::size_t(child.guides[k]) * guides.count + i];
        }
    }
};

/// sum(w kappa P N) at one end of an interval, which has the direction of N~ there.
/// Straight guides have the faintest say, by the normal that they carry.
template <class T>
Vec3T<T> bend_of(const Child<T>& child, const Row<T>& row,
                 Vec3T<T> ProfileInterval<T>::*normal, const Vec3T<T>& tangent) {
    constexpr T kFaint = T(1e-6);  // 1/cm
    Vec3T<T> bend = Vec3T<T>::Zero();
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        bend += child.weights[k] * (row.at[k]->kappa + kFaint) *
                (child.to_space[k] * (row.at[k]->*normal));
    }
    return across<T>(bend, tangent);
}

/// F~(0): the tangent and the curvature-weighted normal of the guides' roots. Where the
/// normals cancel, the guides' first axis across the tangent serves: the frame is
/// orthonormal whatever comes.
template <class T>
Mat3T<T> root_frame_of(const Child<T>& child, const Row<T>& row) {
    const Vec3T<T> tangent = mean_direction(
        child, in_space(child, [](std::size_t) { return Vec3T<T>::UnitX(); }));
    Vec3T<T> normal = bend_of(child, row, &ProfileInterval<T>::normal_before, tangent);
    if (!(normal.norm() > kNothing<T>)) {
        const auto across_root =
            in_space(child, [](std::size_t) { return Vec3T<T>::UnitY(); });
        normal = across<T>(mean_direction(child, across_root), tangent);
    }
    if (!(normal.norm() > kNothing<T>)) normal = tangent.unitOrthogonal();
    normal.normalize();
    Mat3T<T> frame;
    frame << tangent, normal, tangent.cross(normal);
    orthonormalize<T>(frame);
    return frame;
}

/// A direction across the tangent: cosine and sine of its angle from n1.
template <class T>
struct Angle {
    T cosine = 1, sine = 0;
};

/// `angle` and the turn of N~ about T~ where two intervals meet: from the bend before the
/// joint to the bend after it, both seen across T~ at the joint. An inflection is half a
/// turn.
template <class T>
Angle<T> turned_at_joint(const Angle<T>& angle, const Child<T>& child,
                         const GuideProfiles<T>& guides, const Row<T>& before,
                         const Row<T>& after, std::size_t place) {
    const Vec3T<T> tangent =
        mean_direction(child, in_space(child, [&](std::size_t k) -> Vec3T<T> {
                           return guides.tangent(child.guides[k], place);
                       }));
    const Vec3T<T> from =
        bend_of(child, before, &ProfileInterval<T>::normal_after, tangent);
    const Vec3T<T> to =
        bend_of(child, after, &ProfileInterval<T>::normal_before, tangent);
    const T sine = tangent.dot(from.cross(to)), cosine = from.dot(to);
    const Angle<T> sum{angle.cosine * cosine - angle.sine * sine,
                       angle.sine * cosine + angle.cosine * sine};
    const T size = std::hypot(sum.cosine, sum.sine);
    if (!(size > kNothing<T> * kNothing<T>)) return angle;
    return {sum.cosine / size, sum.sine / size};
}

/// kappa~ and tau~ on one interval.
template <class T>
struct Rates {
    T kappa, tau;
};

/// Rates from the guides in the middle of an interval, inside the hull of the guides'
/// own.
template <class T>
Rates<T> blended_rates(const Child<T>& child, const Row<T>& row) {
    const std::size_t count = child.guides.size();
    const GuideVectors<T> tangents = in_space(
        child, [&](std::size_t k) -> const Vec3T<T>& { return row.at[k]->tangent; });
    const Vec3T<T> tangent = mean_direction(child, tangents);

    // (kappa, N) and (-kappa, -N) are the same bend. All are told with N on the side of
    // the guide that bends most, so that guides on either side of an inflection cancel in
    // kappa, not in N.
    GuideVectors<T> normal = in_space(
        child, [&](std::size_t k) -> const Vec3T<T>& { return row.at[k]->normal; });
    T kappa_of[kMaxNeighbours] = {};
    std::size_t first = 0;
    for (std::size_t k = 0; k < count; ++k) {
        kappa_of[k] = row.at[k]->kappa;
        if (child.weights[k] * kappa_of[k] > child.weights[first] * kappa_of[first])
            first = k;
    }
    const Vec3T<T> side = across<T>(normal[first], tangent);

    Vec3T<T> bend = Vec3T<T>::Zero(), normals = Vec3T<T>::Zero();
    T bending = 0, torsion = 0, plain_tau = 0;
    T kappa_low = kappa_of[0], kappa_high = 0;
    T tau_low = row.at[0]->tau, tau_high = tau_low;
    for (std::size_t k = 0; k < count; ++k) {
        const T w = child.weights[k], kappa = kappa_of[k], tau = row.at[k]->tau;
        bending += w * kappa;
        torsion += w * kappa * tau;
        plain_tau += w * tau;
        kappa_high = std::max(kappa_high, kappa);
        tau_low = std::min(tau_low, tau);
        tau_high = std::max(tau_high, tau);
        if (normal[k].dot(side) < 0) {
            normal[k] = -normal[k];
            kappa_of[k] = -kappa;
        }
        kappa_low = std::min(kappa_low, kappa);
        const Vec3T<T> flat = across<T>(normal[k], tangent);
        bend += w * kappa_of[k] * flat;
        normals += w * flat;
    }
    // Guides that do not bend have no say in torsion; where none bends, all have.
    const T mean_tau = (torsion + kNothing<T> * plain_tau) / (bending + kNothing<T>);

    // kappa~ = |sum w kappa P N| / |sum w P N|
    const T size = bend.norm();
    const T printed = (size + kSteady<T> * bending) / (normals.norm() + kSteady<T>);
    const T kappa = std::clamp(printed, kappa_low, kappa_high);

    // kappa~ tau~ = sum w kappa tau (B.B~) / |sum w (B.B~)|, with N~ along the bend. The
    // quotient by kappa~ leans on the mean as kappa~ goes to zero.
    T tau = mean_tau;
    if (size > 0) {
        const Vec3T<T> binormal = tangent.cross(bend) / size;
        T product = 0, binormals = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3T<T> own = tangents[k].cross(normal[k]);
            const T along = child.weights[k] * own.dot(binormal);
            product += along * kappa_of[k] * row.at[k]->tau;
            binormals += along;
        }
        const T kappa_tau = (product + kSteady<T> * kappa * mean_tau) /
                            (std::abs(binormals) + kSteady<T>);
        const T floor = T(1e-3) * bending + kNothing<T>, weight = floor * floor;
        tau = (kappa_tau * kappa + weight * mean_tau) / (kappa * kappa + weight);
    }
    return {kappa, std::clamp(tau, tau_low, tau_high)};
}

}  // namespace

template <class T>
void blend_option1(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    const T ds = child.length / T(guides.count);
    Row<T> row(child, guides, 0);
    HelixState<T> state{root_frame_of(child, row), Vec3T<T>::Zero()};
    states[0] = state;
    Angle<T> angle;  // of N~ from n1: the turns so far
    for (int i = 0; i < guides.count; ++i) {
        if (i > 0) {
            const Row<T> next(child, guides, i);
            if (guides.joints[i]) {
                angle = turned_at_joint(angle, child, guides, row, next, i);
            }
            row = next;
        }
        const Rates<T> rates = blended_rates(child, row);
        const Vec3T<T> u(rates.tau, -rates.kappa * angle.sine,
                         rates.kappa * angle.cosine);
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
