// Blend option1: curvature, torsion and root frame are blended, and the strand is
// synthesised from them [TW99, Sec. 4.3, option 1].
//
// As printed, the blended curvature is a quotient that grows without limit as the guides'
// normals cancel, and the torsion is another that fails at inflections. Both are clamped
// to the range of the guides' values, and both quotients pass to a weighted mean as their
// denominators vanish. The jumps that remain stay within that range.

#include <algorithm>
#include <array>
#include <cmath>

#include "procedural/blend/blend.h"
#include "procedural/blend/option1_constants.h"

namespace lancret {

namespace {

using option1::kFaint;
using option1::kFloor;
using option1::kNothing;
using option1::kSteady;

template <class T>
Vec3T<T> across(const Vec3T<T>& v, const Vec3T<T>& axis) {
    return v - axis * axis.dot(v);
}

/// One vector per guide.
template <class T>
using GuideVectors = std::array<Vec3T<T>, kMaxNeighbours>;

/// vector(k) of guide k, turned from its root frame to space.
template <class T, class Vector>
GuideVectors<T> in_space(const Child<T>& child, Vector&& vector) {
    GuideVectors<T> out;
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        out[k] = child.to_space[k] * vector(k);
    }
    return out;
}

/// The unit vector along sum(w_k v_k); the heaviest guide's vector if the sum vanishes.
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

/// Interval i of each guide.
template <class T>
struct Row {
    const ProfileInterval<T>* at[kMaxNeighbours] = {};

    Row(const Child<T>& child, const GuideProfiles<T>& guides, std::size_t i) {
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            at[k] = &guides.intervals[std::size_t(child.guides[k]) * guides.count + i];
        }
    }
};

/// sum(w kappa P N) at one end of an interval; its direction is that of N~ there. P
/// projects across the tangent.
template <class T>
Vec3T<T> bend_of(const Child<T>& child, const Row<T>& row,
                 Vec3T<T> ProfileInterval<T>::*normal, const Vec3T<T>& tangent) {
    Vec3T<T> bend = Vec3T<T>::Zero();
    for (std::size_t k = 0; k < child.guides.size(); ++k) {
        bend += child.weights[k] *
                (row.at[k]->kappa + kFaint<T>)*(child.to_space[k] * (row.at[k]->*normal));
    }
    return across<T>(bend, tangent);
}

/// F~(0): the mean tangent and the curvature-weighted normal at the guides' roots. If the
/// normals cancel, the guides' mean first axis across the tangent replaces them, then any
/// axis across the tangent, so that the frame is always orthonormal.
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

/// A direction across the tangent, as cosine and sine of its angle from n1.
template <class T>
struct Angle {
    T cosine = 1, sine = 0;
};

/// `angle` plus the turn of N~ about T~ where two intervals meet: from the bend before
/// the joint to the bend after it, both projected across T~ at the joint. An inflection
/// is half a turn.
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

/// The guides' bends on one interval, their sums and their ranges.
template <class T>
struct Means {
    Vec3T<T> tangent;                      ///< T~
    GuideVectors<T> tangents;              ///< T_k
    GuideVectors<T> normals;               ///< N_k, all on one side of T~
    T kappas[kMaxNeighbours] = {};         ///< with the sign that N_k has on that side
    Vec3T<T> bend = Vec3T<T>::Zero();      ///< sum w kappa P N
    Vec3T<T> flat_sum = Vec3T<T>::Zero();  ///< sum w P N
    T bending = 0;                         ///< sum w |kappa|
    T torsion = 0;                         ///< sum w |kappa| tau
    T plain_tau = 0;                       ///< sum w tau
    T kappa_low, kappa_high, tau_low, tau_high;

    /// The mean torsion, weighted by curvature; the plain mean if no guide bends.
    T mean_tau() const {
        return (torsion + kNothing<T> * plain_tau) / (bending + kNothing<T>);
    }
};

