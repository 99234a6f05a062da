#include "tools/preview/check_views.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <map>

#include "guides/base/errors.h"
#include "guides/bodies/signed_distance.h"
#include "procedural/check/strand.h"
#include "procedural/check/tolerances.h"
#include "render_test/image/colour_scale.h"

namespace lancret {

namespace {

using Kind = ColourScale::Kind;

/// Depth up to which a strand lies on the surface, cm: the tolerance of its root.
const float kOnSurface = float(CheckTolerances{}.root);

/// The 99th percentile of the absolute values above `least`; 0 if there is none.
float typical_maximum(const std::vector<float>& values, float least) {
    std::vector<float> sizes;
    sizes.reserve(values.size());
    for (const float value : values) {
        const float size = std::abs(value);
        if (size > least && size < std::numeric_limits<float>::max()) {
            sizes.push_back(size);
        }
    }
    if (sizes.empty()) return 0;
    const auto rank = sizes.begin() + std::ptrdiff_t(0.99 * double(sizes.size() - 1));
    std::ranges::nth_element(sizes, rank);
    return *rank;
}

/// Four decades up to a limit of the check; red above it.
ColourScale error_scale(double limit) {
    return {Kind::logarithmic, float(1e-4 * limit), float(limit), "fails", std::nullopt};
}

/// From 0, or symmetric about 0, to the typical maximum.
ColourScale size_scale(Kind kind, const std::vector<float>& values, float least) {
    const float maximum = typical_maximum(values, least);
    const float high = maximum > 0 ? maximum : 1.0f;
    return {kind, kind == Kind::diverging ? -high : 0.0f, high, "", std::nullopt};
}

/// The most frequent values as swatches with their shares.
std::vector<Swatch> most_frequent(std::span<const std::uint32_t> values) {
    constexpr std::size_t kMax = 8;
    std::map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t value : values) ++counts[value];
    std::vector<std::pair<std::size_t, std::uint32_t>> order;
    for (const auto& [what, count] : counts) order.emplace_back(count, what);
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    std::vector<Swatch> out;
    for (std::size_t i = 0; i < std::min(kMax, order.size()); ++i) {
        const double share = 100 * double(order[i].first) / double(values.size());
        out.push_back({fmt::format("{}: {:.3g}%", order[i].second, share),
                       category_colour(order[i].second)});
    }
    return out;
}

StrandValues figures(const ViewSubject& subject, int figure) {
    return subject.strands.figures(figure, 0, subject.shown.curves);
}

void set_length_error(const ViewSubject& subject, CheckView& view) {
    view.title = "length error, relative";
    view.values = figures(subject, LANCRET_LENGTH_ERROR);
    view.scale = error_scale(CheckTolerances{}.length);
}

void set_orthogonality(const ViewSubject& subject, CheckView& view) {
    view.title = "orthogonality of frames, |R^T R - I|";
    view.values = figures(subject, LANCRET_ORTHOGONALITY);
    view.scale = error_scale(CheckTolerances{}.orthogonality);
}

void set_curvature(const ViewSubject& subject, CheckView& view) {
    view.title = "curvature, 1/cm";
    view.values = figures(subject, LANCRET_CURVATURE);
    view.scale = size_scale(Kind::sequential, view.values.values, 0);
}

void set_torsion(const ViewSubject& subject, CheckView& view) {
    const auto blend = subject.groom.expand.blend;
    if (!traits_of(blend).has_torsion) {
        throw InputError(
            fmt::format("--view torsion: blend {} carries frames without twist, and so "
                        "without torsion",
                        blend_name(blend)));
    }
    view.title = "torsion, 1/cm, right-handed above 0";
    view.values = figures(subject, LANCRET_TORSION);
    view.scale = size_scale(Kind::diverging, view.values.values, 0);
}

/// Mixes one colour per guide by the weights of each strand; values are the strongest
/// guide of each strand.
void set_influence(const ViewSubject& subject, CheckView& view) {
    view.title = fmt::format("influence of {} guides, mixed; strongest:",
                             subject.plugin.info().guides);
    const StrandGuides binding = subject.strands.guides();
    const std::size_t strands = subject.strands.size(), n = binding.neighbours;
    std::vector<std::uint32_t> strongest(strands);
    view.colours.assign(strands, Vec3f::Zero());
    tbb::parallel_for(std::size_t(0), strands, [&](std::size_t i) {
        const auto weights = std::span(binding.weights).subspan(i * n, n);
        for (std::size_t k = 0; k < n; ++k) {
            if (!(weights[k] > 0)) continue;
            view.colours[i] += weights[k] * category_colour(binding.guides[i * n + k]);
        }
        const auto heaviest = std::ranges::max_element(weights) - weights.begin();
        strongest[i] = binding.guides[i * n + std::size_t(heaviest)];
    });
    view.values.values.assign(strongest.begin(), strongest.end());
    view.swatches = most_frequent(strongest);
}

void set_regions(const ViewSubject& subject, CheckView& view) {
    if (!subject.groom.regions.any()) {
        throw InputError(fmt::format(
            "--view region: {} has no regions; its [regions] table names them",
            subject.groom.name));
    }
    view.title = "region, share of the strands";
    view.values = figures(subject, LANCRET_REGION);
    const std::vector<std::uint32_t> regions(view.values.values.begin(),
                                             view.values.values.end());
    for (const std::uint32_t region : regions) {
        view.colours.push_back(category_colour(region));
    }
    view.swatches = most_frequent(regions);
}

void set_penetration(const ViewSubject& subject, CheckView& view) {
    const ShownTime& shown = subject.shown;
    if (!shown.body || shown.body->triangles.empty()) {
        throw InputError(fmt::format(
            "--view penetration: {} has no surface to penetrate; give --scalp",
            subject.groom.name));
    }
    view.title = "greatest depth below the surface, cm";
    view.values = penetration_values(shown.curves, *shown.body);
    view.scale = size_scale(Kind::sequential, view.values.values, kOnSurface);
    view.scale.clean = kOnSurface;
    view.apart = strands_apart(view, shown.curves, &*shown.body, subject.aspect);
}

}  // namespace

