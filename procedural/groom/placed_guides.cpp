#include "procedural/groom/placed_guides.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "guides/base/cancel.h"
#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "guides/base/farthest_points.h"
#include "guides/base/stopwatch.h"
#include "guides/files/guide_cache.h"
#include "guides/files/hair_file.h"
#include "guides/files/obj_file.h"
#include "guides/made/made_lawn.h"
#include "guides/mesh/closest_point.h"
#include "procedural/bind/guide_lookup.h"

namespace lancret {

namespace {

/// Roots and root tangents of the strands that have a length.
struct StrandRoots {
    std::vector<std::uint32_t> strands;     ///< indices of the strands
    std::vector<Vec3> positions, tangents;  ///< [strands]
};

StrandRoots strand_roots(const Strands& strands) {
    std::vector<std::optional<CurvePoint>> starts(strands.size());
    cancellable_for(std::size_t(0), strands.size(), [&](std::size_t i) {
        if (const auto curve = strand_curve(strands, i)) {
            starts[i] = evaluate(*curve, curve->knots.front());
            starts[i]->d1 = unit_tangent(*curve, curve->knots.front());
        }
    });
    StrandRoots out;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (!starts[i]) continue;
        out.strands.push_back(std::uint32_t(i));
        out.positions.push_back(starts[i]->position);
        out.tangents.push_back(starts[i]->d1);
    }
    return out;
}

template <class T>
std::vector<T> picked(const std::vector<T>& from, std::span<const std::uint32_t> which) {
    std::vector<T> out;
    for (const std::uint32_t i : which) out.push_back(from[i]);
    return out;
}

/// Coordinates of a file are within limits, but scaling to centimetres may exceed them.
void check_places(const std::vector<Vec3f>& places, const std::string& file) {
    if (std::ranges::all_of(places, is_place)) return;
    throw InputError(fmt::format(
        "{}: metres_per_unit in [scene] scales coordinates beyond the limit of {:.0e} cm",
        file, kLargestCoordinate));
}

}  // namespace

LoadedGroom load_groom(const GroomSettings& groom, std::vector<std::string>& warnings) {
    LoadedGroom out;
    if (groom.own_strands) {
        out.strands = *groom.own_strands;
    } else if (groom.strands_file.empty()) {
        MadeGroom made = groom.made.kind == MadeKind::lawn ? make_lawn(groom.made)
                                                           : make_groom(groom.made);
        out.strands = std::move(made.strands);
        out.scalp = std::move(made.scalp);
        out.body = std::move(made.head);
        if (!made.parting.empty()) out.partings = {std::move(made.parting)};
    } else {
        HairReport report;
        out.strands = read_hair(groom.strands_file, &report);
        out.strands.basis = groom.basis;
        warnings = std::move(report.warnings);
        out.dropped = std::move(report.dropped);
        if (report.dropped_strands > 0) {
            warnings.push_back(fmt::format("{}: ignored {} strands of one point",
                                           groom.strands_file.string(),
                                           report.dropped_strands));
        }
    }
    const float scale = float(groom.scene.centimetres_per_unit());
    if (scale != 1 && (groom.own_strands || !groom.strands_file.empty())) {
        for (Vec3f& p : out.strands.points) p *= scale;
        check_places(out.strands.points,
                     groom.own_strands ? groom.name : groom.strands_file.string());
        for (float& t : out.strands.thickness) t *= scale;
        out.strands.default_thickness *= scale;
    }
    return out;
}

std::optional<TriangleMesh> read_scalp_mesh(const GroomSettings& groom) {
    if (!groom.own_scalp && groom.scalp_file.empty()) return std::nullopt;
    TriangleMesh mesh = groom.own_scalp ? *groom.own_scalp : read_obj(groom.scalp_file);
    const float scale = float(groom.scene.centimetres_per_unit());
    for (Vec3f& p : mesh.positions) p *= scale;
    check_places(mesh.positions,
                 groom.own_scalp ? groom.name : groom.scalp_file.string());
    return mesh;
}

std::optional<Scalp> load_scalp(const GroomSettings& groom) {
    auto mesh = read_scalp_mesh(groom);
    if (!mesh) return std::nullopt;
    Scalp out = make_scalp(std::move(*mesh));
    if (!(out.area > 0)) {
        throw InputError(
            fmt::format("{}: the scalp mesh has no area",
                        groom.own_scalp ? groom.name : groom.scalp_file.string()));
    }
    return out;
}

