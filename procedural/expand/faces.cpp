#include "procedural/expand/faces.h"

#include <algorithm>
#include <cmath>

#include "guides/base/cancel.h"
#include "procedural/curves/control_points.h"
#include "procedural/expand/synthesis.h"

namespace lancret {

namespace {

/// Whether n1 at the root follows the bend instead of being transported from the guides.
bool frame_follows_bend(Blend blend) {
    return traits_of(blend).rates == BlendRates::blended;
}

/// n1 of child i's heaviest guide, rotated onto the child's tangent, as an angle in
/// `frame`.
Vec2f carried_normal(const Binding& binding, const GuideProfiles<float>& profiles,
                     std::size_t i, const Mat3f& frame) {
    const BoundChild<float> bound = bound_child(binding, profiles, i);
    const Child<float> child = bound.child();
    const Mat3f& guide =
        child.to_space[std::ranges::max_element(child.weights) - child.weights.begin()];
    const Vec3f normal =
        frame.transpose() *
        (smallest_rotation<float>(guide.col(0), frame.col(0)) * guide.col(1));
    return Vec2f(normal.y(), normal.z()).normalized();
}

/// The sum of two angles.
Vec2f turned(const Vec2f& a, const Vec2f& b) {
    return {a.x() * b.x() - a.y() * b.y(), a.y() * b.x() + a.x() * b.y()};
}

}  // namespace

std::vector<Vec2f> rest_faces(const Binding& binding, const GuideProfiles<float>& rest,
                              Blend blend) {
    std::vector<Vec2f> out(binding.size());
    cancellable_for(
        tbb::blocked_range<std::size_t>(0, out.size(), 256), [&](const auto& range) {
            std::vector<HelixState<float>> states(rest.count + 1);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                synthesize_child<float>(binding, rest, blend, i, states);
                out[i] = bent_face(states);
                if (!frame_follows_bend(blend)) continue;
                const Vec2f from = carried_normal(binding, rest, i, states[0].frame);
                out[i] = turned(out[i], {from.x(), -from.y()});
            }
        });
    return out;
}

Vec2f face_at(const Binding& binding, const GuideProfiles<float>& profiles, Blend blend,
              std::size_t i, const Mat3f& frame) {
    const Vec2f& face = binding.faces[i];
    if (!frame_follows_bend(blend)) return face;
    return turned(face, carried_normal(binding, profiles, i, frame));
}

}  // namespace lancret
