#pragma once
// A pinhole, or a thin lens.

#include "guides/base/types.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

struct Camera {
    Vec3f position = Vec3f(0, 0, 50);  ///< cm
    Mat3f frame = Mat3f::Identity();   ///< columns right, up, back; unit
    float tangent = 0.36397f;          ///< of half the vertical field of view
    float aspect = 1;                  ///< width / height
    float lens_radius = 0;             ///< cm; 0 is a pinhole
    float focus_distance = 50;         ///< cm along the direction of sight, > 0

    Vec3f view() const { return -frame.col(2); }
    /// The ray through a place of the picture: (0, 0) its top left corner, (1, 1) its
    /// bottom right.
    Ray ray(const Vec2f& place) const;
    /// The ray to the same point in focus, from a place of the lens: `random` is spread
    /// evenly over its disc. Of a pinhole, the ray above.
    Ray ray(const Vec2f& place, const Vec2f& random) const;
    /// Where the ray from the middle of the lens shows a point of the world (cm), within
    /// the picture or not; nothing where it is not in front of the camera.
    std::optional<Vec2f> place_of(const Vec3f& point) const;
};

/// How a camera that frames something by itself looks at it.
struct Framing {
    Vec3f view = Vec3f(0, 0, -1);   ///< direction of sight, any length but zero
    Vec3f up = Vec3f::UnitY();      ///< shown upward
    float field_of_view = 0.6981f;  ///< vertical, radian (40 degrees)
    float aspect = 1;               ///< width / height
    float margin = 1.05f;           ///< distance over the closest from which all is seen
};

/// A camera at `position` that looks at `target` (cm). Throws std::invalid_argument where
/// these are the same or the field of view is not within 0 and pi.
Camera look_at(const Vec3f& position, const Vec3f& target, const Vec3f& up,
               float field_of_view, float aspect);

/// A camera from its matrix: `to_world` turns column vectors (x right, y up, z back; cm)
/// to the world. A scale that is the same each way is taken out. Throws
/// std::invalid_argument where it is not a rotation, a place and such a scale to 1e-3,
/// and as look_at.
Camera camera_of_matrix(const Eigen::Matrix4d& to_world, float field_of_view,
                        float aspect);

/// The lens radius (cm) of a stop f/N on film 2.4 cm high.
float lens_radius_of(float f_stop, float field_of_view);

/// The camera closest to the box (cm, not empty) from which every corner is seen, then
/// moved back by the margin. Throws as look_at.
Camera framed(const Eigen::AlignedBox3f& box, const Framing& framing);

}  // namespace lancret
