#pragma once
// The recursion along a rod for the registers that LANCRET_SIMD names. A vector is one
// Lanes whose last number is ignored, a matrix is three columns. Included only by
// loops_code.h.

#include <cmath>

#include "sim/segment/block.h"
#include "sim/segment/lanes.h"

namespace lancret::LANCRET_SIMD {

namespace {

struct Columns {
    Lanes c[3];

    static Columns zero() { return {}; }
    static Columns load(const double* m) {
        // The fourth number of each column is the first of what follows it in memory.
        return {{Lanes::load(m), Lanes::load(m + 3), Lanes::load(m + 6)}};
    }
    void store(double* m) const {
        for (int i = 0; i < 3; ++i) c[i].store3(m + 3 * i);
    }
    Columns& operator+=(const Columns& b) {
        for (int i = 0; i < 3; ++i) c[i] += b.c[i];
        return *this;
    }
    Columns& operator-=(const Columns& b) {
        for (int i = 0; i < 3; ++i) c[i] = c[i] - b.c[i];
        return *this;
    }
    Columns transpose() const {
        return {{Lanes(Lanes::Vector{c[0].v[0], c[1].v[0], c[2].v[0], 0}),
                 Lanes(Lanes::Vector{c[0].v[1], c[1].v[1], c[2].v[1], 0}),
                 Lanes(Lanes::Vector{c[0].v[2], c[1].v[2], c[2].v[2], 0})}};
    }
};

Lanes product(const Columns& a, double x, double y, double z) {
    return a.c[0] * Lanes(x) + a.c[1] * Lanes(y) + a.c[2] * Lanes(z);
}

/// a times the vector b.
Lanes product(const Columns& a, const Lanes& b) {
    return product(a, b.v[0], b.v[1], b.v[2]);
}

Columns product(const Columns& a, const Columns& b) {
    return {{product(a, b.c[0]), product(a, b.c[1]), product(a, b.c[2])}};
}

/// a b^T.
Columns outer(const Columns& a, const Columns& b) {
    const auto column = [&](int i) {
        return product(a, b.c[0].v[i], b.c[1].v[i], b.c[2].v[i]);
    };
    return {{column(0), column(1), column(2)}};
}

Lanes cross(const Lanes& a, const Lanes& b) {
    const auto next = [](const Lanes& v) {
        return Lanes(__builtin_shufflevector(v.v, v.v, 1, 2, 0, 3));
    };
    return next(a * next(b) - next(a) * b);
}

/// a x each column of m.
Columns cross(const Lanes& a, const Columns& m) {
    return {{cross(a, m.c[0]), cross(a, m.c[1]), cross(a, m.c[2])}};
}

Columns operator+(Columns a, const Columns& b) { return a += b; }
Columns operator*(const Lanes& s, const Columns& m) {
    return {{s * m.c[0], s * m.c[1], s * m.c[2]}};
}

/// A lower triangular 3 x 3 matrix.
struct Lower {
    double a, b, c, d, e, f;  ///< by rows
};

/// The Cholesky factor of a symmetric, positive definite matrix.
Lower cholesky(const Columns& m) {
    Lower l;
    l.a = std::sqrt(m.c[0].v[0]);
    l.b = m.c[0].v[1] / l.a;
    l.d = m.c[0].v[2] / l.a;
    l.c = std::sqrt(m.c[1].v[1] - l.b * l.b);
    l.e = (m.c[1].v[2] - l.d * l.b) / l.c;
    l.f = std::sqrt(m.c[2].v[2] - l.d * l.d - l.e * l.e);
    return l;
}

/// u l^-T.
Columns right_solve(const Columns& u, const Lower& l) {
    Columns w;
    w.c[0] = u.c[0] * Lanes(1 / l.a);
    w.c[1] = (u.c[1] - w.c[0] * Lanes(l.b)) * Lanes(1 / l.c);
    w.c[2] = (u.c[2] - w.c[0] * Lanes(l.d) - w.c[1] * Lanes(l.e)) * Lanes(1 / l.f);
    return w;
}

/// Everything beyond a joint, as one body held there.
struct Composite {
    Columns aa, al, ll;
    Lanes moment, force;

