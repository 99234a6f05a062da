#include "procedural/expand/class_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "guides/base/cancel.h"
#include "procedural/expand/intervals.h"

namespace lancret {

namespace {

/// Of the tolerance, for the sample: the other children hold a few that are worse.
constexpr double kSampleShare = 0.6;
/// Half of what the check lets an emitted curve's length be off by.
constexpr float kMaxLengthChange = 0.005f;
/// Radians that an interval may turn, as in intervals_within.
constexpr float kMaxTurn = 2;
constexpr int kMaxMultiples = 16;
/// A guide of this weight leads other children much like the one that is measured.
constexpr float kNearlyLeads = 0.25f;

/// Finest first.
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

/// A child at the finest count: places and unit tangents at the ends of its intervals and
/// in their middles, from the root, and the length of the chords between them.
struct FineChild {
    float length = 0;  ///< cm
    std::vector<HelixState<float>> states;
    std::vector<Vec3f> places, tangents;  ///< [2 n + 1]
    float chords = 0;                     ///< cm
};

/// Middles are those of the cubics with the ends' places and tangents: of an arc of 2
/// radians of radius r they are 0.04 r off, of one of 1 radian 0.003 r.
void grow_fine(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
               std::size_t child, FineChild& out) {
    const std::size_t n = std::size_t(profiles.count);
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

/// Room for a child at a class.
struct CoarseChild {
    std::vector<HelixState<float>> states;
    std::vector<Point4f> points, tangents;
    std::vector<Point4f> places;  ///< of a Hermite curve that `points` are made of

    /// `states` as the control points of a curve.
    void emit(float ds, const ExpandSettings& settings) {
        const std::size_t n = states.size() - 1;
        points.resize(control_points_of(settings.basis, std::uint32_t(n)));
        tangents.resize(n + 1);
        if (settings.basis == CurveBasis::bspline) {
            bspline_points(states, ds, Vec3f::Zero(), {}, points,
                           traits_of(settings.blend).ends);
        } else if (settings.basis == CurveBasis::hermite) {
            hermite_points(states, ds, Vec3f::Zero(), {}, points, tangents);
        } else {
            places.resize(n + 1);
            hermite_points(states, ds, Vec3f::Zero(), {}, places, tangents);
            points_of_hermite(settings.basis, places, tangents, points);
        }
    }
};

/// What a class makes of a child.
struct Change {
    float distance = 0;  ///< cm
    float length = 0;    ///< of the emitted curve, relative to that of the finest
};

/// Gives up where the distance passes `limit`.
Change change_of(const FineChild& fine, const Binding& binding,
                 const GuideProfiles<float>& profiles, std::size_t child,
                 const ExpandSettings& settings, float limit, CoarseChild& room) {
    const std::size_t n = std::size_t(profiles.count), samples = fine.places.size() - 1;
    const float ds = fine.length / float(n);
    room.states.resize(n + 1);
    synthesize_child<float>(binding, profiles, settings.blend, child, room.states);
    room.emit(ds, settings);
    Change out;
    float chords = 0;
    Vec3f before = Vec3f::Zero();
    for (std::size_t j = 0; j <= samples; ++j) {
        const double along = double(j) / double(samples) * double(n);
        const std::size_t segment = std::min(std::size_t(along), n - 1);
        const Vec3f place = emitted_place(settings.basis, room.points, room.tangents,
                                          segment, float(along - double(segment)));
        const Vec3f off = place - fine.places[j], &tangent = fine.tangents[j];
        const float distance = (off - tangent * tangent.dot(off)).norm();
        if (!(distance <= out.distance)) {  // so that a NaN is seen
            out.distance =
                std::isnan(distance) ? std::numeric_limits<float>::infinity() : distance;
            if (out.distance > limit) return out;
        }
        if (j > 0) chords += (place - before).norm();
        before = place;
    }
    out.length = chords / fine.chords - 1;
    return out;
}

/// All that choosing reads: profiles and the largest curvature of each guide at each
/// class.
struct Measures {
    std::vector<GuideProfiles<float>> profiles;  ///< [classes]
    std::vector<float> most_curved;              ///< [classes][guides] 1/cm

    Measures(const Guides& guides, const std::vector<int>& counts) {
        for (const int count : counts) {
            profiles.push_back(guide_profiles<float>(guides, count));
            const auto& curvatures = profiles.back().curvatures;
            for (std::size_t g = 0; g < guides.size(); ++g) {
                float most = 0;
                for (std::size_t i = 0; i < std::size_t(count); ++i) {
                    most = std::max(most, curvatures[g * std::size_t(count) + i].norm());
                }
                most_curved.push_back(most);
            }
        }
    }
    /// Radians that an interval of a child may turn at a class.
    float turn(const Binding& binding, std::size_t child, std::size_t c) const {
        const auto n = std::size_t(binding.neighbours);
        float most = 0;
        for (std::size_t k = child * n; k < (child + 1) * n; ++k) {
            if (!(binding.weights[k] > 0)) continue;
            most =
                std::max(most, most_curved[c * profiles[c].size() + binding.guides[k]]);
        }
        return most * binding.lengths[child] / float(profiles[c].count);
    }
};

/// A coarse class, `at` or finer, at which these children keep what they must.
std::size_t class_of(const Binding& binding, std::span<const std::uint32_t> children,
                     const Measures& measures, std::size_t at, float limit,
                     const ExpandSettings& settings) {
    FineChild fine;
    CoarseChild room;
    for (const std::uint32_t child : children) {
        if (at == 0) break;
        grow_fine(binding, measures.profiles[0], settings.blend, child, fine);
        const auto keeps = [&](std::size_t c) {
            if (!(measures.turn(binding, child, c) <= kMaxTurn)) return false;
            const Change change = change_of(fine, binding, measures.profiles[c], child,
                                            settings, limit, room);
            return change.distance <= limit &&
                   std::abs(change.length) <= kMaxLengthChange;
        };
        if (keeps(at)) continue;
        // The last that was seen to keep it, and the first that was not.
        std::size_t kept = 0, beyond = at;
        while (beyond - kept > 1) {
            const std::size_t c = kept + (beyond - kept) / 2;
            (keeps(c) ? kept : beyond) = c;
        }
        at = kept;
    }
    return at;
}

/// A child for each guide that is the guide itself, where it stands.
Binding images(const Binding& sample, const Guides& guides) {
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
    const Measures measures(guides, classes.counts);
    const Binding alone = images(sample, guides);
    std::vector<std::vector<std::uint32_t>> followers(guides.size());
    const auto k = std::size_t(sample.neighbours);
    for (std::uint32_t i = 0; i < sample.size(); ++i) {
        const std::uint32_t leads = heaviest_guide(sample, i);
        for (std::size_t j = i * k; j < (i + 1) * k; ++j) {
            const std::uint32_t g = sample.guides[j];
            if (g == leads || sample.weights[j] >= kNearlyLeads)
                followers[g].push_back(i);
        }
    }
    const float limit = float(kSampleShare * tolerance);
    cancellable_for(std::uint32_t(0), std::uint32_t(guides.size()), [&](auto g) {
        const Binding& from = followers[g].empty() ? alone : sample;
        const std::vector<std::uint32_t> own =
            followers[g].empty() ? std::vector<std::uint32_t>{g} : followers[g];
        classes.of_guide[g] = std::uint8_t(
            class_of(from, own, measures, classes.of_guide[g], limit, settings));
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
    FineChild grown;
    CoarseChild room;
    grow_fine(binding, fine, settings.blend, child, grown);
    return change_of(grown, binding, coarse, child, settings,
                     std::numeric_limits<float>::infinity(), room)
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
