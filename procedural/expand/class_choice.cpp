#include "procedural/expand/class_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "guides/base/cancel.h"
#include "guides/base/worst.h"
#include "procedural/curves/emitted_curve.h"
#include "procedural/expand/intervals.h"

namespace lancret {

namespace {

/// Half of what the check tolerates for the length of an emitted curve, relative.
constexpr float kMaxLengthChange = 0.005f;
constexpr int kMaxMultiples = 16;
/// A guide of this weight is nearly the heaviest: other children near it have it as such.
constexpr float kNearlyLeads = 0.25f;

/// The counts of coarsest_classes, finest first.
std::vector<int> class_counts(int finest, int segments) {
    std::vector<int> out{finest};
    const int multiples = (finest - 1) / segments;
    const int step =
        segments * std::max(1, (multiples + kMaxMultiples - 1) / kMaxMultiples);
    for (int n = (finest - 1) / step * step; n >= segments; n -= step) out.push_back(n);
    for (int n = segments; n > 1 && out.back() > 1;) {
        n /= 2;
        if (n < out.back()) out.push_back(n);
    }
    return out;
}

/// A child at the finest count, relative to its root.
struct FineChild {
    std::size_t child = 0;
    float length = 0;  ///< cm
    std::vector<HelixState<float>> states;
    std::vector<Vec3f> places, tangents;  ///< [2 n + 1] at the ends and in the middles of
                                          ///< intervals; unit tangents
    float chords = 0;                     ///< cm, the length of the polyline of `places`
};

/// Middles are those of the cubics through the ends with their tangents: 0.04 r off for
/// an arc of 2 radians of radius r, 0.003 r for one of 1 radian.
void grow_fine(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
               std::size_t child, FineChild& out) {
    const std::size_t n = std::size_t(profiles.count);
    out.child = child;
    out.length = binding.lengths[child];
    out.states.resize(n + 1);
    out.places.resize(2 * n + 1);
    out.tangents.resize(2 * n + 1);
    synthesize_child<float>(binding, profiles, blend, child, out.states);
    const float ds = out.length / float(n);
    for (std::size_t i = 0; i <= n; ++i) {
        out.places[2 * i] = out.states[i].position;
        out.tangents[2 * i] = out.states[i].frame.col(0);
    }
    out.chords = 0;
    for (std::size_t i = 1; i < 2 * n; i += 2) {
        const Vec3f &a = out.places[i - 1], &b = out.places[i + 1];
        const Vec3f &ta = out.tangents[i - 1], &tb = out.tangents[i + 1];
        out.places[i] = (a + b) / 2 + ds / 8 * (ta - tb);
        out.tangents[i] = (6 / ds * (b - a) - (ta + tb)).normalized();
        out.chords += (out.places[i] - a).norm() + (b - out.places[i]).norm();
    }
}

/// Memory for a child at a coarser class.
struct CoarseChild {
    std::vector<HelixState<float>> states;
    StrandBuffer curve;
};

/// How a child at a coarser class differs from the child at the finest.
struct Change {
    float distance = 0;  ///< cm
    float length = 0;    ///< of the emitted curve, relative to that of the finest
};

/// Stops, with `length` unset, once the distance exceeds `limit`.
Change change_of(const FineChild& fine, const Binding& binding,
                 const GuideProfiles<float>& profiles, const ExpandSettings& settings,
                 float limit, CoarseChild& coarse) {
    const std::size_t n = std::size_t(profiles.count), samples = fine.places.size() - 1;
    const float ds = fine.length / float(n);
    coarse.states.resize(n + 1);
    synthesize_child<float>(binding, profiles, settings.blend, fine.child, coarse.states);
    emit({.states = coarse.states, .ds = ds, .ends = traits_of(settings.blend).ends},
         settings.basis, coarse.curve);
    Change out;
    float chords = 0;
    Vec3f before = Vec3f::Zero();
    for (std::size_t j = 0; j <= samples; ++j) {
        const double along = double(j) / double(samples) * double(n);
        const std::size_t segment = std::min(std::size_t(along), n - 1);
        const Vec3f place =
            emitted_place(settings.basis, coarse.curve.points, coarse.curve.tangents,
                          segment, float(along - double(segment)));
        const Vec3f off = place - fine.places[j], &tangent = fine.tangents[j];
        out.distance = worst_of(out.distance, (off - tangent * tangent.dot(off)).norm());
        if (out.distance > limit) return out;
        if (j > 0) chords += (place - before).norm();
        before = place;
    }
    out.length = chords / fine.chords - 1;
    return out;
}

/// The guides at each class.
struct ClassMeasures {
    std::vector<GuideProfiles<float>> profiles;  ///< [classes]
    std::vector<float> max_curvature;            ///< [classes][guides] 1/cm

