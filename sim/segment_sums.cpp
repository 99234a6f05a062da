#include "sim/segment_sums.h"

#include <array>

#include "sim/gauss_legendre.h"
#include "sim/lanes.h"
#include "sim/segment_kernel.h"

namespace lancret {

namespace {

using Vec3L = std::array<Lanes, 3>;

int halvings_of(const SegmentQuadrature& s) {
    return stumpff_halvings(s.length * s.length * s.darboux.squaredNorm());
}

Vec3L spread(const Vec3& v) { return {Lanes(v.x()), Lanes(v.y()), Lanes(v.z())}; }

Vec3L operator+(const Vec3L& a, const Vec3L& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec3L operator*(Lanes s, const Vec3L& a) { return {s * a[0], s * a[1], s * a[2]}; }

Vec3L cross(const Vec3L& a, const Vec3L& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}

/// The matrix times the vectors.
Vec3L turned(const Mat3& m, const Vec3L& v) {
    const auto row = [&](int i) {
        return Lanes(m(i, 0)) * v[0] + Lanes(m(i, 1)) * v[1] + Lanes(m(i, 2)) * v[2];
    };
    return {row(0), row(1), row(2)};
}

/// The targets from the places, in the segment's frame.
Vec3L residual(const SegmentQuadrature& s, const Mat3& to_frame, int i, const Lanes* p) {
    const Vec3L away = {Lanes::load(s.targets.x + i) - Lanes(s.start.x()),
                        Lanes::load(s.targets.y + i) - Lanes(s.start.y()),
                        Lanes::load(s.targets.z + i) - Lanes(s.start.z())};
    const Vec3L local = turned(to_frame, away);
    return {local[0] - p[0], local[1] - p[1], local[2] - p[2]};
}

void store(const Vec3L& v, double* to, std::size_t stride, int i) {
    for (int c = 0; c < 3; ++c) v[c].store(to + c * stride + i);
}

/// The vectors that p, p' and p'' are sums of, with factors that depend on u alone.
struct RateVectors {
    Vec3 turn, turn_rate;       ///< K e0, k' x e0
    Vec3 square, cross, rates;  ///< K^2 e0, its derivative by k', its second one
    double along, speed;        ///< k . k', |k'|^2

    RateVectors(const Vec3& k, const Vec3& rate) {
        const Vec3 e0 = Vec3::UnitX();
        turn = k.cross(e0);
        turn_rate = rate.cross(e0);
        square = k.x() * k - k.squaredNorm() * e0;
        along = k.dot(rate);
        speed = rate.squaredNorm();
        cross = k.x() * rate + rate.x() * k - 2 * along * e0;
        rates = 2 * (rate.x() * rate - speed * e0);
    }
};

/// p at arc length u.
Vec3L place(const RateVectors& r, const Lanes& u, const Stumpff<Lanes>& c) {
    const Lanes a2 = u * u * c.c2, a3 = u * u * u * c.c3;
    return {u + a3 * Lanes(r.square.x()),
            a2 * Lanes(r.turn.y()) + a3 * Lanes(r.square.y()),
            a2 * Lanes(r.turn.z()) + a3 * Lanes(r.square.z())};
}

/// p' = J k' at arc length u.
Vec3L relative_velocity(const RateVectors& r, const Lanes& u, const Stumpff<Lanes>& c) {
    const Lanes u2 = u * u, u3 = u2 * u, u4 = u2 * u2;
    const Lanes d2 = u4 * (Lanes(2.) * c.c4 - c.c3);
    const Lanes d3 = u4 * u * (Lanes(3.) * c.c5 - c.c4);
    return (u2 * c.c2) * spread(r.turn_rate) + (u3 * c.c3) * spread(r.cross) +
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
           (Lanes(2.) * along * d3) * spread(r.cross) + (u3 * c.c3) * spread(r.rates);
}

}  // namespace

SegmentSums segment_sums(const SegmentQuadrature& segment) {
    const GaussRule rule = gauss_rule(segment.points);
    const int halvings = halvings_of(segment);
    const Mat3 to_frame = segment.frame.transpose();
    Lanes gram[6], turned_jacobian[9], jacobian[9], second[6], first[3];
    Lanes load[3], moment[3], force[3], half_square;
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes w = Lanes::load(&rule.weights[i]);
        const auto [p, j] = segment_point<Lanes>(
            segment.darboux.data(), Lanes(segment.length) * Lanes::load(&rule.nodes[i]),
            halvings);
        const Vec3L e = residual(segment, to_frame, i, p);
        const Vec3L wp = {w * p[0], w * p[1], w * p[2]};
        const Vec3L we = {w * e[0], w * e[1], w * e[2]};
        for (int c = 0, n = 0; c < 3; ++c) {
            const Lanes wj[3] = {w * j[0][c], w * j[1][c], w * j[2][c]};
            for (int d = 0; d <= c; ++d, ++n) {
                gram[n] += wj[0] * j[0][d] + wj[1] * j[1][d] + wj[2] * j[2][d];
                second[n] += wp[c] * p[d];
            }
            for (int r = 0; r < 3; ++r) {
                jacobian[3 * c + r] += wj[r];
                const int s = (r + 1) % 3, t = (r + 2) % 3;
                turned_jacobian[3 * c + r] += wp[s] * j[t][c] - wp[t] * j[s][c];
            }
            load[c] += wj[0] * e[0] + wj[1] * e[1] + wj[2] * e[2];
            first[c] += wp[c];
            force[c] += we[c];
            const int s = (c + 1) % 3, t = (c + 2) % 3;
            moment[c] += wp[s] * e[t] - wp[t] * e[s];
            half_square += we[c] * e[c];
        }
    }
    SegmentSums out;
    for (int c = 0, n = 0; c < 3; ++c) {
        for (int d = 0; d <= c; ++d, ++n) {
            out.gram(c, d) = out.gram(d, c) = gram[n].sum();
            out.second(c, d) = out.second(d, c) = second[n].sum();
        }
        for (int r = 0; r < 3; ++r) {
            out.jacobian(r, c) = jacobian[3 * c + r].sum();
            out.turned_jacobian(r, c) = turned_jacobian[3 * c + r].sum();
        }
        out.first[c] = first[c].sum();
        out.load[c] = load[c].sum();
        out.moment[c] = moment[c].sum();
        out.force[c] = force[c].sum();
    }
    out.half_square = half_square.sum() / 2;
    return out;
}

double segment_half_square(const SegmentQuadrature& segment) {
    const GaussRule rule = gauss_rule(segment.points);
    const int halvings = halvings_of(segment);
    const Mat3 to_frame = segment.frame.transpose();
    Lanes sum;
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const auto point = segment_point<Lanes>(
            segment.darboux.data(), Lanes(segment.length) * Lanes::load(&rule.nodes[i]),
            halvings);
        const Vec3L e = residual(segment, to_frame, i, point.p);
        const Lanes square = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        sum += Lanes::load(&rule.weights[i]) * square;
    }
    return sum.sum() / 2;
}

