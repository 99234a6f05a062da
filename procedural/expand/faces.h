#pragma once
// Which way the children's faces look: chosen once, in the rest pose, and never changed
// with time, so that a blade which swings through straight does not flip.

#include <vector>

#include "procedural/bind/binding.h"

namespace lancret {

/// Where each child's face lies at rest, for `Binding::faces`: as bent_face has it.
/// `rest` are the profiles of the guides that the binding was made with, before
/// pose_binding has touched it. [children], unit: cosine and sine of the angle from n1 to
/// n2 of the child's root frame. The root frame of option 1 has the normal of the bend
/// for n1, which is half a turn away once the bend has gone through zero; its angles are
/// from n1 of the heaviest guide, swung onto the child's tangent.
std::vector<Vec2f> rest_faces(const Binding& binding, const GuideProfiles<float>& rest,
                              Blend blend);

/// The face that was chosen for child i, as an angle in `frame`: its root's at the time
/// of `profiles`. Needs `binding.faces`.
Vec2f face_at(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
              std::size_t i, const Mat3f& frame);

}  // namespace lancret
