#include "procedural/abi/box.h"

#include <algorithm>

#include "procedural/abi/chunk.h"
#include "procedural/chunk/box.h"
#include "procedural/groom/children.h"

namespace lancret::abi {

namespace {

/// From the roots only, at the places to which the scalp carries them.
ChunkBox reach_of_roots(const OpenGroom& groom, std::uint32_t index,
                        const Request& request) {
    const ReadyGroom& ready = groom.ready();
    const ChunkedGroom& chunked = groom.chunked();
    ChunkBinding roots{request, {}, {}};
    roots.binding.roots =
        child_roots(ready.placed, chunked.places, chunked.chunks.of(index));
    roots.binding.guide_normals = ready.placed.normals;
    Eigen::AlignedBox3f box;
    PosedBinding posed(groom, roots);
    for (const double frame : request.frames) {
        const auto pose = groom.pose(frame, request.classes);
        for (const Vec3f& root : posed.at(*pose).roots.positions) box.extend(root);
        if (request.is_still()) break;
    }
    const float longest =
        std::ranges::max(ready.profiles.lengths) * ready.groom.bind.length_scale;
    return reach_box(box, longest, request.classes->counts.back(),
                     settings_of(groom, request), request.density);
}

ChunkBox tight_box(const OpenGroom& groom, const ChunkBinding& chunk) {
    const Request& request = chunk.request;
    const ExpandSettings settings = settings_of(groom, request);
    ChunkBox out;
    PosedBinding posed(groom, chunk);
    for (const double frame : request.frames) {
        const auto pose = groom.pose(frame, request.classes);
        out.extend(chunk_box(posed.at(*pose), pose->classed, settings));
        if (request.is_still()) break;
    }
    return out;
}

}  // namespace

Eigen::AlignedBox3f box_of_chunk(const OpenGroom& groom, std::uint32_t index,
                                 const lancret_options* options, int kind) {
    const Request request = read_request(groom, index, options);
    const ChunkBox cm = kind == LANCRET_REACH
                            ? reach_of_roots(groom, index, request)
                            : tight_box(groom, bind_request(groom, index, options));
    const Eigen::AlignedBox3f box = cm.box();
    if (box.isEmpty()) return box;
    return {box.min() * float(request.scale), box.max() * float(request.scale)};
}

}  // namespace lancret::abi
