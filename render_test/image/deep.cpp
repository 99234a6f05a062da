#include "render_test/image/deep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "render_test/image/half_values.h"

namespace lancret {

void merge(std::vector<DeepSample>& samples, float gap) {
    std::ranges::stable_sort(samples, [](const DeepSample& a, const DeepSample& b) {
        return std::tie(a.id, a.depth) < std::tie(b.id, b.depth);
    });
    std::size_t kept = 0;
    float back = 0;  // depth of the last sample of the current group
    for (const DeepSample& s : samples) {
        DeepSample* group = kept > 0 ? &samples[kept - 1] : nullptr;
        if (!group || group->id != s.id || s.depth - back > gap * s.depth) {
            back = s.depth;
            samples[kept++] = s;
            continue;
        }
        back = s.depth;
        const float coverage = group->coverage + s.coverage;
        if (coverage > 0) {
            group->depth += (s.depth - group->depth) * (s.coverage / coverage);
        }
        group->coverage = coverage;
        group->radiance += s.radiance;
    }
    samples.resize(kept);
}

void composited(std::span<const DeepSample> samples, std::vector<DeepPoint>& points) {
    points.clear();
    for (const DeepSample& s : samples) {
        Eigen::Vector4f rgba;
        rgba << s.radiance, s.coverage;
        points.push_back({s.id, s.depth, rgba});
    }
    std::ranges::sort(points, [](const DeepPoint& a, const DeepPoint& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    // The largest half below one: samples behind must stay visible, or their light would
    // be lost.
    constexpr float kMaxBefore = 1 - 0x1p-11f;
    float through = 1, before = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        DeepPoint& point = points[i];
        if (point.depth <= before) {
            point.depth = std::nextafter(before, std::numeric_limits<float>::infinity());
        }
        before = point.depth;
        point.rgba /= through;
        point.rgba.w() =
            std::min(point.rgba.w(), i + 1 < points.size() ? kMaxBefore : 1.0f);
        for (float& value : point.rgba) value = rounded_to_half(value);
        through *= 1 - point.rgba.w();
    }
}

}  // namespace lancret