    /// Moves the reference point by -d: T^T I T and T^T (moment; force).
    void shift(const Lanes& d) {
        const Columns turned = cross(d, ll), coupling = cross(d, al.transpose());
        const Columns twice = cross(d, turned.transpose());  // [d] ll [d]^T
        aa += coupling + coupling.transpose();
        aa += Lanes(0.5) * (twice + twice.transpose());
        al += turned;
        moment += cross(d, force);
    }
};

void to_space(const double* sums, double weight, SegmentBlock& s) {
    const Columns frame = Columns::load(s.frame);
    const Lanes w(weight);
    const double* g = sums + kGramSum;
    const double* p = sums + kSecondSum;
    const double gram[9] = {g[0], g[1], g[3], g[1], g[2], g[4], g[3], g[4], g[5]};
    for (int i = 0; i < 9; ++i) s.gram[i] = weight * gram[i];
    product(w * frame, Columns::load(sums + kTurnedSum)).store(s.moment);
    product(w * frame, Columns::load(sums + kJacobianSum)).store(s.force);
    // Inertia: w (tr S - S) about the start, from S = sum p p^T.
    const double trace = weight * (p[0] + p[2] + p[5]);
    const Columns second = {{Lanes(Lanes::Vector{p[0], p[1], p[3], 0}),
                             Lanes(Lanes::Vector{p[1], p[2], p[4], 0}),
                             Lanes(Lanes::Vector{p[3], p[4], p[5], 0})}};
    Columns aa = Lanes(-weight) * outer(product(frame, second), frame);
    for (int i = 0; i < 3; ++i) aa.c[i].v[i] += trace;
    aa.store(s.aa);
    const Lanes first = w * product(frame, Lanes::load(sums + kFirstSum));
    const double x = first.v[0], y = first.v[1], z = first.v[2];
    const double al[9] = {0, z, -y, -z, 0, x, y, -x, 0};
    const double ll[9] = {weight, 0, 0, 0, weight, 0, 0, 0, weight};
    for (int i = 0; i < 9; ++i) {
        s.al[i] = al[i];
        s.ll[i] = ll[i];
    }
    (w * Lanes::load(sums + kLoadSum)).store3(s.load);
    (w * product(frame, Lanes::load(sums + kMomentSum))).store3(s.moment_load);
    (w * product(frame, Lanes::load(sums + kForceSum))).store3(s.force_load);
}

void solve(SegmentBlock* segments, int count, const double* diagonal, const double* load,
           double* x) {
    Composite beyond;
    for (int q = count; q-- > 0;) {
        SegmentBlock& s = segments[q];
        const Columns turn = Columns::load(s.turn), move = Columns::load(s.move);
        const Columns turn_t = turn.transpose(), move_t = move.transpose();
        const Columns angular = product(beyond.aa, turn) + product(beyond.al, move);
        const Columns linear =
            product(beyond.al.transpose(), turn) + product(beyond.ll, move);
        Columns schur = Columns::load(s.gram) + product(turn_t, angular);
        schur += product(move_t, linear);
        for (int i = 0; i < 3; ++i) schur.c[i].v[i] += diagonal[3 * q + i];
        double y[4];
        (product(turn_t, beyond.moment) + product(move_t, beyond.force)).store(y);
        for (int i = 0; i < 3; ++i) y[i] += s.load[i] + load[3 * q + i];
        const Lower l = cholesky(schur);
        const Lanes offset = Lanes::load(s.offset);
        const Columns wl = right_solve(Columns::load(s.force) + linear, l);
        const Columns wa =
            right_solve(Columns::load(s.moment) + angular + cross(offset, linear), l);
        double* z = s.z;
        z[0] = y[0] / l.a;
        z[1] = (y[1] - l.b * z[0]) / l.c;
        z[2] = (y[2] - l.d * z[0] - l.e * z[1]) / l.f;
        wl.store(s.wl);
        wa.store(s.wa);
        const double factor[9] = {l.a, l.b, l.d, 0, l.c, l.e, 0, 0, l.f};
        for (int i = 0; i < 9; ++i) s.factor[i] = factor[i];
        beyond.shift(offset);
        // Subtracting a product of a matrix and its transpose keeps the inertia
        // symmetric; an asymmetry would grow along the strand.
        beyond.aa += Columns::load(s.aa);
        beyond.aa -= outer(wa, wa);
        beyond.al += Columns::load(s.al);
        beyond.al -= outer(wa, wl);
        beyond.ll += Columns::load(s.ll);
        beyond.ll -= outer(wl, wl);
        beyond.moment += Lanes::load(s.moment_load) - product(wa, z[0], z[1], z[2]);
        beyond.force += Lanes::load(s.force_load) - product(wl, z[0], z[1], z[2]);
    }
    Lanes angular, linear;
    for (int q = 0; q < count; ++q) {
        const SegmentBlock& s = segments[q];
        double z[4];
        (Lanes::load(s.z) - product(Columns::load(s.wa).transpose(), angular) -
         product(Columns::load(s.wl).transpose(), linear))
            .store(z);
        double* k = x + 3 * q;
        const double* l = s.factor;
        k[2] = z[2] / l[8];
        k[1] = (z[1] - l[5] * k[2]) / l[4];
        k[0] = (z[0] - l[1] * k[1] - l[2] * k[2]) / l[0];
        linear += cross(angular, Lanes::load(s.offset)) +
                  product(Columns::load(s.move), k[0], k[1], k[2]);
        angular += product(Columns::load(s.turn), k[0], k[1], k[2]);
    }
}

}  // namespace

}  // namespace lancret::LANCRET_SIMD
