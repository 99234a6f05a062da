#include "procedural/abi/chunk.h"

#include <limits>
#include <utility>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "procedural/expand/faces.h"

namespace lancret::abi {

ExpandSettings settings_of(const OpenGroom& groom, const Request& request) {
    ExpandSettings out = groom.ready().groom.expand;
    out.basis = request.curve;
    out.faces = out.faces || request.wants(LANCRET_NORMALS);
    return out;
}

ChunkBinding bind_request(const OpenGroom& groom, std::uint32_t index,
                          const lancret_options* options) {
    ChunkBinding out{read_request(groom, index, options), {}, {}};
    const ReadyGroom& ready = groom.ready();
    const StrandClasses& classes = *out.request.classes;
    out.binding = bind_chunk(groom.chunked(), index, out.request.density, classes);
    stop_if_cancelled();
    each_class(
        classes, out.binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            const auto intervals = std::uint32_t(classes.counts[c]);
            out.classes.push_back({std::uint32_t(last - first), intervals,
                                   control_points_of(out.request.curve, intervals)});
        });
    if (out.request.wants(LANCRET_NORMALS) && out.binding.faces.empty()) {
        out.binding.faces =
            rest_faces(out.binding, ready.profiles, ready.groom.expand.blend);
    }
    return out;
}

lancret_curves sizes_of(const ChunkBinding& chunk) {
    lancret_curves out{};
    out.size = sizeof out;
    out.basis = chunk.request.basis;
    std::uint64_t points = 0;
    for (const ChunkClass& alike : chunk.classes) {
        points += std::uint64_t(alike.strands) * alike.points;
    }
    if (points > std::numeric_limits<lancret_u32>::max()) {
        throw InputError("a chunk has more than 2^32 points: reduce chunk_strands");
    }
    out.strands = lancret_u32(chunk.binding.size());
    out.points = lancret_u32(points);
    out.times = lancret_u32(chunk.request.frames.size());
    out.neighbours = lancret_u32(chunk.binding.neighbours);
    return out;
}

PosedBinding::PosedBinding(const OpenGroom& groom, const ChunkBinding& chunk)
    : still_(chunk.binding) {
    if (!groom.times().moves()) return;
    rest_ = rest_places(chunk.binding, groom.ready().placed);
    moved_ = &copy_.emplace(chunk.binding);
}

PosedBinding::PosedBinding(const OpenGroom& groom, ChunkBinding&& chunk)
    : still_(chunk.binding) {
    if (!groom.times().moves()) return;
    rest_ = rest_places(chunk.binding, groom.ready().placed);
    moved_ = &chunk.binding;
}

const Binding& PosedBinding::at(const GuidePose& pose) {
    if (!moved_) return still_;
    pose_binding_on(*moved_, rest_, pose.scalp);
    return *moved_;
}

}  // namespace lancret::abi
