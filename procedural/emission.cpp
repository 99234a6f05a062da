#include "procedural/emission.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include "guides/super_helix.h"
#include "procedural/control_points.h"

namespace lancret {

namespace {

constexpr int kBetween = 4;  ///< places measured in each interval

/// The emitted curve at parameter t in [0, 1] of segment j.
Vec3f emitted(CurveBasis basis, std::span<const Point4f> points,
              std::span<const Point4f> tangents, std::size_t j, float t) {
    const float r = 1 - t;
    if (basis == CurveBasis::hermite) {
        return r * r * (1 + 2 * t) * points[j].xyz() +
               t * t * (3 - 2 * t) * points[j + 1].xyz() + t * r * r * tangents[j].xyz() -
               t * t * r * tangents[j + 1].xyz();
    }
    return (r * r * r * points[j].xyz() +
            (4 - 6 * t * t + 3 * t * t * t) * points[j + 1].xyz() +
            (4 - 6 * r * r + 3 * r * r * r) * points[j + 2].xyz() +
            t * t * t * points[j + 3].xyz()) /
           6;
}

double guide_distance(const Guides& guides, std::size_t g, int n, CurveBasis basis) {
    SuperHelix helix = super_helix(guides, g);
    helix.root = {};
    const double length = guide_length(guides, g);
    const std::size_t places = std::size_t(n) * kBetween;
    std::vector<double> s(places + 1);
    for (std::size_t i = 0; i <= places; ++i) s[i] = length * double(i) / double(places);
    std::vector<HelixState<float>> fine(places + 1), coarse;
    sample(helix, s, [&](std::size_t i, auto, const HelixState<double>& state) {
        fine[i] = {state.frame.cast<float>(), state.position.cast<float>()};
    });
    for (std::size_t i = 0; i <= places; i += kBetween) coarse.push_back(fine[i]);

    const std::uint32_t count = control_points_of(basis, n);
    std::vector<Point4f> points(count), tangents(count);
    const float ds = float(length / n);
    if (basis == CurveBasis::hermite) {
        hermite_points(coarse, ds, Vec3f::Zero(), {}, points, tangents);
    } else {
        bspline_points(coarse, ds, Vec3f::Zero(), {}, points);
    }
    double worst = 0;
    for (std::size_t i = 0; i <= places; ++i) {
        const std::size_t j = std::min(i / kBetween, std::size_t(n) - 1);
        const float t = float(i - j * kBetween) / kBetween;
        // The curve's own parameter may run ahead along the strand: only what lies across
        // counts.
        const Vec3f off = emitted(basis, points, tangents, j, t) - fine[i].position;
        const Vec3f tangent = fine[i].frame.col(0);
        worst = std::max(worst, double((off - tangent * tangent.dot(off)).norm()));
    }
    return worst;
}

}  // namespace

double emission_distance(const Guides& guides, int intervals, CurveBasis basis) {
    using Range = tbb::blocked_range<std::size_t>;
    return tbb::parallel_reduce(
        Range(0, guides.size()), 0.0,
        [&](const Range& range, double worst) {
            for (std::size_t g = range.begin(); g < range.end(); ++g) {
                worst = std::max(worst, guide_distance(guides, g, intervals, basis));
            }
            return worst;
        },
        [](double a, double b) { return std::max(a, b); });
}

int intervals_within(const Guides& guides, double tolerance, CurveBasis basis, int most) {
    for (int n = guides.segments;; n += guides.segments) {
        if (n >= most || emission_distance(guides, n, basis) <= tolerance) return n;
    }
}

}  // namespace lancret