namespace {

/// Reads the guides of a cache, which are the whole groom.
void read_cached_guides(const GroomSettings& groom, PlacedGuides& out) {
    out.guides = read_rest_guides(groom.strands_file);
    out.report.groom_strands = out.guides.size();
    out.grown.roots = out.guides.root_positions;
    for (const Mat3& frame : out.guides.root_frames) {
        out.grown.tangents.push_back(frame.col(0));
    }
}

/// Maps indices of the strands that were kept to their numbers in the file, which also
/// counts the `dropped` ones. Both ascend.
std::vector<std::uint32_t> numbers_in_file(std::span<const std::uint32_t> strands,
                                           std::span<const std::uint32_t> dropped) {
    std::vector<std::uint32_t> out;
    std::size_t gone = 0;
    for (std::uint32_t i : strands) {
        while (gone < dropped.size() && dropped[gone] <= i + gone) ++gone;
        out.push_back(i + std::uint32_t(gone));
    }
    return out;
}

/// Selects guides from the strands and fits them.
void fit_selected(const GroomSettings& groom, const Strands& strands,
                  const StrandRoots& roots, PlacedGuides& out) {
    const std::uint32_t count = groom.guides.of(roots.strands.size());
    auto selected = farthest_points(roots.positions, count, groom.seed);
    if (const std::size_t more =
            choose_for_regions(out.grown.regions, roots.positions, selected);
        more > 0) {
        out.report.warnings.push_back(fmt::format(
            "{}: {} regions had none of the {} selected guides and were given one each",
            groom.name, more, count));
    }
    std::vector<Vec3> surface_tangents;
    if (out.scalp) {
        const ClosestPoint closest(out.scalp->mesh);
        for (const std::uint32_t i : selected) {
            const MeshPoint point = closest.closest(roots.positions[i]).point;
            surface_tangents.push_back(surface_frame(*out.scalp, point).col(1));
        }
    }
    FittedGuides fitted =
        fit_guides(strands, picked(roots.strands, selected), surface_tangents, groom.fit);
    out.guides = std::move(fitted.guides);
    out.fits = std::move(fitted.reports);
    if (!out.grown.regions.strands.empty()) {
        out.guide_regions = picked(out.grown.regions.strands, selected);
    }
}

/// Projects the guides' roots onto the scalp and takes its normals there. Without a
/// scalp, the normal is the direction of the guide at its root.
void stand_on_scalp(PlacedGuides& out) {
    if (!out.scalp) {
        for (const Mat3& frame : out.guides.root_frames) {
            out.normals.push_back(frame.col(0).cast<float>());
        }
        return;
    }
    // A root closer than this, cm, is on the surface to the precision of a float file.
    constexpr double kOnSurface = 1e-4;
    const ClosestPoint closest(out.scalp->mesh);
    for (Vec3& root : out.guides.root_positions) {
        const ClosestResult nearest = closest.closest(root);
        root = nearest.position;
        out.places.push_back(nearest.point);
        out.normals.push_back(scalp_normal(*out.scalp, nearest.point).cast<float>());
        out.report.snapped_roots += nearest.distance > kOnSurface;
        out.report.largest_snap = std::max(out.report.largest_snap, nearest.distance);
    }
}

}  // namespace

std::vector<Polyline> groom_partings(const GroomSettings& groom,
                                     std::span<const Polyline> made,
                                     const std::optional<Scalp>& scalp,
                                     std::vector<std::string>& warnings) {
    double farthest = 0;
    const bool has_partings = !groom.partings.empty();
    auto out = partings_on_scalp(has_partings ? groom.partings : made, scalp, farthest);
    constexpr double kFarOff = 1;  // cm: likely drawn for another head or in another unit
    if (has_partings && farthest > kFarOff) {
        warnings.push_back(fmt::format(
            "{}: the points of [[partings]] are up to {:.3g} cm off the scalp and were "
            "moved onto it; check that both use the same unit",
            groom.name, farthest));
    }
    return out;
}

PlacedGuides place_guides(const GroomSettings& groom, const StageCallback& stage) {
    const auto enter = [&](GroomStage next) {
        if (stage) stage(next);
    };
    PlacedGuides out;
    Stopwatch watch;
    enter(GroomStage::load);
    out.scalp = load_scalp(groom);
    if (groom.strands_file.extension() == ".h5") {
        read_cached_guides(groom, out);
        std::vector<std::uint32_t> numbers(out.guides.size());
        std::iota(numbers.begin(), numbers.end(), 0u);
        out.grown.regions = read_regions(groom.regions, groom.name, out.scalp,
                                         out.grown.roots, numbers, numbers.size());
        out.guide_regions = out.grown.regions.strands;
        out.partings = groom_partings(groom, {}, out.scalp, out.report.warnings);
        stand_on_scalp(out);
        out.lookup = std::make_shared<GuideLookup>(out.guides, out.guide_regions);
        out.report.seconds.load = watch.lap();
        return out;
    }
    LoadedGroom loaded = load_groom(groom, out.report.warnings);
    out.report.groom_strands = loaded.strands.size();
    if (!out.scalp && loaded.scalp) {
        out.scalp = make_scalp(std::move(*loaded.scalp));
        out.body = std::move(loaded.body);
        out.whole_scalp = true;
    }
    const StrandRoots roots = strand_roots(loaded.strands);
    if (roots.strands.empty()) {
        throw InputError(fmt::format("{}: no strand has a length", groom.name));
    }
    if (const std::size_t flat = loaded.strands.size() - roots.strands.size(); flat > 0) {
        out.report.warnings.push_back(
            fmt::format("{}: ignored {} strands of zero length", groom.name, flat));
    }
    out.grown.regions =
        read_regions(groom.regions, groom.name, out.scalp, roots.positions,
                     numbers_in_file(roots.strands, loaded.dropped),
                     loaded.strands.size() + loaded.dropped.size());
    out.partings = groom_partings(groom, loaded.partings, out.scalp, out.report.warnings);
    out.report.seconds.load = watch.lap();

    enter(GroomStage::fit);
    if (groom.guides_file.empty()) {
        fit_selected(groom, loaded.strands, roots, out);
    } else {
        out.guides = read_rest_guides(groom.guides_file);
        out.guide_regions = regions_at(out.grown.regions, out.scalp, roots.positions,
                                       out.guides.root_positions);
    }
    stand_on_scalp(out);
    out.lookup = std::make_shared<GuideLookup>(out.guides, out.guide_regions);
    out.grown.roots = roots.positions;
    out.grown.tangents = roots.tangents;
    out.report.seconds.fit = watch.lap();
    return out;
}

}  // namespace lancret
