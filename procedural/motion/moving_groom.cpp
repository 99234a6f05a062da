#include "procedural/motion/moving_groom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "guides/base/errors.h"
#include "guides/motion/guides_between.h"
#include "procedural/expand/class_choice.h"
#include "procedural/expand/intervals.h"

namespace lancret {

namespace {

/// Calls visit(frame, guides, sample) for frames spread over the whole cache, with the
/// sample of the children posed at that frame.
template <class Visit>
void each_measured_frame(const ReadyGroom& ready, const GroomTimes& times,
                         const Visit& visit) {
    if (!times.moves() || times.info.frames < 2) return;
    constexpr int kMeasured = 13;
    Binding sample = ready.sample;
    const RestPlaces rest = rest_places(sample, ready.placed);
    const int n = std::min(kMeasured, times.info.frames);
    for (int i = 0; i < n; ++i) {
        const int frame =
            times.info.first_frame + (times.info.frames - 1) * i / std::max(n - 1, 1);
        const Guides guides = guides_at(times, rest.guide_places, frame);
        pose_binding(sample, rest,
                     times.pose_at ? times.pose_at(frame) : ScalpPose(RigidPose{}));
        visit(frame, guides, sample);
    }
}

}  // namespace

StrandClasses classes_in_time(const ReadyGroom& ready, const GroomTimes& times,
                              CurveBasis basis, double tolerance, int finest) {
    ExpandSettings settings = ready.groom.expand;
    settings.basis = basis;
    StrandClasses all = coarsest_classes(ready.placed.guides, finest);
    const auto refine = [&](const Binding& sample, const Guides& guides) {
        refine_classes(all, sample, guides, tolerance, settings);
    };
    refine(ready.sample, ready.placed.guides);
    each_measured_frame(ready, times,
                        [&](int, const Guides& guides, const Binding& sample) {
                            refine(sample, guides);
                        });
    return used_classes(all);
}

int intervals_in_time(const ReadyGroom& ready, const GroomTimes& times, CurveBasis basis,
                      double tolerance, int most, double* reached) {
    const Blend blend = ready.groom.expand.blend;
    FoundIntervals out = intervals_within(ready.sample, ready.placed.guides, blend,
                                          tolerance, basis, most);
    each_measured_frame(
        ready, times, [&](int frame, const Guides& guides, const Binding& sample) {
            try {
                const FoundIntervals found =
                    intervals_within(sample, guides, blend, tolerance, basis, most);
                out.count = std::max(out.count, found.count);
                out.distance = std::max(out.distance, found.distance);
            } catch (const InputError& error) {
                throw InputError(fmt::format("{}: frame {}: {}", times.cache.string(),
                                             frame, error.what()));
            }
        });
    if (reached) *reached = out.distance;
    return out.count;
}

RestPlaces prepare_frames(ReadyGroom& ready, const GroomTimes& times) {
    const GroomSettings& groom = ready.groom;
    if (times.moves() && times.info.frames > 1 && !groom.intervals) {
        const int intervals = std::max(ready.profiles.count,
                                       intervals_in_time(ready, times, groom.expand.basis,
                                                         groom.tolerance, kMaxIntervals));
        if (intervals != ready.profiles.count) {
            ready.profiles = guide_profiles<float>(ready.placed.guides, intervals);
        }
        ready.classes = groom.adapts() ? classes_in_time(ready, times, groom.expand.basis,
                                                         groom.tolerance, intervals)
                                       : StrandClasses{{intervals}};
        ready.binding = in_class_order(std::move(ready.binding), ready.classes);
    }
    return rest_places(ready.binding, ready.placed);
}

Guides guides_at(const GroomTimes& times, std::span<const MeshPoint> guide_places,
                 double frame) {
    const auto read = [&](int f) {
        return read_guide_cache(times.cache, f - times.first());
    };
    const int whole = int(std::floor(frame));
    const double share = frame - whole;
    if (share == 0) return read(whole);
    const Guides from = read(whole), to = read(whole + 1);
    std::optional<Guides> before, after;
    if (whole > times.first()) before = read(whole - 1);
    if (whole + 1 < times.last()) after = read(whole + 2);
    const GuideKeys keys{&from, &to, before ? &*before : nullptr,
                         after ? &*after : nullptr};
    if (!times.pose_at) return guides_between(keys, share);
    const auto carriers_at = [&](double f) {
        return carriers(times.pose_at(f), guide_places, from.size());
    };
    RootCarriers roots{
        carriers_at(whole), carriers_at(whole + 1), {}, {}, carriers_at(frame)};
    if (before) roots.before = carriers_at(whole - 1);
    if (after) roots.after = carriers_at(whole + 2);
    return guides_between(keys, share, InTime::frames, &roots);
}

FrameState go_to_frame(ReadyGroom& ready, const RestPlaces& rest, const GroomTimes& times,
                       double frame) {
    FrameState out;
    if (times.cache.empty()) {
        out.guides = ready.placed.guides;
    } else {
        out.guides = guides_at(times, rest.guide_places, frame);
        if (times.pose_at) out.pose = times.pose_at(frame);
    }
    out.scalp_roots = pose_binding(ready.binding, rest, out.pose);
    out.classed = classed_guides(out.guides, ready.classes, ready.binding.guide_normals,
                                 ready.groom.expand.blend);
    return out;
}

namespace {

bool same(const Guides& a, const Guides& b) {
    return a.segments == b.segments && a.root_positions == b.root_positions &&
           a.root_frames == b.root_frames && a.segment_lengths == b.segment_lengths &&
           a.curvatures == b.curvatures;
}

bool same(const ScalpPose& a, const ScalpPose& b) {
    if (a.index() != b.index()) return false;
    if (const auto* mesh = std::get_if<TriangleMesh>(&a)) {
        return mesh->positions == std::get<TriangleMesh>(b).positions;
    }
    const auto& x = std::get<RigidPose>(a);
    const auto& y = std::get<RigidPose>(b);
    return x.rotation == y.rotation && x.translation == y.translation;
}

}  // namespace

bool is_still(const GroomTimes& times, std::span<const MeshPoint> guide_places,
              std::span<const double> frames) {
    const bool one =
        std::ranges::adjacent_find(frames, std::not_equal_to{}) == frames.end();
    if (!times.moves() || one) return true;
    const auto pose_at = [&](double frame) {
        return times.pose_at ? times.pose_at(frame) : ScalpPose();
    };
    const ScalpPose pose = pose_at(frames[0]);
    const Guides guides = guides_at(times, guide_places, frames[0]);
    return std::ranges::all_of(frames.subspan(1), [&](double frame) {
        return frame == frames[0] ||
               (same(pose, pose_at(frame)) &&
                same(guides, guides_at(times, guide_places, frame)));
    });
}

}  // namespace lancret
