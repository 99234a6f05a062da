// What a host is to know of a groom besides its strands: how it came about, its head,
// when it moves.

#include <cmath>
#include <nlohmann/json.hpp>

#include "procedural/abi/request.h"
#include "procedural/groom/fit_report.h"

namespace lancret::abi {

namespace {

std::string description_of(const ReadyGroom& ready) {
    nlohmann::json out = fit_json(ready.source);
    out["blend"] = blend_name(ready.groom.expand.blend);
    return out.dump();
}

/// Nothing where there is no head.
TriangleMesh head_at(const OpenGroom& groom, double time) {
    const PlacedGuides& source = groom.ready().source;
    if (!source.body && !source.scalp) return {};
    const TriangleMesh& rest = source.body ? *source.body : source.scalp->mesh;
    const GroomTimes& times = groom.times();
    const bool on_head = times.moves() && times.pose_at;
    return posed_mesh(
        rest, on_head ? times.pose_at(groom.frame_at(time)) : ScalpPose(RigidPose{}));
}

lancret_mesh view_of(const TriangleMesh& mesh) {
    static_assert(sizeof(Vec3f) == 3 * sizeof(float));
    static_assert(sizeof(mesh.triangles[0]) == 3 * sizeof(lancret_u32));
    static_assert(sizeof(mesh.uvs[0]) == 6 * sizeof(float));
    lancret_mesh out{};
    out.size = sizeof out;
    out.vertices = lancret_u32(mesh.positions.size());
    out.triangles = lancret_u32(mesh.triangles.size());
    if (out.vertices > 0) out.positions = mesh.positions.data()->data();
    if (out.triangles > 0) out.corners = mesh.triangles.data()->data();
    if (!mesh.uvs.empty()) out.uvs = mesh.uvs.data()->data()->data();
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_groom_describe(const lancret_groom* groom, lancret_text_sink sink,
                                      void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink");
        const std::string text = description_of(groom->own->ready());
        call_host([&] { sink(user, text.c_str()); });
    });
}

lancret_status lancret_groom_get_head(const lancret_groom* groom, double time,
                                      lancret_mesh_sink sink, void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink");
        require(std::isfinite(time), "time");
        const lancret::TriangleMesh head = head_at(*groom->own, time);
        const lancret_mesh view = view_of(head);
        lancret_status status = LANCRET_OK;
        call_host([&] { status = sink(user, &view); });
        if (status != LANCRET_OK) throw SinkEnded{status};
    });
}

lancret_status lancret_groom_is_still(const lancret_groom* groom, const double* times,
                                      std::size_t time_count, int* still) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(still, "still");
        require(times && time_count > 0 && time_count <= kMaxTimes, "times");
        std::vector<double> frames;
        for (std::size_t i = 0; i < time_count; ++i) {
            require(std::isfinite(times[i]), "a time is not finite");
            frames.push_back(groom->own->frame_at(times[i]));
        }
        *still = is_still(groom->own->times(), groom->own->ready().source.places, frames);
    });
}