void segment_places(const SegmentQuadrature& segment, double* places,
                    std::size_t stride) {
    const GaussRule rule = gauss_rule(segment.points);
    const int halvings = halvings_of(segment);
    const Lanes square(segment.darboux.squaredNorm());
    const RateVectors fixed(segment.darboux, Vec3::Zero());
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = Lanes(segment.length) * Lanes::load(&rule.nodes[i]);
        const auto c = stumpff_functions<Lanes>(u * u * square, halvings);
        store(spread(segment.start) + turned(segment.frame, place(fixed, u, c)), places,
              stride, i);
    }
}

void segment_velocities(const SegmentQuadrature& segment, const SegmentMotion& motion,
                        double* velocities, std::size_t stride) {
    const GaussRule rule = gauss_rule(segment.points);
    const int halvings = halvings_of(segment);
    const Lanes square(segment.darboux.squaredNorm());
    const RateVectors rates(segment.darboux, motion.rates);
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = Lanes(segment.length) * Lanes::load(&rule.nodes[i]);
        const auto c = stumpff_functions<Lanes>(u * u * square, halvings);
        const Vec3L d = turned(segment.frame, place(rates, u, c));
        const Vec3L relative = turned(segment.frame, relative_velocity(rates, u, c));
        store(spread(motion.velocity) + cross(spread(motion.angular_velocity), d) +
                  relative,
              velocities, stride, i);
    }
}

void segment_bias(const SegmentQuadrature& segment, const SegmentMotion& motion,
                  const Vec3& acceleration, const Vec3& angular_acceleration,
                  double* bias, std::size_t stride) {
    const GaussRule rule = gauss_rule(segment.points);
    const int halvings = halvings_of(segment);
    const RateVectors rates(segment.darboux, motion.rates);
    const Lanes square(segment.darboux.squaredNorm());
    const Vec3L omega = spread(motion.angular_velocity);
    for (int i = 0; i < segment.points; i += Lanes::kCount) {
        const Lanes u = Lanes(segment.length) * Lanes::load(&rule.nodes[i]);
        StumpffTail<Lanes> tail;
        const auto c = stumpff_functions<Lanes>(u * u * square, halvings, tail);
        const Vec3L d = turned(segment.frame, place(rates, u, c));
        const Vec3L relative = turned(segment.frame, relative_velocity(rates, u, c));
        const Vec3L own = turned(segment.frame, relative_bias(rates, u, c, tail));
        store(spread(acceleration) + cross(spread(angular_acceleration), d) +
                  cross(omega, cross(omega, d) + Lanes(2.) * relative) + own,
              bias, stride, i);
    }
}

}  // namespace lancret
