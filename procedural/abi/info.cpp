// Entry points that describe an open groom: everything but its strands.

#include <cmath>
#include <nlohmann/json.hpp>

#include "procedural/abi/handles.h"
#include "procedural/abi/request.h"
#include "procedural/groom/fit_report.h"

namespace lancret::abi {

namespace {

int shape_of(const std::optional<CurveShape>& shape) {
    if (!shape) return LANCRET_ANY_SHAPE;
    return *shape == CurveShape::flat    ? LANCRET_FLAT
           : *shape == CurveShape::round ? LANCRET_ROUND
                                         : LANCRET_RIBBON;
}

lancret_groom_info info_of(const OpenGroom& groom) {
    const ReadyGroom& ready = groom.ready();
    const SceneUnits& scene = ready.groom.scene;
    lancret_groom_info out{};
    out.chunks = lancret_u32(groom.chunked().chunks.size());
    out.strands = lancret_u32(groom.chunked().places.size());
    out.guides = lancret_u32(ready.placed.guides.size());
    out.segments = lancret_u32(ready.placed.guides.segments);
    out.intervals = lancret_u32(ready.profiles.count);
    out.neighbours = lancret_u32(ready.binding.neighbours);
    if (groom.times().moves()) {
        out.first_frame = groom.times().first();
        out.last_frame = groom.times().last();
        out.frames = groom.times().info.frames;
    }
    const ExpandSettings& expand = ready.groom.expand;
    out.basis = expand.basis == CurveBasis::hermite ? LANCRET_HERMITE : LANCRET_BSPLINE;
    out.shape = shape_of(expand.shape);
    const Eigen::AlignedBox3f box = guide_box(ready);
    for (int i = 0; i < 3; ++i) {
        out.box[i] = box.min()[i];
        out.box[3 + i] = box.max()[i];
    }
    out.cm_per_unit = float(scene.centimetres_per_unit());
    for (int i = 0; i < 3; ++i) out.up[i] = float(scene.up[i]);
    out.load_seconds = ready.seconds.load;
    out.fit_seconds = ready.seconds.fit;
    out.bind_seconds = ready.seconds.bind;
    out.bytes = groom.bytes();
    return out;
}

std::string description_of(const ReadyGroom& ready) {
    nlohmann::json out = fit_json(ready.placed);
    out["blend"] = blend_name(ready.groom.expand.blend);
    return out.dump();
}

/// Empty if the groom has no head.
TriangleMesh head_at(const OpenGroom& groom, double time) {
    const PlacedGuides& placed = groom.ready().placed;
    if (!placed.body && !placed.scalp) return {};
    const TriangleMesh& rest = placed.body ? *placed.body : placed.scalp->mesh;
    const GroomTimes& times = groom.times();
    const bool on_head = times.moves() && times.pose_at;
    return posed_mesh(
        rest, on_head ? times.pose_at(groom.frame_at(time)) : ScalpPose(RigidPose{}));
}

/// Points to the arrays of `mesh`.
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

/// Points to the arrays of `groom`.
lancret_guides guides_of(const OpenGroom& groom) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    const Guides& guides = groom.ready().placed.guides;
    const GuideArrays& arrays = groom.guide_arrays();
    lancret_guides out{};
    out.guides = lancret_u32(guides.size());
    out.segments = lancret_u32(guides.segments);
    out.root_positions = guides.root_positions.data()->data();
    out.root_frames = arrays.root_frames.data();
    out.segment_lengths = guides.segment_lengths.data();
    out.curvatures = guides.curvatures.data()->data();
    out.fit_rms = arrays.fit_rms.empty() ? nullptr : arrays.fit_rms.data();
    return out;
}

}  // namespace

}  // namespace lancret::abi

using namespace lancret::abi;

lancret_status lancret_groom_get_info(const lancret_groom* groom,
                                      lancret_groom_info* info) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        write_sized(info, info_of(*groom->shared),
                    "lancret_groom_info: null, or invalid size");
    });
}

lancret_status lancret_groom_get_guides(const lancret_groom* groom,
                                        lancret_guides* guides) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        write_sized(guides, guides_of(*groom->shared),
                    "lancret_guides: null, or invalid size");
    });
}

lancret_status lancret_groom_describe(const lancret_groom* groom, lancret_text_sink sink,
                                      void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink is null");
        const std::string text = description_of(groom->shared->ready());
        call_host([&] { sink(user, text.c_str()); });
    });
}

lancret_status lancret_groom_get_head(const lancret_groom* groom, double time,
                                      lancret_mesh_sink sink, void* user) {
    if (!groom) return LANCRET_BAD_CALL;
    return run(groom->context, [&] {
        require(sink, "sink is null");
        require(std::isfinite(time), "time is not finite");
        const lancret::TriangleMesh head = head_at(*groom->shared, time);
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
        require(still, "still is null");
        require(times && time_count > 0 && time_count <= kMaxTimes,
                "times is null, or time_count is not in [1, 256]");
        const OpenGroom& shared = *groom->shared;
        std::vector<double> frames;
        for (std::size_t i = 0; i < time_count; ++i) {
            require(std::isfinite(times[i]), "a time is not finite");
            frames.push_back(shared.frame_at(times[i]));
        }
        *still = is_still(shared.times(), shared.ready().placed.places, frames);
    });
}
