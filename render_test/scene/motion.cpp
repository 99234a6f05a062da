#include "render_test/scene/motion.h"

#include "render_test/scene/strand_axis.h"

namespace lancret {
namespace {

Vec3f place_at(const SceneTime& time, const Hit& hit) {
    if (hit.kind == Hit::Kind::strand) {
        return axis_point(*time.curves, hit.primitive, hit.u).value.head<3>();
    }
    const auto& [a, b, c] = time.mesh->triangles[hit.primitive];
    const std::vector<Vec3f>& p = time.mesh->positions;
    return (1 - hit.u - hit.v) * p[a] + hit.u * p[b] + hit.v * p[c];
}

}  // namespace

Vec2f screen_motion(std::span<const SceneTime> times, const Camera& camera, int height,
                    const Hit& hit) {
    if (times.size() < 2) return Vec2f::Zero();
    const auto from = camera.place_of(place_at(times.front(), hit));
    const auto to = camera.place_of(place_at(times.back(), hit));
    if (!from || !to) return Vec2f::Zero();
    const Vec2f pixels(camera.aspect * float(height), -float(height));
    return (*to - *from).cwiseProduct(pixels);
}

}  // namespace lancret
