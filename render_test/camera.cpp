#include "render_test/camera.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render_test/sampling.h"

namespace lancret {

Ray Camera::ray(const Vec2f& place) const {
    Ray ray;
    ray.origin = position;
    ray.direction = (frame * Vec3f((2 * place.x() - 1) * tangent * aspect,
                                   (1 - 2 * place.y()) * tangent, -1))
                        .normalized();
    return ray;
}

Camera look_at(const Vec3f& position, const Vec3f& target, const Vec3f& up,
               float field_of_view, float aspect) {
    const Vec3f back = position - target;
    if (!position.allFinite() || !target.allFinite() || !(back.norm() > 0))
        throw std::invalid_argument("a camera needs a direction of sight");
    if (!(field_of_view > 0 && field_of_view < kPi) || !(aspect > 0))
        throw std::invalid_argument(
            "a camera's field of view must be within 0 and 180 degrees, its aspect > 0");
    Camera camera;
    camera.position = position;
    camera.tangent = std::tan(field_of_view / 2);
    camera.aspect = aspect;
    const Vec3f z = back.normalized(), across = up.cross(z);
    const Vec3f x = across.norm() > 1e-6f * up.norm() ? Vec3f(across.normalized())
                                                      : Vec3f(z.unitOrthogonal());
    camera.frame << x, z.cross(x), z;
    return camera;
}

Camera framed(const Eigen::AlignedBox3f& box, const Framing& framing) {
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite())
        throw std::invalid_argument("there is nothing to frame");
    const Vec3f centre = box.center(), view = framing.view.normalized();
    // About the origin: far from it a float has no room for a step of one.
    Camera camera =
        look_at(-view, Vec3f::Zero(), framing.up, framing.field_of_view, framing.aspect);
    float distance = 0;
    for (int i = 0; i < 8; ++i) {
        const Vec3f corner = camera.frame.transpose() *
                             (box.corner(Eigen::AlignedBox3f::CornerType(i)) - centre);
        const float needed =
            std::max(std::abs(corner.y()), std::abs(corner.x()) / camera.aspect);
        distance = std::max(distance, needed / camera.tangent + corner.z());
    }
    distance = std::max(distance * framing.margin, 1e-3f);
    camera.position = centre + distance * camera.frame.col(2);
    return camera;
}

}  // namespace lancret
