#include "render_test/scene/thin_strands.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lancret {
namespace {

/// The smallest radius, over all cameras, of a strand `pixels` wide at `p`, cm; 0 behind
/// every camera.
float min_radius(const Point4f& p, std::span<const Camera> cameras, float pixels,
                 float height) {
    float smallest = std::numeric_limits<float>::infinity();
    for (const Camera& camera : cameras) {
        const float depth = (Vec3f(p.x, p.y, p.z) - camera.position).dot(camera.view());
        if (depth > 0) {
            smallest = std::min(smallest, pixels * camera.tangent * depth / height);
        }
    }
    return std::isfinite(smallest) ? smallest : 0;
}

/// Sets the slopes of new radii at Hermite points, by central differences.
void set_slopes(Curves& curves, std::uint32_t strand) {
    const std::uint32_t n = curves.points_of(strand);
    const std::size_t first = curves.first_point(strand);
    for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t before = j > 0 ? j - 1 : 0, after = std::min(j + 1, n - 1);
        curves.tangents[first + j].w =
            (curves.points[first + after].w - curves.points[first + before].w) /
            float(std::max(after - before, 1u));
    }
}

}  // namespace

std::vector<float> widen_thin_strands(Curves& curves, std::span<const Camera> cameras,
                                      int height, float pixels) {
    if (!(pixels >= 0 && std::isfinite(pixels)) || height < 1) {
        throw std::invalid_argument("a strand's minimum width must be 0 pixels or more");
    }
    std::vector<float> before(curves.points.size());
    tbb::parallel_for(std::uint32_t(0), curves.strands, [&](std::uint32_t strand) {
        const std::size_t first = curves.first_point(strand);
        for (std::size_t i = first; i < first + curves.points_of(strand); ++i) {
            Point4f& p = curves.points[i];
            before[i] = p.w;
            p.w = std::max(p.w, min_radius(p, cameras, pixels, float(height)));
        }
        if (curves.basis == CurveBasis::hermite) set_slopes(curves, strand);
    });
    return before;
}

float radius_at(const Curves& curves, std::span<const float> radii, std::uint32_t segment,
                float u) {
    const float* r = radii.data() + curves.segments[segment];
    const float t = 1 - u;
    if (curves.basis == CurveBasis::hermite) return t * r[0] + u * r[1];
    return (t * t * t * r[0] + (4 - 3 * u * u * (2 - u)) * r[1] +
            (4 - 3 * t * t * (2 - t)) * r[2] + u * u * u * r[3]) /
           6;
}

}  // namespace lancret
