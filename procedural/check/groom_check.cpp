#include "procedural/check/groom_check.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "guides/base/stopwatch.h"

namespace lancret {

namespace {

/// The children of a frame, kept to measure their motion to the next.
struct KeptFrame {
    double frame = 0;
    Binding binding;
    GuideProfiles<double> profiles;
    std::vector<RigidPose> carriers;

    Moment moment() const { return {&binding, &profiles, carriers}; }
};

KeptFrame kept(const ReadyGroom& ready, const FrameState& state, double frame) {
    const bool rigid = std::holds_alternative<RigidPose>(state.pose);
    const Binding& binding = ready.binding;
    return {frame, binding, guide_profiles<double>(state.guides, ready.profiles.count),
            carriers(state.pose, binding.roots.places, rigid ? 1 : binding.size())};
}

AdaptedReport worst_of(const AdaptedReport& a, const AdaptedReport& b) {
    return {std::max(a.farthest, b.farthest), std::max(a.beyond, b.beyond)};
}

/// Measures what classes cost at a frame, if the groom has several.
AdaptedReport adapted_at(const ReadyGroom& ready, const FrameState& state,
                         double tolerance) {
    if (ready.classes.size() < 2) return {};
    return adapted_report(ready.binding, state.classed,
                          guide_profiles<float>(state.guides, ready.profiles.count),
                          tolerance, ready.groom.expand);
}

}  // namespace

GroomCheck check_groom(ReadyGroom& ready, const GroomTimes& times,
                       std::span<const double> frames, const CheckTolerances& tolerances,
                       const std::function<void(double)>& progress) {
    const RestPlaces rest = prepare_frames(ready, times);
    const std::vector<Vec3f>& roots = ready.binding.roots.positions;
    const Chunks chunks =
        make_chunks(roots.size(), [&](std::uint32_t i) { return roots[i]; });
    const ExpandSettings& settings = ready.groom.expand;
    GroomCheck out;
    std::optional<KeptFrame> before;
    for (const double frame : frames) {
        const FrameState state = go_to_frame(ready, rest, times, frame);
        Stopwatch watch;
        out.curves = expand(ready.binding, state.classed, settings);
        out.expand_seconds += watch.lap();
        CheckReport children =
            check_strands({ready.binding, state.guides, state.classed, out.curves,
                           settings, ready.groom.bind.length_scale, tolerances});
        out.chunks = worst_of(out.chunks, check_chunks(ready.binding, state.classed,
                                                       out.curves, settings, chunks));
        out.adapted =
            worst_of(out.adapted, adapted_at(ready, state, tolerances.distance));
        GuideCheck guides =
            check_guides(state.guides, ready.placed.guides, state.scalp_roots);
        // Guides without a rest pose come from elsewhere and are moved onto the scalp
        // when they are read.
        guides.root_applies = times.info.has_rest;
        add_frame(out.frames, frame, std::move(children), guides);
        if (frames.size() > 1) {
            KeptFrame now = kept(ready, state, frame);
            if (before) {
                add_step(out.frames, before->frame, frame,
                         check_motion(before->moment(), now.moment(), settings.blend));
            }
            before = std::move(now);
        }
        out.check_seconds += watch.lap();
        if (progress) {
            progress(double(out.frames.frames.size()) / double(frames.size()));
        }
    }
    out.pass = out.chunks.pass() &&
               (times.cache.empty() ? out.frames.worst.pass() : out.frames.pass());
    return out;
}

}  // namespace lancret
