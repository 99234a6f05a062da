#include "render_test/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

void check_lens(float field_of_view, float aspect) {
    if (!(field_of_view > 0 && field_of_view < kPif) || !(aspect > 0)) {
        throw std::invalid_argument(
            "a camera's field of view must be between 0 and 180 degrees, its aspect "
            "above 0");
    }
}

}  // namespace

Ray Camera::ray(const Vec2f& place) const {
    Ray ray;
    ray.origin = position;
    ray.direction = (frame * Vec3f((2 * place.x() - 1) * tangent * aspect,
                                   (1 - 2 * place.y()) * tangent, -1))
                        .normalized();
    return ray;
}

Ray Camera::ray(const Vec2f& place, const Vec2f& random) const {
    Ray ray = this->ray(place);
    if (!(lens_radius > 0)) return ray;
    const Vec3f focus = focus_distance / ray.direction.dot(view()) * ray.direction;
    const float r = lens_radius * std::sqrt(random.x()), phi = 2 * kPif * random.y();
    const Vec3f on_lens = frame * Vec3f(r * std::cos(phi), r * std::sin(phi), 0);
    ray.origin = position + on_lens;
    ray.direction = (focus - on_lens).normalized();
    return ray;
}

std::optional<Vec2f> Camera::place_of(const Vec3f& point) const {
    const Vec3f seen = frame.transpose() * (point - position);
    if (!(seen.z() < 0)) return std::nullopt;
    const Vec2f slope = seen.head<2>() / (-seen.z() * tangent);
    return Vec2f((1 + slope.x() / aspect) / 2, (1 - slope.y()) / 2);
}

Camera camera_of_matrix(const Eigen::Matrix4d& to_world, float field_of_view,
                        float aspect) {
    check_lens(field_of_view, aspect);
    const Eigen::Matrix3d turn = to_world.topLeftCorner<3, 3>();
    const double scale = std::cbrt(turn.determinant());
    const bool rigid =
        to_world.allFinite() && scale > 1e-9 &&
        (turn.transpose() * turn / (scale * scale) - Eigen::Matrix3d::Identity())
                .cwiseAbs()
                .maxCoeff() < 1e-3 &&
        (to_world.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() < 1e-6;
    if (!rigid) {
        throw std::invalid_argument(
            "a camera's matrix must be a right-handed rotation, a translation and at "
            "most a uniform scale");
    }
    Camera camera;
    camera.position = to_world.topRightCorner<3, 1>().cast<float>();
    camera.frame = Eigen::Quaterniond(turn / scale).normalized().matrix().cast<float>();
    camera.tangent = std::tan(field_of_view / 2);
    camera.aspect = aspect;
    return camera;
}

float lens_radius_of(float f_stop, float field_of_view) {
    constexpr float kFilmHeight = 2.4f;
    const float focal_length = kFilmHeight / (2 * std::tan(field_of_view / 2));
    return focal_length / (2 * f_stop);
}

Camera look_at(const Vec3f& position, const Vec3f& target, const Vec3f& up,
               float field_of_view, float aspect) {
    const Vec3f back = position - target;
    if (!position.allFinite() || !target.allFinite() || !(back.norm() > 0)) {
        throw std::invalid_argument("a camera needs a viewing direction");
    }
    check_lens(field_of_view, aspect);
    Camera camera;
    camera.position = position;
    camera.focus_distance = back.norm();
    camera.tangent = std::tan(field_of_view / 2);
    camera.aspect = aspect;
    const Vec3f z = back.normalized(), across = up.cross(z);
    const Vec3f x = across.norm() > 1e-6f * up.norm() ? Vec3f(across.normalized())
                                                      : Vec3f(z.unitOrthogonal());
    camera.frame << x, z.cross(x), z;
    return camera;
}

Camera framed(const Eigen::AlignedBox3f& box, const Framing& framing) {
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) {
        throw std::invalid_argument("there is nothing to frame");
    }
    const Vec3f centre = box.center(), view = framing.view.normalized();
    // About the origin: far from it, floats cannot resolve a unit step.
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
    camera.focus_distance = distance;
    return camera;
}

}  // namespace lancret
