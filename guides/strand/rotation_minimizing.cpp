#include "guides/strand/rotation_minimizing.h"

#include <cassert>

#include "guides/helix/helix.h"

namespace lancret {

namespace {

/// `v` reflected in the plane normal to `axis`, which is not zero.
Vec3 mirrored(const Vec3& v, const Vec3& axis) {
    return v - 2 * axis.dot(v) / axis.squaredNorm() * axis;
}

/// The normal carried over a step by two reflections, which make a rotation that differs
/// from the rotation-minimising one by the fifth power of the step. If the step has no
/// chord or reverses direction, a reflection is undefined: the smallest rotation is used.
Vec3 carried_normal(const Vec3& normal, const Vec3& tangent, const Vec3& chord,
                    const Vec3& next_tangent) {
    if (chord.squaredNorm() > 0 && tangent.dot(next_tangent) > -0.5) {
        const Vec3 axis = chord.normalized();
        const Vec3 between = next_tangent - mirrored(tangent, axis);
        if (between.squaredNorm() > 1e-6) {
            return mirrored(mirrored(normal, axis), between);
        }
    }
    return smallest_rotation<double>(tangent, next_tangent) * normal;
}

}  // namespace

Vec3 across_tangent(const Vec3& normal, const Vec3& tangent) {
    const double size = normal.norm();
    if (size > 0) {
        const Vec3 unit = normal / size;
        const Vec3 across = unit - tangent * tangent.dot(unit);
        // Repeated to remove the round-off of a normal almost along the tangent.
        if (across.norm() > 1e-7) {
            return (across - tangent * tangent.dot(across)).normalized();
        }
    }
    return tangent.unitOrthogonal();
}

Mat3 frame_from_normal(const Vec3& normal, const Vec3& tangent) {
    const Vec3 across = across_tangent(normal, tangent);
    Mat3 frame;
    frame << tangent, across, tangent.cross(across);
    return frame;
}

std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> positions,
                                             std::span<const Vec3> tangents,
                                             const Vec3& normal) {
    assert(positions.size() == tangents.size());
    std::vector<Mat3> frames;
    frames.reserve(tangents.size());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        frames.push_back(frame_from_normal(
            i == 0 ? normal
                   : carried_normal(frames[i - 1].col(1), tangents[i - 1],
                                    positions[i] - positions[i - 1], tangents[i]),
            tangents[i]));
    }
    return frames;
}

std::vector<Mat3> rotation_minimizing_frames(std::span<const Vec3> tangents,
                                             const Vec3& normal) {
    std::vector<Mat3> frames;
    frames.reserve(tangents.size());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        frames.push_back(frame_from_normal(
            i == 0 ? normal
                   : Vec3(smallest_rotation<double>(tangents[i - 1], tangents[i]) *
                          frames[i - 1].col(1)),
            tangents[i]));
    }
    return frames;
}

}  // namespace lancret
