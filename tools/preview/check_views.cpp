#include "tools/preview/check_views.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "guides/bodies/signed_distance.h"
#include "procedural/check/strand.h"
#include "procedural/check/tolerances.h"
#include "render_test/image/colour_scale.h"

namespace lancret {

namespace {

using Kind = ColourScale::Kind;

/// Below this a strand lies on the surface: as near as its root must be, cm.
const float kOnSurface = float(CheckTolerances{}.root);

bool has_scale(View view) { return view != View::influence && view != View::region; }

bool is_error(View view) {
    return view == View::length_error || view == View::orthogonality;
}

/// The size that one in a hundred exceeds, of those above `least`; 0 where there is none.
float most_of(const std::vector<float>& values, float least) {
    std::vector<float> sizes;
    sizes.reserve(values.size());
    for (const float value : values) {
        const float size = std::abs(value);
        if (size > least && size < std::numeric_limits<float>::max()) {
            sizes.push_back(size);
        }
    }
    if (sizes.empty()) return 0;
    const auto at = sizes.begin() + std::ptrdiff_t(0.99 * double(sizes.size() - 1));
    std::ranges::nth_element(sizes, at);
    return *at;
}

/// Up to a limit of the check in four decades; above it red.
ColourScale error_scale(double limit) {
    return {Kind::logarithmic, float(1e-4 * limit), float(limit), "fails", std::nullopt};
}

/// From 0, or from as much below it, to the size that one in a hundred exceeds.
ColourScale size_scale(Kind kind, const std::vector<float>& values, float least) {
    const float most = most_of(values, least);
    const float high = most > 0 ? most : 1.0f;
    return {kind, kind == Kind::diverging ? -high : 0.0f, high, "", std::nullopt};
}

/// The most frequent of the values as swatches with their shares.
std::vector<Swatch> frequent(std::span<const std::uint32_t> values, const char* name) {
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
        out.push_back({fmt::format("{}{}: {:.3g}%", name, order[i].second, share),
                       category_colour(order[i].second)});
    }
    return out;
}

/// Each guide a colour, mixed by the weights of every strand; and the guide that each
/// follows most.
void set_influence(CheckView& view, const StrandGuides& bound, std::size_t strands) {
    const std::size_t n = bound.neighbours;
    std::vector<std::uint32_t> leading(strands);
    view.colours.assign(strands, Vec3f::Zero());
    tbb::parallel_for(std::size_t(0), strands, [&](std::size_t i) {
        const auto weights = std::span(bound.weights).subspan(i * n, n);
        for (std::size_t k = 0; k < n; ++k) {
            if (!(weights[k] > 0)) continue;
            view.colours[i] += weights[k] * category_colour(bound.guides[i * n + k]);
        }
        const auto most = std::ranges::max_element(weights) - weights.begin();
        leading[i] = bound.guides[i * n + std::size_t(most)];
    });
    view.values.values.assign(leading.begin(), leading.end());
    view.swatches = frequent(leading, "");
}

void set_regions(CheckView& view) {
    const std::vector<std::uint32_t> regions(view.values.values.begin(),
                                             view.values.values.end());
    for (const std::uint32_t region : regions) {
        view.colours.push_back(category_colour(region));
    }
    view.swatches = frequent(regions, "");
}

}  // namespace

std::string_view view_name(View view) {
    return std::ranges::find(kViewNames, view, &ViewName::view)->name;
}

std::optional<View> view_named(std::string_view name) {
    const auto* const found = std::ranges::find(kViewNames, name, &ViewName::name);
    if (found == std::end(kViewNames)) return std::nullopt;
    return found->view;
}

void check_range(const ViewRequest& request) {
    if (!request.range) return;
    // As they are used: two doubles may be one float.
    const Eigen::Vector2f range = request.range->cast<float>();
    if (!(range.x() < range.y()) || !range.allFinite()) {
        throw InputError(
            "--view-range: the two numbers are too near each other, or too far from 1, "
            "to "
            "tell colours apart by");
    }
    if (!has_scale(request.view)) {
        throw InputError(fmt::format("--view-range: the view {} has no scale",
                                     view_name(request.view)));
    }
    if (is_error(request.view) && !(range.x() >= std::numeric_limits<float>::min())) {
        throw InputError(fmt::format(
            "--view-range: the scale of {} is logarithmic and begins above 0, at "
            "1e-37 or more",
            view_name(request.view)));
    }
}

