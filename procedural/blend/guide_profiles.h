#pragma once
// Guides as the blends read them: Frenet-Serret data at equal steps of s / L.

#include <vector>

#include "guides/helix/guides.h"
#include "procedural/blend/spine.h"

namespace lancret {

/// A bend of fewer radians, of an interval or a segment, has no Frenet normal.
inline constexpr double kStraightBend = 1e-9;

/// One interval of a guide, s / L from i / n to (i + 1) / n. Within it the guide is one
/// helix, and its Frenet frame is the carried frame turned about the tangent by a
/// constant angle. The normal of a Super-Helix jumps where two segments meet, so it is
/// stored at both ends of an interval: the turn between one interval's end and the next
/// one's start is part of the torsion. On a straight interval N is that of the nearest
/// interval that bends.
template <class T>
struct ProfileInterval {
    T kappa;           ///< 1/cm, >= 0
    T tau;             ///< 1/cm, positive for a right-handed helix
    Vec3T<T> tangent;  ///< T in the middle of the interval, in the guide's root frame
    Vec3T<T> normal;   ///< N there
    Vec3T<T> normal_before;  ///< N at the interval's start
    Vec3T<T> normal_after;   ///< N at its end
};

/// Profiles of all guides. Interval i of guide g is at g * count + i; the count + 1
/// places of guide g begin at g * (count + 1).
template <class T>
struct GuideProfiles {
    int count = 0;                              ///< intervals per guide
    std::vector<ProfileInterval<T>> intervals;  ///< [guides * count]
    std::vector<char> joints;  ///< [count], 1 if a guide's N may jump at the start
    std::vector<Mat3T<T>> root_frames;  ///< [guides], in space
    std::vector<T> lengths;             ///< [guides], cm
    std::vector<Vec3T<T>> positions;    ///< of places, relative to the root, in the root
                                        ///< frame, cm
    std::vector<Mat3T<T>> frames;       ///< of places, in the root frame, n0 the tangent
    std::vector<Vec3T<T>> curvatures;  ///< of intervals: Darboux vector in `frames`, 1/cm
    std::vector<Vec3T<T>> bishop;  ///< of intervals, 1/cm: the twist, and the two bends
                                   ///< in the rotation-minimising frame that starts as
                                   ///< the root frame, as it is in the interval's middle
    SpineBasis<T> basis;           ///< for `count` intervals
    std::vector<Spine<T>> spines;  ///< [guides], in the root frame
    std::vector<T> advances;       ///< of places: |spine|, at most 1

    std::size_t size() const { return lengths.size(); }
    const Vec3T<T>& position(std::size_t g, std::size_t i) const {
        return positions[g * (count + 1) + i];
    }
    const Mat3T<T>& frame(std::size_t g, std::size_t i) const {
        return frames[g * (count + 1) + i];
    }
    T advance(std::size_t g, std::size_t i) const {
        return advances[g * (count + 1) + i];
    }
    /// The unit tangent of a guide at a place, in its root frame.
    auto tangent(std::size_t g, std::size_t i) const { return frame(g, i).col(0); }
};

/// The profiles of `guides` on `count` intervals. The profile is exact if the guides'
/// joints lie on the grid (segments of one length, `count` a multiple of their number);
/// otherwise an interval that contains a joint becomes the helix with the same relative
/// rotation.
template <class T>
GuideProfiles<T> guide_profiles(const Guides& guides, int count);

}  // namespace lancret
