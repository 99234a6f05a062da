#include "procedural/abi/box.h"

#include <algorithm>

#include "procedural/abi/chunk.h"
#include "procedural/chunk/box.h"
#include "procedural/groom/children.h"

namespace lancret::abi {

namespace {

/// By the roots alone, wherever the scalp carries them.
ChunkBox reach_of(const OpenGroom& groom, std::uint32_t chunk, const Request& request) {
    const ReadyGroom& ready = groom.ready();
    ChunkBinding roots{request, {}, {}};
    roots.binding.roots =
        child_roots(ready.source, groom.groom().places, groom.groom().chunks.of(chunk));
    roots.binding.guide_normals = ready.source.normals;
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

ChunkBox tight_bound(const OpenGroom& groom, const ChunkBinding& bound) {
    const Request& request = bound.request;
    const ExpandSettings settings = settings_of(groom, request);
    ChunkBox out;
    PosedBinding posed(groom, bound);
    for (const double frame : request.frames) {
        const auto pose = groom.pose(frame, request.classes);
        out.extend(chunk_box(posed.at(*pose), pose->classed, settings));
        if (request.is_still()) break;
    }
    return out;
}

}  // namespace

Eigen::AlignedBox3f bound_box(const OpenGroom& groom, std::uint32_t chunk,
                              const lancret_options* options, int kind) {
    const Request request = read_request(groom, chunk, options);
    const ChunkBox found = kind == LANCRET_REACH
                               ? reach_of(groom, chunk, request)
                               : tight_bound(groom, bind_request(groom, chunk, options));
    const Eigen::AlignedBox3f box = found.box();
    if (box.isEmpty()) return box;
    return {box.min() * float(request.scale), box.max() * float(request.scale)};
}

}  // namespace lancret::abi
