#pragma once
// The spine of a strand: its course without the curl.
//
// The tangent over s / L is expanded in Legendre polynomials up to degree 3. Degree 0 is
// the overall direction (the chord from root to tip over the length), degree 1 the
// overall bend; both are always used. Degrees 2 and 3 are used only if the curl turns too
// often for them to follow it. This low-pass of a few coefficients needs no treatment of
// ends, its coefficients add like vectors between strands, and it leaves the higher
// terms, which hold nearly all of a curl's curvature, unchanged.
//
// The length of the spine's vector is its advance: the progress along the spine per arc
// length, 1 for a straight strand and the cosine of the pitch angle for a helix of many
// turns.

#include <algorithm>
#include <array>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

inline constexpr int kSpineTerms = 4;

/// The Legendre coefficients of a spine.
template <class T>
struct Spine {
    std::array<Vec3T<T>, kSpineTerms> terms{Vec3T<T>::Zero(), Vec3T<T>::Zero(),
                                            Vec3T<T>::Zero(), Vec3T<T>::Zero()};
    T turns = 0;  ///< integral of kappa over 2 pi: the number of turns of the curl
};

/// The polynomials P_j on `count` intervals of equal length.
template <class T>
struct SpineBasis {
    std::vector<std::array<T, kSpineTerms>> at_places;   ///< [count + 1]
    std::vector<std::array<T, kSpineTerms>> in_middles;  ///< [count], (2 j + 1) P_j
};

template <class T>
SpineBasis<T> spine_basis(int count);

/// The spine of a strand of `length` cm; position(i), i = 0 .. count, returns its places
/// at equal steps of arc length. `turns` stays 0. The integral of P_j T over s / L takes
/// P_j in the middle of each interval and T exactly, as its integral is the chord.
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

/// Factor of each degree for a strand of `turns` turns: degree j >= 2 rises from 0 at
/// j - 1 turns to 1 at j turns, so that the spine's half waves (length over j) are never
/// shorter than the curl's.
template <class T>
std::array<T, kSpineTerms> spine_taper(T turns) {
    std::array<T, kSpineTerms> out{1, 1};
    for (int j = 2; j < kSpineTerms; ++j) out[j] = std::clamp<T>(turns - T(j - 1), 0, 1);
    return out;
}

/// The spine's vector at a place with the polynomials `basis`; its length is the advance.
template <class T>
Vec3T<T> spine_at(const Spine<T>& spine, const std::array<T, kSpineTerms>& taper,
                  const std::array<T, kSpineTerms>& basis) {
    Vec3T<T> out = spine.terms[0];
    for (int j = 1; j < kSpineTerms; ++j) out += taper[j] * basis[j] * spine.terms[j];
    return out;
}

}  // namespace lancret
