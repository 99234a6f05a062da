#include "procedural/groom/ready_groom.h"

#include <fmt/format.h>

#include <numeric>

#include "guides/base/errors.h"
#include "guides/base/stopwatch.h"
#include "procedural/expand/faces.h"
#include "procedural/groom/children.h"

namespace lancret {

namespace {

/// The roots of the children that are grown at the groom's density.
Roots grown_roots(const GroomSettings& groom, const PlacedGuides& placed,
                  RootPlaces places) {
    if (groom.density == 1) {
        return roots_at(placed.scalp ? &*placed.scalp : nullptr, std::move(places));
    }
    std::vector<std::uint32_t> ids(places.size());
    std::iota(ids.begin(), ids.end(), 0u);
    Roots out = pruned_roots(groom, placed, places, ids, groom.density);
    if (out.size() == 0) {
        throw InputError(fmt::format("{}: density {} leaves none of the {} strands",
                                     groom.name, groom.density, ids.size()));
    }
    return out;
}

}  // namespace

ClassedGuides rest_guides(const ReadyGroom& ready) {
    return classed_guides(ready.placed.guides, ready.classes, ready.binding.guide_normals,
                          ready.groom.expand.blend);
}

Eigen::AlignedBox3f guide_box(const ReadyGroom& ready) {
    const GuideProfiles<float>& profiles = ready.profiles;
    const float scale = ready.groom.bind.length_scale;
    Eigen::AlignedBox3f box;
    const std::size_t places = std::size_t(profiles.count) + 1;
    for (std::size_t g = 0; g < profiles.size(); ++g) {
        const Vec3f root = ready.placed.guides.root_positions[g].cast<float>();
        for (std::size_t i = 0; i < places; ++i) {
            const Vec3f local = scale * profiles.positions[g * places + i];
            box.extend(root + profiles.root_frames[g] * local);
        }
    }
    return box;
}

ReadyGroom make_ready_groom(const GroomSettings& groom, const StageCallback& stage) {
    ReadyGroom out;
    out.groom = groom;
    out.placed = place_guides(groom, stage);
    out.seconds = out.placed.report.seconds;
    if (stage) stage(GroomStage::bind);
    Stopwatch watch;
    RootPlaces places = child_places(groom, out.placed);
    out.sample = sample_of_children(groom, out.placed, places);
    out.binding = bind_children(groom, out.placed,
                                grown_roots(groom, out.placed, std::move(places)));
    const int finest = child_intervals(groom, out.placed, out.sample);
    out.profiles = guide_profiles<float>(out.placed.guides, finest);
    out.classes = child_classes(groom, out.placed, out.sample, finest);
    out.binding = in_class_order(std::move(out.binding), out.classes);
    if (groom.expand.has_faces()) {
        out.binding.faces = rest_faces(out.binding, out.profiles, groom.expand.blend);
    }
    out.seconds.bind = watch.lap();
    return out;
}

}  // namespace lancret
