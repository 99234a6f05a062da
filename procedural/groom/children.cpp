#include "procedural/groom/children.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "guides/base/errors.h"
#include "procedural/expand/class_choice.h"
#include "procedural/expand/intervals.h"
#include "procedural/roots/density.h"

namespace lancret {

namespace {

const Scalp* scalp_of(const PlacedGuides& source) {
    return source.scalp ? &*source.scalp : nullptr;
}

}  // namespace

RootPlaces child_places(const GroomSettings& groom, const PlacedGuides& source) {
    RootPlaces out;
    const std::uint32_t count =
        child_count(groom, source.scalp.has_value(), source.grown_roots.size());
    if (!source.scalp) {
        out.on_strands = roots_of_strands(source.grown_roots, source.grown_tangents,
                                          count, groom.seed, groom.name);
        return out;
    }
    const double everywhere = std::numeric_limits<double>::infinity();
    const double growth = groom.growth_distance ? *groom.growth_distance
                          : source.whole_scalp  ? everywhere
                                                : growth_of_spacing(source.grown_roots);
    try {
        out.on_scalp =
            places_on_scalp(*source.scalp, source.grown_roots, count, groom.seed, growth);
    } catch (const InputError&) {
        throw InputError(fmt::format(
            "{}: has hardly a place within {:.3g} cm of the groom's strands, where "
            "hair may grow; their roots are up to {:.3g} cm away from it. Are they in "
            "one place and one unit? [scalp] growth_distance sets the reach",
            groom.scalp_file.empty() ? "scalp" : groom.scalp_file.string(), growth,
            source.largest_snap));
    }
    return out;
}

Roots child_roots(const PlacedGuides& source, const RootPlaces& places,
                  std::span<const std::uint32_t> ids) {
    return roots_at(scalp_of(source), places, ids);
}

Roots pruned_roots(const GroomSettings& groom, const PlacedGuides& source,
                   const RootPlaces& places, std::span<const std::uint32_t> ids,
                   double density) {
    if (density == 1) return child_roots(source, places, ids);
    std::vector<std::uint32_t> kept(ids.begin(), ids.end());
    std::vector<float> widths = prune(kept, groom.seed, density);
    Roots out = child_roots(source, places, kept);
    out.widths = std::move(widths);
    return out;
}

Binding bind_children(const GroomSettings& groom, const PlacedGuides& source,
                      Roots roots) {
    BindBorders borders;
    borders.guide_regions = source.guide_regions;
    borders.child_regions = child_regions(source.regions, source.grown_roots, roots);
    const Partings partings(source.partings);
    if (partings.size() > 0) borders.partings = &partings;
    return lancret::bind(std::move(roots), source.guides, *source.lookup, source.normals,
                         groom.bind, borders);
}

Binding sample_of_children(const GroomSettings& groom, const PlacedGuides& source,
                           const RootPlaces& places) {
    std::vector<std::uint32_t> ids(std::min(places.size(), kSampledChildren));
    std::iota(ids.begin(), ids.end(), 0u);
    return bind_children(groom, source, child_roots(source, places, ids));
}

int child_intervals(const GroomSettings& groom, const PlacedGuides& source,
                    const Binding& sample) {
    if (groom.intervals) return *groom.intervals;
    try {
        return intervals_within(sample, source.guides, groom.expand.blend,
                                groom.tolerance, groom.expand.basis);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", groom.name, error.what()));
    }
}

StrandClasses child_classes(const GroomSettings& groom, const PlacedGuides& source,
                            const Binding& sample, int finest) {
    if (!groom.adapts()) return {{finest}};
    StrandClasses all = coarsest_classes(source.guides, finest);
    refine_classes(all, sample, source.guides, groom.tolerance, groom.expand);
    return used_classes(all);
}

}  // namespace lancret
