#include "procedural/generator.h"

#include <fmt/format.h>

#include "guides/errors.h"
#include "procedural/child_roots.h"
#include "procedural/emission.h"
#include "procedural/faces.h"
#include "procedural/stopwatch.h"

namespace lancret {

Generator make_generator(const Groom& groom, const StageCallback& stage) {
    Generator out;
    out.groom = groom;
    out.source = groom_guides(groom, stage);
    out.seconds = out.source.seconds;
    if (stage) stage("bind");
    Stopwatch watch;
    const GroomGuides& source = out.source;
    const std::uint32_t count =
        child_count(groom, source.scalp.has_value(), source.grown_roots.size());
    Roots roots;
    if (source.scalp) {
        const double everywhere = std::numeric_limits<double>::infinity();
        const double growth = groom.growth_distance ? *groom.growth_distance
                              : source.whole_scalp
                                  ? everywhere
                                  : growth_of_spacing(source.grown_roots);
        try {
            roots = roots_on_scalp(*source.scalp, source.grown_roots, count, groom.seed,
                                   growth);
        } catch (const InputError&) {
            throw InputError(fmt::format(
                "{}: has hardly a place within {:.3g} cm of the groom's strands, where "
                "hair may grow; their roots are up to {:.3g} cm away from it. Are they "
                "in "
                "one place and one unit? [scalp] growth_distance sets the reach",
                groom.scalp_file.string(), growth, source.largest_snap));
        }
    } else {
        roots = own_roots(source.grown_roots, source.grown_tangents, count, groom.seed,
                          groom.name);
    }
    BindBorders borders;
    borders.guide_regions = source.guide_regions;
    borders.child_regions = child_regions(source.regions, source.grown_roots, roots);
    const Partings partings(source.partings);
    if (partings.size() > 0) borders.partings = &partings;
    out.binding = lancret::bind(std::move(roots), source.guides, source.normals,
                                groom.bind, borders);
    int intervals = 0;
    try {
        intervals = groom.intervals
                        ? *groom.intervals
                        : intervals_within(out.binding, source.guides, groom.expand.blend,
                                           groom.tolerance, groom.expand.basis);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", groom.name, error.what()));
    }
    out.profiles = guide_profiles<float>(source.guides, intervals);
    if (groom.expand.has_faces())
        out.binding.faces = rest_faces(out.binding, out.profiles, groom.expand.blend);
    out.seconds.bind = watch.lap();
    return out;
}

}  // namespace lancret
