#include "procedural/abi/open_groom.h"

#include <fmt/format.h>

#include <algorithm>

#include "guides/base/errors.h"
#include "procedural/expand/intervals.h"
#include "procedural/groom/head_pose.h"

namespace lancret::abi {

OpenGroom::OpenGroom(const SourcedGroom& sourced, std::uint32_t chunk_strands,
                     const StageCallback& stage, Warn warn)
    : warn_(std::move(warn)),
      cache_(stamp_of(cache_of(sourced.groom))),  // before the cache is read
      chunked_(make_chunked_groom(sourced.groom, chunk_strands, stage)),
      times_(groom_times(sourced.groom, head_pose(sourced.motion, sourced.groom))) {
    if (times_.moves()) prepare_frames(chunked_.ready, times_);
    // No longer needed: the guides are fitted and placed.
    chunked_.ready.groom.own_strands.reset();
    chunked_.ready.groom.own_scalp.reset();
    expect_same_cache();
    const PlacedGuides& placed = ready().placed;
    for (const Mat3& frame : placed.guides.root_frames) {
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) arrays_.root_frames.push_back(frame(r, c));
        }
    }
    for (const FitReport& fit : placed.fits) arrays_.fit_rms.push_back(fit.rms);
}

void OpenGroom::expect_same_cache() const {
    if (!times_.moves() || stamp_of(times_.cache) == cache_) return;
    throw InputError(times_.cache.string() + ": has changed since it was opened");
}

double OpenGroom::frame_at(double time) const {
    if (!times_.moves()) return 0;
    return std::clamp(time, double(times_.first()), double(times_.last()));
}

std::shared_ptr<const GuidePose> OpenGroom::pose(
    double frame, const std::shared_ptr<const StrandClasses>& classes) const {
    return poses_.get({frame, classes.get()}, [&] {
        expect_same_cache();
        const PlacedGuides& placed = ready().placed;
        const bool moves = times_.moves();
        auto out = std::make_shared<GuidePose>();
        out->classes = classes;
        out->guides =
            moves ? guides_at(times_, placed.places, frame) : ready().placed.guides;
        expect_same_cache();
        // Guides only, no children.
        Binding guides_only;
        guides_only.guide_normals = placed.normals;
        const RestPlaces rest = rest_places(guides_only, placed);
        const bool on_head = moves && times_.pose_at;
        out->scalp =
            posed_scalp(rest, on_head ? times_.pose_at(frame) : ScalpPose(RigidPose{}));
        if (moves) pose_binding_on(guides_only, rest, out->scalp);
        out->classed = classed_guides(out->guides, *classes, guides_only.guide_normals,
                                      ready().groom.expand.blend);
        return out;
    });
}

std::shared_ptr<const StrandClasses> OpenGroom::classes(CurveBasis basis, float max_error,
                                                        bool alike) const {
    const GroomSettings& groom = ready().groom;
    const bool as_groom = max_error == 0;
    basis = layout_of(basis).same_curve;
    const bool all_alike = alike || !groom.adapt || groom.expand.has_faces();
    return classes_.get({basis, max_error, all_alike}, [&] {
        if (as_groom && (groom.intervals || basis == groom.expand.basis)) {
            return std::make_shared<const StrandClasses>(
                all_alike ? StrandClasses{{ready().profiles.count}} : ready().classes);
        }
        const double tolerance = as_groom ? groom.tolerance : double(max_error);
        expect_same_cache();
        double reached = 0;
        const int finest = intervals_in_time(ready(), times_, basis, tolerance,
                                             kMaxRequestedIntervals, &reached);
        if (reached > tolerance) {
            warn_(fmt::format(
                "{}: curves deviate from their strands by up to {:.2g} cm, more than the "
                "requested {:.2g} cm: strands have at most {} intervals",
                groom.name, reached, tolerance, finest));
        }
        return std::make_shared<const StrandClasses>(
            all_alike ? StrandClasses{{finest}}
                      : classes_in_time(ready(), times_, basis, tolerance, finest));
    });
}

std::size_t OpenGroom::bytes() const {
    const PlacedGuides& placed = ready().placed;
    const auto of = [](const auto& v) { return v.size() * sizeof(v[0]); };
    std::size_t out = chunked_.bytes() + ready().binding.bytes() +
                      ready().sample.bytes() + of(arrays_.root_frames) +
                      of(arrays_.fit_rms);
    out += of(placed.guides.root_positions) + of(placed.guides.root_frames) +
           of(placed.guides.segment_lengths) + of(placed.guides.curvatures);
    out += of(placed.grown.roots) + of(placed.grown.tangents) + of(placed.normals);
    const GuideProfiles<float>& profiles = ready().profiles;
    out += of(profiles.intervals) + of(profiles.joints) + of(profiles.root_frames) +
           of(profiles.lengths) + of(profiles.positions) + of(profiles.frames) +
           of(profiles.curvatures) + of(profiles.bishop) + of(profiles.spines) +
           of(profiles.advances);
    const auto of_mesh = [&](const TriangleMesh& mesh) {
        return of(mesh.positions) + of(mesh.triangles) + of(mesh.uvs);
    };
    if (placed.scalp) {
        out += of_mesh(placed.scalp->mesh) + of(placed.scalp->normals) +
               of(placed.scalp->areas);
    }
    if (placed.body) out += of_mesh(*placed.body);
    return out;
}

}  // namespace lancret::abi
