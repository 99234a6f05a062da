#pragma once
// The faces of ribbons. They are chosen once, in the rest pose, and kept over time, so
// that a blade that swings through straight does not flip.

#include <vector>

#include "procedural/bind/binding.h"

namespace lancret {

/// Each child's face at rest, for `Binding::faces`: [children], cosine and sine of the
/// angle of its bent_face from n1 to n2 of the child's root frame. `rest` are the
/// profiles of the guides that the binding was made with, before pose_binding has changed
/// it. In option 1, n1 of the root frame is the normal of the bend, which turns by half a
/// turn when the bend passes through zero. Its angles are measured from n1 of the
/// heaviest guide instead, rotated onto the child's tangent.
std::vector<Vec2f> rest_faces(const Binding& binding, const GuideProfiles<float>& rest,
                              Blend blend);

/// The face of child i as an angle in `frame`, its root frame at the time of `profiles`.
/// Requires `binding.faces`.
Vec2f face_at(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
              std::size_t i, const Mat3f& frame);

}  // namespace lancret