CheckView view_of(const ViewRequest& request, const ViewSubject& subject) {
    CheckView out;
    switch (request.view) {
        case View::length_error:
            set_length_error(subject, out);
            break;
        case View::orthogonality:
            set_orthogonality(subject, out);
            break;
        case View::curvature:
            set_curvature(subject, out);
            break;
        case View::torsion:
            set_torsion(subject, out);
            break;
        case View::influence:
            set_influence(subject, out);
            break;
        case View::region:
            set_regions(subject, out);
            break;
        case View::penetration:
            set_penetration(subject, out);
            break;
    }
    out.ids = subject.shown.curves.ids;
    if (request.range) {
        out.scale.low = float(request.range->x());
        out.scale.high = float(request.range->y());
        if (!out.scale.over.empty()) out.scale.over = "above";
    }
    return out;
}

void keep_range(const CheckView& view, ViewRequest& request) {
    // Scales of errors are the same in all pictures.
    if (!has_scale(request.view) || is_error(request.view)) return;
    request.range = Vec2(view.scale.low, view.scale.high);
}

StrandValues penetration_values(const Curves& curves, const TriangleMesh& surface) {
    const SignedDistance distance(surface);
    StrandValues out;
    out.values.assign(curves.strands, 0);
    tbb::parallel_for(std::uint32_t(0), curves.strands, [&](std::uint32_t i) {
        const EmittedStrand strand = emitted_strand(curves, i);
        Vec3 queried = Vec3::Zero();
        double clear = 0,
               deepest = 0;  // everything within `clear` of `queried` is outside
        for (std::size_t half = 0; half <= 2 * strand.segments(); ++half) {
            const bool tip = half == 2 * strand.segments();
            const Vec3 place = tip ? strand.position(half / 2 - 1, 1)
                                   : strand.position(half / 2, half % 2 ? 0.5 : 0);
            if (!place.allFinite()) {
                deepest = std::numeric_limits<float>::max();
                break;
            }
            if ((place - queried).norm() < clear) continue;
            clear = distance.at(place).distance;
            queried = place;
            deepest = std::max(deepest, -clear);
        }
        out.values[i] = float(deepest);
    });
    return out;
}

}  // namespace lancret
