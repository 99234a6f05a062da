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

const Scalp* scalp_of(const PlacedGuides& placed) {
    return placed.scalp ? &*placed.scalp : nullptr;
}

}  // namespace

RootPlaces child_places(const GroomSettings& groom, const PlacedGuides& placed) {
    RootPlaces out;
    const std::uint32_t count =
        child_count(groom, placed.scalp.has_value(), placed.grown.roots.size());
    if (!placed.scalp) {
        out.on_strands = roots_of_strands(placed.grown.roots, placed.grown.tangents,
                                          count, groom.seed, groom.name);
        return out;
    }
    const double everywhere = std::numeric_limits<double>::infinity();
    const double growth = groom.growth_distance ? *groom.growth_distance
                          : placed.whole_scalp  ? everywhere
                                                : growth_of_spacing(placed.grown.roots);
    try {
        out.on_scalp =
            places_on_scalp(*placed.scalp, placed.grown.roots, count, groom.seed, growth);
    } catch (const InputError&) {
        throw InputError(fmt::format(
            "{}: almost no part of it is within {:.3g} cm of the groom's strands, where "
            "hair may grow; their roots are up to {:.3g} cm away from it. Check that "
            "both "
            "have the same position and unit; [scalp] growth_distance sets the distance",
            groom.scalp_file.empty() ? "scalp" : groom.scalp_file.string(), growth,
            placed.report.largest_snap));
    }
    return out;
}

Roots child_roots(const PlacedGuides& placed, const RootPlaces& places,
                  std::span<const std::uint32_t> ids) {
    return roots_at(scalp_of(placed), places, ids);
}

Roots pruned_roots(const GroomSettings& groom, const PlacedGuides& placed,
                   const RootPlaces& places, std::span<const std::uint32_t> ids,
                   double density) {
    if (density == 1) return child_roots(placed, places, ids);
    std::vector<std::uint32_t> kept(ids.begin(), ids.end());
    std::vector<float> widths = prune(kept, groom.seed, density);
    Roots out = child_roots(placed, places, kept);
    out.widths = std::move(widths);
    return out;
}

Binding bind_children(const GroomSettings& groom, const PlacedGuides& placed,
                      Roots roots) {
    BindBorders borders;
    borders.guide_regions = placed.guide_regions;
    borders.child_regions =
        child_regions(placed.grown.regions, placed.grown.roots, roots);
    const Partings partings(placed.partings);
    if (partings.size() > 0) borders.partings = &partings;
    return lancret::bind(std::move(roots), placed.guides, *placed.lookup, placed.normals,
                         groom.bind, borders);
}

Binding sample_of_children(const GroomSettings& groom, const PlacedGuides& placed,
                           const RootPlaces& places) {
    std::vector<std::uint32_t> ids(std::min(places.size(), kSampledChildren));
    std::iota(ids.begin(), ids.end(), 0u);
    return bind_children(groom, placed, child_roots(placed, places, ids));
}

int child_intervals(const GroomSettings& groom, const PlacedGuides& placed,
                    const Binding& sample) {
    if (groom.intervals) return *groom.intervals;
    try {
        return intervals_within(sample, placed.guides, groom.expand.blend,
                                groom.tolerance, groom.expand.basis)
            .count;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", groom.name, error.what()));
    }
}

StrandClasses child_classes(const GroomSettings& groom, const PlacedGuides& placed,
                            const Binding& sample, int finest) {
    if (!groom.adapts()) return {{finest}};
    StrandClasses all = coarsest_classes(placed.guides, finest);
    refine_classes(all, sample, placed.guides, groom.tolerance, groom.expand);
    return used_classes(all);
}

}  // namespace lancret
