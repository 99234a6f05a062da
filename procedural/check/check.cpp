#include "procedural/check/check.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "guides/base/cancel.h"
#include "guides/base/worst.h"
#include "procedural/check/strand.h"

namespace lancret {

namespace {

/// Curvature and torsion of one guide at one place.
struct GuideValue {
    double kappa, tau;
};

/// Values of every guide in each interval, [guides][intervals], directly from its
/// segments. NaN if the interval contains a joint and so has no single value.
std::vector<GuideValue> guide_values(const Guides& guides, int intervals) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<GuideValue> out;
    out.reserve(guides.size() * intervals);
    for (std::size_t g = 0; g < guides.size(); ++g) {
        const auto lengths = guides.lengths_of(g);
        const auto u = guides.curvatures_of(g);
        const double total = guide_length(guides, g), slack = 1e-9 * total;
        double start = 0;
        std::size_t q = 0;
        for (int i = 0; i < intervals; ++i) {
            const double from = total * i / intervals, to = total * (i + 1) / intervals;
            while (q + 1 < u.size() && from >= start + lengths[q] - slack) {
                start += lengths[q++];
            }
            const bool whole = q + 1 == u.size() || to <= start + lengths[q] + slack;
            out.push_back(whole ? GuideValue{std::hypot(u[q].y(), u[q].z()), u[q].x()}
                                : GuideValue{kNone, kNone});
        }
    }
    return out;
}

/// Whether the strand's curvature and torsion lie between those of its guides, up to
/// single precision: each frame is accurate to 5e-7, so a rotation over ds to 2e-6.
bool inside_hull(std::span<const MeasuredInterval> measured,
                 std::span<const std::uint32_t> guides, std::span<const float> weights,
                 const std::vector<GuideValue>& values) {
    const std::size_t n = measured.size();
    for (std::size_t i = 0; i < n; ++i) {
        bool joint = false;
        constexpr double kFar = std::numeric_limits<double>::infinity();
        double kappa_low = kFar, kappa_high = -kFar, tau_low = kFar, tau_high = -kFar;
        for (std::size_t k = 0; k < guides.size(); ++k) {
            if (!(weights[k] > 0)) continue;
            const GuideValue& value = values[guides[k] * n + i];
            joint = joint || std::isnan(value.kappa);
            kappa_low = std::min(kappa_low, value.kappa);
            kappa_high = std::max(kappa_high, value.kappa);
            tau_low = std::min(tau_low, value.tau);
            tau_high = std::max(tau_high, value.tau);
        }
        if (joint) continue;
        const MeasuredInterval& m = measured[i];
        const double slack = 4e-6 / m.length;
        const auto inside = [&](double x, double low, double high) {
            const double room = slack + 1e-5 * std::max(std::abs(low), std::abs(high));
            return x >= low - room && x <= high + room;
        };
        const bool kappa_fits = inside(m.kappa, kappa_low, kappa_high);
        // A rotation of half a turn or more is measured as one in the other direction:
        // such intervals are too long to compare.
        const double max_tau = std::max(std::abs(tau_low), std::abs(tau_high));
        const bool tau_is_measured = std::hypot(max_tau, m.kappa) * m.length < 3;
        if (!kappa_fits || (tau_is_measured && !inside(m.tau, tau_low, tau_high))) {
            return false;
        }
    }
    return true;
}

bool finite(std::span<const Point4f> points) {
    return std::ranges::all_of(points, [](const Point4f& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
               std::isfinite(p.w);
    });
}

/// The measurements of child i from its places `states`; `measured` is reused memory.
StrandCheck check_strand(const CheckInput& input, const std::vector<GuideValue>& values,
                         std::size_t i, std::span<const HelixState<float>> states,
                         std::vector<MeasuredInterval>& measured) {
    const Binding& binding = input.binding;
    const std::size_t n = states.size() - 1, k = std::size_t(binding.neighbours);
    const EmittedStrand emitted = emitted_strand(input.curves, i);
    const std::span guides(&binding.guides[i * k], k);
    const std::span weights(&binding.weights[i * k], k);
    const Vec3 root = binding.roots.positions[i].cast<double>();
    StrandCheck out;
    out.strand = binding.roots.id(i);
    out.orthogonality = float(orthogonality_error(states));

    double intended = 0, weight = 0;
    for (std::size_t j = 0; j < k; ++j) {
        intended += double(weights[j]) * guide_length(input.guides, guides[j]);
        weight += weights[j];
    }
    intended *= input.length_scale / weight;
    double length = 0, distance = 0;
    measured.resize(n);
    for (std::size_t j = 0; j < n; ++j) {
        measured[j] = measured_interval(states[j], states[j + 1]);
        length += measured[j].length;
        const Eigen::Matrix3d frame = states[j].frame.cast<double>();
        for (const double t : {0.25, 0.5, 0.75}) {
            // Only what lies across the strand counts.
            const Vec3 off =
                emitted.position(j, t) - root - place_on(states[j], measured[j], t);
            const Vec3 tangent =
                frame * Eigen::AngleAxisd(measured[j].angle * t, measured[j].axis)
                            .matrix()
                            .col(0);
            distance = std::max(distance, (off - tangent * tangent.dot(off)).norm());
        }
    }
    out.length_error = float(length / intended - 1);
    out.emitted_length_error = float(emitted.length() / intended - 1);
    out.distance = float(distance);
    out.root_distance = float((emitted.position(0, 0) - root).norm());
    out.finite = finite(emitted.points) && finite(emitted.tangents) &&
                 std::isfinite(length) && std::isfinite(out.orthogonality);
    const Vec3 tip = emitted.position(n - 1, 1);
    out.tip_within_reach =
        (tip - root).norm() <= intended * (1 + 1e-4) + input.tolerances.root;
    out.inside_hull = inside_hull(measured, guides, weights, values);
    return out;
}

}  // namespace

