#pragma once
// Anchoring: a strand turned so that its spine runs where its guides' spines run.

#include "procedural/blend/blend.h"

namespace lancret {

/// A rotation as a quaternion of any length but zero.
template <class T>
struct Turn {
    T cosine;       ///< times any number
    Vec3T<T> sine;  ///< times the same number

    Mat3T<T> operator*(const Mat3T<T>& m) const {
        const T factor = 2 / (cosine * cosine + sine.squaredNorm());
        Mat3T<T> out;
        for (int c = 0; c < 3; ++c) {
            const Vec3T<T> across = sine.cross(m.col(c));
            out.col(c) = m.col(c) + factor * (cosine * across + sine.cross(across));
        }
        return out;
    }
};

/// What a strand is anchored by.
template <class T>
struct Anchor {
    Spine<T> own, goal;                    ///< of the strand and of its guides, in space
    std::array<T, kSpineTerms> taper;      ///< of both
    std::array<T, kMaxNeighbours> shares;  ///< [guides] w L over their sum: places
                                           ///< blended at equal s / L move by w L T ds
};

template <class T>
Anchor<T> anchor_of(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<const HelixState<T>> states);

/// What happens to a frame at one place.
template <class T>
struct AnchorTurns {
    Vec3T<T>
        tilt_speed;   ///< along the strand's spine, below 1: how the tangent is tilted
    Turn<T> to_goal;  ///< from the strand's spine to that of the guides
};

template <class T>
AnchorTurns<T> turns_at(const Anchor<T>& anchor, const Child<T>& child,
                        const GuideProfiles<T>& guides, std::size_t place);

/// Turns the frames of a synthesised strand so that its spine follows the spine of the
/// child's guides, and moves the places after them. Two rotations at each place, both as
/// smooth along the strand as the spines are, so that its own curvature and torsion stay
/// nearly what they were:
///   - the tangent is tilted about the spine so that the strand gets on as fast as its
///     guides do;
///   - the spine is turned into the direction of the guides'.
/// A strand that is one of its guides, with all the weight, stays as it is. The length
/// stays exact: between two frames there is one helix.
template <class T>
void anchor(const Child<T>& child, const GuideProfiles<T>& guides,
            std::span<HelixState<T>> states);

}  // namespace lancret