CheckView view_of(const ViewRequest& request, const PluginGroom& plugin,
                  const PluginStrands& strands, const ShownTime& shown,
                  const GroomSettings& groom, float aspect) {
    const CheckTolerances tolerances;
    const auto figures = [&](int figure) {
        return strands.figures(figure, 0, shown.curves);
    };
    CheckView out;
    switch (request.view) {
        case View::length_error:
            out.title = "length error, relative";
            out.values = figures(LANCRET_LENGTH_ERROR);
            out.scale = error_scale(tolerances.length);
            break;
        case View::orthogonality:
            out.title = "orthogonality of frames, |R^T R - I|";
            out.values = figures(LANCRET_ORTHOGONALITY);
            out.scale = error_scale(tolerances.orthogonality);
            break;
        case View::curvature:
            out.title = "curvature, 1/cm";
            out.values = figures(LANCRET_CURVATURE);
            out.scale = size_scale(Kind::sequential, out.values.values, 0);
            break;
        case View::torsion:
            if (!traits_of(groom.expand.blend).has_torsion) {
                throw InputError(fmt::format(
                    "--view torsion: the blend {} carries frames without twist, and so "
                    "without torsion",
                    blend_name(groom.expand.blend)));
            }
            out.title = "torsion, 1/cm, right-handed above 0";
            out.values = figures(LANCRET_TORSION);
            out.scale = size_scale(Kind::diverging, out.values.values, 0);
            break;
        case View::influence:
            out.title = fmt::format("influence of {} guides, mixed; most followed:",
                                    plugin.info().guides);
            set_influence(out, strands.guides(), strands.size());
            break;
        case View::region:
            if (!groom.regions.any()) {
                throw InputError(fmt::format(
                    "--view region: {} has no regions; its [regions] table names them",
                    groom.name));
            }
            out.title = "region, share of the strands";
            out.values = figures(LANCRET_REGION);
            set_regions(out);
            break;
        case View::penetration:
            if (!shown.body || shown.body->triangles.empty()) {
                throw InputError(fmt::format(
                    "--view penetration: {} has no surface to be below; give --scalp",
                    groom.name));
            }
            out.title = "deepest place below the surface, cm";
            out.values = penetration_values(shown.curves, *shown.body);
            out.scale = size_scale(Kind::sequential, out.values.values, kOnSurface);
            out.scale.clean = kOnSurface;
            out.apart = strands_apart(out, shown.curves, &*shown.body, aspect);
            break;
    }
    out.ids = shown.curves.ids;
    if (request.range) {
        out.scale.low = float(request.range->x());
        out.scale.high = float(request.range->y());
        if (!out.scale.over.empty()) out.scale.over = "above";
    }
    return out;
}

void keep_range(const CheckView& view, ViewRequest& request) {
    // Those of errors are the same in all pictures as it is.
    if (!has_scale(request.view) || is_error(request.view)) return;
    request.range = Vec2(view.scale.low, view.scale.high);
}

StrandValues penetration_values(const Curves& curves, const TriangleMesh& surface) {
    const SignedDistance distance(surface);
    StrandValues out;
    out.values.assign(curves.strands, 0);
    tbb::parallel_for(std::uint32_t(0), curves.strands, [&](std::uint32_t i) {
        const EmittedStrand strand = emitted_strand(curves, i);
        Vec3 asked = Vec3::Zero();
        double clear = 0, deepest = 0;  // all within `clear` of `asked` is outside
        for (std::size_t half = 0; half <= 2 * strand.segments(); ++half) {
            const bool tip = half == 2 * strand.segments();
            const Vec3 place = tip ? strand.position(half / 2 - 1, 1)
                                   : strand.position(half / 2, half % 2 ? 0.5 : 0);
            if (!place.allFinite()) {
                deepest = std::numeric_limits<float>::max();
                break;
            }
            if ((place - asked).norm() < clear) continue;
            clear = distance.at(place).distance;
            asked = place;
            deepest = std::max(deepest, -clear);
        }
        out.values[i] = float(deepest);
    });
    return out;
}

namespace {

struct Extremes {
    float most = 0;          ///< of all sizes, with its sign
    std::size_t strand = 0;  ///< where that is, its id
    std::size_t beyond = 0;  ///< strands with a value above the limit
};

Extremes extremes(const CheckView& view) {
    const float limit = view.scale.clean.value_or(view.scale.high);
    Extremes out;
    for (std::size_t i = 0; i < view.values.strands(); ++i) {
        bool beyond = false;
        for (const float value : view.values.of(i)) {
            beyond = beyond || value > limit;
            if (std::abs(value) > std::abs(out.most)) {
                out.most = value;
                out.strand = view.ids.empty() ? i : view.ids[i];
            }
        }
        out.beyond += beyond;
    }
    return out;
}

}  // namespace

std::string view_line(const ViewRequest& request, const CheckView& view) {
    if (!has_scale(request.view)) {
        return fmt::format("{} {}", view.title, view.swatches.front().name);
    }
    const Extremes found = extremes(view);
    return fmt::format("{}: most {:.3g}, of strand {}; {} of {} strands above {:.3g}",
                       view.title, found.most, found.strand, found.beyond,
                       view.values.strands(), view.scale.clean.value_or(view.scale.high));
}

nlohmann::json view_json(const ViewRequest& request, const CheckView& view) {
    nlohmann::json out{{"name", view_name(request.view)}};
    if (!has_scale(request.view)) return out;
    const Extremes found = extremes(view);
    out.update({{"low", view.scale.low},
                {"high", view.scale.high},
                {"most", found.most},
                {"strand", found.strand},
                {"above", found.beyond}});
    return out;
}

}  // namespace lancret