CheckReport check_strands(const CheckInput& input) {
    const Binding& binding = input.binding;
    const ClassedGuides& classed = input.classed;
    const Blend blend = input.settings.blend;
    CheckReport report;
    report.tolerances = input.tolerances;
    report.hull_applies = traits_of(blend).keeps_hull;
    report.strands.resize(binding.size());
    using Range = tbb::blocked_range<std::size_t>;
    each_class(classed.classes, binding,
               [&](std::size_t c, std::size_t first, std::size_t last) {
                   const GuideProfiles<float>& profiles = classed.profiles[c];
                   const std::vector<GuideValue> values =
                       guide_values(input.guides, profiles.count);
                   cancellable_for(Range(first, last, 256), [&](const Range& range) {
                       std::vector<MeasuredInterval> measured;
                       const auto visit = [&](std::size_t i,
                                              std::span<const HelixState<float>> states) {
                           report.strands[i] =
                               check_strand(input, values, i, states, measured);
                       };
                       each_strand({binding, profiles, classed.kernel(c), blend},
                                   range.begin(), range.end(), visit);
                   });
               });
    return report;
}

double CheckReport::severity(const StrandCheck& s) const {
    const CheckTolerances& t = tolerances;
    if (!s.finite || !s.tip_within_reach || (hull_applies && !s.inside_hull)) {
        return std::numeric_limits<double>::infinity();
    }
    // An error of 0 keeps a tolerance of 0.
    const auto share_of = [](double error, double tolerance) {
        return error == 0 ? 0 : std::abs(error) / tolerance;
    };
    const double shares[] = {
        share_of(s.orthogonality, t.orthogonality), share_of(s.length_error, t.length),
        share_of(s.emitted_length_error, t.emitted_length),
        share_of(s.distance, t.distance), share_of(s.root_distance, t.root)};
    double worst = 0;
    for (const double share : shares) worst = worst_of(worst, share);
    return worst;
}

bool CheckReport::passes(const StrandCheck& strand) const {
    return severity(strand) <= 1;
}

bool CheckReport::pass() const {
    return std::ranges::all_of(strands, [&](const StrandCheck& s) { return passes(s); });
}

std::vector<StrandCheck> CheckReport::worst(std::size_t n) const {
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(strands.size());
    for (std::uint32_t i = 0; i < strands.size(); ++i) {
        order.emplace_back(-severity(strands[i]), i);
    }
    n = std::min(n, order.size());
    std::partial_sort(order.begin(), order.begin() + n, order.end());
    std::vector<StrandCheck> out;
    for (std::size_t i = 0; i < n; ++i) out.push_back(strands[order[i].second]);
    return out;
}

}  // namespace lancret
