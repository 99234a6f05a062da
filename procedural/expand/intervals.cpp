#include "procedural/expand/intervals.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/worst.h"
#include "procedural/curves/emitted_curve.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

namespace {

/// The largest turn of a segment that is accepted, radians.
constexpr double kMaxTurnOfSegment = 1000;

}  // namespace

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
    StrandBuffer curve;
    emit({.states = states, .ds = ds, .ends = ends}, basis, curve);
    float worst = 0;
    for (std::size_t j = 0; j + 1 < states.size(); ++j) {
        const Vec3f turn =
            rotation_log<float>(states[j].frame.transpose() * states[j + 1].frame);
        const auto measure = [&](float t) {
            HelixState<float> at = states[j];
            advance<float>(at, turn / ds, ds * t);
            // Only what lies across the strand counts: the curve's parameter may run
            // ahead along it.
            const Vec3f off =
                emitted_place(basis, curve.points, curve.tangents, j, t) - at.position;
            const Vec3f tangent = at.frame.col(0);
            worst = worst_of(worst, (off - tangent * tangent.dot(off)).norm());
        };
        measure(0.5f);
        // If its tangents are off by the same amount at both ends, the middle is not off.
        if (basis == CurveBasis::catmull_rom) {
            measure(0.2f);
            measure(0.8f);
        }
    }
    return worst;
}

namespace {

struct Farthest {
    double distance = 0;  ///< cm, from the emitted curve to the strand
    std::size_t child = 0;
};

/// The child with the largest distance among [first, last), the first if several share
/// it.
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

FoundIntervals intervals_within(const Binding& binding, const Guides& guides, Blend blend,
                                double tolerance, CurveBasis basis, int max_count) {
    double turn = 0;
    for (std::size_t i = 0; i < guides.curvatures.size(); ++i) {
        turn = std::max(turn, guides.curvatures[i].norm() * guides.segment_lengths[i]);
    }
    turn *= std::max(1.0, length_over_guides(binding, guides));
    // Also keeps the number of intervals well within an int.
    if (!(turn <= kMaxTurnOfSegment)) {
        throw InputError(
            fmt::format("a segment turns by {:.3g} radians, more than any hair ({}): fit "
                        "more segments or use a smaller length_scale",
                        turn, kMaxTurnOfSegment));
    }
    int n = guides.segments * std::max(1, int(std::ceil(turn / kMaxTurn)));
    const std::size_t sample = std::min(binding.size(), kSampledChildren);
    const double aim = kSampleShare * tolerance;
    Farthest farthest;
    for (;;) {
        const auto profiles = guide_profiles<float>(guides, n);
        const auto farthest_among = [&](std::size_t first, std::size_t last) {
            return farthest_child(binding, profiles, blend, basis, first, last);
        };
        // The child that was too far off before probably still is, and one such child is
        // enough for another step. A polyline's next count depends on the largest
        // distance.
        const std::size_t worst = farthest.child;
        const bool one_is_enough = farthest.distance > aim && n < max_count &&
                                   basis != CurveBasis::linear &&
                                   farthest_among(worst, worst + 1).distance > aim;
        if (!one_is_enough) farthest = farthest_among(0, sample);
        if (n >= max_count || farthest.distance <= aim) return {n, farthest.distance};
        // A polyline is off by kappa ds^2 / 8 and may need hundreds of intervals. Above
        // kMaxIntervals steps of a sixteenth are fine enough.
        const double more = basis == CurveBasis::linear
                                ? n * (std::sqrt(farthest.distance / aim) - 1)
                            : n < kMaxIntervals ? 0
                                                : n / 16;
        const auto segments = [&](double count) {
            return guides.segments * std::max(1, int(std::ceil(count / guides.segments)));
        };
        n = std::min(n + segments(std::min(more, double(max_count))),
                     segments(max_count));
    }
}

}  // namespace lancret
