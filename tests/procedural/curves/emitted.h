#pragma once
// Helices and their emitted curves, for tests.

#include <vector>

#include "procedural/check/strand.h"
#include "procedural/curves/emitted_curve.h"

namespace lancret::test {

/// n + 1 places of the helix of Darboux vector `u` at steps `ds`.
inline std::vector<HelixState<float>> helix_states(const Vec3& u, double ds, int n) {
    std::vector<HelixState<float>> out(n + 1);
    for (int i = 0; i <= n; ++i) {
        HelixState<double> state;
        advance<double>(state, u, i * ds);
        out[i] = {state.frame.cast<float>(), state.position.cast<float>()};
    }
    return out;
}

/// The place at arc length s of that helix.
inline Vec3 helix_position(const Vec3& u, double s) {
    HelixState<double> state;
    advance<double>(state, u, s);
    return state.position;
}

/// A strand's control points and their evaluation.
struct Emitted {
    StrandBuffer curve;
    EmittedStrand strand;

    Emitted(const std::vector<HelixState<float>>& states, double ds, CurveBasis basis,
            const Vec3f& root = Vec3f::Zero(), const Taper& taper = {}) {
        emit({.states = states, .ds = float(ds), .root = root, .taper = taper}, basis,
             curve);
        strand = {basis, curve.points, curve.tangents};
    }
    Emitted(const Emitted&) = delete;
};

}  // namespace lancret::test
