#include "procedural/chunk/chunked_groom.h"

#include "guides/base/stopwatch.h"
#include "procedural/expand/faces.h"

namespace lancret {

ChunkedGroom make_chunked_groom(const GroomSettings& groom, std::uint32_t max_strands,
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
        out.places.size(), [&](std::uint32_t i) { return place_of(out, i); },
        max_strands);
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
    const GroomSettings& settings = groom.ready.groom;
    const PlacedGuides& placed = groom.ready.placed;
    Binding out = bind_children(
        settings, placed,
        pruned_roots(settings, placed, groom.places, groom.chunks.of(chunk), density));
    if (settings.expand.has_faces()) {
        out.faces = rest_faces(out, groom.ready.profiles, settings.expand.blend);
    }
    return in_class_order(std::move(out), classes);
}

Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    return bind_chunk(groom, chunk, groom.ready.groom.density, groom.ready.classes);
}

}  // namespace lancret
