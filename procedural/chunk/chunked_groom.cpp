#include "procedural/chunk/chunked_groom.h"

#include <algorithm>

#include "guides/base/stopwatch.h"
#include "procedural/expand/faces.h"

namespace lancret {

ChunkedGroom make_chunked_groom(const GroomSettings& groom, std::uint32_t most,
                                const StageCallback& stage) {
    ChunkedGroom out;
    ReadyGroom& ready = out.ready;
    ready.groom = groom;
    ready.placed = place_guides(groom, stage);
    ready.seconds = ready.placed.report.seconds;
    if (stage) stage(GroomStage::cut);
    Stopwatch watch;
    out.places = child_places(groom, ready.placed);
    ready.sample = sample_of_children(groom, ready.placed, out.places);
    const int finest = child_intervals(groom, ready.placed, ready.sample);
    ready.profiles = guide_profiles<float>(ready.placed.guides, finest);
    ready.classes = child_classes(groom, ready.placed, ready.sample, finest);
    ready.binding = in_class_order(ready.sample, ready.classes);
    out.chunks = make_chunks(
        out.places.size(), [&](std::uint32_t i) { return place_of(out, i); }, most);
    ready.seconds.bind = watch.lap();
    return out;
}

Vec3f place_of(const ChunkedGroom& groom, std::uint32_t child) {
    const auto& scalp = groom.ready.placed.scalp;
    if (!scalp) return groom.places.on_strands.positions[child];
    return scalp_position(*scalp, groom.places.on_scalp[child]).cast<float>();
}

Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk, double density,
                   const StrandClasses& classes) {
    const GroomSettings& own = groom.ready.groom;
    const PlacedGuides& placed = groom.ready.placed;
    Binding out = bind_children(
        own, placed,
        pruned_roots(own, placed, groom.places, groom.chunks.of(chunk), density));
    if (own.expand.has_faces())
        out.faces = rest_faces(out, groom.ready.profiles, own.expand.blend);
    return in_class_order(std::move(out), classes);
}

Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    return bind_chunk(groom, chunk, groom.ready.groom.density, groom.ready.classes);
}

Curves expand_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    return expand(bind_chunk(groom, chunk), rest_guides(groom.ready),
                  groom.ready.groom.expand);
}

ChunkBox reach_of_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    Eigen::AlignedBox3f roots;
    for (const std::uint32_t i : groom.chunks.of(chunk)) {
        roots.extend(place_of(groom, i));
    }
    const GroomSettings& own = groom.ready.groom;
    const GuideProfiles<float>& profiles = groom.ready.profiles;
    return reach_box(roots, std::ranges::max(profiles.lengths) * own.bind.length_scale,
                     groom.ready.classes.counts.back(), own.expand, own.density);
}

}  // namespace lancret
