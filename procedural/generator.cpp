#include "procedural/generator.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <chrono>

#include "guides/closest_point.h"
#include "guides/errors.h"
#include "guides/farthest_points.h"
#include "guides/hair_file.h"
#include "guides/obj_file.h"
#include "procedural/child_roots.h"
#include "procedural/emission.h"

namespace lancret {

namespace {

/// Adds the time since it was made, or since it was last read, to a stage.
class Stopwatch {
  public:
    void add_to(double& seconds) {
        const auto now = std::chrono::steady_clock::now();
        seconds += std::chrono::duration<double>(now - start_).count();
        start_ = now;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Roots and root tangents of strands that have a length.
struct StrandRoots {
    std::vector<std::uint32_t> strands;  ///< which they are
    std::vector<Vec3> positions, tangents;
};

StrandRoots strand_roots(const Strands& strands) {
    std::vector<std::optional<CurvePoint>> starts(strands.size());
    tbb::parallel_for(std::size_t(0), strands.size(), [&](std::size_t i) {
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

/// Where guides stand: on the scalp, or as they are.
struct GuidePlaces {
    std::vector<Vec3> positions, surface_tangents;
    std::vector<Vec3f> normals;
};

GuidePlaces places_on_scalp(const Scalp& scalp, std::span<const Vec3> roots,
                            Generator& out) {
    // Below a thousandth of a millimetre a root in a single-precision file is on the
    // surface.
    constexpr double kOnSurface = 1e-4;
    const ClosestPoint closest(scalp.mesh);
    GuidePlaces places;
    for (const Vec3& root : roots) {
        const ClosestResult nearest = closest.closest(root);
        places.positions.push_back(nearest.position);
        places.surface_tangents.push_back(surface_frame(scalp, nearest.point).col(1));
        places.normals.push_back(scalp_normal(scalp, nearest.point).cast<float>());
        out.snapped_roots += nearest.distance > kOnSurface;
        out.largest_snap = std::max(out.largest_snap, nearest.distance);
    }
    return places;
}

template <class T>
std::vector<T> picked(const std::vector<T>& from, std::span<const std::uint32_t> which) {
    std::vector<T> out;
    for (const std::uint32_t i : which) out.push_back(from[i]);
    return out;
}

}  // namespace

LoadedGroom load_groom(const Groom& groom) {
    LoadedGroom out;
    if (groom.strands_file.empty()) {
        MadeGroom made = make_groom(groom.made);
        out.strands = std::move(made.strands);
        out.scalp = std::move(made.scalp);
    } else {
        HairReport report;
        out.strands = read_hair(groom.strands_file, &report);
        out.strands.basis = groom.basis;
        out.warnings = std::move(report.warnings);
        if (report.dropped_strands > 0) {
            out.warnings.push_back(
                fmt::format("{}: {} strands of one point were left out",
                            groom.strands_file.string(), report.dropped_strands));
        }
    }
    if (!groom.scalp_file.empty()) out.scalp = read_obj(groom.scalp_file);
    const float scale = float(groom.scene.centimetres_per_unit());
    if (scale != 1 && !groom.strands_file.empty()) {
        for (Vec3f& p : out.strands.points) p *= scale;
        for (float& t : out.strands.thickness) t *= scale;
        out.strands.default_thickness *= scale;
        if (out.scalp) {
            for (Vec3f& p : out.scalp->positions) p *= scale;
        }
    }
    return out;
}

Generator make_generator(const Groom& groom, const StageCallback& stage) {
    const auto enter = [&](const char* name) {
        if (stage) stage(name);
    };
    Generator out;
    out.groom = groom;
    Stopwatch watch;

    enter("load");
    LoadedGroom loaded = load_groom(groom);
    out.warnings = std::move(loaded.warnings);
    out.groom_strands = loaded.strands.size();
    if (loaded.scalp) out.scalp = make_scalp(std::move(*loaded.scalp));
    const StrandRoots roots = strand_roots(loaded.strands);
    if (roots.strands.empty()) {
        throw InputError(fmt::format("{}: no strand has a length", groom.name));
    }
    if (const std::size_t flat = loaded.strands.size() - roots.strands.size(); flat > 0) {
        out.warnings.push_back(fmt::format(
            "{}: {} strands without a length were left out", groom.name, flat));
    }
    watch.add_to(out.seconds.load);

    enter("fit");
    const std::uint32_t count = groom.guides.of(roots.strands.size());
    const auto chosen = farthest_points(roots.positions, count, groom.seed);
    GuidePlaces places;
    if (out.scalp) {
        places = places_on_scalp(*out.scalp, picked(roots.positions, chosen), out);
    } else {
        places.positions = picked(roots.positions, chosen);
        for (const std::uint32_t i : chosen) {
            places.normals.push_back(roots.tangents[i].cast<float>());
        }
    }
    FittedGuides fitted = fit_guides(loaded.strands, picked(roots.strands, chosen),
                                     places.surface_tangents, groom.fit);
    out.guides = std::move(fitted.guides);
    out.guides.root_positions = std::move(places.positions);
    out.fits = std::move(fitted.reports);
    watch.add_to(out.seconds.fit);

    enter("bind");
    Roots children = out.scalp
                         ? roots_on_scalp(*out.scalp, roots.positions, groom.strands,
                                          groom.seed, groom.growth_distance)
                         : own_roots(roots.positions, roots.tangents, groom.strands,
                                     groom.seed, groom.name);
    const int intervals = groom.intervals ? *groom.intervals
                                          : intervals_within(out.guides, groom.tolerance,
                                                             groom.expand.basis);
    out.profiles = guide_profiles<float>(out.guides, intervals);
    out.binding =
        bind(std::move(children), out.guides, std::move(places.normals), groom.bind);
    watch.add_to(out.seconds.bind);
    return out;
}

}  // namespace lancret
