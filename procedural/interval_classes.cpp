#include "procedural/interval_classes.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "guides/cancel.h"
#include "procedural/child_strands.h"
#include "procedural/emission.h"

namespace lancret {

namespace {

constexpr double kShare = 0.9;  ///< of the tolerance, for what is seen of a strand
constexpr int kMostClasses = 16;

using Range = tbb::blocked_range<std::size_t>;

/// Finest first: at most kMostClasses multiples of the guides' segments, on which
/// profiles are exact, then halves of one interval a segment, for strands that hardly
/// bend.
std::vector<int> class_counts(int finest, int segments) {
    std::vector<int> out{finest};
    const int multiples = (finest - 1) / segments;
    const int step =
        segments * std::max(1, (multiples + kMostClasses - 1) / kMostClasses);
    for (int n = (finest - 1) / step * step; n >= segments; n -= step) out.push_back(n);
    for (int n = segments; n > 1 && out.back() > 1;) {
        n /= 2;
        if (n < out.back()) out.push_back(n);
    }
    return out;
}

/// A strand at some number of intervals: places, and what is emitted of them.
struct Shape {
    std::vector<HelixState<float>> states;
    std::vector<Point4f> points, tangents;

    void emit(float length, CurveBasis basis) {
        const std::uint32_t n = std::uint32_t(states.size()) - 1;
        const float ds = length / float(n);
        points.resize(control_points_of(basis, n));
        if (basis == CurveBasis::hermite) {
            tangents.resize(points.size());
            hermite_points(states, ds, Vec3f::Zero(), {}, points, tangents);
        } else {
            bspline_points(states, ds, Vec3f::Zero(), {}, points);
        }
    }
};

/// The farthest that the emitted curve of `coarse` lies from the helices of `fine`,
/// across them.
double distance_of(const Shape& fine, const Shape& coarse, float length,
                   CurveBasis basis) {
    const std::size_t n = fine.states.size() - 1, m = coarse.states.size() - 1;
    const float ds = length / float(n);
    float worst = 0;
    for (std::size_t j = 0; j <= 2 * n; ++j) {
        HelixState<float> at = fine.states[j / 2];
        if (j % 2 == 1) {
            const Vec3f turn =
                rotation_log<float>(at.frame.transpose() * fine.states[j / 2 + 1].frame);
            advance<float>(at, turn / ds, ds / 2);
        }
        const double along = double(j) / double(2 * n) * double(m);
        const std::size_t segment = std::min(std::size_t(along), m - 1);
        const Vec3f off = emitted_place(basis, coarse.points, coarse.tangents, segment,
                                        float(along - double(segment))) -
                          at.position;
        const Vec3f tangent = at.frame.col(0);
        const float distance = (off - tangent * tangent.dot(off)).norm();
        if (!(distance <= worst)) {  // so that a NaN is seen
            worst =
                std::isnan(distance) ? std::numeric_limits<float>::infinity() : distance;
        }
    }
    return worst;
}

/// A child at a class, not yet emitted.
Shape shape_of(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
               std::size_t child) {
    Shape out;
    out.states.resize(profiles.count + 1);
    synthesize_child<float>(binding, profiles, blend, child, out.states);
    return out;
}

double distance_at(const Shape& fine, const Binding& binding,
                   const GuideProfiles<float>& profiles, std::size_t child,
                   const ExpandSettings& settings) {
    Shape coarse = shape_of(binding, profiles, settings.blend, child);
    coarse.emit(binding.lengths[child], settings.basis);
    return distance_of(fine, coarse, binding.lengths[child], settings.basis);
}

/// The children of each class, by their places in the binding.
std::vector<std::vector<std::uint32_t>> members(std::size_t classes,
                                                std::span<const std::uint8_t> of_child) {
    std::vector<std::vector<std::uint32_t>> out(classes);
    for (std::size_t i = 0; i < of_child.size(); ++i) {
        out[of_child[i]].push_back(std::uint32_t(i));
    }
    return out;
}

}  // namespace

IntervalClasses interval_classes(const Guides& guides, int finest) {
    IntervalClasses out;
    out.counts = class_counts(finest, guides.segments);
    for (const int n : out.counts) {
        out.profiles.push_back(guide_profiles<float>(guides, n));
    }
    return out;
}

double adapted_distance(const Binding& binding, const IntervalClasses& classes,
                        std::size_t child, std::size_t at_class,
                        const ExpandSettings& settings) {
    return distance_at(shape_of(binding, classes.profiles[0], settings.blend, child),
                       binding, classes.profiles[at_class], child, settings);
}

std::vector<std::uint8_t> child_classes(const Binding& binding,
                                        const IntervalClasses& classes, double tolerance,
                                        const ExpandSettings& settings) {
    std::vector<std::uint8_t> out(binding.size());
    cancellable_for(Range(0, binding.size(), 64), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Shape fine = shape_of(binding, classes.profiles[0], settings.blend, i);
            // The last that was seen to keep the tolerance, and the first that was not.
            std::size_t kept = 0, beyond = classes.size();
            while (beyond - kept > 1) {
                const std::size_t c = kept + (beyond - kept) / 2;
                const bool keeps = distance_at(fine, binding, classes.profiles[c], i,
                                               settings) <= kShare * tolerance;
                (keeps ? kept : beyond) = c;
            }
            out[i] = std::uint8_t(kept);
        }
    });
    return out;
}

std::vector<Curves> expand_by_class(const Binding& binding,
                                    const IntervalClasses& classes,
                                    std::span<const std::uint8_t> of_child,
                                    const ExpandSettings& settings) {
    const auto own = members(classes.size(), of_child);
    std::vector<Curves> out;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        out.push_back(expand(picked(binding, own[c]), classes.profiles[c], settings));
    }
    return out;
}

Strands adapted_strands(const Binding& binding, const IntervalClasses& classes,
                        std::span<const std::uint8_t> of_child,
                        const ExpandSettings& settings) {
    const auto own = members(classes.size(), of_child);
    std::vector<Strands> parts;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        parts.push_back(
            child_strands(picked(binding, own[c]), classes.profiles[c], settings));
    }
    Strands out;
    std::vector<std::size_t> next(classes.size(), 0);
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const std::size_t c = of_child[i], at = next[c]++;
        const auto from = std::ptrdiff_t(parts[c].first[at]),
                   to = std::ptrdiff_t(parts[c].first[at + 1]);
        out.points.insert(out.points.end(), parts[c].points.begin() + from,
                          parts[c].points.begin() + to);
        out.thickness.insert(out.thickness.end(), parts[c].thickness.begin() + from,
                             parts[c].thickness.begin() + to);
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

}  // namespace lancret
