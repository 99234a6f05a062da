#include "procedural/chunk/chunked_groom.h"

#include <algorithm>

#include "guides/base/stopwatch.h"
#include "procedural/expand/faces.h"

namespace lancret {

ChunkedGroom make_chunked_groom(const Groom& groom, std::uint32_t most,
                                const StageCallback& stage) {
    ChunkedGroom out;
    Generator& generator = out.generator;
    generator.groom = groom;
    generator.source = groom_guides(groom, stage);
    generator.seconds = generator.source.seconds;
    if (stage) stage("cut into chunks");
    Stopwatch watch;
    out.places = child_places(groom, generator.source);
    generator.sample = sample_of_children(groom, generator.source, out.places);
    const int finest = child_intervals(groom, generator.source, generator.sample);
    generator.profiles = guide_profiles<float>(generator.source.guides, finest);
    generator.classes = child_classes(groom, generator.source, generator.sample, finest);
    generator.binding = in_class_order(generator.sample, generator.classes);
    out.chunks = make_chunks(
        out.places.size(), [&](std::uint32_t i) { return place_of(out, i); }, most);
    generator.seconds.bind = watch.lap();
    return out;
}

Vec3f place_of(const ChunkedGroom& groom, std::uint32_t child) {
    const auto& scalp = groom.generator.source.scalp;
    if (!scalp) return groom.places.own.positions[child];
    return scalp_position(*scalp, groom.places.on_scalp[child]).cast<float>();
}

Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk, double density,
                   const StrandClasses& classes) {
    const Groom& own = groom.generator.groom;
    const GroomGuides& source = groom.generator.source;
    Binding out = bind_children(
        own, source,
        pruned_roots(own, source, groom.places, groom.chunks.of(chunk), density));
    if (own.expand.has_faces())
        out.faces = rest_faces(out, groom.generator.profiles, own.expand.blend);
    return in_class_order(std::move(out), classes);
}

Binding bind_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    return bind_chunk(groom, chunk, groom.generator.groom.density,
                      groom.generator.classes);
}

Curves expand_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    return expand(bind_chunk(groom, chunk), rest_guides(groom.generator),
                  groom.generator.groom.expand);
}

ChunkBound reach_of_chunk(const ChunkedGroom& groom, std::size_t chunk) {
    Eigen::AlignedBox3f roots;
    for (const std::uint32_t i : groom.chunks.of(chunk)) {
        roots.extend(place_of(groom, i));
    }
    const Groom& own = groom.generator.groom;
    const GuideProfiles<float>& profiles = groom.generator.profiles;
    return reach_bound(roots, std::ranges::max(profiles.lengths) * own.bind.length_scale,
                       groom.generator.classes.counts.back(), own.expand, own.density);
}

}  // namespace lancret
