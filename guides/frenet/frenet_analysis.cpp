#include "guides/frenet/frenet_analysis.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "guides/strand/rotation_minimizing.h"

namespace lancret {

namespace {

std::vector<Vec3> tangents_of(std::span<const CurvePoint> samples) {
    // Places without a speed take the tangent of the previous one; those before the first
    // with a speed take that one's.
    const auto moving = std::find_if(samples.begin(), samples.end(), [](const auto& x) {
        return x.d1.squaredNorm() > 0;
    });
    Vec3 tangent =
        moving == samples.end() ? Vec3(Vec3::UnitX()) : Vec3(moving->d1.normalized());
    std::vector<Vec3> tangents;
    for (const CurvePoint& x : samples) {
        if (x.d1.squaredNorm() > 0) tangent = x.d1.normalized();  // [TW99, Eq. 39]
        tangents.push_back(tangent);
    }
    return tangents;
}

/// The vector kappa N [TW99, Eq. 40]. Its projector uses the tangent of the place itself
/// (Eq. 44 prints that of the previous place). Zero if the speed is.
Vec3 bending(const CurvePoint& x, const Vec3& tangent) {
    const double speed2 = x.d1.squaredNorm();
    if (speed2 == 0) return Vec3::Zero();
    return (x.d2 - tangent * tangent.dot(x.d2)) / speed2;
}

/// For each place the index of the nearest one that bends, the earlier of two; its own if
/// nothing bends.
std::vector<std::size_t> nearest_bends(const std::vector<double>& bend,
                                       const std::vector<double>& at, double least) {
    const std::size_t n = bend.size();
    std::vector<std::size_t> nearest(n);
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < n; ++i) {
        if (bend[i] > least) last = i;
        nearest[i] = last.value_or(n);
    }
    last.reset();
    for (std::size_t i = n; i-- > 0;) {
        if (bend[i] > least) last = i;
        if (!last) {
            nearest[i] = nearest[i] == n ? i : nearest[i];
        } else if (nearest[i] == n || at[*last] - at[i] < at[i] - at[nearest[i]]) {
            nearest[i] = *last;
        }
    }
    return nearest;
}

/// N about the tangent at every place, as an angle in the rotation-minimising frame.
struct NormalAngles {
    std::vector<double> angle;    ///< radian; continuous except over straight stretches
    std::vector<double> bending;  ///< signed kappa, 1/cm; 0 where straight
};

NormalAngles normal_angles(const std::vector<Vec3>& bends,
                           const std::vector<Mat3>& carried,
                           const std::vector<double>& at, double straight_turn) {
    const std::size_t n = bends.size();
    // In a strand without length no place bends.
    const double least = straight_turn / at.back();
    NormalAngles out{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    std::vector<double> size(n);
    std::optional<double> last;
    for (std::size_t i = 0; i < n; ++i) {
        size[i] = bends[i].norm();
        if (!(size[i] > least)) continue;
        const double angle =
            std::atan2(carried[i].col(2).dot(bends[i]), carried[i].col(1).dot(bends[i]));
        // The side of N is free, so it turns by the smallest angle modulo pi.
        out.angle[i] = last ? *last + std::remainder(angle - *last, kPi) : angle;
        out.bending[i] = std::cos(angle - out.angle[i]) < 0 ? -size[i] : size[i];
        last = out.angle[i];
    }
    const std::vector<std::size_t> nearest = nearest_bends(size, at, least);
    for (std::size_t i = 0; i < n; ++i) out.angle[i] = out.angle[nearest[i]];
    return out;
}

}  // namespace

std::vector<FrenetPoint> frenet_points(std::span<const CurvePoint> samples,
                                       const Vec3& hint, double straight_turn) {
    if (samples.empty()) return {};
    const std::vector<Vec3> tangents = tangents_of(samples);
    std::vector<Vec3> positions, bends;
    std::vector<double> at{0};  // summed length of the chords
    for (std::size_t i = 0; i < samples.size(); ++i) {
        positions.push_back(samples[i].position);
        bends.push_back(bending(samples[i], tangents[i]));
        if (i > 0) at.push_back(at.back() + (positions[i] - positions[i - 1]).norm());
    }
    const std::vector<Mat3> carried =
        rotation_minimizing_frames(positions, tangents, hint);
    const NormalAngles normals = normal_angles(bends, carried, at, straight_turn);
    std::vector<FrenetPoint> points(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double angle = normals.angle[i], kappa = normals.bending[i];
        const Vec3 normal =
            std::cos(angle) * carried[i].col(1) + std::sin(angle) * carried[i].col(2);
        points[i].state = {frame_from_normal(normal, tangents[i]), positions[i]};
        points[i].rates.curvature = kappa;
        if (kappa == 0) continue;
        // [TW99, Eq. 41]: kappa tau is the share of B in x''' / |x'|^3.
        const double speed = samples[i].d1.norm();
        points[i].rates.torsion = points[i].state.frame.col(2).dot(samples[i].d3) /
                                  (speed * speed * speed * kappa);
    }
    return points;
}

FrenetProfile profile_of_points(std::span<const FrenetPoint> points,
                                std::span<const double> steps) {
    if (points.size() != steps.size() + 1) {
        throw std::invalid_argument(
            "profile_of_points: expected one point more than steps");
    }
    FrenetProfile profile{points[0].state, {steps.begin(), steps.end()}, {}};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const FrenetRates &a = points[i].rates, &b = points[i + 1].rates;
        profile.rates.push_back(
            {(a.curvature + b.curvature) / 2, (a.torsion + b.torsion) / 2});
    }
    return profile;
}

FrenetProfile analyze(const Curve& curve, int n, const Vec3& hint, FrenetMethod method,
                      double straight_turn) {
    if (n < 1) throw std::invalid_argument("analyze: expected at least one interval");
    // N is tracked at `fine` places per interval; only every fine-th is kept.
    const int fine = std::max(1, (4 * int(curve.pieces.size()) + n - 1) / n);
    const double ds = curve.length() / n;
    std::vector<CurvePoint> samples;
    for (int i = 0; i <= n * fine; ++i) {
        samples.push_back(evaluate(curve, parameter_at(curve, ds * i / fine)));
    }
    const auto tracked = frenet_points(samples, hint, straight_turn);

    const std::vector<double> steps(n, ds);
    std::vector<FrenetPoint> points;
    for (int i = 0; i <= n; ++i) points.push_back(tracked[std::size_t(i) * fine]);
    if (method == FrenetMethod::point_values) return profile_of_points(points, steps);

    std::vector<HelixState<double>> fine_states, states;
    for (const FrenetPoint& p : tracked) fine_states.push_back(p.state);
    for (const FrenetPoint& p : points) states.push_back(p.state);
    const std::vector<double> fine_steps(std::size_t(n) * fine, ds / fine);
    const FrenetProfile detail = profile_of_frames(fine_states, fine_steps);
    std::vector<FrenetRates> expected(n);
    for (std::size_t i = 0; i < detail.size(); ++i) {
        expected[i / fine].curvature += detail.rates[i].curvature / fine;
        expected[i / fine].torsion += detail.rates[i].torsion / fine;
    }
    return profile_of_frames(states, steps, expected);
}

}  // namespace lancret
