#pragma once
// A pinhole camera, or one with a thin lens.

#include <optional>

#include "guides/base/types.h"
#include "render_test/scene/hit.h"

namespace lancret {

struct Camera {
    Vec3f position = Vec3f(0, 0, 50);  ///< cm
    Mat3f frame = Mat3f::Identity();   ///< columns right, up, back; unit
    float tangent = 0.36397f;          ///< of half the vertical field of view
    float aspect = 1;                  ///< width / height
    float lens_radius = 0;             ///< cm; 0 is a pinhole
    float focus_distance = 50;         ///< cm along the viewing direction, > 0

    Vec3f view() const { return -frame.col(2); }
    /// The ray through a point of the picture: (0, 0) is its top left corner, (1, 1) its
    /// bottom right.
    Ray ray(const Vec2f& place) const;
    /// The ray to the same point in focus, from a point on the lens: `random`, in [0,
    /// 1)^2, maps uniformly to its disc. For a pinhole, the ray above.
    Ray ray(const Vec2f& place, const Vec2f& random) const;
    /// Projects a world point (cm) through the middle of the lens, inside the picture or
    /// not; nullopt if it is not in front of the camera.
    std::optional<Vec2f> place_of(const Vec3f& point) const;
};

/// How an automatically framed camera looks at its subject.
struct Framing {
    Vec3f view = Vec3f(0, 0, -1);   ///< viewing direction, any length but zero
    Vec3f up = Vec3f::UnitY();      ///< points upward in the picture
    float field_of_view = 0.6981f;  ///< vertical, radian (40 degrees)
    float aspect = 1;               ///< width / height
    float margin = 1.05f;           ///< distance over the closest that shows everything
};

/// A camera at `position` that looks at `target` (cm). Throws std::invalid_argument if
/// they coincide or the field of view is not between 0 and pi.
Camera look_at(const Vec3f& position, const Vec3f& target, const Vec3f& up,
               float field_of_view, float aspect);

/// A camera from its matrix: `to_world` maps column vectors (x right, y up, z back; cm)
/// to the world. A uniform scale is removed. Throws std::invalid_argument if the matrix
/// is not a rotation, a translation and a uniform scale to 1e-3, or the field of view is
/// not between 0 and pi.
Camera camera_of_matrix(const Eigen::Matrix4d& to_world, float field_of_view,
                        float aspect);

/// The lens radius (cm) at f-stop N on film 2.4 cm high.
float lens_radius_of(float f_stop, float field_of_view);

/// The camera closest to the box (cm, not empty) that sees every corner, then moved back
/// by the margin. Throws std::invalid_argument if the box is empty or not finite, or as
/// look_at.
Camera framed(const Eigen::AlignedBox3f& box, const Framing& framing);

}  // namespace lancret
