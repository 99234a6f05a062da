#include "tools/preview/lod.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace lancret {

namespace {

/// More pixels than any picture has: for a chunk that is partly behind the camera.
constexpr double kAll = 1e30;

double pixels_of(const Eigen::AlignedBox3f& box, const Camera& camera, int height) {
    Eigen::AlignedBox2f seen;
    for (int c = 0; c < 8; ++c) {
        const auto place =
            camera.place_of(box.corner(Eigen::AlignedBox3f::CornerType(c)));
        if (!place) return kAll;
        seen.extend(*place);
    }
    const double high = height, wide = high * double(camera.aspect);
    return std::min(double(seen.sizes().x()) * wide * double(seen.sizes().y()) * high,
                    kAll);
}

}  // namespace

std::vector<double> chunk_pixels(const PluginGroom& groom,
                                 std::span<const Camera> cameras, int height) {
    std::vector<double> out(groom.info().chunks, 0);
    tbb::parallel_for(std::size_t(0), out.size(), [&](std::size_t c) {
        const Eigen::AlignedBox3f box = groom.chunk_box(lancret_u32(c));
        if (box.isEmpty()) return;
        for (const Camera& camera : cameras) {
            out[c] = std::max(out[c], pixels_of(box, camera, height));
        }
    });
    return out;
}

}  // namespace lancret
