#pragma once
// Anchoring: turning a strand so that its spine follows its guides' spines.

#include "procedural/blend/blend.h"

namespace lancret {

/// A rotation as a quaternion of any non-zero length.
template <class T>
struct Turn {
    T cosine;       ///< cosine of half the angle, up to a common factor
    Vec3T<T> sine;  ///< axis times sine of half the angle, up to the same factor

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

/// The spines that anchor a strand.
template <class T>
struct Anchor {
    Spine<T> own, goal;                ///< of the strand and of its guides, in space
    std::array<T, kSpineTerms> taper;  ///< of both spines
    std::array<T, kMaxNeighbours>
        shares;  ///< [guides] w L over their sum, because places
                 ///< at equal s / L advance by w L T d(s / L)
};

/// The anchor of a strand with these `states`, before it is turned.

template <class T>
Anchor<T> anchor_of(const Child<T>& child, const GuideProfiles<T>& guides,
                    std::span<const HelixState<T>> states);

/// The two rotations of a frame at one place.
template <class T>
struct AnchorTurns {
    Vec3T<T> tilt_speed;  ///< tilts the tangent; along the strand's spine, |v| < 1
    Turn<T> to_goal;      ///< from the strand's spine to the guides'
};

template <class T>
AnchorTurns<T> turns_at(const Anchor<T>& anchor, const Child<T>& child,
                        const GuideProfiles<T>& guides, std::size_t place);

/// Turns the frames of a synthesised strand so that its spine follows the spine of the
/// child's guides, and recomputes its places from the frames. Two rotations act at each
/// place; both vary as smoothly along the strand as the spines, so that the strand's own
/// curvature and torsion hardly change:
///   - the tangent is tilted about the spine so that the strand advances along its spine
///     as fast as its guides;
///   - the spine is turned into the direction of the guides' spine.
/// A strand that copies a guide with weight 1 is unchanged. The length stays exact, as
/// one helix connects two frames.
template <class T>
void anchor(const Child<T>& child, const GuideProfiles<T>& guides,
            std::span<HelixState<T>> states);

}  // namespace lancret
