#include "render_test/scene/strand_width.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cmath>

namespace lancret {
namespace {

float pixels_at(const Point4f& p, const Camera& camera, float height) {
    const Vec3f seen =
        camera.frame.transpose() * (Vec3f(p.x, p.y, p.z) - camera.position);
    const float depth = -seen.z(), reach = 1.5f * camera.tangent * depth;
    if (!(depth > 0) || !(std::abs(seen.y()) <= reach) ||
        !(std::abs(seen.x()) <= reach * camera.aspect)) {
        return 0;
    }
    const float pixels = p.w * height / (camera.tangent * depth);
    return std::isfinite(pixels) ? pixels : 0;
}

}  // namespace

bool any_wider(const Curves& curves, std::span<const Camera> cameras, int height,
               float pixels) {
    std::atomic<bool> found = false;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, curves.points.size(), 4096),
        [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end() && !found; ++i) {
                for (const Camera& camera : cameras) {
                    if (pixels_at(curves.points[i], camera, float(height)) > pixels) {
                        found = true;
                        return;
                    }
                }
            }
        });
    return found;
}

}  // namespace lancret