/// Means over the guides in the middle of an interval.
///
/// (kappa, N) and (-kappa, -N) are the same bend. All guides are written with N on the
/// side of the guide that bends most, so that guides on either side of an inflection
/// cancel in kappa, not in N.
template <class T>
Means<T> means_of(const Child<T>& child, const Row<T>& row) {
    const std::size_t count = child.guides.size();
    Means<T> out;
    out.tangents = in_space(
        child, [&](std::size_t k) -> const Vec3T<T>& { return row.at[k]->tangent; });
    out.tangent = mean_direction(child, out.tangents);
    out.normals = in_space(
        child, [&](std::size_t k) -> const Vec3T<T>& { return row.at[k]->normal; });
    std::size_t first = 0;
    for (std::size_t k = 0; k < count; ++k) {
        out.kappas[k] = row.at[k]->kappa;
        if (child.weights[k] * out.kappas[k] > child.weights[first] * out.kappas[first]) {
            first = k;
        }
    }
    const Vec3T<T> side = across<T>(out.normals[first], out.tangent);

    out.kappa_low = out.kappas[0];
    out.kappa_high = 0;
    out.tau_low = out.tau_high = row.at[0]->tau;
    for (std::size_t k = 0; k < count; ++k) {
        const T w = child.weights[k], kappa = out.kappas[k], tau = row.at[k]->tau;
        out.bending += w * kappa;
        out.torsion += w * kappa * tau;
        out.plain_tau += w * tau;
        out.kappa_high = std::max(out.kappa_high, kappa);
        out.tau_low = std::min(out.tau_low, tau);
        out.tau_high = std::max(out.tau_high, tau);
        if (out.normals[k].dot(side) < 0) {
            out.normals[k] = -out.normals[k];
            out.kappas[k] = -kappa;
        }
        out.kappa_low = std::min(out.kappa_low, kappa);
        const Vec3T<T> flat = across<T>(out.normals[k], out.tangent);
        out.bend += w * out.kappas[k] * flat;
        out.flat_sum += w * flat;
    }
    return out;
}

/// kappa~ = |sum w kappa P N| / |sum w P N|, within the range of the guides' kappa;
/// `size` = |sum w kappa P N|.
template <class T>
T blended_kappa(const Means<T>& means, T size) {
    const T printed =
        (size + kSteady<T> * means.bending) / (means.flat_sum.norm() + kSteady<T>);
    return std::clamp(printed, means.kappa_low, means.kappa_high);
}

/// tau~, within the range of the guides' tau, from
/// kappa~ tau~ = sum w kappa tau (B.B~) / |sum w (B.B~)|, with N~ along the bend. The
/// quotient by kappa~ passes to the mean torsion as kappa~ goes to zero.
template <class T>
T blended_tau(const Child<T>& child, const Row<T>& row, const Means<T>& means, T size,
              T kappa) {
    const T mean_tau = means.mean_tau();
    T tau = mean_tau;
    if (size > 0) {
        const Vec3T<T> binormal = means.tangent.cross(means.bend) / size;
        T product = 0, binormals = 0;
        for (std::size_t k = 0; k < child.guides.size(); ++k) {
            const Vec3T<T> guide_binormal = means.tangents[k].cross(means.normals[k]);
            const T along = child.weights[k] * guide_binormal.dot(binormal);
            product += along * means.kappas[k] * row.at[k]->tau;
            binormals += along;
        }
        const T kappa_tau = (product + kSteady<T> * kappa * mean_tau) /
                            (std::abs(binormals) + kSteady<T>);
        const T floor = kFloor<T> * means.bending + kNothing<T>, weight = floor * floor;
        tau = (kappa_tau * kappa + weight * mean_tau) / (kappa * kappa + weight);
    }
    return std::clamp(tau, means.tau_low, means.tau_high);
}

template <class T>
Rates<T> blended_rates(const Child<T>& child, const Row<T>& row) {
    const Means<T> means = means_of(child, row);
    const T size = means.bend.norm(), kappa = blended_kappa(means, size);
    return {kappa, blended_tau(child, row, means, size, kappa)};
}

}  // namespace

template <class T>
void blend_option1(const Child<T>& child, const GuideProfiles<T>& guides,
                   std::span<HelixState<T>> states) {
    const T ds = child.length / T(guides.count);
    Row<T> row(child, guides, 0);
    HelixState<T> state{root_frame_of(child, row), Vec3T<T>::Zero()};
    states[0] = state;
    Angle<T> angle;  // of N~ from n1, summed over the joints so far
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
