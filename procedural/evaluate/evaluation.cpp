#include "procedural/evaluate/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "guides/base/cancel.h"
#include "guides/base/stopwatch.h"
#include "procedural/check/strand.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

namespace {

constexpr double kMaxTurn = 0.5;  ///< radians per interval
constexpr int kMaxIntervals = 512;

using States = std::span<const HelixState<float>>;

/// The place at the share j / kCompareSteps of a strand, relative to its root. If it lies
/// between two states, `state` is turned and moved along the helix between them.
Vec3 sample_place(States states, std::size_t j, HelixState<float>& state) {
    const std::size_t n = states.size() - 1;
    const std::size_t i = j * n / kCompareSteps, rest = j * n % kCompareSteps;
    state = states[i];
    if (rest == 0) return state.position.cast<double>();
    const double t = double(rest) / kCompareSteps;
    const MeasuredInterval m = measured_interval(state, states[i + 1]);
    const Vec3 out = place_on(state, m, t);
    const Eigen::AngleAxisd turn(t * m.angle, m.axis);
    state.frame = state.frame * turn.toRotationMatrix().cast<float>();
    return out;
}

double synthesised_length(States states) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        length += measured_interval(states[i], states[i + 1]).length;
    }
    return length;
}

/// Time per place of batches of children that are spread evenly over all of them.
double ns_per_point(const SynthesisInput& in) {
    constexpr std::size_t kBatch = 64, kMaxBatches = 16;
    constexpr int kRuns = 5;
    const std::size_t all = in.binding.size(), batch = std::min(kBatch, all);
    const std::size_t batches = std::min(all / batch, kMaxBatches);
    std::vector<HelixState<float>> states(batch * (std::size_t(in.profiles.count) + 1));
    double fastest = std::numeric_limits<double>::infinity();
    for (int run = 0; run < kRuns; ++run) {
        Stopwatch watch;
        for (std::size_t b = 0; b < batches; ++b) {
            const std::size_t first =
                b * (all - batch) / std::max<std::size_t>(1, batches - 1);
            synthesize(in, first, batch, states);
        }
        fastest = std::min(fastest, watch.lap());
    }
    return fastest * 1e9 / double(batches * states.size());
}

Prediction predict(const SynthesisInput& in) {
    constexpr std::size_t kPlaces = kCompareSteps + 1;
    const Binding& binding = in.binding;
    const std::size_t children = binding.size();
    Prediction out;
    out.strands.steps = kCompareSteps;
    out.strands.points.resize(children * kPlaces);
    out.tangents.resize(children * kPlaces);
    out.length_errors.resize(children);
    const auto sample = [&](std::size_t c, States states) {
        const Vec3 root = binding.roots.positions[c].cast<double>();
        const auto points = out.strands.strand(c);
        HelixState<float> state;
        for (std::size_t j = 0; j < kPlaces; ++j) {
            points[j] = sample_place(states, j, state) + root;
            out.tangents[c * kPlaces + j] = state.frame.col(0);
            if (!points[j].allFinite()) {
                throw std::runtime_error(
                    fmt::format("blend {}: child {} has a place that is not finite",
                                blend_name(in.blend), c));
            }
        }
        out.length_errors[c] =
            synthesised_length(states) / double(binding.lengths[c]) - 1;
    };
    using Range = tbb::blocked_range<std::size_t>;
    cancellable_for(Range(0, children, 64), [&](const Range& range) {
        each_strand(in, range.begin(), range.end(), sample);
    });
    return out;
}

}  // namespace

int evaluation_intervals(const Guides& guides) {
    std::vector<double> turns;
    turns.reserve(guides.curvatures.size());
    for (std::size_t i = 0; i < guides.curvatures.size(); ++i) {
        turns.push_back(guides.curvatures[i].norm() * guides.segment_lengths[i]);
    }
    const int segments = guides.segments;
    const double intervals =
        std::min(double(kMaxIntervals), quantile(turns, 0.99) / kMaxTurn);
    const int for_turn = std::max(1, int(std::ceil(intervals)));
    const int for_places = (kCompareSteps + segments - 1) / segments;
    const int limit = std::max(1, kMaxIntervals / segments);
    return segments * std::max(for_places, std::min(for_turn, limit));
}

Prediction predict(const HoldOut& holdout, const GuideProfiles<float>& profiles,
                   Blend blend) {
    const KernelGuides kernel =
        kernel_guides(profiles, holdout.binding.guide_normals, blend);
    return predict({holdout.binding, profiles, kernel, blend});
}

BlendEvaluation evaluate_blend(const HoldOut& holdout,
                               const GuideProfiles<float>& profiles, Blend blend) {
    const KernelGuides kernel =
        kernel_guides(profiles, holdout.binding.guide_normals, blend);
    const SynthesisInput in{holdout.binding, profiles, kernel, blend};
    const Prediction made = predict(in);
    BlendEvaluation out;
    out.blend = blend;
    out.figures = strand_figures(holdout.truth, holdout.lengths, made.strands);
    for (const double error : made.length_errors) {
        out.length_error_mean += std::abs(error) / double(made.length_errors.size());
        out.length_error_max = std::max(out.length_error_max, std::abs(error));
    }
    out.ns_per_point = ns_per_point(in);
    out.code = synthesis_code(blend);
    return out;
}

}  // namespace lancret
