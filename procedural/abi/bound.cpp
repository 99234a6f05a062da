#include "procedural/abi/bound.h"

#include "procedural/abi/chunk.h"
#include "procedural/chunk_bound.h"

namespace lancret::abi {

namespace {

Eigen::AlignedBox3f roots_of(const ChunkedGroom& groom, std::uint32_t chunk) {
    Eigen::AlignedBox3f out;
    for (const std::uint32_t i : groom.chunks.of(chunk)) out.extend(place_of(groom, i));
    return out;
}

}  // namespace

Eigen::AlignedBox3f bound_box(const Prepared& groom, std::uint32_t chunk,
                              const lancret_options* options, int kind) {
    const Generator& generator = groom.generator();
    ChunkBound found;
    Request request;
    if (kind == LANCRET_REACH) {
        request = read_request(groom, chunk, options);
        const float longest = std::ranges::max(generator.profiles.lengths) *
                              generator.groom.bind.length_scale;
        found = reach_bound(roots_of(groom.groom, chunk), longest, request.intervals,
                            settings_of(groom, request), request.density);
    } else {
        const BoundChunk bound = bind_request(groom, chunk, options);
        request = bound.request;
        const auto pose = guide_pose(groom, request);
        found = chunk_bound(bound.binding, pose->profiles, pose->kernel,
                            settings_of(groom, request));
    }
    stop_if_cancelled();
    const Eigen::AlignedBox3f box = found.box();
    if (box.isEmpty()) return box;
    return {box.min() * float(request.scale), box.max() * float(request.scale)};
}

}  // namespace lancret::abi
