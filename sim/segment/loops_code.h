#pragma once
// The loops of loops.h for the registers that LANCRET_SIMD names. Included only by
// loops_plain.cpp and loops_wide.cpp.

#include <array>
#include <cstddef>

#include "sim/segment/kernel.h"
#include "sim/segment/lanes.h"
#include "sim/segment/loops.h"
// Last: it uses the indices of the sums.
#include "sim/segment/recursion_code.h"

namespace lancret::LANCRET_SIMD {

namespace {

using Vec3L = std::array<Lanes, 3>;

Vec3L spread(const double* v) { return {Lanes(v[0]), Lanes(v[1]), Lanes(v[2])}; }

Vec3L operator+(const Vec3L& a, const Vec3L& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec3L operator*(Lanes s, const Vec3L& a) { return {s * a[0], s * a[1], s * a[2]}; }

Vec3L cross(const Vec3L& a, const Vec3L& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}

/// The matrix m, stored by columns, times the vectors.
Vec3L turned(const double* m, const Vec3L& v) {
    const auto row = [&](int i) {
        return Lanes(m[i]) * v[0] + Lanes(m[3 + i]) * v[1] + Lanes(m[6 + i]) * v[2];
    };
    return {row(0), row(1), row(2)};
}

/// The transpose of the matrix m times the vectors.
Vec3L turned_back(const double* m, const Vec3L& v) {
    const auto column = [&](int i) {
        return Lanes(m[3 * i]) * v[0] + Lanes(m[3 * i + 1]) * v[1] +
               Lanes(m[3 * i + 2]) * v[2];
    };
    return {column(0), column(1), column(2)};
}

/// Targets minus positions, in the segment's frame.
Vec3L residual(const SegmentLoop& s, int i, const Lanes* p) {
    const Vec3L local =
        turned_back(s.frame, {Lanes::load(s.targets.x + i) - Lanes(s.start[0]),
                              Lanes::load(s.targets.y + i) - Lanes(s.start[1]),
                              Lanes::load(s.targets.z + i) - Lanes(s.start[2])});
    return {local[0] - p[0], local[1] - p[1], local[2] - p[2]};
}

void store(const Vec3L& v, double* to, std::size_t stride, int i) {
    for (std::size_t c = 0; c < 3; ++c) v[c].store(to + c * stride + i);
}

Lanes arc(const SegmentLoop& s, int i) {
    return Lanes(s.length) * Lanes::load(s.nodes + i);
}

Lanes square_of_curvature(const SegmentLoop& s) {
    const double* k = s.darboux;
    return Lanes(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
}

/// p at arc length u.
Vec3L position(const RateVectors& r, const Lanes& u, const Stumpff<Lanes>& c) {
    const Lanes a2 = u * u * c.c2, a3 = u * u * u * c.c3;
    return {u + a3 * Lanes(r.square[0]), a2 * Lanes(r.turn[1]) + a3 * Lanes(r.square[1]),
            a2 * Lanes(r.turn[2]) + a3 * Lanes(r.square[2])};
}

/// p' = J k' at arc length u.
Vec3L relative_velocity(const RateVectors& r, const Lanes& u, const Stumpff<Lanes>& c) {
    const Lanes u2 = u * u, u3 = u2 * u, u4 = u2 * u2;
    const Lanes d2 = u4 * (Lanes(2.) * c.c4 - c.c3);
    const Lanes d3 = u4 * u * (Lanes(3.) * c.c5 - c.c4);
    return (u2 * c.c2) * spread(r.turn_rate) + (u3 * c.c3) * spread(r.square_rate) +
           (Lanes(r.along) * d2) * spread(r.turn) +
           (Lanes(r.along) * d3) * spread(r.square);
}

/// p'' = D^2 p [k', k'] at arc length u.
Vec3L relative_bias(const RateVectors& r, const Lanes& u, const Stumpff<Lanes>& c,
                    const StumpffTail<Lanes>& tail) {
    const Lanes u2 = u * u, u3 = u2 * u, u4 = u2 * u2;
    const Lanes slope4 = Lanes(4.) * tail.c6 - c.c5;
    const Lanes d2 = u4 * (Lanes(2.) * c.c4 - c.c3);
    const Lanes d3 = u4 * u * (Lanes(3.) * c.c5 - c.c4);
    const Lanes dd2 = u4 * u2 * (Lanes(2.) * slope4 - (Lanes(3.) * c.c5 - c.c4));
    const Lanes dd3 = u4 * u3 * (Lanes(3.) * (Lanes(5.) * tail.c7 - tail.c6) - slope4);
    const Lanes along(r.along), along2(r.along * r.along), speed(r.speed);
    return (dd2 * along2 + d2 * speed) * spread(r.turn) +
           (Lanes(2.) * along * d2) * spread(r.turn_rate) +
           (dd3 * along2 + d3 * speed) * spread(r.square) +
           (Lanes(2.) * along * d3) * spread(r.square_rate) +
           (u3 * c.c3) * spread(r.rates);
}

void sums(const SegmentLoop& segment, double* out) {
    Lanes sum[kSegmentSums];
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes w = Lanes::load(segment.weights + i);
        const auto [p, j] =
            segment_point<Lanes>(segment.darboux, arc(segment, i), segment.halvings);
        const Vec3L e = residual(segment, i, p);
        const Vec3L wp = {w * p[0], w * p[1], w * p[2]};
        const Vec3L we = {w * e[0], w * e[1], w * e[2]};
        for (int c = 0, n = 0; c < 3; ++c) {
            const Lanes wj[3] = {w * j[0][c], w * j[1][c], w * j[2][c]};
            for (int d = 0; d <= c; ++d, ++n) {
                sum[kGramSum + n] += wj[0] * j[0][d] + wj[1] * j[1][d] + wj[2] * j[2][d];
                sum[kSecondSum + n] += wp[std::size_t(c)] * p[d];
            }
            for (int r = 0; r < 3; ++r) {
                const int s = (r + 1) % 3, t = (r + 2) % 3;
                sum[kJacobianSum + 3 * c + r] += wj[r];
                sum[kTurnedSum + 3 * c + r] += p[s] * wj[t] - p[t] * wj[s];
            }
            const auto at = std::size_t(c), s = (at + 1) % 3, t = (at + 2) % 3;
            sum[kFirstSum + c] += wp[at];
            sum[kLoadSum + c] += wj[0] * e[0] + wj[1] * e[1] + wj[2] * e[2];
            sum[kMomentSum + c] += wp[s] * e[t] - wp[t] * e[s];
            sum[kForceSum + c] += we[at];
            sum[kSquareSum] += we[at] * e[at];
        }
    }
    for (int n = 0; n < kSegmentSums; n += 4) {
        Lanes::sums(sum[n], sum[n + 1], sum[n + 2], sum[n + 3]).store(out + n);
    }
}

void positions(const SegmentLoop& segment, const RateVectors& fixed, double* out,
               std::size_t stride) {
    const Lanes square = square_of_curvature(segment);
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = arc(segment, i);
        const auto c = stumpff_functions<Lanes>(u * u * square, segment.halvings);
        store(spread(segment.start) + turned(segment.frame, position(fixed, u, c)), out,
              stride, i);
    }
}

void velocities(const SegmentLoop& segment, const RateVectors& rates,
                const StartMotion& start, double* out, std::size_t stride) {
    const Lanes square = square_of_curvature(segment);
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = arc(segment, i);
        const auto c = stumpff_functions<Lanes>(u * u * square, segment.halvings);
        const Vec3L d = turned(segment.frame, position(rates, u, c));
        const Vec3L relative = turned(segment.frame, relative_velocity(rates, u, c));
        store(
            spread(start.velocity) + cross(spread(start.angular_velocity), d) + relative,
            out, stride, i);
    }
}

void bias(const SegmentLoop& segment, const RateVectors& rates, const StartMotion& start,
          double* out, std::size_t stride) {
    const Lanes square = square_of_curvature(segment);
    const Vec3L omega = spread(start.angular_velocity);
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = arc(segment, i);
        StumpffTail<Lanes> tail;
        const auto c = stumpff_functions<Lanes>(u * u * square, segment.halvings, tail);
        const Vec3L d = turned(segment.frame, position(rates, u, c));
        const Vec3L relative = turned(segment.frame, relative_velocity(rates, u, c));
        const Vec3L bending = turned(segment.frame, relative_bias(rates, u, c, tail));
        store(spread(start.acceleration) + cross(spread(start.angular_acceleration), d) +
                  cross(omega, cross(omega, d) + Lanes(2.) * relative) + bending,
              out, stride, i);
    }
}

constexpr SegmentLoops kLoops = {sums, to_space, solve, positions, velocities, bias};

}  // namespace

}  // namespace lancret::LANCRET_SIMD
