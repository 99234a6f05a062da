#include "render_test/strand_width.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace lancret {
namespace {

float pixels_at(const Point4f& p, const Camera& camera, float height) {
    const Vec3f at = camera.frame.transpose() * (Vec3f(p.x, p.y, p.z) - camera.position);
    const float depth = -at.z(), reach = 1.5f * camera.tangent * depth;
    if (!(depth > 0) || !(std::abs(at.y()) <= reach) ||
        !(std::abs(at.x()) <= reach * camera.aspect))
        return 0;
    const float pixels = p.w * height / (camera.tangent * depth);
    return std::isfinite(pixels) ? pixels : 0;
}

}  // namespace

float widest_pixels(const Curves& curves, std::span<const Camera> cameras, int height) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, curves.points.size(), 16384), 0.0f,
        [&](const auto& range, float widest) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                for (const Camera& camera : cameras)
                    widest = std::max(widest,
                                      pixels_at(curves.points[i], camera, float(height)));
            return widest;
        },
        [](float a, float b) { return std::max(a, b); });
}

}  // namespace lancret
