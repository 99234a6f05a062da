#pragma once
// The spine of a strand: where it goes once its curl is left aside.
//
// The tangent over s / L is told in Legendre polynomials of degree 0 to 3, and no higher.
// Degree 0 is where the strand goes on the whole (the chord from root to tip over the
// length), degree 1 how it bends on the whole; both always count. Degrees 2 and 3 count
// as far as the strand's own curl has a wavelength that they cannot follow. A low-pass by
// a few numbers has no ends to treat, sums like vectors between strands, and leaves what
// is higher, which is nearly all of a curl's curvature, alone. Its length is the spine's
// advance: the share of the arc length by which the strand gets on, 1 for a straight
// strand and the cosine of the pitch angle for a helix of many turns.

#include <algorithm>
#include <array>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

inline constexpr int kSpineTerms = 4;

/// A spine's vectors.
template <class T>
struct Spine {
    std::array<Vec3T<T>, kSpineTerms> terms{Vec3T<T>::Zero(), Vec3T<T>::Zero(),
                                            Vec3T<T>::Zero(), Vec3T<T>::Zero()};
    T turns = 0;  ///< integral of kappa / 2 pi: how often the strand's curl goes round
};

/// The polynomials where they are needed, on `count` intervals of equal length.
template <class T>
struct SpineBasis {
    std::vector<std::array<T, kSpineTerms>> at_places;   ///< [count + 1]
    std::vector<std::array<T, kSpineTerms>> in_middles;  ///< [count], times 2 j + 1
};

template <class T>
SpineBasis<T> spine_basis(int count);

/// The spine of a strand of `length` cm; position(i), i = 0 .. count, are its places at
/// equal steps of arc length. `turns` stays 0. What is integrated over s / L is P_j T,
/// with P_j from the middle of each interval and T exactly: its integral is the chord.
template <class T, class Position>
Spine<T> spine_of(const SpineBasis<T>& basis, T length, Position&& position) {
    Spine<T> out;
    for (std::size_t i = 0; i < basis.in_middles.size(); ++i) {
        const Vec3T<T> chord = (position(i + 1) - position(i)) / length;
        for (int j = 0; j < kSpineTerms; ++j) {
            out.terms[j] += basis.in_middles[i][j] * chord;
        }
    }
    return out;
}

/// How much each degree counts for a strand that turns `turns` times: degree j >= 2 not
/// at all below j - 1 turns and fully from j turns on, so that the spine's half waves
/// (length over j) are never shorter than the curl's own.
template <class T>
std::array<T, kSpineTerms> spine_taper(T turns) {
    std::array<T, kSpineTerms> out{1, 1};
    for (int j = 2; j < kSpineTerms; ++j) out[j] = std::clamp<T>(turns - T(j - 1), 0, 1);
    return out;
}

/// The spine's vector at a place; its length is the advance.
template <class T>
Vec3T<T> spine_at(const Spine<T>& spine, const std::array<T, kSpineTerms>& taper,
                  const std::array<T, kSpineTerms>& basis) {
    Vec3T<T> out = spine.terms[0];
    for (int j = 1; j < kSpineTerms; ++j) out += taper[j] * basis[j] * spine.terms[j];
    return out;
}

}  // namespace lancret
