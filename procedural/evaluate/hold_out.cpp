#include "procedural/evaluate/hold_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/farthest_points.h"
#include "guides/fit/sampled_guides.h"
#include "guides/helix/super_helix.h"
#include "guides/mesh/closest_point.h"

namespace lancret {

namespace {

/// Guides are sampled with the first of these numbers of segments that keeps their shape.
constexpr int kSampledSegments[] = {16, 32, 64, 128};

/// Limits within which guides keep their shape: W1 of the curvatures, and the 95th
/// percentile of the RMS distance over length.
constexpr double kMaxCurvatureW1 = 0.005, kMaxDistance = 0.002;

/// Shorter strands, cm, are ignored: floats cannot hold their curvatures.
constexpr double kMinLength = 1e-6;

/// Every strand at equal steps; those that are too short are empty.
std::vector<SampledCurve> sampled(const Strands& strands) {
    std::vector<SampledCurve> out(strands.size());
    cancellable_for(std::size_t(0), strands.size(), [&](std::size_t i) {
        const auto curve = strand_curve(strands, i);
        if (curve && curve->length() >= kMinLength) {
            out[i] = resample(*curve, kCompareSteps);
        }
    });
    return out;
}

/// The surface at the roots of strands.
struct Surface {
    std::vector<Vec3f> normals;
    std::vector<Vec3> tangents;  ///< empty without a scalp
};

Surface surface_at(const Scalp* scalp, std::span<const Vec3> roots) {
    Surface out;
    if (!scalp) {
        out.normals.assign(roots.size(), Vec3f::UnitZ());
        return out;
    }
    out.normals.resize(roots.size());
    out.tangents.resize(roots.size());
    const ClosestPoint closest(scalp->mesh);
    cancellable_for(std::size_t(0), roots.size(), [&](std::size_t i) {
        const MeshPoint point = closest.closest(roots[i]).point;
        out.normals[i] = scalp_normal(*scalp, point).cast<float>();
        out.tangents[i] = surface_frame(*scalp, point).col(1);
    });
    return out;
}

/// Compares guides with the strands that they were made from.
GuideFit guide_fit(const Guides& guides, const std::vector<SampledCurve>& strands,
                   std::span<const std::uint32_t> which) {
    StrandSamples real{kCompareSteps, {}}, made{kCompareSteps, {}};
    std::vector<double> lengths;
    made.points.resize(which.size() * (kCompareSteps + 1));
    std::vector<double> s(kCompareSteps + 1);
    for (std::size_t g = 0; g < which.size(); ++g) {
        const SampledCurve& strand = strands[which[g]];
        real.points.insert(real.points.end(), strand.positions.begin(),
                           strand.positions.end());
        lengths.push_back(strand.length);
        for (int i = 0; i <= kCompareSteps; ++i) {
            s[i] = strand.length * i / double(kCompareSteps);
        }
        sample(super_helix(guides, g), s,
               [&](std::size_t i, std::size_t, const HelixState<double>& state) {
                   made.strand(g)[i] = state.position;
               });
    }
    const StrandFigures figures = strand_figures(real, lengths, made);
    return {.rms = figures.rms, .curvature = figures.curvature};
}

void make_guides(const Strands& strands, const std::vector<SampledCurve>& curves,
                 std::span<const Vec3> tangents, std::optional<int> segments,
                 HoldOut& out) {
    if (segments) {
        out.guides =
            fit_guides(strands, out.guide_strands, tangents, {.segments = *segments})
                .guides;
        out.fit = guide_fit(out.guides, curves, out.guide_strands);
        out.fit.fitted = true;
        return;
    }
    for (const int n : kSampledSegments) {
        out.guides = sample_guides(strands, out.guide_strands, tangents, n).guides;
        out.fit = guide_fit(out.guides, curves, out.guide_strands);
        if (out.fit.curvature.w1 <= kMaxCurvatureW1 && out.fit.rms.p95 <= kMaxDistance) {
            return;
        }
    }
}

/// Roots of the two parts of a groom, cm.
struct SplitRoots {
    std::vector<Vec3> guides, children;
};

/// Selects the guides and fills the strands, truth and tangents of `out`.
SplitRoots split(const std::vector<SampledCurve>& curves, const HoldOutSettings& settings,
                 const std::string& name, HoldOut& out) {
    std::vector<std::uint32_t> whole;
    std::vector<Vec3> all_roots;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].positions.empty()) continue;
        whole.push_back(std::uint32_t(i));
        all_roots.push_back(curves[i].positions[0]);
    }
    const std::size_t count = settings.guides.of(whole.size());
    if (count < 1 || count >= whole.size()) {
        throw InputError(fmt::format(
            "{}: {} of its {} strands as guides leave {} to predict, expected at least "
            "one of each; see --guides",
            name, count, whole.size(), whole.size() - std::min(count, whole.size())));
    }
    out.flat_strands = curves.size() - whole.size();
    SplitRoots roots;
    std::vector<bool> is_guide(whole.size(), false);
    for (const std::uint32_t i : farthest_points(all_roots, count, settings.seed)) {
        is_guide[i] = true;
        out.guide_strands.push_back(whole[i]);
        roots.guides.push_back(all_roots[i]);
    }
    const std::size_t children = whole.size() - count;
    out.truth.steps = kCompareSteps;
    out.truth.points.reserve(children * (kCompareSteps + 1));
    out.tangents.reserve(children * (kCompareSteps + 1));
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (is_guide[i]) continue;
        const SampledCurve& strand = curves[whole[i]];
        out.child_strands.push_back(whole[i]);
        roots.children.push_back(all_roots[i]);
        out.lengths.push_back(strand.length);
        out.truth.points.insert(out.truth.points.end(), strand.positions.begin(),
                                strand.positions.end());
        for (const Vec3& t : strand.tangents) out.tangents.push_back(t.cast<float>());
    }
    return roots;
}

}  // namespace

HoldOut hold_out(const Strands& strands, const Scalp* scalp,
                 const HoldOutSettings& settings, const std::string& name) {
    const std::vector<SampledCurve> curves = sampled(strands);
    HoldOut out;
    const SplitRoots roots = split(curves, settings, name, out);
    Surface guide_surface = surface_at(scalp, roots.guides);
    make_guides(strands, curves, guide_surface.tangents, settings.segments, out);
    Roots children;
    for (const Vec3& root : roots.children) {
        children.positions.push_back(root.cast<float>());
    }
    children.normals = surface_at(scalp, roots.children).normals;
    BindSettings bind_settings = settings.bind;
    bind_settings.length_scale = 1;
    if (!scalp) bind_settings.facing = false;
    BindBorders borders;
    borders.partings = settings.partings;
    out.binding = lancret::bind(std::move(children), out.guides,
                                std::move(guide_surface.normals), bind_settings, borders);
    return out;
}

}  // namespace lancret
