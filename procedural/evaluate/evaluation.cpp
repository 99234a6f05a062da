#include "procedural/evaluate/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "guides/base/cancel.h"
#include "guides/base/stopwatch.h"
#include "procedural/check/strand.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

namespace {

constexpr double kTurn = 0.5;  ///< radians an interval
constexpr int kMaxIntervals = 512;

/// Children that are timed, and how often.
constexpr std::size_t kTimedChildren = 1000;
constexpr int kTimedRuns = 5;

double seconds_of_run(const HoldOut& taken, const GuideProfiles<float>& profiles,
                      Blend blend, std::size_t children,
                      std::vector<HelixState<float>>& states) {
    const std::size_t all = taken.binding.size();
    Stopwatch watch;
    for (std::size_t i = 0; i < children; ++i) {
        synthesize_child<float>(taken.binding, profiles, blend, i * all / children,
                                states);
    }
    return watch.lap();
}

double ns_per_point(const HoldOut& taken, const GuideProfiles<float>& profiles,
                    Blend blend) {
    const std::size_t children = std::min(taken.binding.size(), kTimedChildren);
    std::vector<HelixState<float>> states(profiles.count + 1);
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < kTimedRuns; ++run) {
        least = std::min(least, seconds_of_run(taken, profiles, blend, children, states));
    }
    return least * 1e9 / double(children * states.size());
}

}  // namespace

int evaluation_intervals(const Guides& guides) {
    std::vector<double> turns;
    turns.reserve(guides.curvatures.size());
    for (std::size_t i = 0; i < guides.curvatures.size(); ++i) {
        turns.push_back(guides.curvatures[i].norm() * guides.segment_lengths[i]);
    }
    const int segments = guides.segments;
    const double most = std::min(double(kMaxIntervals), quantile(turns, 0.99) / kTurn);
    const int for_turn = std::max(1, int(std::ceil(most)));
    const int for_places = (kCompareSteps + segments - 1) / segments;
    const int within = std::max(1, kMaxIntervals / segments);
    return segments * std::max(for_places, std::min(for_turn, within));
}

Prediction predict(const HoldOut& taken, const GuideProfiles<float>& profiles,
                   Blend blend) {
    const std::size_t children = taken.binding.size(), n = profiles.count;
    constexpr std::size_t kPlaces = kCompareSteps + 1;
    Prediction out;
    out.strands.steps = kCompareSteps;
    out.strands.points.resize(children * kPlaces);
    out.tangents.resize(children * kPlaces);
    out.length_errors.resize(children);
    using Range = tbb::blocked_range<std::size_t>;
    cancellable_for(Range(0, children, 64), [&](const Range& range) {
        std::vector<HelixState<float>> states(n + 1);
        for (std::size_t c = range.begin(); c < range.end(); ++c) {
            synthesize_child<float>(taken.binding, profiles, blend, c, states);
            const Vec3 root = taken.binding.roots.positions[c].cast<double>();
            const auto points = out.strands.strand(c);
            for (std::size_t j = 0; j < kPlaces; ++j) {
                // The place at share j / kCompareSteps, on the helix of its interval
                // where it is not a state itself.
                const std::size_t i = j * n / kCompareSteps, rest = j * n % kCompareSteps;
                HelixState<float> state = states[i];
                points[j] = state.position.cast<double>();
                if (rest > 0) {
                    const double t = double(rest) / kCompareSteps;
                    const MeasuredInterval m = measured_interval(state, states[i + 1]);
                    points[j] = place_on(state, m, t);
                    const Eigen::AngleAxisd turn(t * m.angle, m.axis);
                    state.frame = state.frame * turn.toRotationMatrix().cast<float>();
                }
                points[j] += root;
                out.tangents[c * kPlaces + j] = state.frame.col(0);
                if (!points[j].allFinite()) {
                    throw std::runtime_error(
                        fmt::format("blend {}: child {} has a place that is not finite",
                                    blend_name(blend), c));
                }
            }
            double length = 0;
            for (std::size_t i = 0; i < n; ++i) {
                length += measured_interval(states[i], states[i + 1]).length;
            }
            out.length_errors[c] = length / double(taken.binding.lengths[c]) - 1;
        }
    });
    return out;
}

BlendEvaluation evaluate_blend(const HoldOut& taken, const GuideProfiles<float>& profiles,
                               Blend blend) {
    const Prediction made = predict(taken, profiles, blend);
    BlendEvaluation out;
    out.blend = blend;
    out.figures = strand_figures(taken.truth, taken.lengths, made.strands);
    for (const double error : made.length_errors) {
        out.length_error_mean += std::abs(error) / double(made.length_errors.size());
        out.length_error_max = std::max(out.length_error_max, std::abs(error));
    }
    out.ns_per_point = ns_per_point(taken, profiles, blend);
    return out;
}

}  // namespace lancret