    ClassMeasures(const Guides& guides, const std::vector<int>& counts) {
        for (const int count : counts) {
            profiles.push_back(guide_profiles<float>(guides, count));
            const auto& curvatures = profiles.back().curvatures;
            for (std::size_t g = 0; g < guides.size(); ++g) {
                float largest = 0;
                for (std::size_t i = 0; i < std::size_t(count); ++i) {
                    largest =
                        std::max(largest, curvatures[g * std::size_t(count) + i].norm());
                }
                max_curvature.push_back(largest);
            }
        }
    }
    /// Upper limit of the turn of an interval of a child at a class, radians.
    float turn(const Binding& binding, std::size_t child, std::size_t c) const {
        const auto n = std::size_t(binding.neighbours);
        float largest = 0;
        for (std::size_t k = child * n; k < (child + 1) * n; ++k) {
            if (!(binding.weights[k] > 0)) continue;
            largest = std::max(largest,
                               max_curvature[c * profiles[c].size() + binding.guides[k]]);
        }
        return largest * binding.lengths[child] / float(profiles[c].count);
    }
};

/// The coarsest class from `coarsest` on at which all these children keep the limits, to
/// the accuracy of a bisection per child.
std::size_t class_of(const Binding& binding, std::span<const std::uint32_t> children,
                     const ClassMeasures& measures, std::size_t coarsest, float limit,
                     const ExpandSettings& settings) {
    FineChild fine;
    CoarseChild coarse;
    for (const std::uint32_t child : children) {
        if (coarsest == 0) break;
        grow_fine(binding, measures.profiles[0], settings.blend, child, fine);
        const auto keeps = [&](std::size_t c) {
            if (!(measures.turn(binding, child, c) <= kMaxTurn)) return false;
            const Change change =
                change_of(fine, binding, measures.profiles[c], settings, limit, coarse);
            return change.distance <= limit &&
                   std::abs(change.length) <= kMaxLengthChange;
        };
        if (keeps(coarsest)) continue;
        // The coarsest class that is known to keep them, and the finest that does not.
        std::size_t kept = 0, beyond = coarsest;
        while (beyond - kept > 1) {
            const std::size_t c = kept + (beyond - kept) / 2;
            (keeps(c) ? kept : beyond) = c;
        }
        coarsest = kept;
    }
    return coarsest;
}

/// One child per guide, a copy of the guide at its root.
Binding copies_of_guides(const Binding& sample, const Guides& guides) {
    Binding out;
    out.neighbours = 1;
    out.guide_normals = out.roots.normals = sample.guide_normals;
    const double longer = length_over_guides(sample, guides);
    for (std::uint32_t g = 0; g < guides.size(); ++g) {
        out.roots.positions.push_back(guides.root_positions[g].cast<float>());
        out.guides.push_back(g);
        out.weights.push_back(1);
        out.lengths.push_back(float(longer * guide_length(guides, g)));
    }
    return out;
}

}  // namespace

StrandClasses coarsest_classes(const Guides& guides, int finest) {
    StrandClasses out{class_counts(finest, guides.segments)};
    out.of_guide.assign(guides.size(), std::uint8_t(out.size() - 1));
    return out;
}

void refine_classes(StrandClasses& classes, const Binding& sample, const Guides& guides,
                    double tolerance, const ExpandSettings& settings) {
    const ClassMeasures measures(guides, classes.counts);
    const Binding copies = copies_of_guides(sample, guides);
    std::vector<std::vector<std::uint32_t>> followers(guides.size());
    const auto k = std::size_t(sample.neighbours);
    for (std::uint32_t i = 0; i < sample.size(); ++i) {
        const std::uint32_t leads = heaviest_guide(sample, i);
        for (std::size_t j = i * k; j < (i + 1) * k; ++j) {
            const std::uint32_t g = sample.guides[j];
            if (g == leads || sample.weights[j] >= kNearlyLeads) {
                followers[g].push_back(i);
            }
        }
    }
    const float limit = float(kSampleShare * tolerance);
    cancellable_for(std::uint32_t(0), std::uint32_t(guides.size()), [&](auto g) {
        const Binding& from = followers[g].empty() ? copies : sample;
        const std::vector<std::uint32_t> children =
            followers[g].empty() ? std::vector<std::uint32_t>{g} : followers[g];
        classes.of_guide[g] = std::uint8_t(
            class_of(from, children, measures, classes.of_guide[g], limit, settings));
    });
}

StrandClasses used_classes(const StrandClasses& classes) {
    StrandClasses out;
    std::vector<std::uint8_t> number(classes.size(), 0);
    for (std::size_t c = 0; c < classes.size(); ++c) {
        if (std::ranges::find(classes.of_guide, std::uint8_t(c)) ==
            classes.of_guide.end()) {
            continue;
        }
        number[c] = std::uint8_t(out.size());
        out.counts.push_back(classes.counts[c]);
    }
    for (const std::uint8_t c : classes.of_guide) out.of_guide.push_back(number[c]);
    return out;
}

double adapted_distance(const Binding& binding, const GuideProfiles<float>& fine,
                        const GuideProfiles<float>& coarse, std::size_t child,
                        const ExpandSettings& settings) {
    FineChild fine_child;
    CoarseChild coarse_child;
    grow_fine(binding, fine, settings.blend, child, fine_child);
    return change_of(fine_child, binding, coarse, settings,
                     std::numeric_limits<float>::infinity(), coarse_child)
        .distance;
}

AdaptedReport adapted_report(const Binding& binding, const ClassedGuides& guides,
                             const GuideProfiles<float>& fine, double tolerance,
                             const ExpandSettings& settings) {
    using Range = tbb::blocked_range<std::size_t>;
    return cancellable_reduce(
        Range(0, binding.size(), 64), AdaptedReport(),
        [&](const Range& range, AdaptedReport out) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::size_t c = guides.classes.of(binding, i);
                if (guides.profiles[c].count == fine.count) continue;
                const double distance =
                    adapted_distance(binding, fine, guides.profiles[c], i, settings);
                out.farthest = std::max(out.farthest, distance);
                out.beyond += distance > tolerance;
            }
            return out;
        },
        [](const AdaptedReport& a, const AdaptedReport& b) {
            return AdaptedReport{std::max(a.farthest, b.farthest), a.beyond + b.beyond};
        });
}

}  // namespace lancret
