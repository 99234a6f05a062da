#include "procedural/expand/intervals.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "procedural/curves/control_points.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

namespace {

/// They are measured against a share of the tolerance, since the rest hold a few that are
/// worse.
constexpr double kSampleShare = 0.6;

/// Radians that an interval may turn: below half a turn, so that a strand can be told
/// from its places and frames.
constexpr double kMaxTurn = 2;

/// Radians that a segment may turn at all.
constexpr double kMaxTurnOfSegment = 1000;

}  // namespace

Vec3f emitted_place(CurveBasis basis, std::span<const Point4f> points,
                    std::span<const Point4f> tangents, std::size_t j, float t) {
    const float r = 1 - t;
    if (basis == CurveBasis::linear) return r * points[j].xyz() + t * points[j + 1].xyz();
    if (basis == CurveBasis::bezier) {
        const auto* p = &points[3 * j];
        return r * r * r * p[0].xyz() + 3 * t * r * (r * p[1].xyz() + t * p[2].xyz()) +
               t * t * t * p[3].xyz();
    }
    if (basis == CurveBasis::catmull_rom) {
        const Vec3f a = points[j].xyz(), b = points[j + 1].xyz(), c = points[j + 2].xyz(),
                    d = points[j + 3].xyz();
        return b + 0.5f * t *
                       ((c - a) +
                        t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * (b - c) + d - a)));
    }
    if (basis == CurveBasis::hermite) {
        return r * r * (1 + 2 * t) * points[j].xyz() +
               t * t * (3 - 2 * t) * points[j + 1].xyz() + t * r * r * tangents[j].xyz() -
               t * t * r * tangents[j + 1].xyz();
    }
    return (r * r * r * points[j].xyz() +
            (4 - 6 * t * t + 3 * t * t * t) * points[j + 1].xyz() +
            (4 - 6 * r * r + 3 * r * r * r) * points[j + 2].xyz() +
            t * t * t * points[j + 3].xyz()) /
           6;
}

double length_over_guides(const Binding& binding, const Guides& guides) {
    if (binding.size() == 0) return 1;
    double length = 0;
    for (int k = 0; k < binding.neighbours; ++k) {
        if (!(binding.weights[k] > 0)) continue;
        length += double(binding.weights[k]) * guide_length(guides, binding.guides[k]);
    }
    return binding.lengths[0] / length;
}

double emission_distance(std::span<const HelixState<float>> states, float ds,
                         CurveBasis basis, Ends ends) {
    const std::uint32_t n = std::uint32_t(states.size()) - 1;
    std::vector<Point4f> points(control_points_of(basis, n)), tangents(points.size());
    if (is_of_hermite(basis)) {
        std::vector<Point4f> places(n + 1);
        tangents.resize(n + 1);
        hermite_points(states, ds, Vec3f::Zero(), {}, places, tangents);
        points_of_hermite(basis, places, tangents, points);
    } else if (basis == CurveBasis::hermite) {
        hermite_points(states, ds, Vec3f::Zero(), {}, points, tangents);
    } else {
        bspline_points(states, ds, Vec3f::Zero(), {}, points, ends);
    }
    float worst = 0;
    for (std::uint32_t j = 0; j < n; ++j) {
        const Vec3f turn =
            rotation_log<float>(states[j].frame.transpose() * states[j + 1].frame);
        const auto look = [&](float t) {
            HelixState<float> at = states[j];
            advance<float>(at, turn / ds, ds * t);
            // The curve's own parameter may run ahead along the strand: only what lies
            // across counts.
            const Vec3f off = emitted_place(basis, points, tangents, j, t) - at.position;
            const Vec3f tangent = at.frame.col(0);
            const float distance = (off - tangent * tangent.dot(off)).norm();
            if (!(distance <= worst)) {
                worst = std::isnan(distance) ? std::numeric_limits<float>::infinity()
                                             : distance;
            }
        };
        look(0.5f);
        // Where its tangents are the same at both ends, and off, the middle is not.
        if (basis == CurveBasis::catmull_rom) look(0.2f), look(0.8f);
    }
    return worst;
}

namespace {

struct Farthest {
    double distance = 0;  ///< cm, from the emitted curve to the strand
    std::size_t child = 0;
};

/// The first of those that are farthest off, among children first, first + 1, ...,
/// last - 1.
Farthest farthest_child(const Binding& binding, const GuideProfiles<float>& profiles,
                        Blend blend, CurveBasis basis, std::size_t first,
                        std::size_t last) {
    using Range = tbb::blocked_range<std::size_t>;
    const auto farther = [](const Farthest& a, const Farthest& b) {
        const bool second =
            b.distance > a.distance || (b.distance == a.distance && b.child < a.child);
        return second ? b : a;
    };
    return cancellable_reduce(
        Range(first, last), Farthest{0, first},
        [&](const Range& range, Farthest worst) {
            std::vector<HelixState<float>> states(std::size_t(profiles.count) + 1);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                synthesize_child<float>(binding, profiles, blend, i, states);
                const float ds = binding.lengths[i] / float(profiles.count);
                worst = farther(
                    worst,
                    {emission_distance(states, ds, basis, traits_of(blend).ends), i});
            }
            return worst;
        },
        farther);
}

}  // namespace

int intervals_within(const Binding& binding, const Guides& guides, Blend blend,
                     double tolerance, CurveBasis basis, int most, double* reached) {
    double turn = 0;
    for (std::size_t i = 0; i < guides.curvatures.size(); ++i) {
        turn = std::max(turn, guides.curvatures[i].norm() * guides.segment_lengths[i]);
    }
    turn *= std::max(1.0, length_over_guides(binding, guides));
    // Also keeps the count of intervals far from what an int can hold.
    if (!(turn <= kMaxTurnOfSegment)) {
        throw InputError(
            fmt::format("a segment turns by {:.3g} radian, more than any hair ({}): fit "
                        "more segments "
                        "or take a smaller length_scale",
                        turn, kMaxTurnOfSegment));
    }
    int n = guides.segments * std::max(1, int(std::ceil(turn / kMaxTurn)));
    const std::size_t sample = std::min(binding.size(), kSampledChildren);
    const double aim = kSampleShare * tolerance;
    Farthest farthest;
    for (;;) {
        const auto profiles = guide_profiles<float>(guides, n);
        const auto among = [&](std::size_t first, std::size_t last) {
            return farthest_child(binding, profiles, blend, basis, first, last);
        };
        // The child that was too far off before most likely is again, and one is enough.
        // A polyline's distance is asked for below.
        const std::size_t worst = farthest.child;
        const bool one_is_enough = farthest.distance > aim && n < most &&
                                   basis != CurveBasis::linear &&
                                   among(worst, worst + 1).distance > aim;
        if (!one_is_enough) farthest = among(0, sample);
        if (n >= most || farthest.distance <= aim) {
            if (reached) *reached = farthest.distance;
            return n;
        }
        // A polyline is off by kappa ds^2 / 8 and may need hundreds. Beyond those that
        // grooms need by themselves a sixteenth more or less is no matter.
        const double more = basis == CurveBasis::linear
                                ? n * (std::sqrt(farthest.distance / aim) - 1)
                            : n < kMaxIntervals ? 0
                                                : n / 16;
        const auto segments = [&](double count) {
            return guides.segments * std::max(1, int(std::ceil(count / guides.segments)));
        };
        n = std::min(n + segments(std::min(more, double(most))), segments(most));
    }
}

}  // namespace lancret
